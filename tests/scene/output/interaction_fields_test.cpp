#include "scene/output/interaction_fields.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "interaction/gap_law.hpp"
#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::numbers;
using test::word;

std::string fields_output(const std::string& fields) {
  return list("Output", test::texts("Fields", "{" + fields + "}"));
}

/// A block of 3 by 2 L0 before two walls: y = -0.5 below, x = 3.75 at its right.
Teuchos::ParameterList cornered(const std::string& fields = "") {
  return test::scene(test::block_2d(0) + test::time_integrator("Newmark", 0.1, 1) +
                     list("Interactions", list("Floor", word("Side Set", "bottom") + numbers("Point", {0, -0.5})) +
                                              list("Stop", word("Side Set", "right") + numbers("Point", {3.75, 0}) +
                                                               numbers("Normal", {-1, 0}))) +
                     (fields.empty() ? "" : fields_output(fields)));
}

TEST(InteractionFieldsTest, FieldsFollowThoseOfTheCatalogue) {
  const Simulation s(cornered("pressure_Stop, gap_Floor, gap"), test::world());
  std::vector<std::string> names;
  for (const OutputField& field : chosen_fields(s.output().fields, s.model())) names.push_back(field.name);
  EXPECT_EQ(names, (std::vector<std::string>{"gap", "gap_Floor", "pressure_Stop"}));
  const std::vector<OutputField> all = interaction_fields("Stop");
  ASSERT_EQ(all.size(), 9U);
  EXPECT_EQ(all[1].components(2), (std::vector<std::string>{"normal_StopX", "normal_StopY"}));
  EXPECT_EQ(all[2].components(3).back(), "traction_StopZ");
  for (const OutputField& field : all) {
    EXPECT_EQ(field.sentence.back(), '.');
    EXPECT_FALSE(field.usual);
  }
}

TEST(InteractionFieldsTest, EachInteractionHasItsOwnValues) {
  Simulation s(cornered(), test::world());
  FieldFrame frame(s.integrator());
  const std::vector<OutputField> floor = interaction_fields("Floor"), stop = interaction_fields("Stop");
  const NodalValues gap = floor[0].nodal(frame), normal = stop[1].nodal(frame), traction = stop[2].nodal(frame),
                    pressure = stop[3].nodal(frame);
  const LocalMesh& mesh = s.model().mesh();
  const double push = s.interactions()[1].law->traction(0.75)[0];
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.nodes()); ++node) {  // ghosts, too
    const bool below = mesh.coordinates[2 * node + 1] == 0, beside = mesh.coordinates[2 * node] == 3;
    EXPECT_EQ(std::isnan(gap[0][node]), !below);
    if (below) {
      EXPECT_NEAR(gap[0][node], 0.5, 1e-15);
    }
    EXPECT_EQ(normal[0][node], beside ? -1 : 0);
    EXPECT_EQ(normal[1][node], 0);
    EXPECT_NEAR(pressure[0][node], beside ? push : 0, 1e-14);
    EXPECT_NEAR(traction[0][node], beside ? -push : 0, 1e-14);
    EXPECT_NEAR(traction[1][node], 0, 1e-15);
  }
  EXPECT_LT(push, 0) << "it attracts";
}

TEST(InteractionFieldsTest, DamageIsThatOfBondsOnly) {
  const auto bonded = [](const std::string& law, double height) {
    return test::scene(test::block_2d(0) + test::time_integrator("Newmark", 0.1, 1) +
                       list("Interactions", list("Bond", word("Side Set", "bottom") + numbers("Point", {0, -height}) +
                                                             word("Law", law))) +
                       fields_output("damage_Bond"));
  };
  const std::string place = test::refusal([&] { Simulation(bonded("Morse", 0.5), test::world()); });
  test::expect_contains(place,
                        "Output/Fields: \"damage_Bond\" needs the law \"Bilinear Damage\" in the interaction \"Bond\"");
  Simulation s(bonded("Bilinear Damage", 100), test::world());  // beyond the range: broken
  FieldFrame frame(s.integrator());
  const std::vector<OutputField> chosen = chosen_fields(s.output().fields, s.model());
  ASSERT_EQ(chosen.size(), 1U);
  EXPECT_EQ(chosen[0].name, "damage_Bond");
  const NodalValues damage = chosen[0].nodal(frame);
  const LocalMesh& mesh = s.model().mesh();
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.nodes()); ++node)  // ghosts, too
    EXPECT_NEAR(damage[0][node], mesh.coordinates[2 * node + 1] == 0 ? 1 : 0, 1e-14);
}

TEST(InteractionFieldsTest, OtherNamesAreRefused) {
  const auto refusal = [](const std::string& fields) {
    return test::refusal([&] { Simulation(cornered(fields), test::world()); });
  };
  test::expect_contains(refusal("gap_Flor"),
                        "Output/Fields: field \"gap_Flor\" does not exist; did you mean \"gap_Floor\"?");
  test::expect_contains(refusal("gap_Floor, gap_Floor"), "\"gap_Floor\" is given twice");
  EXPECT_EQ(refusal("default, normal_Floor, traction_Floor"), "");
}

TEST(InteractionFieldsTest, AFieldOfTheBodyWithTheSameNameIsRefused) {
  test::expect_contains(
      test::refusal([&] {
        Simulation(test::scene(test::block_2d(0) + test::time_integrator("Newmark", 0.1, 1) +
                               list("Interactions",
                                    list("energy_density", word("Side Set", "bottom") + numbers("Point", {0, -0.5}))) +
                               fields_output("dissipated_energy_density")),
                   test::world());
      }),
      "Output/Fields: \"dissipated_energy_density\" names a field of the body and one of an interaction");
}

TEST(InteractionFieldsTest, NamesThatFilesWouldCutAreRefused) {
  const std::string name(75, 'n');
  const auto refusal = [&](const std::string& field) {
    return test::refusal([&] {
      Simulation(
          test::scene(test::block_2d(0) + test::time_integrator("Newmark", 0.1, 1) +
                      list("Interactions", list(name, word("Side Set", "bottom") + numbers("Point", {0, -0.5}))) +
                      fields_output(field + name)),
          test::world());
    });
  };
  EXPECT_EQ(refusal("gap_").substr(0, 14), "Output/Fields:");
  test::expect_contains(refusal("gap_"), "has 79 bytes; names of fields may have 78");
}

}  // namespace
}  // namespace ixos
