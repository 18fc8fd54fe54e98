#include "parameters/scene_node.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/refusal.hpp"

namespace ixos {
namespace {

using Teuchos::ParameterList;

/// Interactions with two walls, and a number between the lists.
ParameterList scene() {
  ParameterList list("Scene");
  ParameterList& interactions = list.sublist("Interactions");
  interactions.sublist("Wall 2").set("Side Set", std::string("top"));
  interactions.set("Number", 3);
  ParameterList& wall = interactions.sublist("Wall 1");
  wall.set("Side Set", std::string("bottom"));
  wall.set("Cutoff", 1.5);
  wall.set("Points", 7);
  wall.set("Exact", true);
  wall.set("Normal", Teuchos::Array<double>(Teuchos::tuple(0.6, 0.8)));
  wall.set("Point", Teuchos::Array<double>());
  return list;
}

TEST(SceneNodeTest, PathsLeadFromTheRoot) {
  const ParameterList list = scene();
  const SceneNode root(list, "");
  EXPECT_EQ(root.path(), "");
  EXPECT_EQ(root.path_of("Interactions"), "Interactions");
  const SceneNode wall = root.sublist("Interactions").sublist("Wall 1");
  EXPECT_EQ(wall.path(), "Interactions/Wall 1");
  EXPECT_EQ(wall.path_of("Law"), "Interactions/Wall 1/Law");
  EXPECT_EQ(wall.name(), "Wall 1");
  EXPECT_EQ(root.sublist("Interactions").name(), "Interactions");
}

TEST(SceneNodeTest, RefersToTheList) {
  ParameterList list = scene();
  const SceneNode wall = SceneNode(list, "").sublist("Interactions").sublist("Wall 1");
  EXPECT_EQ(&wall.list(), &list.sublist("Interactions").sublist("Wall 1"));
  list.sublist("Interactions").sublist("Wall 1").set("Cutoff", 2.5);
  EXPECT_EQ(wall.number("Cutoff"), 2.5);
}

TEST(SceneNodeTest, ReadsValuesOfEveryType) {
  const ParameterList list = scene();
  const SceneNode wall = SceneNode(list, "").sublist("Interactions").sublist("Wall 1");
  EXPECT_EQ(wall.text("Side Set"), "bottom");
  EXPECT_EQ(wall.number("Cutoff"), 1.5);
  EXPECT_EQ(wall.count("Points"), 7);
  EXPECT_TRUE(wall.get<bool>("Exact"));
  EXPECT_EQ(wall.numbers("Normal"), (std::vector<double>{0.6, 0.8}));
  EXPECT_EQ(wall.numbers("Point"), std::vector<double>());
}

TEST(SceneNodeTest, ArraysHaveTheNumberOfElementsThatTheCallerWants) {
  const ParameterList list = scene();
  const SceneNode wall = SceneNode(list, "").sublist("Interactions").sublist("Wall 1");
  EXPECT_EQ(wall.numbers("Normal", 2, {1.0, 2.0}), (std::vector<double>{0.6, 0.8}));
  EXPECT_EQ(wall.numbers("Point", 2, {1.0, 2.0}), (std::vector<double>{1.0, 2.0}));
  test::expect_contains(test::refusal([&wall] {
                          wall.numbers("Normal", 3, {0.0, 0.0, 1.0});
                        }),
                        "Interactions/Wall 1/Normal has 2 elements, not 3");
}

TEST(SceneNodeTest, SublistsComeInTheOrderOfTheList) {
  const ParameterList list = scene();
  std::vector<std::string> paths;
  for (const SceneNode& node : SceneNode(list, "").sublist("Interactions").sublists()) paths.push_back(node.path());
  EXPECT_EQ(paths, (std::vector<std::string>{"Interactions/Wall 2", "Interactions/Wall 1"}));
}

TEST(SceneNodeTest, RefusalsNameThePlace) {
  const ParameterList list = scene();
  const SceneNode interactions = SceneNode(list, "").sublist("Interactions");
  EXPECT_EQ(test::refusal([&] { interactions.refuse("Number", "too many"); }), "Interactions/Number: too many");
  EXPECT_EQ(test::refusal([&] { interactions.refuse("", "too many"); }), "Interactions: too many");
}

TEST(AtTest, PutsThePathBeforeTheMessageOfAnInputError) {
  EXPECT_EQ(test::refusal([] { at("Mesh", [] { at("Box", [] { throw InputError("too small"); }); }); }),
            "Mesh: Box: too small");
}

TEST(AtTest, LeavesAMessageThatBeginsWithThePathAsItIs) {
  const auto refusal = [](const std::string& message) {
    return test::refusal([&] { at("Mesh/Box", [&] { throw InputError(message); }); });
  };
  EXPECT_EQ(refusal("Mesh/Box: too small"), "Mesh/Box: too small");
  EXPECT_EQ(refusal("Mesh/Box/Lengths has 1 elements"), "Mesh/Box/Lengths has 1 elements");
  EXPECT_EQ(refusal("Mesh/Box is empty"), "Mesh/Box is empty");
  EXPECT_EQ(refusal("Mesh/Boxes: too small"), "Mesh/Box: Mesh/Boxes: too small");
  EXPECT_EQ(refusal("Mesh: too small"), "Mesh/Box: Mesh: too small");
  EXPECT_EQ(placed("", "too small"), "too small");
}

TEST(AtTest, LetsEverythingElseThrough) {
  EXPECT_EQ(at("Mesh", [] { return 42; }), 42);
  try {
    at("Mesh", [] { throw std::out_of_range("no such cell"); });
    ADD_FAILURE() << "nothing was thrown";
  } catch (const std::out_of_range& error) {
    EXPECT_STREQ(error.what(), "no such cell");
  }
  try {
    at("Mesh", [] { throw FileError("disk full"); });
    ADD_FAILURE() << "nothing was thrown";
  } catch (const FileError& error) {
    EXPECT_STREQ(error.what(), "disk full");
  }
}

TEST(SceneNodeTest, ANameMayContainASlash) {
  Teuchos::ParameterList list;
  list.sublist("Histories").sublist("a/b").sublist("Ramp");
  const SceneNode node = SceneNode(list, "").sublist("Histories").sublist("a/b");
  EXPECT_EQ(node.name(), "a/b");
  EXPECT_EQ(node.sublist("Ramp").path(), "Histories/a/b/Ramp");
  EXPECT_EQ(SceneNode(list, "").sublist("Histories").sublists().front().name(), "a/b");
}

}  // namespace
}  // namespace ixos
