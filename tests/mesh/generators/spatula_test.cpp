#include "mesh/generators/spatula.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>

#include "mesh/generators/spatula_surface.hpp"
#include "mesh/quality.hpp"

namespace ixos {
namespace {

using test::area_vector;
using test::default_spatula;
using test::named;
using test::nodes_of;
using test::position;
using test::small;
using test::Vec;

double simpson(const std::function<double(double)>& f, double from, double to) {
  const int n = 2000;
  double sum = f(from) + f(to);
  for (int i = 1; i < n; ++i) sum += (i % 2 == 0 ? 2 : 4) * f(from + (to - from) * i / n);
  return sum * (to - from) / n / 3;
}

/// The default pad's half-width.
double half_width(double x) {
  if (x > 110) return std::sqrt(std::max(0.0, 120 * 120 - (x - 110) * (x - 110)));
  const double s = std::min(x / 100, 1.0);
  return 50 + 70 * s * s * (3 - 2 * s);
}

/// A corner of the default transition's section seen at `p` of its lower right quarter, 0 to 1: below, then the end.
/// `share` of the quarter's perimeter is the lower side. Blends rectangle and disk as the generator does.
std::array<double, 2> outline(double round, double p, double share) {
  const double end = M_PI / 8;
  std::array<double, 2> flat{50, -7.5}, disk{};
  if (p < share) {
    const double angle = (M_PI / 2 - end) * p / share;
    flat[0] *= p / share;
    disk = {40 * std::sin(angle), -40 * std::cos(angle)};
  } else {
    const double rest = (1 - p) / (1 - share);
    flat[1] *= rest;
    disk = {40 * std::cos(end * rest), -40 * std::sin(end * rest)};
  }
  return {(1 - round) * flat[0] + round * disk[0], (1 - round) * flat[1] + round * disk[1]};
}

double section_area(double round) {
  const int n = 2000;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const auto a = outline(round, 1.0 * i / n, 0.5), b = outline(round, (i + 1.0) / n, 0.5);
    sum += 2 * (a[0] * b[1] - a[1] * b[0]);  // four quarters of half the cross product
  }
  return sum;
}

double smooth_volume() {
  const double pad = simpson([](double x) { return 2 * half_width(x) * (15 - 10 * x / 230); }, 0, 110) +
                     simpson(
                         [](double a) {  // the ellipse by its angle, smooth at the apex
                           const double x = 110 + 120 * std::sin(a);
                           return 2 * half_width(x) * (15 - 10 * x / 230) * 120 * std::cos(a);
                         },
                         0, M_PI / 2);
  // Pappus: the sections' centroids lie on the centreline.
  double transition = 0;
  const int n = 200;
  for (int i = 0; i < n; ++i) {
    const double s = (i + 0.5) / n;
    transition += section_area(s * s * s * (10 - 15 * s + 6 * s * s)) * 100 / n;
  }
  return pad + transition + M_PI * 1600 * 180;
}

/// Returns the number of cells. A section has a core of c by l cells and r rings around it. Beyond the last station
/// c - 2 t columns of cells join the outermost t columns of either side, on the l + 2 r layers of the core, and the
/// cells at the narrow ends of the sections.
int cells_of(const SpatulaShape& s, int stations) {
  const int c = s.core_cells, l = s.core_layers, r = s.rings, t = s.tip_rows;
  return stations * (c * l + 2 * r * (c + l)) + (c - 2 * t) * (t * (l + 2 * r) + r * l);
}

/// Returns the number of nodes of that mesh.
int nodes_of_stations(const SpatulaShape& s, int stations) {
  const int c = s.core_cells, l = s.core_layers, r = s.rings, t = s.tip_rows;
  return (stations + 1) * ((c + 1) * (l + 1) + 2 * r * (c + l)) + (c - 2 * t - 1) * (t * (l + 1 + 2 * r) + r * (l - 1));
}

TEST(SpatulaTest, FullMeshHasTheCellsOfThePaper) {
  const SpatulaShape shape;
  const Mesh& mesh = default_spatula();
  const SpatulaDivisions divisions = spatula_divisions(shape);
  EXPECT_NEAR(mesh.cells(), 114414, 0.5 * divisions.section_cells());  // the paper's number, to half a station
  EXPECT_EQ(mesh.cells(), cells_of(shape, divisions.stations()));
  EXPECT_EQ(divisions.cells(), mesh.cells());
  EXPECT_EQ(mesh.nodes(), nodes_of_stations(shape, divisions.stations()));
  EXPECT_NO_THROW(check_cells(mesh));
  const MeshQuality quality = mesh_quality(mesh);
  EXPECT_GT(quality.least_scaled_jacobian, 0.45);
  EXPECT_GT(quality.low_scaled_jacobian, 0.7);
  EXPECT_GT(quality.mean_scaled_jacobian, 0.9);
  EXPECT_LT(quality.largest_aspect_ratio, 20);
  EXPECT_NEAR(quality.volume / smooth_volume(), 1, 0.01);  // the narrow ends of the shaft's sections are two chords
}

TEST(SpatulaTest, VolumeConverges) {
  SpatulaShape shape;
  shape.stations = 120;
  shape.core_cells = 24;
  shape.tip_rows = 5;
  std::vector<double> error;
  for (int layers : {2, 4}) {
    shape.core_layers = layers;
    error.push_back(1 - mesh_quality(spatula(shape)).volume / smooth_volume());
  }
  EXPECT_GT(error[1], 0);
  EXPECT_LT(error[1], 0.004);
  EXPECT_GT(error[0], 2 * error[1]);
}

TEST(SpatulaTest, StationsAreTakenAsGiven) {
  SpatulaShape shape;
  for (int stations : {3, 7, 373}) {
    shape.stations = stations;
    EXPECT_EQ(spatula_divisions(shape).stations(), stations);
    EXPECT_EQ(spatula_divisions(shape).cells(), cells_of(shape, stations));
  }
  shape.stations = 7;
  EXPECT_EQ(spatula(shape).nodes(), nodes_of_stations(shape, 7));
  // With 373 stations the mesh has the paper's degrees of freedom to 0.1 %.
  EXPECT_NEAR(3 * nodes_of_stations(shape, 373), 363144, 363);
}

void expect_target_met(int target) {
  const Mesh mesh = spatula(small(target));
  EXPECT_EQ(mesh.cells(), spatula_divisions(small(target)).cells());
  EXPECT_NEAR(mesh.cells(), target, 0.03 * target) << target;
  EXPECT_NO_THROW(check_cells(mesh));
  EXPECT_GT(mesh_quality(mesh).least_scaled_jacobian, 0.33) << target;
}

TEST(SpatulaTest, TargetsAreMetWithGoodCellsAtAnySize) {
  for (int target : {250, 500, 1000, 2500, 5000, 20000, 50000}) expect_target_met(target);
}

TEST(SpatulaLongTest, ALargeTargetIsMetToo) { expect_target_met(250000); }

TEST(SpatulaTest, OtherDivisionsAndShapesHaveValidCells) {
  const std::vector<std::function<void(SpatulaShape&)>> changes{
      [](SpatulaShape& s) { s.rings = 1; },
      [](SpatulaShape& s) { s.core_layers = 1; },
      [](SpatulaShape& s) { s.core_layers = 3, s.rings = 3, s.tip_rows = 1; },
      [](SpatulaShape& s) { s.growth = 1, s.layer_ratio = 1; },
      [](SpatulaShape& s) { s.inclination = 60, s.transition_length = 120; },
      [](SpatulaShape& s) { s.inclination = 90, s.transition_length = 150; },
      [](SpatulaShape& s) { s.tip_width = s.neck_width; },
      [](SpatulaShape& s) { s.tip_length = 60, s.pad_length = 200; },
      [](SpatulaShape& s) { s.shaft_diameter = 30, s.fillet_radius = 40; },
      [](SpatulaShape& s) { s.tip_thickness = s.rear_thickness = 10; }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    SpatulaShape shape;
    shape.stations = 100;
    shape.core_cells = 16;
    shape.tip_rows = 3;
    changes[i](shape);
    const Mesh mesh = spatula(shape);
    EXPECT_NO_THROW(check_cells(mesh));
    EXPECT_GT(mesh_quality(mesh).least_scaled_jacobian, 0.2) << "change " << i;
  }
}

TEST(SpatulaTest, FacesAreSharedByTwoCellsOrOnTheSurface) {
  for (int target : {300, 3000}) {
    const Mesh mesh = spatula(small(target));
    std::map<std::set<int>, int> count;
    for (int cell = 0; cell < mesh.cells(); ++cell)
      for (int s = 0; s < 6; ++s) {
        const auto nodes = nodes_of(mesh, {0, cell, s});
        ++count[{nodes.begin(), nodes.end()}];
      }
    std::set<std::set<int>> surface;
    for (const Side& side : named(mesh.side_sets, "surface").sides) {
      const auto nodes = nodes_of(mesh, side);
      EXPECT_TRUE(surface.insert({nodes.begin(), nodes.end()}).second);
    }
    std::set<int> used;
    for (const auto& [face, cells] : count) {
      EXPECT_EQ(face.size(), 4u);
      EXPECT_EQ(cells, surface.count(face) == 1 ? 1 : 2);
      used.insert(face.begin(), face.end());
    }
    EXPECT_EQ(static_cast<int>(used.size()), mesh.nodes());
    // A closed surface without holes through it: vertices - edges + faces = 2.
    const auto faces = static_cast<int>(surface.size());
    EXPECT_EQ(static_cast<int>(named(mesh.node_sets, "surface").nodes.size()) - 2 * faces + faces, 2);
    for (double d : area_vector(mesh, "surface")) EXPECT_NEAR(d, 0, 1e-8);
  }
}

TEST(SpatulaTest, IsMirrorSymmetric) {
  const Mesh mesh = spatula(small(2000));
  std::set<Vec> points;
  for (int node = 0; node < mesh.nodes(); ++node) points.insert(position(mesh, node));
  EXPECT_EQ(static_cast<int>(points.size()), mesh.nodes());
  const auto distance = [](const Vec& a, const Vec& b) {
    return std::hypot(a[0] - b[0], std::hypot(a[1] - b[1], a[2] - b[2]));
  };
  for (const Vec& p : points) {
    const Vec image{p[0], -p[1], p[2]};
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec& q : points) nearest = std::min(nearest, distance(image, q));
    EXPECT_LT(nearest, 1e-11);
  }
}

}  // namespace
}  // namespace ixos
