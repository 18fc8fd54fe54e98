// The spatula with the mesh's default shape, on a coarse mesh: the start of peeling.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fem/quadrature.hpp"
#include "mesh/generators/spatula.hpp"
#include "scene/simulation.hpp"
#include "solve/direct/factorization.hpp"
#include "support/comparison.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

Teuchos::ParameterList scene(const std::string& scheme, std::vector<std::string> settings = {}) {
  settings.insert(settings.begin(),
                  {"Mesh/Spatula/Target Cells=400", "Nonlinear Solver/Tolerance=1e-11",
                   "Time Integrator/Type=" + scheme, "Time Integrator/Time Step Control/Time Step=1"});
  return test::scene_file("spatula-stiff.xml", settings);
}

std::vector<std::string> direct(const std::string& factorization) {
  return {"Linear Solver/Linear Solver Type=Direct",
          "Linear Solver/Linear Solver Types/Direct/Solver Type=" + factorization};
}

std::vector<std::string> conjugate_gradients(const std::string& preconditioner, const std::string& op) {
  std::vector<std::string> list{"Linear Solver/Linear Solver Type=Belos", "Linear Solver/Operator=" + op};
  if (preconditioner == "MueLu") {
    list.push_back("Linear Solver/Preconditioner Type=MueLu");
  } else {
    list.push_back("Linear Solver/Preconditioner Type=Direct");
    list.push_back("Linear Solver/Preconditioner Types/Direct/Solver Type=" + preconditioner);
  }
  return list;
}

std::array<double, 3> reaction(const Simulation& s) {
  const LocalMesh& mesh = s.model().mesh();
  std::array<double, 3> sum{};
  for (int node : mesh.node_sets[mesh.node_set("shaft end")])
    for (std::size_t i = 0; i < 3; ++i)
      if (node < mesh.owned_nodes) sum[i] += s.integrator().state().reaction[3 * static_cast<std::size_t>(node) + i];
  s.model().space().sum(sum.data(), 3);
  return sum;
}

InteractionReport contact(const Simulation& s) { return test::report_of(s).interaction_report(); }

Momenta momenta(const Simulation& s) { return test::report_of(s).momenta(); }

/// Of the polygons that the pad's sides are: twice the area of a plane one is the cross product of its diagonals.
double pad_area(const Mesh& mesh) {
  double area = 0;
  for (const SideSet& set : mesh.side_sets)
    for (const Side& side : set.sides) {
      if (set.name != "pad") continue;
      const std::vector<int>& corners = side_nodes(CellType::Hex8, side.side);
      const auto place = [&](std::size_t corner, std::size_t axis) {
        const int node = mesh.blocks[0].nodes[cell_entry(side.cell, 8, corners[corner])];
        return mesh.coordinates[3 * static_cast<std::size_t>(node) + axis];
      };
      const double ax = place(2, 0) - place(0, 0), ay = place(2, 1) - place(0, 1);
      const double bx = place(3, 0) - place(1, 0), by = place(3, 1) - place(1, 1);
      area += std::abs(ax * by - ay * bx) / 2;
    }
  return area;
}

TEST(SpatulaSceneTest, StartsWithItsWholePadAtTheEquilibriumGap) {
  // A half-width of 50 + 70 s^2 (3 - 2 s) over 100, 120 over 10, half an ellipse of semi-axes 120.
  const double outline = 2 * (50 + 35) * 100 + 240 * 10 + M_PI / 2 * 120 * 120;
  double before = 0.2;
  for (int cells : {400, 1600, 6400}) {
    Simulation s(scene("Newmark", {"Mesh/Spatula/Target Cells=" + std::to_string(cells)}), world());
    SpatulaShape shape;
    shape.target_cells = cells;
    const double area = pad_area(spatula(shape));
    const InteractionReport start = contact(s);
    EXPECT_NEAR(start.measure, area, 1e-9 * area);
    EXPECT_NEAR(start.least_gap, std::pow(15, -1.0 / 6) / 2.5, 1e-12);
    for (double force : start.force) EXPECT_NEAR(force, 0, 1e-9);  // against 2624 of repulsion alone
    // int psi dA = -W A, the work of adhesion W = 15^(1/3) pi/(8 25 2.5).
    const double adhesion = std::cbrt(15.0) * M_PI / (8 * 25 * 2.5);
    EXPECT_NEAR(test::report_of(s).energy(Part::Interaction), -adhesion * area, 1e-9 * area);
    const double error = 1 - area / outline;
    EXPECT_GT(error, 0) << "an inscribed polygon";
    EXPECT_LT(error, 0.3 * before) << cells;
    before = error;
  }
}

TEST(SpatulaSceneTest, QuasiStaticPullIsTheForceOnTheWall) {
  Simulation s(scene("Static"), world());
  double before = 0;
  for (int n = 0; n < 36; ++n) {
    ASSERT_TRUE(s.integrator().step(1.0).converged) << n;
    const auto pull = reaction(s);
    const auto wall = contact(s).force;
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(pull[i], -wall[i], 1e-8) << n;
    // The wall is smooth, and y = 0 a plane of symmetry.
    EXPECT_NEAR(wall[0], 0, 1e-15);
    EXPECT_NEAR(wall[1], 0, 1e-15);
    EXPECT_GT(pull[2], before) << n;
    before = pull[2];
  }
  EXPECT_GT(before, 1e-4) << "the balance was tested on nothing";
}

TEST(SpatulaLongTest, EverySchemePeelsWithoutACutAndBalancesItsForces) {
  Simulation still(scene("Static"), world());
  for (int n = 0; n < 39; ++n) ASSERT_TRUE(still.integrator().step(0.5).converged);
  const double mean_static = reaction(still)[2];
  ASSERT_TRUE(still.integrator().step(0.5).converged);
  const double end_static = reaction(still)[2];
  for (const std::string scheme : {"Bathe Composite", "Gautam-Sauer Composite", "Average Vector Field"}) {
    Simulation s(scene(scheme, conjugate_gradients(first_rank_factorization(), "Assembled")), world());
    const bool at_end = scheme == "Bathe Composite";  // its forces are those at the step's end; else means over it
    const Quadrature means = gauss_legendre_unit(scheme == "Average Vector Field" ? 8 : 5);
    const double area = contact(s).measure;
    double start = 0, peak = 0, imbalance = 0, lateral = 0;
    for (int n = 0; n < 50; ++n) {
      const std::vector<double> u0 = s.integrator().state().u;
      const Momenta before = momenta(s);
      const StepResult result = s.integrator().step(1.0);
      ASSERT_TRUE(result.converged) << scheme << ", t = " << s.integrator().time() << ": " << result.reason;
      // The whole body: inertia = force of the wall + reaction; damping and elasticity have no resultant.
      const State& state = s.integrator().state();
      std::vector<double> wall(3, 0.0), inertia = momenta(s).linear;
      if (at_end) {
        wall = contact(s).force;
        inertia = test::ReportAt(s.model(), state.u.data(), state.a.data()).momenta().linear;
      } else {
        for (std::size_t q = 0; q < means.points.size(); ++q) {
          std::vector<double> u(u0);
          for (std::size_t i = 0; i < u.size(); ++i) u[i] += means.points[q] * (state.u[i] - u0[i]);
          const auto force = test::ReportAt(s.model(), u.data()).interaction_report().force;
          for (std::size_t i = 0; i < 3; ++i) wall[i] += means.weights[q] * force[i];
        }
        for (std::size_t i = 0; i < 3; ++i) inertia[i] -= before.linear[i];
      }
      const auto pull = reaction(s);
      for (std::size_t i = 0; i < 3; ++i) imbalance = std::max(imbalance, std::abs(pull[i] + wall[i] - inertia[i]));
      peak = std::max(peak, pull[2]);
      lateral = std::max(lateral, std::abs(pull[1]));
      if (n == 19) start = pull[2];
    }
    EXPECT_LT(contact(s).measure, area) << scheme << " did not begin to peel";
    EXPECT_GT(contact(s).measure, 0) << scheme;
    EXPECT_NEAR(start, at_end ? end_static : mean_static, 0.02 * end_static) << scheme;
    EXPECT_LT(imbalance, 1e-9 * peak) << scheme;
    EXPECT_LT(lateral, 1e-10 * peak) << scheme;  // y = 0 is a plane of symmetry
  }
}

TEST(SpatulaLongTest, AverageVectorFieldAccountsForTheEnergy) {
  for (const char* damping : {"0", "0.004"}) {
    std::vector<std::string> settings = conjugate_gradients(first_rank_factorization(), "Assembled");
    settings.push_back(std::string("Materials/Keratin/Stiffness Damping=") + damping);
    settings.push_back("Time Integrator/Average Vector Field/Interaction Points=0");
    Simulation s(scene("Average Vector Field", settings), world());
    const double start = test::total_energy(s), area = contact(s).measure;
    bool peels = false;
    for (int n = 0; n < 48; ++n) {
      ASSERT_TRUE(s.integrator().step(1.0).converged) << n;
      peels = peels || contact(s).measure < (1 - 1e-12) * area;
      const double work = s.integrator().external_work() - s.integrator().dissipated_energy();
      // Once it peels, the elastic energy is not a polynomial of degree 8 along a step.
      ASSERT_NEAR(test::total_energy(s) - start, work, peels ? 1e-5 : 1e-10) << damping << ", " << n;
    }
    EXPECT_TRUE(peels) << damping;
    EXPECT_GT(s.integrator().external_work(), 0.1) << "the balance was tested on nothing";
    const double dissipated = s.integrator().dissipated_energy();
    if (damping == std::string("0")) {
      EXPECT_EQ(dissipated, 0.0);
    } else {
      EXPECT_GT(dissipated, 0.01);
    }
  }
}

/// Of all nodes, after some steps with these settings.
std::vector<double> displacements(const Comm& comm, const std::vector<std::string>& settings, int steps) {
  Simulation s(scene("Average Vector Field", settings), comm);
  for (int n = 0; n < steps; ++n) {
    const StepResult result = s.integrator().step(1.0);
    EXPECT_TRUE(result.converged) << n << ": " << result.reason;
    if (!result.converged) return {};
  }
  return test::gathered(s.model(), s.integrator().state().u);
}

// All ranks together against each alone with its own factorisation.
TEST(SpatulaSceneTest, RanksAndLinearSolversAgree) {
  const int early = 5, late = 12;
  const auto reference = displacements(test::self(), direct(first_rank_factorization()), late);
  const auto check = [](const std::vector<double>& u, const std::vector<double>& expected, const std::string& name) {
    ASSERT_EQ(u.size(), expected.size()) << name;
    const double size = *std::max_element(expected.begin(), expected.end());
    EXPECT_LT(test::distance(u, expected), 1e-9 * size) << name;
  };
  for (const std::string& factorization : {first_rank_factorization(), std::string("MUMPS")})
    check(displacements(world(), direct(factorization), late), reference, factorization);
  check(displacements(world(), conjugate_gradients(first_rank_factorization(), "Assembled"), late), reference,
        "CG, " + first_rank_factorization());
  check(displacements(world(), conjugate_gradients("MUMPS Single", "Matrix-Free"), late), reference, "CG, MUMPS");
  const auto sooner = displacements(test::self(), direct(first_rank_factorization()), early);
  for (const char* op : {"Assembled", "Matrix-Free"})  // dearer on so slender a body
    check(displacements(world(), conjugate_gradients("MueLu", op), early), sooner, std::string("MueLu, ") + op);
}

}  // namespace
}  // namespace ixos
