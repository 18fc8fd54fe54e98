#include "discretization/dof_space.hpp"

#include <gtest/gtest.h>

#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <limits>

#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

struct Part {
  explicit Part(const Mesh& whole)
      : comm(test::world()),
        mesh(localize(whole, partition_nodes(whole, comm->getSize()), comm->getRank(), comm->getSize())),
        space(mesh, comm) {}

  /// A number for each degree of freedom of the whole mesh: every rank knows those of its local nodes.
  std::vector<double> field(double factor) const {
    std::vector<double> values;
    for (int node : mesh.original_ids)
      for (int d = 0; d < mesh.dimension; ++d) values.push_back(factor * (10 * node + d + 1));
    return values;
  }
  std::size_t owned() const { return static_cast<std::size_t>(space.owned()); }

  Comm comm;
  LocalMesh mesh;
  DofSpace space;
};

/// A plane grid, one in space, and a single cell, which leaves ranks without nodes if there are many.
std::vector<Mesh> meshes() {
  std::vector<Mesh> all;
  for (const auto& [dimension, divisions] :
       {std::pair{2, std::array<int, 3>{4, 3, 1}}, std::pair{3, std::array<int, 3>{3, 2, 2}},
        std::pair{2, std::array<int, 3>{1, 1, 1}}}) {
    BoxShape shape;
    shape.dimension = dimension;
    shape.divisions = divisions;
    all.push_back(box(shape));
  }
  return all;
}

TEST(DofSpaceTest, EachDegreeOfFreedomIsOwnedOnce) {
  for (const Mesh& mesh : meshes()) {
    const Part part(mesh);
    EXPECT_EQ(part.space.dimension(), mesh.dimension);
    EXPECT_EQ(part.space.global(), mesh.nodes() * mesh.dimension);
    double counts[] = {1.0 * part.space.owned(), 1.0 * (part.space.local() - part.space.owned())};
    part.space.sum(counts, 2);
    EXPECT_EQ(counts[0], mesh.nodes() * mesh.dimension);
    EXPECT_EQ(counts[1] > 0, part.comm->getSize() > 1);  // ghosts
  }
}

TEST(DofSpaceTest, MapsNumberTheDegreesOfFreedomOfEachNodeInSequence) {
  for (const Mesh& mesh : meshes()) {
    const Part part(mesh);
    EXPECT_TRUE(part.space.owned_map()->isOneToOne());
    EXPECT_FALSE(part.space.owned_map()->isNodeLocalElement(part.space.owned()));
    EXPECT_FALSE(part.space.local_map()->isNodeLocalElement(part.space.local()));
    for (int i = 0; i < part.space.local(); ++i) {
      const GlobalId id =
          part.mesh.global_ids[static_cast<std::size_t>(i / mesh.dimension)] * mesh.dimension + i % mesh.dimension;
      EXPECT_EQ(part.space.local_map()->getGlobalElement(i), id);
      if (i < part.space.owned()) {
        EXPECT_EQ(part.space.owned_map()->getGlobalElement(i), id);
      }
    }
  }
}

TEST(DofSpaceTest, ImportBringsTheOwnersValues) {
  for (const Mesh& mesh : meshes()) {
    const Part part(mesh);
    // Twice: the second import must leave nothing of the first.
    for (double factor : {1.0, -3.0}) {
      const std::vector<double> expected = part.field(factor);
      Vector owned(part.space.owned_map());
      {
        const auto view = owned.getLocalViewHost(Tpetra::Access::OverwriteAll);
        std::copy_n(expected.begin(), part.owned(), view.data());
      }
      std::vector<double> local(expected.size(), not_a_number);
      part.space.import(owned, local.data());
      EXPECT_EQ(local, expected);
    }
  }
}

TEST(DofSpaceTest, GhostsAreReplacedByTheOwnersValues) {
  for (const Mesh& mesh : meshes()) {
    const Part part(mesh);
    const std::vector<double> expected = part.field(2.0);
    std::vector<double> local = expected;
    std::fill(local.begin() + static_cast<std::ptrdiff_t>(part.owned()), local.end(), not_a_number);
    part.space.update_ghosts(local.data());
    EXPECT_EQ(local, expected);
  }
}

TEST(DofSpaceTest, ReductionsRunOverAllRanks) {
  const Part part(meshes().front());
  const int rank = part.comm->getRank(), ranks = part.comm->getSize();
  double values[] = {1.0, rank + 1.0, -7.0};
  part.space.sum(values, 2);
  EXPECT_EQ(values[0], ranks);
  EXPECT_EQ(values[1], ranks * (ranks + 1) / 2);
  EXPECT_EQ(values[2], -7.0);  // not among the two
  EXPECT_EQ(part.space.minimum(3.0 - rank), 4.0 - ranks);
  EXPECT_EQ(part.space.minimum(3.0 + rank), 3.0);
  EXPECT_EQ(part.space.maximum(-3.0 + rank), ranks - 4.0);
  EXPECT_EQ(part.space.maximum(-3.0 - rank), -3.0);
}

}  // namespace
}  // namespace ixos
