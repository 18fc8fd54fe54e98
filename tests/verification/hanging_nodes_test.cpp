// Bodies with hanging nodes: affine motions, conservation, solvers and ranks.
#include <gtest/gtest.h>

#include <cmath>

#include "mesh/cell_order.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/selection.hpp"
#include "mesh/splitting/refine.hpp"
#include "mesh/tied_nodes.hpp"
#include "support/contact_element.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"
#include "support/tied_bodies.hpp"
#include "time/integrator.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

/// A box of 3 by 3 (by 3) cells, those in a corner of the bottom split twice, those in the middle once, and some in one
/// direction; inner nodes that are not tied are moved off the grid.
Mesh refined_box(int dimension, ContactElement element, bool distorted = true) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {3, 3, 3};
  shape.divisions = {3, 3, 3};
  Mesh mesh = box(shape);
  if (test::is_of_quadratic_cells(element)) raise_order(mesh);
  RefinedRegion corner, middle, film;
  corner.levels = 2;
  corner.lower.assign(static_cast<std::size_t>(dimension), -1);
  corner.upper.assign(static_cast<std::size_t>(dimension), 0.3);
  middle.lower.assign(static_cast<std::size_t>(dimension), 1.4);
  middle.upper.assign(static_cast<std::size_t>(dimension), 1.6);
  film.directions = "x";
  film.lower.assign(static_cast<std::size_t>(dimension), 2.4);
  refine(mesh, {{"corner", corner}, {"middle", middle}, {"film", film}}, test::is_of_quadratic_cells(element) ? 2 : 1);
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t n = 0; n < static_cast<std::size_t>(mesh.nodes()) && distorted; ++n) {
    bool inside = true;
    for (std::size_t i = 0; i < d; ++i)
      inside = inside && mesh.coordinates[n * d + i] > 1e-9 && mesh.coordinates[n * d + i] < 3 - 1e-9;
    for (std::size_t i = 0; i < d && inside; ++i)
      mesh.coordinates[n * d + i] += 0.03 * std::sin(7.0 * static_cast<double>(n) + 2.0 * static_cast<double>(i));
  }
  place_tied_nodes(mesh);
  enrich(mesh, "bottom", element);
  return mesh;
}

void run_patch(int dimension, const Table& table, ContactElement element, Formulation formulation, bool matrix_free) {
  Material rubber = test::elastic(neo_hooke, 0.3);
  rubber.formulation = formulation;
  test::expect_affine_motion(refined_box(dimension, element), rubber, "surface", table, matrix_free);
}

TEST(HangingNodesTest, AffineMotionsAreReproduced) {
  for (const ContactElement element :
       {ContactElement::Q1C1, ContactElement::Q1C2, ContactElement::Q1C4, ContactElement::Q2C2, ContactElement::Q2C4}) {
    SCOPED_TRACE(static_cast<int>(element));
    run_patch(2, newmark(0.25, 0.5), element, Formulation::Standard, false);
    run_patch(2, average_vector_field(4, 8), element, Formulation::Standard, false);
    run_patch(3, average_vector_field(4, 8), element, Formulation::Standard, false);
  }
  run_patch(2, energy_momentum(), ContactElement::Q1C1, Formulation::Standard, false);
}

TEST(HangingNodesTest, AffineMotionsAreReproducedByFormulationsAgainstLocking) {
  for (const int dimension : {2, 3}) {
    run_patch(dimension, newmark(0.25, 0.5), ContactElement::Q1C1, Formulation::Enhanced, false);
    run_patch(dimension, newmark(0.25, 0.5), ContactElement::Q1C1, Formulation::MeanDilatation, false);
  }
}

TEST(HangingNodesTest, AffineMotionsAreReproducedMatrixFree) {
  for (const int dimension : {2, 3})
    for (const ContactElement element : {ContactElement::Q1C1, ContactElement::Q2C2})
      run_patch(dimension, newmark(0.25, 0.5), element, Formulation::Standard, true);
}

void expect_conserved(int dimension, ContactElement element, const Table& table, int steps, double tolerance,
                      bool angular = true) {
  test::expect_conserved(refined_box(dimension, element), table, steps, tolerance, angular);
}

TEST(HangingNodesTest, EnergyMomentumConservesBothMomentaAndEnergy) {
  expect_conserved(2, ContactElement::Q1C1, energy_momentum(), 50, 1e-9);
  expect_conserved(2, ContactElement::Q2C2, energy_momentum(), 20, 1e-9);
  expect_conserved(3, ContactElement::Q1C1, energy_momentum(), 5, 1e-9);
}

/// The squared error of a harmonic displacement on a mesh with a refined corner.
double squared_error(int dimension, int order, int halvings) {
  BoxShape shape;
  shape.dimension = dimension;
  const int n = 2 << halvings;
  shape.divisions = {n, n, n};
  Mesh mesh = box(shape);
  if (order == 2) raise_order(mesh);
  RefinedRegion corner;  // one level: with more, the coarsest mesh has hardly a coarse cell left
  corner.lower.assign(static_cast<std::size_t>(dimension), 0.6);
  refine(mesh, {{"corner", corner}}, order);
  return test::squared_error(mesh, test::harmonic(dimension));
}

TEST(HangingNodesTest, ErrorsFallWithTheOrderOfTheCells) {
  for (const int dimension : {2, 3})
    for (const int order : {1, 2}) {
      const int first = dimension == 2 ? 1 : 0;
      const double coarse = squared_error(dimension, order, first), fine = squared_error(dimension, order, first + 1);
      EXPECT_GT(std::log2(coarse / fine) / 2, order + 0.75) << dimension << "D, order " << order;
    }
}

TEST(HangingNodesLongTest, EnergyAndMomentaLast) {
  expect_conserved(2, ContactElement::Q1C1, energy_momentum(), 10000, 1e-9);
  expect_conserved(2, ContactElement::Q2C2, energy_momentum(), 10000, 1e-9);
  expect_conserved(2, ContactElement::Q1C1, average_vector_field(4, 8), 10000, 1e-7, false);
}

}  // namespace
}  // namespace ixos
