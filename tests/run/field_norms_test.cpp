#include "run/field_norms.hpp"

#include <algorithm>
#include <cmath>

#include "run/restart_fixture.hpp"
#include "scene/history_columns.hpp"
#include "study/common/history_table.hpp"

namespace ixos::test {
namespace {

class FieldNormsTest : public RestartTest {
 protected:
  HistoryTable history(const std::string& scene) {
    run_scene(scene, "run");
    world()->barrier();
    return HistoryTable(folder("run") + "/history.csv");
  }
};

std::string norms(const std::string& names) { return texts("Norms", "{" + names + "}"); }

const std::string strains = "<Parameter name=\"Strains\" type=\"bool\" value=\"true\"/>";

/// A box of 2 by 3 L0 of linear elastic material with E = 2 and these Poisson's ratio and density.
std::string box_of(double ratio, const std::string& divisions) {
  return list("Mesh", word("Type", "Box") + list("Box", numbers("Lengths", {2, 3}) + divisions)) +
         list("Materials", list("Rubber", word("Model", "Linear Elastic") + number("Young's Modulus", 2) +
                                              number("Poisson's Ratio", ratio) + number("Density", 5)));
}

// A free body keeps its velocity (3, 4): |u| = 5 t, |v| = 5, a = 0 and no stress, whatever the density.
TEST_F(FieldNormsTest, ATranslation) {
  for (const char* scheme : {"Newmark", "Average Vector Field", "Central Difference"}) {
    const HistoryTable found =
        history(box_of(0.3, counts("Divisions", {5, 4})) + list("Initial Conditions", numbers("Velocity", {3, 4})) +
                list("Output", norms("velocity, displacement, acceleration, stress, jacobian")) +
                time_integrator(scheme, 0.1, 1));
    const auto time = found.column("time"), u = found.column("norm_displacement"), v = found.column("norm_velocity"),
               a = found.column("norm_acceleration"), stress = found.column("norm_stress"),
               jacobian = found.column("norm_jacobian");
    ASSERT_GE(time.size(), 11U);
    for (std::size_t k = 0; k < time.size(); ++k) {
      EXPECT_NEAR(u[k], 5 * time[k], 1e-12) << scheme;
      EXPECT_NEAR(v[k], 5, 1e-12) << scheme;
      EXPECT_NEAR(a[k], 0, 1e-9) << scheme;
      EXPECT_NEAR(stress[k], 0, 1e-12) << scheme;
      EXPECT_NEAR(jacobian[k], 1, 1e-12) << scheme;
    }
  }
}

// Simple shear u = (0.03 t y/3, 0) of a row of cells that is held all around: |u| = 0.03 t/sqrt(3), |v| = 0.03/sqrt(3),
// and, with nu = 0.25 and so mu = 0.8, sigma_xy = 0.8 0.01 t, which counts twice; von Mises' stress is sqrt(3)
// sigma_xy. A shear by g turns by atan(g/2) and has the stretches sqrt(1 + g^2/4) +- g/2.
TEST_F(FieldNormsTest, AShear) {
  const auto held = [](const std::string& name, const std::string& components, const std::string& more) {
    return list(name, word("Node Set", name) + word("Components", components) + more);
  };
  const HistoryTable found = history(
      box_of(0.25, counts("Divisions", {6, 1})) + list("Histories", expression("Shear", "0.03*t", "0.03", "0")) +
      list("Boundary Conditions", held("bottom", "xy", "") + held("top", "x", word("History", "Shear")) +
                                      list("Guide", word("Node Set", "top") + word("Components", "y"))) +
      list("Output", strains + norms("displacement, velocity, stress, von_mises_stress, principal_stress")) +
      list("Initial Conditions", numbers("Velocity Gradient", {0, 0.01, 0, 0})) + time_integrator("Newmark", 0.1, 1));
  const auto time = found.column("time"), u = found.column("norm_displacement"), v = found.column("norm_velocity"),
             stress = found.column("norm_stress"), mises = found.column("norm_von_mises_stress"),
             principal = found.column("norm_principal_stress"), rotation = found.column("largest_rotation"),
             least = found.column("least_strain"), largest = found.column("largest_strain");
  ASSERT_EQ(time.size(), 11U);
  for (std::size_t k = 0; k < time.size(); ++k) {
    EXPECT_NEAR(u[k], 0.03 * time[k] / std::sqrt(3), 1e-14);
    EXPECT_NEAR(v[k], 0.03 / std::sqrt(3), 1e-14);
    EXPECT_NEAR(stress[k], std::sqrt(2) * 0.008 * time[k], 1e-14);
    EXPECT_NEAR(principal[k], stress[k], 1e-14);
    EXPECT_NEAR(mises[k], std::sqrt(3) * 0.008 * time[k], 1e-14);
    const double half = 0.005 * time[k], root = std::sqrt(1 + half * half) - 1;
    EXPECT_NEAR(rotation[k], std::atan(half), 1e-14);
    EXPECT_NEAR(largest[k], root + half, 1e-14);
    EXPECT_NEAR(least[k], root - half, 1e-14);
  }
}

TEST_F(FieldNormsTest, ARestartContinuesThem) {
  for (const char* scheme : {"Newmark", "Average Vector Field"}) {
    SCOPED_TRACE(scheme);
    expect_goes_on(drawn(word("Type", scheme) + steps(0.05, 1),
                         strains + norms("displacement, velocity, acceleration, stress") + checkpoints(7, 100)),
                   {7, 14});
    const HistoryTable found(folder("whole") + "/history.csv");
    EXPECT_GT(found.column("norm_acceleration").back(), 1e-3);
    const auto velocity = found.column("norm_velocity"), energy = found.column("kinetic_energy");
    for (std::size_t k = 0; k < energy.size(); ++k)  // of density 1 and volume 2
      EXPECT_NEAR(velocity[k] * velocity[k], energy[k], 1e-13 * energy[k]);
  }
}

TEST_F(FieldNormsTest, WithoutTheListThereIsNothing) {
  Simulation simulation(scene(drawn(word("Type", "Newmark") + steps(0.05, 1))), world());
  EXPECT_TRUE(FieldNorms({}, simulation.model()).values(simulation.integrator()).empty());
  const std::vector<std::string> names = history_columns(simulation).names;
  EXPECT_EQ(std::count(names.begin(), names.end(), "largest_rotation"), 0);
}

}  // namespace
}  // namespace ixos::test
