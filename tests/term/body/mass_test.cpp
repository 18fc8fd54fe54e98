#include "term/body/mass.hpp"

#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "discretization/nodal_measure.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "mesh/quality.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

/// Returns a box of 3 by 2 (by 1), sheared along x: its cells are parallelepipeds.
Mesh sheared(int dimension) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {3, 2, 1};
  shape.divisions = {4, 3, 2};
  Mesh mesh = box(shape);
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t i = 0; i < mesh.coordinates.size(); i += d) mesh.coordinates[i] += 0.3 * mesh.coordinates[i + 1];
  return mesh;
}

std::unique_ptr<Model> body(int dimension, Inertia inertia, int order = 1) {
  Material material = test::elastic(linear_elastic, 0.2);
  material.density = 0.7;
  Mesh mesh = sheared(dimension);
  if (order == 2) raise_order(mesh);
  return test::model_of(mesh, material, inertia);
}

/// Returns a smooth field of the place, so that ghosts agree with their owners.
std::vector<double> wave(const Model& model) {
  std::vector<double> field = test::at_rest(model);
  for (std::size_t i = 0; i < field.size(); ++i) field[i] = std::sin(1.3 * model.mesh().coordinates[i]) + 2;
  return field;
}

std::vector<double> product(const Model& model, const std::vector<double>& x) {
  std::vector<double> y(static_cast<std::size_t>(model.space().owned()));
  model.mass()->multiply(x.data(), y.data());
  return y;
}

// rho A/36 [4 2 1 2] by the distance round the rectangle, and nothing between directions.
TEST(MassSerialTest, ElementMatrixOfARectangle) {
  BoxShape shape;
  shape.lengths = {3, 2, 0};
  const Mesh mesh = box(shape);
  const LocalMesh local = localize(mesh, partition_nodes(mesh, 1), 0, 1);
  const Pattern pattern(local);
  Mass mass(local, pattern);
  mass.add_block(local.blocks[0], 0.5);
  const double around[] = {4, 2, 1, 2};
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t i = 0; i < 2; ++i) {
      const auto corner = [&](std::size_t b) { return 2 * static_cast<std::size_t>(local.blocks[0].nodes[b]); };
      std::vector<double> x(8, 0.0), y(8, 9.0), diagonal(8, 1.0);
      x[corner(a) + i] = 1;
      mass.multiply(x.data(), y.data());
      for (std::size_t b = 0; b < 4; ++b) {
        EXPECT_NEAR(y[corner(b) + i], 0.5 * 6 / 36 * around[(b + 4 - a) % 4], 1e-15);
        EXPECT_EQ(y[corner(b) + 1 - i], 0);
      }
      mass.add_diagonal(2.0, diagonal.data());
      EXPECT_NEAR(diagonal[corner(a) + i], 1 + 2 * y[corner(a) + i], 1e-15);
    }
}

TEST(MassTest, SumsToTheMassOfTheBodyAndItsFirstMoment) {
  for (const auto& [inertia, order] : {std::pair{Inertia::Consistent, 1}, std::pair{Inertia::Lumped, 1},
                                       std::pair{Inertia::Consistent, 2}, std::pair{Inertia::Lumped, 2}})
    for (int dimension : {2, 3}) {
      const auto model = body(dimension, inertia, order);
      const auto d = static_cast<std::size_t>(dimension);
      const std::vector<double> y = product(*model, std::vector<double>(test::at_rest(*model).size(), 1.0));
      double sums[3] = {};  // of direction x: the mass, and its moments along x and y
      for (std::size_t i = 0; i < y.size(); i += d) {
        sums[0] += y[i];
        for (std::size_t k = 0; k < 2; ++k) sums[1 + k] += y[i] * model->mesh().coordinates[i + k];
      }
      model->space().sum(sums, 3);
      EXPECT_NEAR(sums[0], 0.7 * 6, 1e-13);
      EXPECT_NEAR(sums[1], 0.7 * 6 * (1.5 + 0.3), 1e-13);
      EXPECT_NEAR(sums[2], 0.7 * 6 * 1.0, 1e-13);
    }
}

TEST(MassTest, LumpedMassesAreRowSumsAndDivideBack) {
  for (const auto& [dimension, order] : {std::pair{2, 1}, std::pair{3, 1}, std::pair{2, 2}, std::pair{3, 2}}) {
    const auto consistent = body(dimension, Inertia::Consistent, order);
    const auto lumped = body(dimension, Inertia::Lumped, order);
    EXPECT_FALSE(consistent->mass()->is_lumped());
    EXPECT_TRUE(lumped->mass()->is_lumped());
    const std::vector<double> x = wave(*lumped), ones(x.size(), 1.0);
    const std::vector<double> rows = product(*consistent, ones), y = product(*lumped, x);
    std::vector<double> diagonal(rows.size(), 0.0), back(rows.size());
    lumped->mass()->add_diagonal(1.0, diagonal.data());
    lumped->mass()->divide(y.data(), back.data());
    double largest = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_NEAR(diagonal[i], rows[i], 1e-15);
      EXPECT_NEAR(back[i], x[i], 1e-15 * std::abs(x[i]));
      largest = std::max(largest, x[i]);
    }
    EXPECT_NEAR(lumped->mass()->largest_quotient(y.data()), largest, 1e-14);
  }
}

// rho A/36 by the products of Simpson's weights 1, 4, 1.
TEST(MassSerialTest, LumpedMassesOfAQuadraticRectangleAreSimpsons) {
  BoxShape shape;
  shape.lengths = {3, 2, 0};
  Mesh mesh = box(shape);
  raise_order(mesh);
  const LocalMesh local = localize(mesh, partition_nodes(mesh, 1), 0, 1);
  const Pattern pattern(local);
  Mass mass(local, pattern, true);
  mass.add_block(local.blocks[0], 0.5);
  std::vector<double> diagonal(18, 0.0);
  mass.add_diagonal(1.0, diagonal.data());
  for (std::size_t a = 0; a < 9; ++a)
    EXPECT_NEAR(diagonal[2 * static_cast<std::size_t>(local.blocks[0].nodes[a])],
                0.5 * 6 / 36 *
                    (a < 4   ? 1
                     : a < 8 ? 4
                             : 16),
                1e-15);
}

/// Expects positive lumped masses on quadratic cells whose sum is the density times the volume.
void expect_lumped(const Mesh& mesh, double volume) {
  Material material = test::elastic(linear_elastic, 0.2);
  material.density = 0.7;
  const auto model = test::model_of(mesh, material, Inertia::Lumped);
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> diagonal(static_cast<std::size_t>(model->space().owned()), 0.0);
  model->mass()->add_diagonal(1.0, diagonal.data());
  double sum = 0;
  for (std::size_t i = 0; i < diagonal.size(); i += d) {
    EXPECT_GT(diagonal[i], 0.0);
    sum += diagonal[i];
  }
  model->space().sum(&sum, 1);
  EXPECT_NEAR(sum, 0.7 * volume, 1e-12 * volume);
}

TEST(MassTest, LumpedMassesOfCurvedQuadraticCellsArePositive) {
  DiskShape shape;
  shape.cell_order = 2;
  shape.core_divisions = 2;
  expect_lumped(disk(shape), mesh_quality(disk(shape)).volume);
  shape.half = true;
  Mesh ball = disk(shape);
  ball.axisymmetric = true;
  // The volume by the nodal measure, which takes other sums.
  const LocalMesh whole = localize(ball, partition_nodes(ball, 1), 0, 1);
  std::vector<double> measure(static_cast<std::size_t>(whole.nodes()), 0.0);
  add_block_measure(whole, whole.blocks[0], measure);
  expect_lumped(ball, std::accumulate(measure.begin(), measure.end(), 0.0));
  Mesh mesh = sheared(3);
  raise_order(mesh);
  for (std::size_t i = 3 * static_cast<std::size_t>(mesh.linear_nodes); i < mesh.coordinates.size(); ++i)
    mesh.coordinates[i] += 0.04 * std::sin(7.0 * static_cast<double>(i));
  expect_lumped(mesh, mesh_quality(mesh).volume);
}

TEST(MassTest, TheMatrixMultipliesAlike) {
  for (Inertia inertia : {Inertia::Consistent, Inertia::Lumped}) {
    const auto model = body(3, inertia);
    const auto matrix = model->pattern().create_matrix(model->space());
    model->mass()->add_to(3.0, matrix->getLocalMatrixHost().values.data());
    const std::vector<double> x = wave(*model), y = product(*model, x);
    Vector argument(model->space().owned_map()), image(model->space().owned_map());
    for (std::size_t i = 0; i < y.size(); ++i) argument.replaceLocalValue(static_cast<LocalId>(i), x[i]);
    matrix->apply(argument, image);
    const auto view = image.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(view(i, 0), 3 * y[i], 1e-14);
    const auto values = matrix->getLocalMatrixHost().values;
    std::vector<double> set(values.extent(0), 99.0);
    model->mass()->set(3.0, set.data());
    for (std::size_t i = 0; i < set.size(); ++i) EXPECT_EQ(set[i], values(i));
  }
}

TEST(MassSerialTest, HermiteElementsCannotBeLumped) {
  Mesh mesh = sheared(2);
  enrich(mesh, "bottom", ContactElement::Q1CH);
  const LocalMesh local = localize(mesh, partition_nodes(mesh, 1), 0, 1);
  const Pattern pattern(local);
  Mass mass(local, pattern, true);
  EXPECT_THROW(
      {
        for (const LocalBlock& block : local.blocks) mass.add_block(block, 1.0);
      },
      InputError);
}

}  // namespace
}  // namespace ixos
