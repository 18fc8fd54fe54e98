#include "scene/output/output_fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::numbers;
using test::word;

/// A block without a wall, and what else the scene holds.
Teuchos::ParameterList block(const std::string& more = "") {
  return test::scene(test::block_2d(0) + test::time_integrator("Newmark", 0.1, 1) + more);
}

std::string fields(const std::string& names) { return list("Output", test::texts("Fields", "{" + names + "}")); }

std::vector<std::string> names_of(const std::vector<OutputField>& chosen) {
  std::vector<std::string> names;
  for (const OutputField& field : chosen) names.push_back(field.name);
  return names;
}

const OutputField& field(const std::string& name) {
  for (const OutputField& candidate : output_fields())
    if (candidate.name == name) return candidate;
  throw std::out_of_range(name);
}

TEST(OutputFieldsTest, EachEntryIsWholeAndItsComponentsHaveNamesOfTheirOwn) {
  for (int dimension : {2, 3}) {
    std::set<std::string> names;
    std::size_t count = 0;
    for (const OutputField& entry : output_fields()) {
      EXPECT_NE(entry.nodal == nullptr, entry.cell == nullptr) << entry.name;
      EXPECT_EQ(entry.needs.empty(), entry.present == nullptr) << entry.name;
      EXPECT_EQ(entry.sentence.back(), '.') << entry.name;
      EXPECT_FALSE(entry.unit.empty()) << entry.name;
      for (const std::string& component : entry.components(dimension)) {
        names.insert(component);
        ++count;
        EXPECT_NE(component.back(), '_');
      }
    }
    EXPECT_EQ(names.size(), count);
  }
}

TEST(OutputFieldsTest, EndingsNameTheComponents) {
  const std::vector<std::string> plane{"stressXX", "stressYY", "stressZZ", "stressXY"};
  EXPECT_EQ(field("stress").components(2), plane);
  EXPECT_EQ(field("stress").components(3).back(), "stressZX");
  EXPECT_EQ(field("reaction").components(2), (std::vector<std::string>{"reactionX", "reactionY"}));
  EXPECT_EQ(field("principal_stress").components(2).back(), "principal_stress3");
  EXPECT_EQ(field("gap").components(3), std::vector<std::string>{"gap"});
}

TEST(OutputFieldsTest, UnitsFollowTheDimension) {
  EXPECT_EQ(unit_in(2, "E0 L0^(D-1)"), "E0 L0");
  EXPECT_EQ(unit_in(3, "E0 L0^(D-1)"), "E0 L0^2");
  EXPECT_EQ(unit_in(2, "E0 L0^D"), "E0 L0^2");
  EXPECT_EQ(unit_in(3, "L0/T0^2"), "L0/T0^2");
}

TEST(OutputFieldsTest, WithoutAListThereAreTheUsualFields) {
  const std::vector<std::string> of_any{"displacement",           "velocity", "acceleration",
                                        "first_stress_invariant", "jacobian", "energy_density"};
  const Simulation s(block(), test::world());
  EXPECT_EQ(names_of(chosen_fields({}, s.model())), of_any);
  EXPECT_EQ(names_of(chosen_fields({"default"}, s.model())), of_any);
  std::vector<std::string> more = of_any;
  more.emplace_back("stress");
  EXPECT_EQ(names_of(chosen_fields({"stress", "default"}, s.model())), more);
  const Simulation ball(test::scene_file("ball.xml"), test::world());
  std::vector<std::string> attracted = of_any;
  attracted.insert(attracted.begin() + 3, "interaction_traction");
  EXPECT_EQ(names_of(chosen_fields({}, ball.model())), attracted);
  EXPECT_EQ(names_of(chosen_fields({"gap", "displacement"}, ball.model())),
            (std::vector<std::string>{"displacement", "gap"}));
}

TEST(OutputFieldsTest, BadNamesAreRefused) {
  const auto refusal = [](const std::string& names) {
    return test::refusal([&] { Simulation(block(fields(names)), test::world()); });
  };
  test::expect_contains(refusal("strss"), "Output/Fields: field \"strss\" does not exist; did you mean \"stress\"?");
  test::expect_contains(refusal("strss"), "\"contact_pressure\"");
  test::expect_contains(refusal("stress, jacobian, stress"), "Output/Fields: \"stress\" is given twice");
  test::expect_contains(refusal("gap"), "Output/Fields: \"gap\" needs an interaction, which the scene does not have");
  test::expect_contains(refusal("contact_pressure"), "needs an interaction");
  test::expect_contains(refusal("reaction"), "needs a prescribed displacement");
  test::expect_contains(refusal("dissipated_energy_density"), "needs a viscosity");
  EXPECT_EQ(refusal("default, von_mises_stress, principal_stress"), "");
}

// A block, held at the left in both directions and pulled at the right by a known force, over a wall.
TEST(OutputFieldsTest, FieldsOfAPulledBlock) {
  const double traction = 0.02, height = 2;
  Simulation s(
      test::scene(
          test::block_2d(0) +
          list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -50}))) +
          list("Boundary Conditions", list("Held", word("Node Set", "left")) +
                                          list("Pull", word("Type", "Traction") + word("Side Set", "right") +
                                                           numbers("Vector", {traction, 0}))) +
          list("Time Integrator",
               word("Type", "Static") + list("Time Step Control", number("Time Step", 1) + number("Final Time", 1)))),
      test::world());
  ASSERT_TRUE(s.integrator().step(1).converged);
  const LocalMesh& mesh = s.model().mesh();
  FieldFrame frame(s.integrator());

  const NodalValues reaction = field("reaction").nodal(frame), gap = field("gap").nodal(frame);
  ASSERT_EQ(reaction.size(), 2U);
  ASSERT_EQ(gap.size(), 1U);
  double sums[] = {0, 0};
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.nodes()); ++node) {
    const double x = mesh.coordinates[2 * node], y = mesh.coordinates[2 * node + 1];
    for (std::size_t i = 0; i < 2; ++i) {
      if (node < static_cast<std::size_t>(mesh.owned_nodes)) sums[i] += reaction[i][node];
      if (x > 0) {
        EXPECT_EQ(reaction[i][node], 0);
      }
    }
    // Ghosts have values too.
    if (x == 0) {
      EXPECT_LT(reaction[0][node], -1e-3);
    }
    EXPECT_EQ(std::isnan(gap[0][node]), y > 0);
    if (y == 0) {
      EXPECT_NEAR(gap[0][node], 50 + s.integrator().state().u[2 * node + 1], 1e-13);
    }
  }
  s.model().space().sum(sums, 2);
  EXPECT_NEAR(sums[0], -traction * height, 1e-9);
  EXPECT_NEAR(sums[1], 0, 1e-5) << "but for the wall far away";

  const CellValues stress = field("stress").cell(frame), invariant = field("first_stress_invariant").cell(frame);
  const CellValues principal = field("principal_stress").cell(frame), mises = field("von_mises_stress").cell(frame);
  ASSERT_EQ(stress.size(), 4U);
  ASSERT_EQ(principal.size(), 3U);
  for (std::size_t cell = 0; cell < mises[0][0].size(); ++cell) {
    const double trace = stress[0][0][cell] + stress[1][0][cell] + stress[2][0][cell];
    EXPECT_NEAR(trace, invariant[0][0][cell], 1e-14) << "E is 1";
    EXPECT_NEAR(principal[0][0][cell] + principal[1][0][cell] + principal[2][0][cell], trace, 1e-14);
    EXPECT_GE(principal[0][0][cell], stress[0][0][cell] - 1e-15);
    EXPECT_NEAR(mises[0][0][cell],
                von_mises({principal[0][0][cell], principal[1][0][cell], principal[2][0][cell], 0, 0, 0}), 1e-14);
  }
}

}  // namespace
}  // namespace ixos
