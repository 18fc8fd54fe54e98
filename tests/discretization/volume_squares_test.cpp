#include "discretization/volume_squares.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>

#include "mesh/cell_order.hpp"
#include "mesh/generators/shapes.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

using test::model_of;

Mesh block(int dimension) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {3, 2, 1};
  shape.divisions = {4, 3, 2};
  return box(shape);
}

std::unique_ptr<Model> body(const Mesh& mesh) {
  return model_of(mesh, test::elastic(linear_elastic, 0.2), Inertia::Consistent);
}

/// Returns a function of the place by local node.
std::vector<double> nodal(const LocalMesh& mesh, const std::function<double(const double*)>& function) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> values;
  for (std::size_t node = 0; node < mesh.global_ids.size(); ++node)
    values.push_back(function(&mesh.coordinates[node * d]));
  return values;
}

double square(const Model& model, const std::vector<std::function<double(const double*)>>& functions) {
  std::vector<std::vector<double>> components;
  components.reserve(functions.size());
  for (const auto& function : functions) components.push_back(nodal(model.mesh(), function));
  double sum = nodal_square(model.mesh(), components);
  model.space().sum(&sum, 1);
  return sum;
}

double volume(const Model& model) {
  double sum = 0;
  for (const std::vector<double>& own : owned_volumes(model.mesh()))
    sum += std::accumulate(own.begin(), own.end(), 0.0);
  model.space().sum(&sum, 1);
  return sum;
}

// int x^2 dV = 9 A and int y^2 dV = 4/3 V in a box of 3 by 2.
TEST(VolumeSquaresTest, LinearFieldsAreExactInBoxes) {
  for (const int dimension : {2, 3}) {
    const auto model = body(block(dimension));
    EXPECT_NEAR(volume(*model), 6, 1e-13);
    EXPECT_NEAR(square(*model, {[](const double* x) { return x[0]; }, [](const double* x) { return x[1]; }}), 18 + 8,
                1e-12);
  }
}

// Two ranks share cells; those of the other rank must not count twice.
TEST(VolumeSquaresTest, OnlyOwnCellsCount) {
  const auto model = body(block(2));
  const LocalMesh& mesh = model->mesh();
  const auto volumes = owned_volumes(mesh);
  for (std::size_t cell = 0; cell < volumes[0].size(); ++cell)
    EXPECT_NEAR(volumes[0][cell], mesh.blocks[0].owned[cell] != 0 ? 0.5 : 0, 1e-14);
}

TEST(VolumeSquaresTest, QuadraticCellsHoldSquares) {
  Mesh mesh = block(2);
  raise_order(mesh);
  EXPECT_NEAR(square(*body(mesh), {[](const double* x) { return x[0] * x[0]; }}), std::pow(3, 5) / 5 * 2, 1e-11);
}

// A disk of radius 3 and height 2: int r^2 dV = 2 pi 3^4/4 2.
TEST(VolumeSquaresTest, RingsCountWhole) {
  Mesh mesh = block(2);
  mesh.axisymmetric = true;
  const auto model = body(mesh);
  EXPECT_NEAR(volume(*model), M_PI * 9 * 2, 1e-12);
  EXPECT_NEAR(square(*model, {[](const double* x) { return x[0]; }}), M_PI * 81, 1e-11);
}

// The shape functions of an enriched cell are a basis of the same linear fields; its mass is that of a plain one.
TEST(VolumeSquaresTest, EnrichedCellsKeepTheVolumeAndTheMass) {
  const auto model = test::box_with_contact(2, ContactElement::Q1C4);
  EXPECT_NEAR(volume(*model), 2, 1e-13);
  const Pattern& pattern = model->pattern();
  Mass mass(model->mesh(), pattern);
  for (const LocalBlock& own : model->mesh().blocks) mass.add_block(own, 1);
  const std::vector<double> u = test::smooth_field(*model, 0.3);
  std::vector<double> product(static_cast<std::size_t>(model->space().owned()));
  mass.multiply(u.data(), product.data());
  double expected = std::inner_product(product.begin(), product.end(), u.begin(), 0.0);
  model->space().sum(&expected, 1);
  std::vector<std::vector<double>> components(2);
  for (std::size_t i = 0; i < u.size(); ++i) components[i % 2].push_back(u[i]);
  double found = nodal_square(model->mesh(), components);
  model->space().sum(&found, 1);
  EXPECT_GT(found, 1e-3);
  EXPECT_NEAR(found, expected, 1e-12 * expected);
}

}  // namespace
}  // namespace ixos
