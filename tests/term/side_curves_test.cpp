// Surfaces as curves.
#include "term/side_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "support/two_bodies.hpp"

namespace ixos {
namespace {

LocalMesh part(const Mesh& mesh, const std::vector<std::string>& whole = {}) {
  const Comm comm = test::world();
  return localize(mesh, partition_nodes(mesh, comm->getSize()), comm->getRank(), comm->getSize(), whole);
}

SideCurves curves_of(const Mesh& mesh, const std::string& set, Smoothing smoothing) {
  const LocalMesh local = part(mesh, {set});
  return side_curves(local, local.whole_side_sets.at(set), smoothing, set);
}

TEST(SideCurvesTest, ACircleIsOneClosedSmoothCurve) {
  const double radius = 5;
  const Mesh mesh = test::two_disks(radius, {20, 0}, 8, 2);
  const LocalMesh local = part(mesh, {"b_surface"});
  const SideCurves curves = side_curves(local, local.whole_side_sets.at("b_surface"), Smoothing::CatmullRom, "b");
  ASSERT_EQ(curves.segments.size(), 32U);
  EXPECT_EQ(curves.nodes.size(), 32U);
  const std::vector<double> u(local.coordinates.size(), 0.0);
  const std::vector<Planar> x = curves.places(local, u.data());
  double length_around = 0;
  for (const CurveSegment& segment : curves.segments) {
    EXPECT_TRUE(segment.smooth[0] && segment.smooth[1]);
    CurveSegment::Points own{};
    for (std::size_t a = 0; a < segment.count; ++a) own[a] = x[static_cast<std::size_t>(segment.nodes[a])];
    for (int k = 0; k <= 10; ++k) {
      const Planar r = segment.sum(segment.weights(k / 10.0), own) - Planar{20, 0};
      EXPECT_NEAR(length(r), radius, 2e-4 * radius);  // the sag of straight sides is 5e-3
      if (k < 10)
        length_around +=
            length(segment.sum(segment.weights((k + 1) / 10.0), own) - segment.sum(segment.weights(k / 10.0), own));
      // The body is on the left: the outward normal on the right.
      const Planar tangent = segment.sum(segment.slopes(k / 10.0), own);
      EXPECT_GT(dot({tangent[1], -tangent[0]}, r), 0);
    }
  }
  EXPECT_NEAR(length_around, 2 * M_PI * radius, 1e-3 * radius);
}

TEST(SideCurvesTest, CornersAndFreeEndsEndACurve) {
  const Mesh mesh = test::two_blocks(0.3);
  const SideCurves whole = curves_of(mesh, "upper_surface", Smoothing::CatmullRom);
  int corners = 0;
  for (const CurveSegment& segment : whole.segments) {
    EXPECT_GE(segment.neighbours[0], 0);
    EXPECT_GE(segment.neighbours[1], 0);
    if (!segment.smooth[0]) ++corners;
    if (!segment.smooth[1]) ++corners;
  }
  EXPECT_EQ(corners, 8);
  const SideCurves bottom = curves_of(mesh, "upper_bottom", Smoothing::CatmullRom);
  int ends = 0;
  for (const CurveSegment& segment : bottom.segments)
    ends += (segment.neighbours[0] < 0 ? 1 : 0) + (segment.neighbours[1] < 0 ? 1 : 0);
  EXPECT_EQ(ends, 2);
  for (const CurveSegment& segment : curves_of(mesh, "upper_bottom", Smoothing::None).segments) {
    EXPECT_EQ(segment.count, 2U);
    EXPECT_FALSE(segment.smooth[0] || segment.smooth[1]);
  }
}

TEST(SideCurvesTest, EachSideCountsOnOneRank) {
  const Mesh mesh = test::two_disks(5, {20, 0}, 8, 2);
  const LocalMesh local = part(mesh, {"a_surface"});
  const SideCurves curves = side_curves(local, local.whole_side_sets.at("a_surface"), Smoothing::None, "a");
  double owned = 0;
  for (const char own : curves.owned) owned += own;
  const DofSpace space(local, test::world());
  space.sum(&owned, 1);
  EXPECT_EQ(owned, 32);
}

TEST(SideCurvesTest, RefusesSidesThatAreNotStraight) {
  Mesh mesh = test::two_blocks(0.3);
  enrich(mesh, "upper_bottom", ContactElement::Q1C2);
  EXPECT_THROW(curves_of(mesh, "upper_bottom", Smoothing::None), InputError);
  BoxShape shape;
  shape.dimension = 3;
  EXPECT_THROW(curves_of(box(shape), "bottom", Smoothing::None), InputError);
  EXPECT_THROW(part(mesh, {"no such set"}), InputError);
}

}  // namespace
}  // namespace ixos
