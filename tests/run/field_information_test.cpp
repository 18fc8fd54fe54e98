#include "run/field_information.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "scene/scene_changes.hpp"
#include "support/bodies.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::word;

std::vector<std::string> information(const std::string& scene, const std::string& file = "") {
  const bool lasts = scene.find("Time Integrator") != std::string::npos;
  const Simulation simulation(test::scene(scene + (lasts ? "" : test::time_integrator("Newmark", 0.1, 1))),
                              test::world());
  return field_information(simulation, file, chosen_fields({"displacement", "stress"}, simulation.model()));
}

bool has(const std::vector<std::string>& lines, const std::string& line) {
  return std::find(lines.begin(), lines.end(), line) != lines.end();
}

TEST(FieldInformationTest, ItNamesTheSceneAndTheUnits) {
  const std::string units = list("Units", word("Length", "3 um") + word("Energy Density", "2 MPa"));
  const auto lines = information(test::block_2d(0) + units, "scenes/block.xml");
  EXPECT_EQ(lines[0].rfind("written by: Ixos ", 0), 0U);
  for (const char* line : {"scene: Test", "scene file: scenes/block.xml", "L0: 3 um", "E0: 2 MPa", "T0: 1 ns",
                           "unit of displacement: L0", "unit of stress: E0", "unit of elastic_energy: E0 L0^2"})
    EXPECT_TRUE(has(lines, line)) << line;
  EXPECT_TRUE(has(information(test::block_3d(0)), "unit of elastic_energy: E0 L0^3"));
}

// fields.e of a run that was resumed, with a later end or other output, equals that of a run without a break.
TEST(FieldInformationTest, ItDoesNotChangeWithTheEndOfTheRun) {
  const auto short_run = test::block_2d(0) + test::time_integrator("Newmark", 0.1, 1);
  const auto long_run =
      test::block_2d(0) + test::time_integrator("Newmark", 0.1, 2) + list("Output", test::count("Fields Interval", 3));
  EXPECT_EQ(information(short_run), information(long_run));
  EXPECT_NE(information(short_run), information(test::block_2d(0) + test::time_integrator("Newmark", 0.2, 1)));
}

TEST(FieldInformationTest, TheDigestIsOfWhatMoves) {
  const auto digest = [](const std::string& lists, const std::string& mesh = "m") {
    return scene_digest(test::scene(lists), mesh);
  };
  const std::string scene = list("Materials", list("Rubber", number("Density", 1)));
  EXPECT_EQ(digest(scene).size(), 32U);
  EXPECT_EQ(digest(scene), digest(scene + list("Output", test::count("Fields Interval", 4))));
  EXPECT_EQ(digest(scene), digest(scene + list("Linear Solver", word("Linear Solver Type", "Belos"))));
  EXPECT_NE(digest(scene), digest(scene, "n"));
  EXPECT_NE(digest(scene), digest(list("Materials", list("Rubber", number("Density", 2)))));
  EXPECT_NE(digest(scene), digest(scene + list("Mesh", list("Sets", list("edge", word("Kind", "Nodes"))))));
  const auto of_file = [&](const char* path) { return digest(scene + list("Mesh", list("Gmsh", word("File", path)))); };
  EXPECT_EQ(of_file("/here/one.msh"), of_file("/there/one.msh"));
  EXPECT_NE(of_file("/here/one.msh"), of_file("/here/two.msh"));
}

}  // namespace
}  // namespace ixos
