// Surfaces as patches.
#include "geometry/surface_patches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "geometry/placed_surface.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/joined_parts.hpp"
#include "mesh/mortar/tied_surfaces.hpp"
#include "mesh/periodic_sides.hpp"
#include "mesh/splitting/refine.hpp"
#include "support/refusal.hpp"
#include "support/sphere_patches.hpp"
#include "support/two_bodies.hpp"

namespace ixos {
namespace {

LocalMesh part(const Mesh& mesh, const std::vector<std::string>& whole = {}) {
  const Comm comm = test::world();
  return localize(mesh, partition_nodes(mesh, comm->getSize()), comm->getRank(), comm->getSize(), whole);
}

SurfacePatches<2> curves_of(const Mesh& mesh, const std::string& set, Smoothing smoothing) {
  const LocalMesh local = part(mesh, {set});
  return surface_patches<2>(local, local.whole_side_sets.at(set), smoothing, set);
}

TEST(SurfacePatchesTest, ACircleIsOneClosedSmoothCurve) {
  const double radius = 5;
  const Mesh mesh = test::two_disks(radius, {20, 0}, 8, 2);
  const LocalMesh local = part(mesh, {"b_surface"});
  for (const Smoothing smoothing : {Smoothing::CatmullRom, Smoothing::Spline}) {
    const auto curves = surface_patches<2>(local, local.whole_side_sets.at("b_surface"), smoothing, "b");
    ASSERT_EQ(curves.patches.size(), 32U);
    EXPECT_EQ(curves.nodes.size(), 32U);
    double length_around = 0;
    for (const SurfacePatch<2>& patch : curves.patches) {
      EXPECT_TRUE(patch.smooth[0] && patch.smooth[1]);
      SurfacePatch<2>::Points own{};
      for (std::size_t a = 0; a < patch.count; ++a)
        own[a] = reference_place<2>(local, curves.nodes[static_cast<std::size_t>(patch.nodes[a])]);
      const PlacedPatch<2> placed = patch.placed(own);
      for (int k = 0; k <= 10; ++k) {
        const Vec<2> r = placed.at({k / 10.0}) - Vec<2>{20, 0};
        EXPECT_NEAR(length(r), radius, 2e-4 * radius);  // the sag of straight sides is 5e-3
        if (k < 10) length_around += length(placed.at({(k + 1) / 10.0}) - placed.at({k / 10.0}));
        EXPECT_GT(inner(placed.normal(PatchParameters<2>{k / 10.0}), r), 0);
      }
    }
    EXPECT_NEAR(length_around, 2 * M_PI * radius, 1e-3 * radius);
  }
}

/// Nodes of periodic sides and of tied surfaces follow others, too, but end no side of another size.
TEST(SurfacePatchesTest, HangingNodesAloneInterruptSmoothFaces) {
  const auto refusal = [](const Mesh& mesh, const std::string& set) {
    return test::refusal([&] { test::MeshPatches(mesh, set, Smoothing::CatmullRom); });
  };
  BoxShape shape;
  shape.dimension = 3;
  shape.divisions = {3, 3, 2};
  Mesh periodic = box(shape), refined = box(shape);
  make_periodic(periodic, "left", "right", 0);
  EXPECT_EQ(refusal(periodic, "top"), "");
  RefinedRegion corner;
  corner.upper = {0.1, 0.1, 2};
  refine(refined, {{"corner", corner}}, 1);
  test::expect_contains(refusal(refined, "top"), "the surface \"top\" has hanging nodes");
  shape.lower = {0, 0, 1};
  shape.divisions = {2, 2, 1};
  Mesh tied = joined_parts({{"lower", periodic}, {"upper", box(shape)}});
  tie_surfaces(tied, "upper_bottom", "lower_top", 0);
  EXPECT_EQ(refusal(tied, "upper_left"), "");
}

TEST(SurfacePatchesTest, CornersAndFreeEndsEndACurve) {
  const Mesh mesh = test::two_blocks(0.3);
  int corners = 0;
  for (const SurfacePatch<2>& patch : curves_of(mesh, "upper_surface", Smoothing::CatmullRom).patches) {
    EXPECT_GE(patch.neighbours[0], 0);
    EXPECT_GE(patch.neighbours[1], 0);
    if (!patch.smooth[0]) ++corners;
    if (!patch.smooth[1]) ++corners;
  }
  EXPECT_EQ(corners, 8);
  // A spline of the 5 sides of the bottom has both ends of the curve, and up to six nodes.
  std::vector<std::size_t> counts;
  for (const SurfacePatch<2>& patch : curves_of(mesh, "upper_bottom", Smoothing::Spline).patches)
    counts.push_back(patch.count);
  std::sort(counts.begin(), counts.end());
  EXPECT_EQ(counts, (std::vector<std::size_t>{4, 4, 5, 5, 6}));
  int ends = 0;
  for (const SurfacePatch<2>& patch : curves_of(mesh, "upper_bottom", Smoothing::CatmullRom).patches)
    ends += (patch.neighbours[0] < 0 ? 1 : 0) + (patch.neighbours[1] < 0 ? 1 : 0);
  EXPECT_EQ(ends, 2);
  for (const SurfacePatch<2>& patch : curves_of(mesh, "upper_bottom", Smoothing::None).patches) {
    EXPECT_EQ(patch.count, 2U);
    EXPECT_FALSE(patch.smooth[0] || patch.smooth[1]);
  }
}

TEST(SurfacePatchesTest, EachSideCountsOnOneRank) {
  const Mesh mesh = test::two_disks(5, {20, 0}, 8, 2);
  const LocalMesh local = part(mesh, {"a_surface"});
  const auto curves = surface_patches<2>(local, local.whole_side_sets.at("a_surface"), Smoothing::None, "a");
  double owned = 0;
  for (const char own : curves.owned) owned += own;
  const DofSpace space(local, test::world());
  space.sum(&owned, 1);
  EXPECT_EQ(owned, 32);
}

/// Samples both patches at each side that is called smooth: places and normals agree. At other sides places do.
template <class Surface>
void expect_joins(const Surface& surface, double& smooth_sides, double& kink) {
  const PlacedSurface<3> placed(surface.patches(), surface.x);
  smooth_sides = kink = 0;
  for (std::size_t p = 0; p < surface.patches().size(); ++p)
    for (std::size_t side = 0; side < 4; ++side) {
      const SurfacePatch<3>& patch = surface.patches()[p];
      const int other = patch.neighbours[side];
      if (other < 0) continue;
      if (patch.smooth[side]) ++smooth_sides;
      for (const double t : {0.0, 0.2, 0.7, 1.0}) {
        PatchParameters<3> xi{};
        xi[side / 2] = side % 2 == 0 ? 0 : 1;
        xi[1 - side / 2] = t;
        const PlacedPatch<3>& own = placed.patch(static_cast<int>(p));
        const PatchProjection<3> projection =
            nearest_point(placed.patch(other), surface.patches()[static_cast<std::size_t>(other)].smooth, own.at(xi),
                          PatchBound<3>(placed.patch(other)).start(own.at(xi)));
        EXPECT_NEAR(projection.distance, 0, 1e-12);
        const double cosine = inner(own.normal(xi), placed.patch(other).normal(projection.xi));
        if (patch.smooth[side])
          EXPECT_NEAR(cosine, 1, 1e-12);
        else
          kink = std::max(kink, std::acos(std::min(1.0, cosine)));
      }
    }
  smooth_sides /= 4.0 * static_cast<double>(surface.patches().size());
}

TEST(SurfacePatchesSerialTest, ASphereIsSmoothButAtTheCornersOfItsCube) {
  for (const int divisions : {4, 8}) {
    const test::SpherePatches sphere(5, divisions, Smoothing::CatmullRom);
    double smooth = 0, kink = 0;
    expect_joins(sphere, smooth, kink);
    // Three of the edges that meet at each of 8 corners are not; each is seen from both sides.
    EXPECT_NEAR(smooth, 1 - 48.0 / (24.0 * divisions * divisions), 1e-12);
    EXPECT_LT(kink, 0.6 / divisions);
    const PlacedSurface<3> placed(sphere.patches(), sphere.x);
    for (int p = 0; p < static_cast<int>(sphere.patches().size()); ++p)
      EXPECT_NEAR(length(placed.patch(p).at({0.5, 0.5})), 5, divisions == 4 ? 0.04 : 0.01);
    double bilinear_smooth = 0, bilinear_kink = 0;
    expect_joins(test::SpherePatches(5, divisions, Smoothing::None), bilinear_smooth, bilinear_kink);
    EXPECT_EQ(bilinear_smooth, 0);
    EXPECT_GT(bilinear_kink, 1.0 / divisions);
  }
}

/// Splines join where smooth patches do, and have one curvature away from the corners of the cube.
TEST(SurfacePatchesSerialTest, ASphereOfSplines) {
  double last = 0;
  for (const int divisions : {4, 8, 16}) {
    const test::SpherePatches sphere(5, divisions, Smoothing::Spline);
    EXPECT_FALSE(sphere.surface.through_nodes);
    double smooth = 0, kink = 0;
    expect_joins(sphere, smooth, kink);
    EXPECT_NEAR(smooth, 1 - 48.0 / (24.0 * divisions * divisions), 1e-12);
    EXPECT_LT(kink, 0.6 / divisions);
    const PlacedSurface<3> placed(sphere.patches(), sphere.x);
    double off = 0;
    for (int p = 0; p < static_cast<int>(sphere.patches().size()); ++p)
      off = std::max(off, std::abs(length(placed.patch(p).at({0.5, 0.5})) - 5));
    EXPECT_LT(off, 0.2 / divisions);
    if (last > 0) {
      EXPECT_LT(off, last / 3) << "of second order at least, also at the corners";
    }
    last = off;
  }
}

/// The faces of a box are smooth up to its edges, which are straight, whatever the cells' lengths.
TEST(SurfacePatchesSerialTest, EdgesOfABoxStayEdges) {
  BoxShape shape;
  shape.dimension = 3;
  shape.divisions = {3, 4, 2};
  Mesh mesh = box(shape);
  for (std::size_t k = 0; k < mesh.coordinates.size(); ++k) mesh.coordinates[k] *= 1 + 2 * mesh.coordinates[k];
  for (const Smoothing smoothing : {Smoothing::CatmullRom, Smoothing::Spline}) {
    const test::MeshPatches surface(mesh, "surface", smoothing);
    double smooth = 0, kink = 0;
    expect_joins(surface, smooth, kink);
    const double faces = 2 * (3 * 4 + 3 * 2 + 4 * 2), edge_sides = 2 * 4 * (3 + 4 + 2);
    EXPECT_NEAR(smooth, 1 - edge_sides / (4 * faces), 1e-12);
    EXPECT_NEAR(kink, M_PI / 2, 1e-12);
    const PlacedSurface<3> placed(surface.patches(), surface.x);
    for (int p = 0; p < static_cast<int>(faces); ++p) {
      const Vec<3> x = placed.patch(p).at({0.3, 0.6});
      double off = HUGE_VAL;
      for (const double component : x) off = std::min({off, std::abs(component), std::abs(component - 3)});
      EXPECT_NEAR(off, 0, 1e-13) << "a flat face stays flat";
    }
  }
}

/// Quadratic sides of a disk, whose nodes are on the circle, have a sag of fourth order.
TEST(SurfacePatchesTest, SidesOfHigherOrderKeepTheirShape) {
  DiskShape shape;
  shape.diameter = 10;
  shape.cell_order = 2;
  const LocalMesh local = part(disk(shape), {"surface"});
  const auto curves = surface_patches<2>(local, local.whole_side_sets.at("surface"), Smoothing::CatmullRom, "disk");
  ASSERT_EQ(curves.patches.size(), 16U);
  EXPECT_EQ(curves.nodes.size(), 32U);
  for (const SurfacePatch<2>& patch : curves.patches) {
    EXPECT_EQ(patch.degree, 2);
    EXPECT_FALSE(patch.smooth[0] || patch.smooth[1]);
    SurfacePatch<2>::Points own{};
    for (std::size_t a = 0; a < patch.count; ++a)
      own[a] = reference_place<2>(local, curves.nodes[static_cast<std::size_t>(patch.nodes[a])]);
    for (int k = 0; k <= 10; ++k) EXPECT_NEAR(length(patch.placed(own).at({k / 10.0})), 5, 5e-3);
  }
  Mesh mesh = test::two_blocks(0.3);
  enrich(mesh, "upper_bottom", ContactElement::Q1C4);
  for (const SurfacePatch<2>& patch : curves_of(mesh, "upper_bottom", Smoothing::CatmullRom).patches)
    EXPECT_EQ(patch.count, 5U);
}

TEST(SurfacePatchesTest, RefusesSidesOfOtherCells) {
  Mesh mesh = test::two_blocks(0.3);
  enrich(mesh, "upper_bottom", ContactElement::Q1CH);
  EXPECT_THROW(curves_of(mesh, "upper_bottom", Smoothing::None), InputError);
  EXPECT_THROW(part(mesh, {"no such set"}), InputError);
}

}  // namespace
}  // namespace ixos
