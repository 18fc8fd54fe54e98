// The splits that gaps and strains call for.
#include "adapt/wished_splits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "adapt/split_bodies.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/van_der_waals.hpp"
#include "mesh/tied_nodes.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using test::split_box;

const std::shared_ptr<const GapLaw> law = gap_law(VanDerWaals(1, 1));

TEST(FrontTest, TheChangeOfTractionIsThatOfTheLaw) {
  const auto attraction = [](double gap) { return -static_cast<double>(law->traction(Pack(gap))[0]); };
  const double rest = law->equilibrium_gap(), peak = law->adhesion_gap(), strength = attraction(peak);
  EXPECT_NEAR(traction_change(*law, rest, peak), 1, 1e-14);
  EXPECT_NEAR(traction_change(*law, rest, 100), 1, 1e-5);  // the peak lies between
  EXPECT_NEAR(traction_change(*law, peak, 2 * peak), 1 - attraction(2 * peak) / strength, 1e-14);
  EXPECT_EQ(traction_change(*law, 1.5 * peak, 1.5 * peak), 0);
  EXPECT_NEAR(traction_change(*law, 0.5 * rest, peak), 2, 1e-14);  // pressure counts up to the strength
  EXPECT_EQ(traction_change(*law, 0.3 * rest, 0.5 * rest), 0);     // no front where all is pressed together
  EXPECT_NEAR(traction_change(*law, -1, peak), 2, 1e-14);          // whatever is on the other side
}

/// Gaps at the bottom that grow with x.
std::vector<double> rising(const SplitMesh& mesh, double first, double slope) {
  const auto d = static_cast<std::size_t>(mesh.mesh().dimension);
  std::vector<double> gaps(static_cast<std::size_t>(mesh.mesh().nodes()), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t node = 0; node < gaps.size(); ++node)
    if (mesh.mesh().coordinates[node * d + d - 1] == 0) gaps[node] = first + slope * mesh.mesh().coordinates[node * d];
  return gaps;
}

TEST(FrontTest, PartsOfAFaceHaveTheirPartOfTheGaps) {
  for (const int dimension : {2, 3})
    for (const int kind : {0, 1, 3}) {
      const SplitMesh mesh = split_box(dimension, ContactElement::Q1C1, kind);
      const double peak = law->adhesion_gap();
      const Front front(mesh, "bottom", law, rising(mesh, peak, 0.5));
      // The first cell, and its left half, whether the mesh has it or not.
      TreeCell whole = mesh.tree().cell(0), left = whole;
      left.upper[0] = 0;
      left.halvings[0] = 1;
      EXPECT_NEAR(front.change(whole), traction_change(*law, peak, peak + 0.5), 1e-14);
      EXPECT_NEAR(front.change(left), traction_change(*law, peak, peak + 0.25), 1e-14);
      // The upper half has no face there.
      const auto up = static_cast<std::size_t>(dimension - 1);
      whole.lower[up] = 0;
      whole.halvings[up] = 1;
      EXPECT_EQ(front.change(whole), 0);
    }
}

TEST(BulkStrainTest, AQuadraticFieldHasTheJumpOfHalfACell) {
  for (const int dimension : {2, 3}) {
    const SplitMesh mesh = split_box(dimension, ContactElement::Q1C1, 0);
    const auto d = static_cast<std::size_t>(dimension);
    std::vector<double> affine(mesh.mesh().coordinates.size()), quadratic = affine;
    for (std::size_t k = 0; k < affine.size(); k += d) {
      affine[k] = 0.3 * mesh.mesh().coordinates[k] - 0.2 * mesh.mesh().coordinates[k + 1];
      quadratic[k] = mesh.mesh().coordinates[k] * mesh.mesh().coordinates[k] / 2;
    }
    const BulkStrain none(mesh, affine, dimension), bent(mesh, quadratic, dimension);
    for (int k = 0; k < mesh.base().cells(); ++k) {
      EXPECT_NEAR(none.jump(mesh.tree().cell(k)), 0, 1e-15);
      // The gradient x is that of a cell's middle; at its nodes the mean of two cells is half a cell of 1 L0 away.
      EXPECT_NEAR(bent.jump(mesh.tree().cell(k)), 0.5, 1e-14);
      TreeCell part = mesh.tree().cell(k);
      for (std::size_t i = 0; i < d; ++i) {
        part.upper[i] = 0;
        part.halvings[i] = 1;
      }
      EXPECT_NEAR(bent.jump(part), 0.25, 1e-14);
    }
  }
}

AdaptOptions options(int levels) {
  AdaptOptions result;
  result.levels = levels;
  return result;
}

/// Returns the mesh that the gaps ask for, of one whose cells are not split.
SplitMesh adapted(const SplitMesh& mesh, const AdaptOptions& asked, double first, double slope, bool keep_all = false) {
  Signs signs;
  signs.fronts.emplace_back(mesh, "bottom", law, rising(mesh, first, slope));
  Mesh next = mesh.base();
  SplitTree tree = split(next, wished_splits(mesh, signs, asked, {}, keep_all), 1);
  return {mesh.base(), next, std::move(tree)};
}

TEST(WishedSplitsTest, FacesAreSplitUntilTheTractionChangesByThePart) {
  for (const int dimension : {2, 3}) {
    const SplitMesh coarse = split_box(dimension, ContactElement::Q1C1, 0);
    const double first = law->equilibrium_gap();
    const SplitMesh fine = adapted(coarse, options(8), first, 0.2);
    const Front front(fine, "bottom", law, rising(fine, first, 0.2));
    Signs signs;
    signs.fronts.push_back(front);
    EXPECT_TRUE(coarse_leaves(fine, signs, options(8)).empty());
    double largest = 0;
    for (std::size_t k = 0; k < fine.tree().cells().size(); ++k)
      if (fine.tree().is_leaf(static_cast<int>(k))) largest = std::max(largest, front.change(fine.tree().cells()[k]));
    EXPECT_LE(largest, 0.25);
    EXPECT_GT(largest, 0.125);  // none of them is finer than needed, but for their neighbours' sake
    EXPECT_GT(fine.mesh().cells(), 2 * coarse.mesh().cells());
    // No more halvings than allowed.
    const SplitMesh bounded = adapted(coarse, options(1), first, 0.2);
    for (const TreeCell& cell : bounded.tree().cells()) EXPECT_LE(cell.halvings[0], 1);
    // Where the surface is far from the wall, all is joined; unless all is to be kept.
    EXPECT_EQ(adapted(fine, options(8), 50, 0).mesh().cells(), coarse.mesh().cells());
    EXPECT_TRUE(adapted(fine, options(8), 50, 0, true).tree().splits() == fine.tree().splits());
  }
}

TEST(WishedSplitsTest, ASmallChangeToAndFroChangesNothing) {
  const SplitMesh coarse = split_box(2, ContactElement::Q1C1, 0);
  const double peak = law->adhesion_gap();
  // A change of the gap after which one cell is a little above what splits it, then a little below.
  double slope = 0.01;
  while (adapted(coarse, options(1), peak, slope).mesh().cells() == coarse.mesh().cells()) slope *= 1.01;
  const SplitMesh fine = adapted(coarse, options(1), peak, slope);
  const SplitMesh later = adapted(fine, options(1), peak, 0.9 * slope);
  EXPECT_TRUE(later.tree().splits() == fine.tree().splits());
  EXPECT_EQ(adapted(coarse, options(1), peak, 0.9 * slope).mesh().cells(), coarse.mesh().cells());
}

TEST(WishedSplitsTest, DirectionsAndRegionsCount) {
  const SplitMesh coarse = split_box(2, ContactElement::Q1C1, 0);
  AdaptOptions along = options(2);
  along.directions = "x";
  const SplitMesh fine = adapted(coarse, along, law->equilibrium_gap(), 0.2);
  EXPECT_GT(fine.mesh().cells(), coarse.mesh().cells());
  for (const TreeCell& cell : fine.tree().cells()) EXPECT_EQ(cell.halvings[1], 0);
  RefinedRegion corner;
  corner.lower = {2.5, 1.5};
  Mesh next = coarse.base();
  const SplitTree tree = split(next, wished_splits(coarse, {}, options(2), {{"corner", corner}}, false), 1);
  EXPECT_EQ(next.cells(), coarse.mesh().cells() + 3);
}

}  // namespace
}  // namespace ixos
