// Matrices of fine cells on their coarse cells' corners: those of a lumped mass add up to P^T D P.
#include "term/galerkin_products.hpp"

#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include "fem/corner_element.hpp"
#include "fem/reference_elements.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "mesh/refinement.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

static_assert(is_linear_element<Line2> && is_linear_element<Quad4> && is_linear_element<Hex8>);

TEST(GalerkinProductTest, HasTheProlongationOnBothSides) {
  constexpr std::size_t N = 4, M = 2;
  Prolongation<N> prolongation;
  Small<Pack, N * M> k;
  for (std::size_t a = 0; a < N; ++a)
    for (std::size_t p = 0; p < N; ++p) prolongation[a][p] = 1.0 + static_cast<double>(3 * a + 5 * p % 7);
  for (std::size_t r = 0; r < N * M; ++r)
    for (std::size_t c = 0; c < N * M; ++c) k[r][c] = static_cast<double>(2 * r + c * c) - 3.0;
  const auto found = galerkin_product<N, M>(prolongation, k);
  for (std::size_t r = 0; r < N * M; ++r)
    for (std::size_t c = 0; c < N * M; ++c) {
      double sum = 0;
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t e = 0; e < N; ++e)
          sum += prolongation[a][r / M][0] * k[a * M + r % M][e * M + c % M][0] * prolongation[e][c / M][0];
      EXPECT_EQ(found[r][c][0], sum);
    }
}

template <std::size_t N, std::size_t D>
void expect_lumped_mass() {
  const Comm comm = test::world();
  BoxShape shape;
  shape.dimension = static_cast<int>(D);
  shape.divisions = {4, 6, 4};
  const Mesh mesh = box(shape);
  const std::vector<int> owner = partition_nodes(mesh, comm->getSize());
  LocalMesh part = localize(mesh, owner, comm->getRank(), comm->getSize());
  add_coarse_cells(mesh, owner, comm->getRank(), comm->getSize(), part);
  const DofSpace space(part, comm);
  const CoarseSpace coarse(part, space, {});
  const LocalBlock& block = part.blocks.front();
  const ElementBatches<N, D> batches(block.nodes, Pattern(part));
  // Each cell adds 1 + its number in the mesh to the diagonal entries of its nodes.
  std::vector<double> diagonal(static_cast<std::size_t>(space.local()), 0.0);
  const auto weight = [&](std::size_t cell) { return 1.0 + block.original_cells[cell]; };
  for (std::size_t cell = 0; cell < block.owned.size(); ++cell)
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t i = 0; i < D; ++i)
        diagonal[static_cast<std::size_t>(block.nodes[cell * N + a]) * D + i] += weight(cell);
  space.update_ghosts(diagonal.data());
  const auto expected = coarse.matrix([&](double* values) { coarse.add_diagonal(diagonal.data(), values); }, 1);
  const auto number = [](std::size_t b, std::size_t lane) { return b * ElementBatches<N, D>::width + lane; };
  const auto owned = [&](std::size_t b) {
    return Pack([&](auto lane) { return lane < batches.lanes(b) && block.owned[number(b, lane)] != 0 ? 1.0 : 0.0; });
  };
  const auto set = [&](std::size_t b, const Prolongation<N>& prolongation, Small<Pack, N * D>& k) {
    Small<Pack, N * D> own{};
    for (std::size_t r = 0; r < N * D; ++r)
      own[r][r] = Pack([&](auto lane) { return lane < batches.lanes(b) ? weight(number(b, lane)) : 0.0; });
    k = galerkin_product<N, D>(prolongation, own);
  };
  const auto found =
      coarse.matrix([&](double* values) { add_galerkin_products(batches, coarse, owned, set, values); }, 1);
  Vector x(found->getDomainMap()), y(found->getRangeMap());
  x.randomize();
  expected->apply(x, y);
  const double scale = y.normInf();
  found->apply(x, y, Teuchos::NO_TRANS, -1.0, 1.0);
  EXPECT_GT(scale, 1);
  EXPECT_LT(y.normInf(), 1e-13 * scale);
}

TEST(GalerkinProductsTest, ALumpedMassIsTheGalerkinProductOfItsDiagonal) {
  expect_lumped_mass<4, 2>();
  expect_lumped_mass<8, 3>();
}

}  // namespace
}  // namespace ixos
