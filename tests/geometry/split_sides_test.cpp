// Surfaces with triangles as four-sided patches.
#include "geometry/split_sides.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "base/error.hpp"
#include "base/vector3.hpp"
#include "fem/cells/triangles.hpp"
#include "geometry/placed_surface.hpp"
#include "mesh/cell_order.hpp"
#include "support/simplices.hpp"
#include "support/sphere_patches.hpp"

namespace ixos {
namespace {

Mesh sphere_of_tetrahedra(double radius, int divisions) {
  return test::split_cells(test::SpherePatches::of(radius, divisions), "twelve tetrahedra");
}

Mesh block(const char* kind) {
  BoxShape shape;
  shape.dimension = 3;
  shape.lower = {-1, 0, 0};
  shape.lengths = {2, 1, 1};
  shape.divisions = {4, 3, 2};
  return test::split_cells(box(shape), kind);
}

PatchParameters<3> on_side(std::size_t side, double along) {
  PatchParameters<3> xi{};
  xi[side / 2] = side % 2 == 0 ? 0 : 1;
  xi[1 - side / 2] = along;
  return xi;
}

/// Returns the largest angle between normals of patches that meet, in sides that are not smooth. Patches meet at the
/// same places; smooth ones have one normal there.
double largest_kink(const test::MeshPatches& surface, double tolerance) {
  const PlacedSurface<3> placed(surface.patches(), surface.x);
  double kink = 0;
  for (std::size_t p = 0; p < surface.patches().size(); ++p)
    for (std::size_t side = 0; side < 4; ++side) {
      const int other = surface.patches()[p].neighbours[side];
      EXPECT_GE(other, 0) << "the surface is closed";
      if (other < 0) continue;
      for (const double t : {0.0, 0.3, 1.0}) {
        const PlacedPatch<3>& own = placed.patch(static_cast<int>(p));
        const Vec<3> place = own.at(on_side(side, t));
        double off = HUGE_VAL, cosine = 0;
        for (std::size_t s = 0; s < 4; ++s)
          for (const double u : {t, 1 - t}) {
            const Vec<3> there = placed.patch(other).at(on_side(s, u));
            if (!(length(there - place) < off)) continue;
            off = length(there - place);
            cosine = inner(own.normal(on_side(side, t)), placed.patch(other).normal(on_side(s, u)));
          }
        EXPECT_LT(off, tolerance);
        if (surface.patches()[p].smooth[side])
          EXPECT_NEAR(cosine, 1, 1e-12);
        else
          kink = std::max(kink, std::acos(std::min(1.0, cosine)));
      }
    }
  return kink;
}

TEST(SplitSidesSerialTest, ATriangleIsThreePatches) {
  const test::MeshPatches surface(sphere_of_tetrahedra(5, 2), "surface", Smoothing::None);
  const std::size_t triangles = 2 * 24;
  ASSERT_EQ(surface.patches().size(), 3 * triangles);
  double area = 0, of_triangles = 0;
  std::map<std::array<int, 3>, std::vector<int>> parts;
  for (std::size_t p = 0; p < surface.patches().size(); ++p) {
    const SurfacePatch<3>& patch = surface.patches()[p];
    EXPECT_EQ(patch.side_corners, 3U);
    parts[surface.surface.sides[p]].push_back(surface.surface.part[p]);
    const PlacedPatch<3> placed = patch.placed(patch.among(surface.x));
    for (const PatchPoint<3>& point : patch_points<3>(2)) {
      const auto frame = placed.frame(point.xi);
      area += point.weight * length(cross(frame.tangents[0], frame.tangents[1]));
      EXPECT_GT(inner(placed.normal(point.xi), placed.at(point.xi)), 0) << "outward";
    }
    if (surface.surface.part[p] > 0) continue;
    std::array<Vec<3>, 3> x;
    for (std::size_t k = 0; k < 3; ++k) x[k] = surface.x[static_cast<std::size_t>(patch.nodes[k])];
    of_triangles += length(cross(x[1] - x[0], x[2] - x[0])) / 2;
  }
  EXPECT_EQ(parts.size(), triangles);
  for (const auto& [side, own] : parts) EXPECT_EQ(own, (std::vector<int>{0, 1, 2}));
  EXPECT_NEAR(area, of_triangles, 1e-12 * area);
  EXPECT_EQ(surface.surface.points_along(0), 3);
  EXPECT_EQ(surface.surface.points_along(2), 1);
}

/// Quadrilaterals beside triangles are four patches, so that all meet side by side; faces stay flat.
TEST(SplitSidesSerialTest, MixedSurfacesClose) {
  for (const char* kind : {"tetrahedra", "prisms", "hexahedra and prisms", "hexahedra to tetrahedra"})
    for (const Smoothing smoothing : {Smoothing::None, Smoothing::CatmullRom}) {
      SCOPED_TRACE(kind);
      const test::MeshPatches surface(block(kind), "surface", smoothing);
      EXPECT_NEAR(largest_kink(surface, 1e-12), M_PI / 2, 1e-7);
      for (const SurfacePatch<3>& patch : surface.patches()) {
        const Vec<3> x = patch.placed(patch.among(surface.x)).at({0.3, 0.6});
        EXPECT_NEAR(std::min({std::abs(std::abs(x[0]) - 1), std::abs(x[1]), std::abs(x[1] - 1), std::abs(x[2]),
                              std::abs(x[2] - 1)}),
                    0, 1e-13);
      }
    }
}

/// The normals of smooth sides jump much less than those of flat ones, and by less than the square of their length.
TEST(SplitSidesSerialTest, ASmoothSphereHasSmallKinks) {
  double before = 0, off_before = 0;
  for (const int divisions : {8, 16}) {  // coarser sides meet at more than 30 degrees
    const Mesh mesh = sphere_of_tetrahedra(5, divisions);
    const test::MeshPatches flat(mesh, "surface", Smoothing::None), smooth(mesh, "surface", Smoothing::CatmullRom);
    const double kink = largest_kink(smooth, 1e-12), of_flat = largest_kink(flat, 1e-12);
    double off = 0, mean = 0;
    for (const SurfacePatch<3>& patch : smooth.patches()) {
      const double own = std::abs(length(patch.placed(patch.among(smooth.x)).at({0.5, 0.5})) - 5);
      off = std::max(off, own);
      mean += own / static_cast<double>(smooth.patches().size());
    }
    EXPECT_LT(off, 2 * mean);
    EXPECT_LT(kink, 0.05 * of_flat);
    if (before > 0) {
      EXPECT_LT(kink, before / 4);
      EXPECT_LT(mean, off_before / 8);
    }
    before = kink;
    off_before = mean;
  }
}

/// A patch of a curved side is the side: at the parameters of its points, the element's own functions of its nodes.
TEST(SplitSidesSerialTest, CurvedSidesKeepTheirShape) {
  for (const bool bubbles : {false, true}) {
    Mesh mesh = block("tetrahedra");
    raise_order(mesh, bubbles);
    test::bend(mesh, 0.05);
    const test::MeshPatches surface(mesh, "surface", Smoothing::CatmullRom);
    largest_kink(surface, 1e-12);
    for (const SurfacePatch<3>& patch : surface.patches()) {
      ASSERT_EQ(patch.count, bubbles ? 7U : 6U);
      EXPECT_EQ(patch.degree, bubbles ? 3 : 2);
      // Its corners in barycentric coordinates are means of those of the side.
      const double s = 0.3, t = 0.8;
      const std::array<double, 4> share{(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t};
      std::array<double, 3> l{};
      for (std::size_t c = 0; c < 4; ++c)
        for (const int node : patch.corner(c)) {
          const auto k = std::find(patch.nodes.begin(), patch.nodes.begin() + 3, node) - patch.nodes.begin();
          ASSERT_LT(k, 3);
          l[static_cast<std::size_t>(k)] += share[c] / static_cast<double>(patch.corner(c).size());
        }
      const auto weights = patch.weights({s, t});
      const auto expect = [&](auto value) {
        for (std::size_t a = 0; a < patch.count; ++a) EXPECT_NEAR(weights[a], value[a], 1e-14);
      };
      if (bubbles) {
        std::array<double, 7> value;
        std::array<std::array<double, 2>, 7> gradient;
        Tri7::evaluate({l[1], l[2]}, value, gradient);
        expect(value);
      } else {
        std::array<double, 6> value;
        std::array<std::array<double, 2>, 6> gradient;
        Tri6::evaluate({l[1], l[2]}, value, gradient);
        expect(value);
      }
    }
  }
}

TEST(SplitSidesSerialTest, SplinesOverTrianglesAreRefused) {
  EXPECT_THROW(test::MeshPatches(block("tetrahedra"), "surface", Smoothing::Spline), InputError);
}

}  // namespace
}  // namespace ixos
