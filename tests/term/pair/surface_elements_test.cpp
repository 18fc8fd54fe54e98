// Area elements of a surface.
#include "term/pair/surface_elements.hpp"

#include <gtest/gtest.h>

#include "support/two_bodies.hpp"

namespace ixos {
namespace {

template <std::size_t D>
SurfacePatches<D> patches(const Mesh& mesh, const char* set) {
  const LocalMesh local = localize(mesh, partition_nodes(mesh, 1), 0, 1, {set});
  return surface_patches<D>(local, local.whole_side_sets.at(set), Smoothing::CatmullRom, set);
}

template <std::size_t D>
std::vector<Vec<D>> rest_of(const Mesh& mesh, const SurfacePatches<D>& surface) {
  const LocalMesh local = localize(mesh, partition_nodes(mesh, 1), 0, 1, {});
  return combined_places<D>(surface.nodes, local.coordinates, 1, {});
}

/// The vectors of a closed surface sum to 0, and a third (in the plane, half) of the sum of x . n dA is its volume.
TEST(SurfaceElementsTest, ClosedSurfacesHaveNoNetAreaAndTheirVolume) {
  const Mesh balls = test::two_balls(2, {5, 0, 0}, 4, 1), disks = test::two_disks(2, {5, 0}, 8, 1);
  const SurfacePatches<3> ball = patches<3>(balls, "a_surface");
  const SurfaceElements<3> in_space(ball, 5);
  const auto placed = in_space.at(rest_of<3>(balls, ball));
  Vec<3> sum{};
  double volume = 0;
  for (std::size_t q = 0; q < placed.place.size(); ++q) {
    sum = sum + placed.area[q];
    volume += inner(placed.place[q], placed.area[q]) / 3;
  }
  EXPECT_LT(length(sum), 1e-12);
  EXPECT_NEAR(volume, 4 * M_PI / 3 * 8, 0.3);
  EXPECT_GT(volume, 0) << "the vectors point outwards";
  const SurfacePatches<2> circle = patches<2>(disks, "a_surface");
  const SurfaceElements<2> in_plane(circle, 5);
  const auto points = in_plane.at(rest_of<2>(disks, circle));
  Vec<2> net{};
  double area = 0;
  for (std::size_t q = 0; q < points.place.size(); ++q) {
    net = net + points.area[q];
    area += (points.place[q][0] * points.area[q][1] - points.place[q][1] * points.area[q][0]) / 2;
  }
  EXPECT_LT(length(net), 1e-13);
  EXPECT_NEAR(area, 4 * M_PI, 0.01);
}

/// Slopes, and derivatives by nodes, are those of differences.
TEST(SurfaceElementsTest, SlopesAreDerivatives) {
  const Mesh balls = test::two_balls(2, {5, 0, 0}, 2, 1);
  const SurfacePatches<3> ball = patches<3>(balls, "a_surface");
  const SurfaceElements<3> elements(ball, 2);
  std::vector<Vec<3>> x = rest_of<3>(balls, ball);
  const auto placed = elements.at(x);
  // A function that is linear in all places and areas.
  std::vector<Vec<3>> by_place(placed.place.size()), by_area(placed.place.size());
  for (std::size_t q = 0; q < by_place.size(); ++q) {
    const auto t = static_cast<double>(q);
    by_place[q] = {std::sin(t), std::cos(2 * t), std::sin(3 * t)};
    by_area[q] = {std::cos(t), std::sin(2 * t), std::cos(4 * t)};
  }
  const auto value = [&](const std::vector<Vec<3>>& nodes) {
    const auto now = elements.at(nodes);
    double sum = 0;
    for (std::size_t q = 0; q < by_place.size(); ++q)
      sum += inner(by_place[q], now.place[q]) + inner(by_area[q], now.area[q]);
    return sum;
  };
  const std::vector<Vec<3>> slopes = elements.at_nodes(placed, by_place, by_area);
  const double h = 1e-5;
  for (std::size_t n = 0; n < x.size(); n += 3)
    for (std::size_t i = 0; i < 3; ++i) {
      const double kept = x[n][i];
      x[n][i] = kept + h;
      const double up = value(x);
      x[n][i] = kept - h;
      EXPECT_NEAR((up - value(x)) / (2 * h), slopes[n][i], 1e-8);
      x[n][i] = kept;
    }
}

/// The lanes beyond the last point have no area.
TEST(SurfaceElementsTest, PacksHoldThePoints) {
  const Mesh disks = test::two_disks(2, {5, 0}, 2, 1);
  const SurfacePatches<2> circle = patches<2>(disks, "a_surface");
  const SurfaceElements<2> elements(circle, 3);
  const auto placed = elements.at(rest_of<2>(disks, circle));
  const auto width = static_cast<std::size_t>(pack_width);
  ASSERT_EQ(placed.areas[0].size() * width, elements.packs() * width);
  for (std::size_t q = 0; q < elements.packs() * width; ++q)
    for (std::size_t i = 0; i < 2; ++i) {
      const double area = placed.areas[i][q / width][q % width];
      EXPECT_EQ(area, q < placed.area.size() ? placed.area[q][i] : 0);
      if (q >= placed.place.size()) continue;
      EXPECT_EQ(placed.places[i][q / width][q % width], placed.place[q][i]);
    }
}

}  // namespace
}  // namespace ixos
