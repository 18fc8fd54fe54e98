#include "io/msh_file.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/refusal.hpp"

namespace ixos {
namespace {

/// A square of one cell, a line and a point. Tags of nodes are not contiguous; entity 2 has parametric coordinates.
const std::string square = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$Comments
anything 1 2 3
$EndComments
$PhysicalNames
2
1 7 "the foot"
2 3 "body"
$EndPhysicalNames
$Entities
1 1 1 0
1 0 0 0 0
2 0 0 0 1 0 0 2 7 -9 2 1 -1
5 0 0 0 1 1 0 1 3 1 2
$EndEntities
$Nodes
2 4 2 40
0 1 0 1
2
0 0 0
1 2 1 3
10
40
30
1 0 0 0.5
1 1 0 0.6
0 1 0 0.7
$EndNodes
$Elements
3 3 1 3
0 1 15 1
1 2
1 2 1 1
2 2 10
2 5 3 1
3 2 10 40 30
$EndElements
)";

MshFile read(const std::string& text) { return read_msh_file(MshSource("m.msh", text)); }

/// Returns the square with `from` replaced.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = square;
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

TEST(MshFileTest, ASquareIsReadAsItIsWritten) {
  const MshFile file = read(square);
  EXPECT_EQ(file.coordinates, (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
  EXPECT_EQ(file.names, (std::map<MshTag, std::string>{{{1, 7}, "the foot"}, {{2, 3}, "body"}}));
  EXPECT_EQ(file.groups, (std::map<MshTag, std::vector<int>>{{{0, 1}, {}}, {{1, 2}, {7, 9}}, {{2, 5}, {3}}}));
  ASSERT_EQ(file.elements.size(), 3U);
  EXPECT_EQ(file.elements[0].dimension, 0);
  EXPECT_EQ(file.elements[1].type, 1);
  EXPECT_EQ(file.elements[1].nodes, (std::vector<int>{0, 1}));
  EXPECT_EQ(file.elements[2].entity, 5);
  EXPECT_EQ(file.elements[2].nodes, (std::vector<int>{0, 1, 2, 3}));
}

void expect_same(const MshFile& file, const MshFile& other) {
  EXPECT_EQ(file.coordinates, other.coordinates);
  EXPECT_EQ(file.names, other.names);
  EXPECT_EQ(file.groups, other.groups);
  ASSERT_EQ(file.elements.size(), other.elements.size());
  for (std::size_t k = 0; k < file.elements.size(); ++k) {
    EXPECT_EQ(file.elements[k].nodes, other.elements[k].nodes);
    EXPECT_EQ(file.elements[k].tags, other.elements[k].tags);
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t place = text.find(from); place != std::string::npos; place = text.find(from, place + to.size()))
    text.replace(place, from.size(), to);
  return text;
}

TEST(MshFileTest, MarksCommentsLineEndsAndPlusSignsChangeNothing) {
  const MshFile file = read(square);
  EXPECT_EQ(file.elements.at(2).tags, std::vector<long long>{3});
  const std::string mark = "\xef\xbb\xbf", comment = "$Comments\nmade by hand, $Nodes and all\n$EndComments\n";
  expect_same(read(mark + square), file);
  expect_same(read(comment + square), file);
  expect_same(read(mark + comment + comment + square), file);
  expect_same(read(square + comment), file);
  for (const char* name : {"PhysicalNames", "Entities", "Nodes", "Elements"})
    expect_same(read(changed("\n$" + std::string(name) + "\n", "\n" + comment + "$" + name + "\n")), file);
  expect_same(read(replaced(square, "\n", "\r\n")), file);
  expect_same(read(mark + replaced(comment + square, "\n", "\r\n")), file);
  expect_same(read(replaced(replaced(square, " 0", " +0"), " 1", " +1")), file);
  test::expect_contains(test::refusal([&] { read(comment); }), "m.msh: is not a mesh of gmsh");
  test::expect_contains(test::refusal([&] { read("$Comments\n" + square.substr(0, square.find("$Comments"))); }),
                        "m.msh: ends inside $Comments: the file is truncated");
}

TEST(MshFileTest, ASectionMayBeMissingThatOnlyNames) {
  const std::size_t names = square.find("$PhysicalNames"), nodes = square.find("$Nodes");
  const MshFile file = read(square.substr(0, names) + square.substr(nodes));
  EXPECT_TRUE(file.names.empty());
  EXPECT_EQ(file.elements.size(), 3U);
}

TEST(MshFileTest, WhatDoesNotFitIsRefusedWithItsPlace) {
  struct Case {
    const char *from, *to, *message;
  };
  const Case cases[] = {
      {"$MeshFormat", "$Nodes", "m.msh: is not a mesh of gmsh"},
      {"4.1 0 8", "4.0 0 8",
       "m.msh: line 2: the format is MSH 4.0; 4.1 and 2.2 are allowed. Convert the file with: gmsh"},
      {"4.1 0 8", "4.1 2 8", "line 2: the mode is 2; 0 (ASCII) and 1 (binary) are allowed"},
      {"4.1 0 8", "4.1 0 4", "line 2: a size_t has 4 bytes; 8 are allowed"},
      {"\n2\n1 7 \"", "\n3\n1 7 \"", "line 11: a dimension is \"$EndPhysicalNames\""},
      {"1 7 \"", "4 7 \"", "line 9: a dimension is 4; 0 to 3 are allowed"},
      {"1 7 \"", "1 0 \"", "line 9: the tag of a physical group is 0; 1 to 2147483647 are allowed"},
      {"2 3 \"body\"", "1 7 \"body\"", "line 10: the physical group 7 of dimension 1 has two names"},
      {"\"body\"", "body", "line 10: the name of a physical group has to stand in quotes"},
      {"$Comments", "$PartitionedEntities", "the mesh is partitioned"},
      {"$Comments", "$Comment", "ends inside $Comment: the file is truncated"},
      {"1 1 1 0\n", "1 1 1 999\n", "line 13: a number of entities is 999, more than the rest of the file can hold"},
      {"2 7 -9", "999999 7 -9", "the number of physical groups of an entity is 999999, more than"},
      {"5 0 0 0 1 1 0 1 3 1 2", "5 0 0 0 1 1 0 1 3 2 2", "the tag of a bounding entity is \"$EndEntities\""},
      {"2 4 2 40", "2 5 2 40", "the entities have 4 nodes, not 5"},
      {"2 4 2 40", "2 3 2 40", "the entities have more nodes than 3"},
      {"2 4 2 40", "2 4000000000000 2 40", "line 19: the number of nodes is 4000000000000, more than the rest of the"},
      {"1 2 1 3\n", "1 2 2 3\n", "the mark of parametric coordinates is 2; 0 and 1 are allowed"},
      {"\n40\n30", "\n10\n30", "the node 10 is given twice"},
      {"1 1 0 0.6", "1 inf 0 0.6", "line 28: a coordinate of a node is inf; a finite number is allowed"},
      {"3 3 1 3\n", "3 4 1 3\n", "the entities have 3 elements, not 4"},
      {"3 3 1 3\n", "3 2 1 3\n", "the entities have more elements than $Elements claims"},
      {"2 5 3 1\n", "2 5 99 1\n",
       "elements of type 99, which is unknown; elements of first and second order are allowed"},
      {"2 5 3 1\n", "2 5 1 1\n", "lines (type 1) in an entity of dimension 2"},
      {"2 5 3 1\n", "2 5 3 900000000000\n", "the number of elements of an entity is 900000000000, more than"},
      {"3 2 10 40 30", "3 2 10 40 31", "line 38: an element has the node 31, which does not exist"},
      {"3 2 10 40 30\n", "", "line 38: the tag of an element is \"$EndElements\""},
      {"$EndElements", "$EndElement", "line 39: \"$EndElement\" stands where $EndElements has to"},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.message);
    test::expect_contains(test::refusal([&] { read(changed(c.from, c.to)); }), c.message);
  }
  test::expect_contains(test::refusal([&] { read(square + square.substr(square.find("$Nodes"))); }),
                        "$Nodes is given twice");
  test::expect_contains(test::refusal([&] { read(square.substr(0, square.find("$Elements"))); }),
                        "m.msh: has no section $Elements");
  test::expect_contains(
      test::refusal([&] { read(square.substr(0, square.find("$Nodes")) + square.substr(square.find("$Elements"))); }),
      "$Elements stands before $Nodes");
}

TEST(MshFileTest, NoTruncatedFileIsRead) {
  const std::size_t end = square.rfind("$EndElements") + std::string("$EndElements").size();
  for (std::size_t cut = 0; cut < end; ++cut) EXPECT_NE(test::refusal([&] { read(square.substr(0, cut)); }), "") << cut;
  EXPECT_EQ(test::refusal([&] { read(square.substr(0, end)); }), "");
}

}  // namespace
}  // namespace ixos
