#include "scene/output/output_norms.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "scene/history_columns.hpp"
#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;

std::string with_output(const std::string& output) {
  return test::block_2d(0) + test::time_integrator("Newmark", 0.1, 1) + list("Output", output);
}

std::string norms(const std::string& names) { return test::texts("Norms", "{" + names + "}"); }

std::vector<std::string> columns(const std::string& output) {
  return history_columns(Simulation(test::scene(with_output(output)), test::world())).names;
}

TEST(OutputNormsTest, TheyAreTheLastColumnsInTheOrderOfTheList) {
  const std::vector<std::string> without = columns(""), with = columns(norms("stress, displacement"));
  ASSERT_EQ(with.size(), without.size() + 2);
  EXPECT_TRUE(std::equal(without.begin(), without.end(), with.begin()));
  EXPECT_EQ(with[without.size()], "norm_stress");
  EXPECT_EQ(with[without.size() + 1], "norm_displacement");
}

TEST(OutputNormsTest, TheyAreThereOfFieldsOfTheVolume) {
  const auto refusal = [](const std::string& names) {
    return test::refusal([&] { Simulation(test::scene(with_output(norms(names))), test::world()); });
  };
  EXPECT_EQ(refusal("displacement, velocity, acceleration, energy_density, jacobian"), "");
  test::expect_contains(refusal("velocty"),
                        "Output/Norms: field \"velocty\" does not exist; did you mean \"velocity\"?");
  test::expect_contains(refusal("gap"), "Output/Norms: field \"gap\" does not exist");
  test::expect_contains(refusal("stress, stress"), "Output/Norms: \"stress\" is given twice");
  test::expect_contains(refusal("dissipated_energy_density"),
                        "Output/Norms: \"dissipated_energy_density\" needs a viscosity or Maxwell branches");
}

}  // namespace
}  // namespace ixos
