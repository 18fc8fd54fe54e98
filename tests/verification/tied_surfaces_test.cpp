// Bodies of two meshes that are tied: affine motions, conservation, stiffness.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/cell_order.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/joined_parts.hpp"
#include "mesh/merged_parts.hpp"
#include "mesh/mortar/tied_surfaces.hpp"
#include "mesh/splitting/refine.hpp"
#include "support/contact_element.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"
#include "support/tied_bodies.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

Mesh tied_boxes(int dimension, ContactElement element, const std::string& enriched = "lower_bottom") {
  Mesh mesh = test::stacked_boxes(dimension, test::is_of_quadratic_cells(element) ? 2 : 1);
  tie_surfaces(mesh, "upper_bottom", "lower_top", 0);
  enrich(mesh, enriched, element);
  return mesh;
}

TEST(TiedSurfacesTest, AffineMotionsPass) {
  const Material rubber = test::elastic(neo_hooke, 0.3);
  for (const int dimension : {2, 3})
    for (const ContactElement element : {ContactElement::Q1C1, ContactElement::Q2C2}) {
      SCOPED_TRACE(static_cast<int>(element));
      const Mesh mesh = tied_boxes(dimension, element);
      test::expect_affine_motion(mesh, rubber, "outer", average_vector_field(4, 8), false);
      test::expect_affine_motion(mesh, rubber, "outer", newmark(0.25, 0.5), true);
    }
  test::expect_affine_motion(tied_boxes(2, ContactElement::Q1C1), rubber, "outer", energy_momentum(), false);
}

TEST(TiedSurfacesTest, AffineMotionsPassBetweenTriangles) {
  for (const test::StackedCells& cells : test::stacked_triangles()) {
    SCOPED_TRACE(cells.lower + " below " + cells.upper + ", order " + std::to_string(cells.order));
    Material rubber = test::elastic(neo_hooke, 0.3);
    if (cells.bubbles) rubber.formulation = Formulation::MeanDilatation;
    Mesh mesh = test::stacked_boxes(cells);
    tie_surfaces(mesh, "upper_bottom", "lower_top", 0);
    test::expect_affine_motion(mesh, rubber, "outer", newmark(0.25, 0.5), !cells.bubbles);
  }
}

TEST(TiedSurfacesTest, AffineMotionsPassByFormulationsAgainstLocking) {
  for (const Formulation formulation : {Formulation::Enhanced, Formulation::MeanDilatation}) {
    Material rubber = test::elastic(neo_hooke, 0.3);
    rubber.formulation = formulation;
    for (const int dimension : {2, 3})
      test::expect_affine_motion(tied_boxes(dimension, ContactElement::Q1C1), rubber, "outer", newmark(0.25, 0.5),
                                 false);
  }
}

TEST(TiedSurfacesTest, AffineMotionsPassBesideEnrichedSides) {
  const Material rubber = test::elastic(neo_hooke, 0.3);
  for (const char* side : {"lower_left", "upper_left"})
    for (const ContactElement element : {ContactElement::Q1C2, ContactElement::Q1C4, ContactElement::Q2C4}) {
      SCOPED_TRACE(side);
      for (const int dimension : {2, 3})
        test::expect_affine_motion(tied_boxes(dimension, element, side), rubber, "outer", newmark(0.25, 0.5), false);
    }
}

TEST(TiedSurfacesTest, EnergyMomentumConservesBothMomentaAndEnergy) {
  test::expect_conserved(tied_boxes(2, ContactElement::Q1C1), energy_momentum(), 50, 1e-9, true);
  test::expect_conserved(tied_boxes(2, ContactElement::Q2C2), energy_momentum(), 20, 1e-9, true);
  test::expect_conserved(tied_boxes(3, ContactElement::Q1C1), energy_momentum(), 5, 1e-9, true);
}

/// Two boxes, one upon the other; the upper one has `upper` divisions along the joint.
Mesh boxes_of(int dimension, int order, int lower, int upper, bool tied) {
  const auto up = static_cast<std::size_t>(dimension - 1);
  std::vector<MeshPart> parts;
  for (const int divisions : {lower, upper}) {
    BoxShape shape;
    shape.dimension = dimension;
    shape.divisions.fill(divisions);
    shape.divisions[up] = std::max(divisions / 2, 1);
    shape.lengths[up] = 0.5;
    shape.lower[up] = parts.empty() ? 0 : 0.5;
    parts.push_back({parts.empty() ? "lower" : "upper", box(shape)});
    if (order == 2) raise_order(parts.back().mesh);
  }
  Mesh mesh = joined_parts(parts);
  if (tied)
    tie_surfaces(mesh, "upper_bottom", "lower_top", 0);
  else
    merge_parts(parts, 1e-9, mesh);
  for (ElementBlock& block : mesh.blocks) block.name = "body";
  return mesh;
}

/// The squared error of a displacement on boxes_of().
double squared_error(int dimension, int order, int lower, int upper, bool tied, const test::Displacement& exact) {
  return test::squared_error(boxes_of(dimension, order, lower, upper, tied), exact);
}

TEST(TiedSurfacesTest, ErrorsFallWithTheOrderOfTheCells) {
  for (const int dimension : {2, 3})
    for (const int order : {1, 2})
      for (const auto& [lower, upper] : {std::pair{2, 3}, {3, 2}}) {
        const int finer = dimension == 2 ? 4 : 2;
        const double coarse = squared_error(dimension, order, finer / 2 * lower, finer / 2 * upper, true,
                                            test::harmonic(dimension)),
                     fine =
                         squared_error(dimension, order, finer * lower, finer * upper, true, test::harmonic(dimension));
        EXPECT_GT(std::log2(coarse / fine) / 2, order + 0.7)
            << dimension << "D, order " << order << ", " << lower << " to " << upper;
      }
}

TEST(TiedSurfacesTest, CellsOfVeryDifferentSizesPassAffineMotions) {
  const auto affine = [](const double* x, std::size_t i) { return i == 0 ? 0.1 * x[1] - 0.2 * x[0] : 0.3 * x[0]; };
  for (const auto& [lower, upper] : {std::pair{2, 100}, {100, 2}, {3, 7}, {64, 61}})
    EXPECT_LT(squared_error(2, 1, lower, upper, true, affine), 1e-20) << lower << " to " << upper;
  for (const auto& [lower, upper] : {std::pair{2, 16}, {16, 2}})
    EXPECT_LT(squared_error(3, 1, lower, upper, true, affine), 1e-20) << lower << " to " << upper;
}

TEST(TiedSurfacesTest, MatchingMeshesAreOne) {
  for (const int dimension : {2, 3})
    for (const int order : {1, 2}) {
      const double merged = squared_error(dimension, order, 3, 3, false, test::harmonic(dimension));
      EXPECT_NEAR(squared_error(dimension, order, 3, 3, true, test::harmonic(dimension)) / merged, 1, 1e-9)
          << dimension << "D, order " << order;
    }
}

/// Two tied boxes, the lower one with hanging nodes away from the joint.
Mesh refined_and_tied(int dimension, int order) {
  Mesh mesh = test::stacked_boxes(dimension, order);
  RefinedRegion corner;
  corner.upper.assign(static_cast<std::size_t>(dimension), 0.3);
  refine(mesh, {{"corner", corner}}, order);
  tie_surfaces(mesh, "upper_bottom", "lower_top", 0);
  return mesh;
}

TEST(TiedSurfacesTest, ABodyWithHangingNodesAndATiedPartKeepsBothMomentaAndEnergy) {
  for (const int order : {1, 2}) test::expect_conserved(refined_and_tied(2, order), energy_momentum(), 20, 1e-9, true);
  test::expect_conserved(refined_and_tied(3, 1), energy_momentum(), 3, 1e-9, true);
}

TEST(TiedSurfacesLongTest, EnergyAndMomentaLast) {
  for (const int order : {1, 2})
    test::expect_conserved(refined_and_tied(2, order), energy_momentum(), 10000, 1e-9, true);
  test::expect_conserved(refined_and_tied(2, 1), average_vector_field(4, 8), 10000, 1e-7, false);
}

}  // namespace
}  // namespace ixos
