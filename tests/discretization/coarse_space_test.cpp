#include "discretization/coarse_space.hpp"

#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mesh/cell_order.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "mesh/refinement.hpp"
#include "mesh/selection.hpp"
#include "mesh/splitting/refine.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

LocalMesh part_of(const Mesh& mesh, const Comm& comm) {
  const int rank = comm->getRank(), ranks = comm->getSize();
  const std::vector<int> owner = partition_nodes(mesh, ranks);
  LocalMesh part = localize(mesh, owner, rank, ranks);
  add_coarse_cells(mesh, owner, rank, ranks, part);
  return part;
}

struct Kind {
  int dimension;
  bool quadratic;
};

/// A box of quadratic cells, 3 x 2 (x 2), or of linear ones with the same nodes, whose bottom is constrained along all
/// axes, the middle of an edge of the top along the first one.
struct Body {
  explicit Body(const Kind& kind) : comm(test::world()), mesh(part_of(whole(kind), comm)), space(mesh, comm) {
    const int dimension = kind.dimension;
    for (const int node : mesh.node_sets[mesh.node_set("bottom")])
      for (int i = 0; i < dimension; ++i) constrained.push_back(node * dimension + i);
    for (int node = 0; node < mesh.nodes(); ++node)
      if (place(node, 0) == 0.5 && place(node, 1) == 0 && place(node, dimension - 1) == height(dimension))
        constrained.push_back(node * dimension);
  }
  static double height(int dimension) { return dimension == 2 ? 0 : 2; }
  static Mesh whole(const Kind& kind) {
    BoxShape shape;
    shape.dimension = kind.dimension;
    shape.lengths = {3, 2, 2};
    shape.divisions = {6, 4, 4};
    if (kind.quadratic) shape.divisions = {3, 2, 2};
    Mesh mesh = box(shape);
    if (kind.quadratic) raise_order(mesh);
    return mesh;
  }
  double place(int node, int i) const { return mesh.coordinates[static_cast<std::size_t>(node * mesh.dimension + i)]; }
  /// A field of the place on a mesh's owned nodes.
  template <class Field>
  Vector field(const LocalMesh& on, const DofSpace& of, const Field& value) const {
    Vector result(of.owned_map());
    const auto view = result.getLocalViewHost(Tpetra::Access::OverwriteAll);
    const auto d = static_cast<std::size_t>(mesh.dimension);
    for (std::size_t i = 0; i < view.extent(0); ++i) {
      std::array<double, 3> x{};
      std::copy_n(&on.coordinates[i / d * d], d, x.begin());
      view(i, 0) = value(x, i % d);
    }
    return result;
  }

  Comm comm;
  LocalMesh mesh;
  DofSpace space;
  std::vector<int> constrained;
};

double wave(const std::array<double, 3>& x, std::size_t i) {
  return std::sin(1 + 1.7 * x[0] + 2.9 * x[1] - 0.8 * x[2] + 2.0 * static_cast<double>(i));
}
double other_wave(const std::array<double, 3>& x, std::size_t i) {
  return std::cos(2.3 * x[0] - x[1] + 3.1 * x[2] + static_cast<double>(i));
}
/// Linear along each axis.
double multilinear(const std::array<double, 3>& x, std::size_t i) {
  return (1 + 2 * x[0]) * (3 - x[1]) * (0.5 + x[2]) + static_cast<double>(i);
}

class CoarseSpaceTest : public testing::TestWithParam<Kind> {};

TEST_P(CoarseSpaceTest, HasTheCornersOnceEach) {
  const Body body(GetParam());
  const CoarseSpace coarse(body.mesh, body.space, {});
  EXPECT_EQ(coarse.mesh().global_nodes, GetParam().dimension == 2 ? 4 * 3 : 4 * 3 * 3);
  EXPECT_EQ(coarse.space().global(), coarse.mesh().global_nodes * GetParam().dimension);
  double owned = coarse.mesh().owned_nodes;
  coarse.space().sum(&owned, 1);
  EXPECT_EQ(owned, static_cast<double>(coarse.mesh().global_nodes));
  EXPECT_EQ(coarse.mesh().blocks[0].type, GetParam().dimension == 2 ? CellType::Quad4 : CellType::Hex8);
  for (int node = 0; node < body.mesh.nodes(); ++node)
    if (const int number = coarse.number(node); number >= 0) {
      EXPECT_EQ(number < coarse.mesh().owned_nodes, node < body.mesh.owned_nodes);
      for (int i = 0; i < GetParam().dimension; ++i)
        EXPECT_EQ(coarse.mesh().coordinates[static_cast<std::size_t>(number * GetParam().dimension + i)],
                  body.place(node, i));
    }
  // Ghosts carry their owners' numbers: a field of the place comes back from an exchange.
  std::vector<double> local(coarse.mesh().coordinates);
  coarse.space().update_ghosts(local.data());
  EXPECT_EQ(local, coarse.mesh().coordinates);
}

TEST_P(CoarseSpaceTest, ProlongatesMultilinearFieldsExactly) {
  const Body body(GetParam());
  const CoarseSpace coarse(body.mesh, body.space, {});
  Vector fine(body.space.owned_map());
  coarse.prolongate(body.field(coarse.mesh(), coarse.space(), multilinear), fine);
  fine.update(-1.0, body.field(body.mesh, body.space, multilinear), 1.0);
  EXPECT_LT(fine.normInf(), 1e-13);
}

// Nodes at the quarters of contact sides follow the linear cells too; a tied edge has none.
TEST(ContactCoarseSpaceTest, ProlongatesToContactSidesOfFourthOrder) {
  for (const int dimension : {2, 3}) {
    const Kind kind{dimension, true};
    Mesh whole = Body::whole(kind);
    add_side_set(whole, "patch", "bottom",
                 {{}, dimension == 2 ? std::vector<double>{2, 2} : std::vector<double>{2, 1.5, 2}});
    enrich(whole, "patch", ContactElement::Q2C4);
    bool is_tied = false;
    for (const ElementBlock& block : whole.blocks) is_tied = is_tied || block.tied != 0;
    EXPECT_EQ(is_tied, dimension == 3);
    const Comm comm = test::world();
    const LocalMesh mesh = part_of(whole, comm);
    const DofSpace space(mesh, comm);
    const CoarseSpace coarse(mesh, space, {});
    EXPECT_EQ(coarse.mesh().global_nodes, dimension == 2 ? 4 * 3 : 4 * 3 * 3);
    const Body body(kind);
    Vector fine(space.owned_map());
    coarse.prolongate(body.field(coarse.mesh(), coarse.space(), multilinear), fine);
    fine.update(-1.0, body.field(mesh, space, multilinear), 1.0);
    EXPECT_LT(fine.normInf(), 1e-13);
  }
}

// Linear cells conform where nodes of finer cells hang: what they prolongate is what the ties make of it.
TEST(HangingCoarseSpaceTest, IsConformingAndProlongatesMultilinearFieldsExactly) {
  for (const int dimension : {2, 3}) {
    const Kind kind{dimension, true};
    Mesh whole = Body::whole(kind);
    RefinedRegion region;
    region.upper.assign(static_cast<std::size_t>(dimension), 0.7);
    refine(whole, {{"corner", region}}, 2);
    const Comm comm = test::world();
    const LocalMesh mesh = part_of(whole, comm);
    const DofSpace space(mesh, comm);
    const CoarseSpace coarse(mesh, space, {});
    EXPECT_GT(coarse.mesh().global_tied, 0);
    Body body(kind);
    body.mesh = mesh;
    Vector fine(space.owned_map());
    coarse.prolongate(body.field(coarse.mesh(), coarse.space(), multilinear), fine);
    fine.update(-1.0, body.field(mesh, space, multilinear), 1.0);
    EXPECT_LT(fine.normInf(), 1e-13);
    Vector x = body.field(coarse.mesh(), coarse.space(), wave), y = body.field(mesh, space, other_wave);
    Vector px(space.owned_map()), pty(coarse.space().owned_map());
    coarse.prolongate(x, px);
    coarse.restrict_to_coarse(y, pty);
    EXPECT_NEAR(px.dot(y), x.dot(pty), 1e-13 * px.norm2() * y.norm2());
  }
}

TEST_P(CoarseSpaceTest, RestrictionIsTheTranspose) {
  const Body body(GetParam());
  const CoarseSpace coarse(body.mesh, body.space, body.constrained);
  const Vector x = body.field(coarse.mesh(), coarse.space(), wave), y = body.field(body.mesh, body.space, other_wave);
  Vector px(body.space.owned_map()), pty(coarse.space().owned_map());
  coarse.prolongate(x, px);
  coarse.restrict_to_coarse(y, pty);
  EXPECT_NEAR(px.dot(y), x.dot(pty), 1e-13 * px.norm2() * y.norm2());
  EXPECT_GT(px.norm2(), 1);
}

TEST_P(CoarseSpaceTest, MovesNoConstrainedDegreeOfFreedom) {
  const Body body(GetParam());
  const CoarseSpace coarse(body.mesh, body.space, body.constrained);
  Vector fine(body.space.owned_map());
  coarse.prolongate(body.field(coarse.mesh(), coarse.space(), wave), fine);
  const auto view = fine.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (const int dof : body.constrained)
    if (dof < body.space.owned()) {
      EXPECT_EQ(view(static_cast<std::size_t>(dof), 0), 0);
    }
  // Those of the bottom's corners, and both ends of the edge whose middle is held; in the plane that edge is of the
  // bottom.
  double left_out = 0;
  for (const int dof : coarse.left_out()) left_out += dof < coarse.space().owned() ? 1 : 0;
  coarse.space().sum(&left_out, 1);
  EXPECT_EQ(left_out, GetParam().dimension == 2 ? 4 * 2 : 4 * 3 * 3 + 2);
}

TEST_P(CoarseSpaceTest, DiagonalsHaveAGalerkinProduct) {
  const Body body(GetParam());
  const CoarseSpace coarse(body.mesh, body.space, body.constrained);
  const Vector diagonal = body.field(body.mesh, body.space, wave);
  std::vector<double> local(coarse.fine_local());
  body.space.import(diagonal, local.data());
  const auto matrix = coarse.matrix([&](double* values) { coarse.add_diagonal(local.data(), values); }, 7);
  Vector x = body.field(coarse.mesh(), coarse.space(), other_wave);
  Vector product(coarse.space().owned_map()), fine(body.space.owned_map()), expected(coarse.space().owned_map());
  matrix->apply(x, product);
  coarse.prolongate(x, fine);
  fine.elementWiseMultiply(1.0, diagonal, fine, 0.0);
  coarse.restrict_to_coarse(fine, expected);
  {
    const auto from = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto to = expected.getLocalViewHost(Tpetra::Access::ReadWrite);
    for (const int dof : coarse.left_out())
      if (dof < coarse.space().owned())
        to(static_cast<std::size_t>(dof), 0) = 7 * from(static_cast<std::size_t>(dof), 0);
  }
  expected.update(-1.0, product, 1.0);
  EXPECT_LT(expected.normInf(), 1e-14 * static_cast<double>(product.getGlobalLength()));
}

TEST(CoarseSpaceSerialTest, LinearCellsWithoutParentsHaveNone) {
  BoxShape shape;
  shape.divisions = {3, 2, 1};
  const LocalMesh mesh = part_of(box(shape), test::world());
  const DofSpace space(mesh, test::world());
  EXPECT_THROW(CoarseSpace(mesh, space, {}), std::logic_error);
}

INSTANTIATE_TEST_SUITE_P(Kinds, CoarseSpaceTest,
                         testing::Values(Kind{2, true}, Kind{3, true}, Kind{2, false}, Kind{3, false}));

}  // namespace
}  // namespace ixos
