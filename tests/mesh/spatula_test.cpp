#include "mesh/spatula.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>

#include "base/error.hpp"
#include "mesh/quality.hpp"

namespace ixos {
namespace {

using Vec = std::array<double, 3>;

SpatulaShape small(int cells) {
  SpatulaShape shape;
  shape.target_cells = cells;
  return shape;
}

Vec position(const Mesh& mesh, int node) {
  const std::size_t at = 3 * static_cast<std::size_t>(node);
  return {mesh.coordinates.at(at), mesh.coordinates.at(at + 1), mesh.coordinates.at(at + 2)};
}

std::array<int, 4> nodes_of(const Mesh& mesh, const Side& side) {
  std::array<int, 4> nodes{};
  for (std::size_t a = 0; a < 4; ++a)
    nodes[a] = mesh.blocks[0].nodes.at(cell_entry(side.cell, 8, side_nodes(CellType::Hex8, side.side)[a]));
  return nodes;
}

/// Outward normal times area.
Vec side_vector(const Mesh& mesh, const Side& side) {
  std::array<Vec, 4> x;
  for (std::size_t a = 0; a < 4; ++a) x[a] = position(mesh, nodes_of(mesh, side)[a]);
  Vec result{};
  for (std::size_t d = 0; d < 3; ++d) {
    const std::size_t i = (d + 1) % 3, j = (d + 2) % 3;
    result[d] = ((x[2][i] - x[0][i]) * (x[3][j] - x[1][j]) - (x[2][j] - x[0][j]) * (x[3][i] - x[1][i])) / 2;
  }
  return result;
}

template <class Set>
const Set& named(const std::vector<Set>& sets, const std::string& name) {
  const auto found = std::find_if(sets.begin(), sets.end(), [&](const Set& set) { return set.name == name; });
  if (found == sets.end()) throw std::runtime_error("no set " + name);
  return *found;
}

Vec area_vector(const Mesh& mesh, const std::string& set) {
  Vec sum{};
  for (const Side& side : named(mesh.side_sets, set).sides) {
    const Vec v = side_vector(mesh, side);
    for (std::size_t d = 0; d < 3; ++d) sum[d] += v[d];
  }
  return sum;
}

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

TEST(SpatulaTest, FullMeshHasTheCellsOfThePaper) {
  const Mesh mesh = spatula({});
  EXPECT_EQ(mesh.cells(), 114416);  // the paper: 114,414
  EXPECT_EQ(mesh.nodes(), 134360);
  EXPECT_EQ(spatula_divisions({}).cells(), mesh.cells());
  EXPECT_EQ(spatula_divisions({}).section_cells(), 272);
  EXPECT_EQ(spatula_divisions({}).stations(), 415);
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
    EXPECT_EQ(spatula_divisions(shape).cells(), 272 * stations + 24 * 64);
  }
  EXPECT_EQ(spatula(shape).nodes(), 120962);  // 362,886 degrees of freedom; the paper: 363,144
}

TEST(SpatulaTest, TargetsAreMetWithGoodCellsAtAnySize) {
  for (int target : {250, 500, 1000, 2500, 5000, 20000, 50000, 250000}) {
    const Mesh mesh = spatula(small(target));
    EXPECT_EQ(mesh.cells(), spatula_divisions(small(target)).cells());
    EXPECT_NEAR(mesh.cells(), target, 0.03 * target) << target;
    EXPECT_NO_THROW(check_cells(mesh));
    EXPECT_GT(mesh_quality(mesh).least_scaled_jacobian, 0.33) << target;
  }
}

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

TEST(SpatulaTest, PadIsTheFlatUnderside) {
  const SpatulaShape shape;
  const Mesh mesh = spatula(shape);
  const SideSet& pad = named(mesh.side_sets, "pad");
  const SpatulaDivisions d = spatula_divisions(shape);
  EXPECT_EQ(static_cast<int>(pad.sides.size()), 44 * d.pad + 24 * 10);
  std::set<int> cells;
  for (const Side& side : pad.sides) {
    EXPECT_TRUE(cells.insert(side.cell).second);
    EXPECT_LT(side_vector(mesh, side)[2], 0);
  }
  const std::vector<int>& nodes = named(mesh.node_sets, "pad").nodes;
  for (int node : nodes) EXPECT_EQ(position(mesh, node)[2], shape.gap);
  const Vec area = area_vector(mesh, "pad");
  EXPECT_NEAR(area[0], 0, 1e-9);
  EXPECT_NEAR(area[1], 0, 1e-9);
  EXPECT_NEAR(area[2] / -(17000 + 2400 + M_PI / 2 * 14400), 1, 3e-4);  // widening, straight part, ellipse
  // Nothing else touches the plane of the underside, nor lies below it.
  const std::set<int> flat(nodes.begin(), nodes.end());
  for (int node = 0; node < mesh.nodes(); ++node)
    EXPECT_TRUE(flat.count(node) == 1 || position(mesh, node)[2] > shape.gap);
}

TEST(SpatulaTest, PadFacesHaveTheSizesWanted) {
  const Mesh mesh = spatula({});
  double along = 0, shortest = 1e9, across = 0;
  const SideSet& pad = named(mesh.side_sets, "pad");
  for (const Side& side : pad.sides) {
    const auto nodes = nodes_of(mesh, side);  // seen from below: two nodes across, then along
    const Vec a = position(mesh, nodes[0]), b = position(mesh, nodes[1]), c = position(mesh, nodes[2]);
    const double first = std::hypot(b[0] - a[0], b[1] - a[1]), second = std::hypot(c[0] - b[0], c[1] - b[1]);
    along += std::min(first, second) / static_cast<double>(pad.sides.size());
    shortest = std::min({shortest, first, second});
    across = std::max({across, first, second});
  }
  EXPECT_NEAR(along, 0.96, 0.1);
  EXPECT_GT(shortest, 0.4);
  EXPECT_LT(across, 9);
}

TEST(SpatulaTest, TipIsTheForemostNodeOfTheUnderside) {
  for (int target : {300, 5000}) {
    const Mesh mesh = spatula(small(target));
    const std::vector<int>& tip = named(mesh.node_sets, "tip").nodes;
    ASSERT_EQ(tip.size(), 1u);
    const Vec p = position(mesh, tip[0]);
    EXPECT_NEAR(p[0], 230, 1e-12);
    EXPECT_EQ(p[1], 0);
    EXPECT_EQ(p[2], SpatulaShape().gap);
  }
}

TEST(SpatulaTest, ShaftEndIsAPlaneDisk) {
  const Mesh mesh = spatula({});
  EXPECT_EQ(named(mesh.side_sets, "shaft end").sides.size(), 272u);
  const Vec area = area_vector(mesh, "shaft end");
  EXPECT_NEAR(area[0], -area[2], 1e-9);  // along the shaft, at 45 degrees
  EXPECT_NEAR(area[1], 0, 1e-9);
  // A polygon in the circle: 44 sides above and below, 2 at either end.
  const double below = 3 * M_PI / 4 / 44, end = M_PI / 8;
  EXPECT_NEAR(std::hypot(area[0], area[2]), 800 * (88 * std::sin(below) + 4 * std::sin(end)), 1e-8);
  const double r = 68, beyond = 280 - r * M_PI / 4, c = std::sqrt(0.5);
  const double x = -r * c - beyond * c, z = SpatulaShape().gap + 7.5 + r * (1 - c) + beyond * c;
  for (int node : named(mesh.node_sets, "shaft end").nodes) {
    const Vec p = position(mesh, node);
    EXPECT_NEAR((p[0] - x) * -c + (p[2] - z) * c, 0, 1e-10);
    EXPECT_LE(std::hypot(p[0] - x, std::hypot(p[1], p[2] - z)), 40 + 1e-10);
  }
}

std::string refusal(const std::function<void(SpatulaShape&)>& change) {
  SpatulaShape shape = small(1000);
  change(shape);
  try {
    spatula(shape);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SpatulaTest, BadLengthsAreRefused) {
  const std::vector<std::pair<std::string, double SpatulaShape::*>> lengths{
      {"pad length", &SpatulaShape::pad_length},
      {"neck width", &SpatulaShape::neck_width},
      {"widening length", &SpatulaShape::widening_length},
      {"tip length", &SpatulaShape::tip_length},
      {"rear thickness", &SpatulaShape::rear_thickness},
      {"tip thickness", &SpatulaShape::tip_thickness},
      {"shaft diameter", &SpatulaShape::shaft_diameter},
      {"shaft length", &SpatulaShape::shaft_length},
      {"gap", &SpatulaShape::gap}};
  for (const auto& [name, member] : lengths) {
    const auto field = member;
    EXPECT_EQ(refusal([&](SpatulaShape& s) { s.*field = 0; }), "spatula: " + name + " 0 must be positive");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal([&](SpatulaShape& s) { s.*field = nan; }), "spatula: " + name + " nan must be positive");
  }
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.tip_width = 90; }),
            "spatula: tip width 90 must be at least the neck width, 100");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.tip_length = 140; }),
            "spatula: tip length 140 must be at most the pad length less the widening length, 130");
}

TEST(SpatulaTest, BadBendsAreRefused) {
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.inclination = 91; }),
            "spatula: inclination 91 must be greater than 0 and at most 90");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.fillet_radius = 40; }),
            "spatula: fillet radius 40 must be greater than half the thickness of shaft and pad, 40");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.transition_length = 50; }),
            "spatula: transition length 50 must be at least the length of the fillet, 53.4071");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.inclination = 20; }),
            "spatula: transition length 100 is too short, the transition sinks below the pad's underside: lengthen it, "
            "or choose a larger inclination or a smaller fillet radius or shaft diameter");
}

TEST(SpatulaTest, BadCountsAreRefused) {
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.core_cells = 5; }),
            "spatula: core cells 5 must be even and between 4 and 1000");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.core_layers = 0; }), "spatula: core layers 0 must be between 1 and 100");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.rings = 0; }), "spatula: rings 0 must be between 1 and 100");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.tip_rows = 22; }),
            "spatula: tip rows 22 must be between 1 and half the core cells less 1, 21");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.stations = 2; }), "spatula: stations 2 must be 0, or between 3 and 100000");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.target_cells = 100; }),
            "spatula: target cells 100 must be between 200 and 20000000");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.growth = 0.5; }), "spatula: growth 0.5 must be between 1 and 100");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.layer_ratio = 0; }), "spatula: layer ratio 0 must be between 1 and 100");
}

}  // namespace
}  // namespace ixos
