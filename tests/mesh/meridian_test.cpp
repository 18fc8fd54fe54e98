// Nodes on the axis. tests/model/axis_test.cpp has meshes beyond the axis.
#include "mesh/meridian.hpp"

#include <gtest/gtest.h>

#include "mesh/generators/shapes.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

constexpr double off = 7e-9;

/// A disk of a radius of 100 whose innermost nodes are beside the axis by less than 1e-10 of it.
Mesh disk() {
  BoxShape shape;
  shape.lengths = {100, 1, 0};
  shape.divisions = {100, 1, 1};
  Mesh mesh = box(shape);
  mesh.axisymmetric = true;
  for (std::size_t k = 0; k < mesh.coordinates.size(); k += 2)
    if (mesh.coordinates[k] == 0) mesh.coordinates[k] = off;
  return mesh;
}

/// The first rank has radii up to 50, and one ghost beyond.
std::vector<int> halves(const Mesh& mesh) {
  std::vector<int> owner;
  for (std::size_t k = 0; k < mesh.coordinates.size(); k += 2) owner.push_back(mesh.coordinates[k] > 50 ? 1 : 0);
  return owner;
}

TEST(MeridianTest, EachRankKnowsTheLargestRadiusOfTheMesh) {
  const Mesh mesh = disk();
  EXPECT_EQ(largest_radius(mesh), 100);
  for (const int rank : {0, 1}) {
    const LocalMesh part = localize(mesh, halves(mesh), rank, 2);
    EXPECT_EQ(part.largest_radius, 100);
    const std::vector<bool> on_axis = nodes_on_axis(part);
    ASSERT_EQ(on_axis.size(), static_cast<std::size_t>(part.nodes()));
    int count = 0;
    for (std::size_t node = 0; node < on_axis.size(); ++node) {
      EXPECT_EQ(on_axis[node], part.coordinates[2 * node] < 0.5) << part.coordinates[2 * node];
      count += on_axis[node] ? 1 : 0;
    }
    EXPECT_EQ(count, rank == 0 ? 2 : 0);
  }
}

TEST(MeridianTest, OtherMeshesHaveNoAxis) {
  Mesh mesh = disk();
  mesh.axisymmetric = false;
  EXPECT_EQ(largest_radius(mesh), 0);
  EXPECT_TRUE(nodes_on_axis(localize(mesh, halves(mesh), 0, 2)).empty());
}

// A program gives each rank a ring of its own: the last one has the largest radius.
TEST(MeridianTest, ADistributedMeshHasOneLargestRadius) {
  const Comm comm = test::world();
  const int rank = comm->getRank(), ranks = comm->getSize();
  DistributedMesh mesh;
  mesh.axisymmetric = true;
  mesh.blocks.push_back({"ring", {}});
  for (const int column : {0, 1}) {
    if (column == 0 && rank > 0) continue;  // that of the rank before
    for (const int row : {0, 1}) {
      mesh.nodes.push_back(2LL * (rank + column) + row);
      mesh.coordinates.insert(mesh.coordinates.end(),
                              {rank + column == 0 ? 0.7e-10 * ranks : rank + column, 1.0 * row});
    }
  }
  const long long first = 2LL * rank;
  mesh.blocks[0].nodes = {first, first + 2, first + 3, first + 1};
  const LocalMesh part = local_part(mesh, comm);
  EXPECT_EQ(part.largest_radius, ranks);
  const std::vector<bool> on_axis = nodes_on_axis(part);
  for (std::size_t node = 0; node < on_axis.size(); ++node)
    EXPECT_EQ(on_axis[node], part.coordinates[2 * node] < 0.5) << part.coordinates[2 * node];
}

}  // namespace
}  // namespace ixos
