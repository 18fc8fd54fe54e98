// Meshes that are split in regions: what fills the body, what is continuous, and how fine it is.
#include "mesh/splitting/refine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "base/small_matrix.hpp"
#include "fem/with_element.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/connected_parts.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/local_mesh.hpp"
#include "mesh/quality.hpp"
#include "mesh/selection.hpp"
#include "mesh/splitting/cell_tree.hpp"
#include "mesh/tied_nodes.hpp"
#include "support/mesh_points.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

Mesh grid(int dimension, int order, int n = 3) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {3, 2, 2};
  shape.divisions = {n, 2, 2};
  Mesh mesh = box(shape);
  if (order == 2) raise_order(mesh);
  return mesh;
}

/// The cells of that box with other corners first, so that their axes point elsewhere; without sets.
Mesh turned_grid(int dimension, int order) {
  Mesh mesh = grid(dimension, 1);
  mesh.side_sets.clear();
  mesh.node_sets.clear();
  const std::vector<int> turn =
      dimension == 2 ? std::vector<int>{1, 2, 3, 0} : std::vector<int>{3, 2, 6, 7, 0, 1, 5, 4};
  ElementBlock& block = mesh.blocks[0];
  for (int cell = 0; cell < block.cells(); ++cell)
    for (int times = 0; times < cell % 4; ++times) {
      const std::vector<int> old(&block.nodes[cell_entry(cell, static_cast<int>(turn.size()))],
                                 &block.nodes[cell_entry(cell, static_cast<int>(turn.size()))] + turn.size());
      for (std::size_t a = 0; a < turn.size(); ++a)
        block.nodes[cell_entry(cell, static_cast<int>(turn.size())) + a] = old[static_cast<std::size_t>(turn[a])];
    }
  if (order == 2) raise_order(mesh);
  return mesh;
}

NamedRegion corner(int dimension, int levels, const std::string& directions = "") {
  RefinedRegion region;
  region.levels = levels;
  region.directions = directions;
  region.lower.assign(static_cast<std::size_t>(dimension), -1);
  region.upper = dimension == 2 ? std::vector<double>{0.6, 0.4} : std::vector<double>{0.6, 0.4, 0.3};
  return {"corner", region};
}

NamedRegion ball(int dimension, int levels) {
  RefinedRegion region;
  region.levels = levels;
  region.sphere_radius = 0.35;
  region.sphere_center = dimension == 2 ? std::vector<double>{1.7, 1.1} : std::vector<double>{1.7, 1.1, 0.9};
  return {"ball", region};
}

std::vector<NamedRegion> cases(int dimension, int number) {
  if (number == 0) return {corner(dimension, 1)};
  if (number == 1) return {corner(dimension, 3)};
  if (number == 2) return {corner(dimension, 1), ball(dimension, 3)};
  if (number == 3) return {corner(dimension, 2, "x")};
  return {corner(dimension, 2, "x"), ball(dimension, 2)};
}
constexpr int all_cases = 5;

/// The field at all nodes, tied ones by their ties.
std::vector<double> field(const Mesh& mesh, const std::function<double(const double*)>& f) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> values;
  for (int node = 0; node < mesh.nodes(); ++node)
    values.push_back(f(&mesh.coordinates[static_cast<std::size_t>(node) * d]));
  for (const Tie& tie : resolved_ties(mesh)) {
    double sum = 0;
    for (std::size_t k = 0; k < tie.masters.size(); ++k)
      sum += tie.weights[k] * values[static_cast<std::size_t>(tie.masters[k])];
    values[static_cast<std::size_t>(tie.node)] = sum;
  }
  return values;
}

/// A number for each node that has nothing to do with its place; tied ones by their ties. Then traces of neighbours
/// differ unless ties make them equal.
std::vector<double> rough_field(const Mesh& mesh) {
  return field(mesh, [](const double* x) { return std::sin(40 * x[0] + 90 * x[1] * x[1] + 17 * x[0] * x[1]); });
}

/// The field at a point of a side, by weights of its corners' places.
double at_point(const Mesh& mesh, const std::vector<double>& values, const Side& side,
                const std::array<double, 3>& place, bool& inside) {
  const ElementBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
  return with_element(block.type, [&](auto tag) {
    using Element = typename decltype(tag)::type;
    constexpr std::size_t D = Element::dimension;
    const int* nodes = &block.nodes[cell_entry(side.cell, Element::nodes)];
    // Boxes: reference coordinates are linear in places, each in one of them. Corners 1, 3 and 4 end the cell's axes.
    std::array<double, D> xi;
    inside = true;
    constexpr std::array<std::size_t, 3> ends{1, 3, 4};
    for (std::size_t k = 0; k < D; ++k) {
      double along = 0, length = 0;
      for (std::size_t i = 0; i < D; ++i) {
        const double from = mesh.coordinates[static_cast<std::size_t>(nodes[0]) * D + i];
        const double way = mesh.coordinates[static_cast<std::size_t>(nodes[ends[k]]) * D + i] - from;
        along += way * (place[i] - from);
        length += way * way;
      }
      xi[k] = 2 * along / length - 1;
      inside = inside && std::abs(xi[k]) < 1 + 1e-9;
    }
    std::array<double, Element::nodes> value;
    std::array<std::array<double, D>, Element::nodes> gradient;
    Element::evaluate(xi, value, gradient);
    double sum = 0;
    for (std::size_t a = 0; a < value.size(); ++a) sum += value[a] * values[static_cast<std::size_t>(nodes[a])];
    return sum;
  });
}

bool near(const Mesh& mesh, const Side& a, const Side& b) {
  const auto pa = centre_of(mesh, corners_of(mesh, a)), pb = centre_of(mesh, corners_of(mesh, b));
  return std::hypot(pa[0] - pb[0], pa[1] - pb[1], pa[2] - pb[2]) < 1;
}

TEST(RefineTest, CellsFillTheBodyOnceAndAreSound) {
  for (const int dimension : {2, 3})
    for (const int order : {1, 2})
      for (int number = 0; number < all_cases; ++number) {
        Mesh mesh = grid(dimension, order);
        const int cells = mesh.cells();
        refine(mesh, cases(dimension, number), order);
        SCOPED_TRACE(testing::Message() << dimension << "D, order " << order << ", case " << number);
        EXPECT_GT(mesh.cells(), cells);
        EXPECT_FALSE(mesh.ties.empty());
        check_cells(mesh);
        EXPECT_NEAR(test::volume(mesh), dimension == 2 ? 6 : 12, 1e-12);
        for (const int part : connected_parts(mesh)) EXPECT_EQ(part, connected_parts(mesh).front());
        double area = 0;
        std::set<std::array<int, 3>> on_surface;
        for (const Side& side : boundary_sides(mesh)) {
          const auto normal = outward_normal(mesh, side);
          area += std::hypot(normal[0], normal[1], normal[2]) / (dimension == 2 ? 1 : 2);
          on_surface.insert({side.block, side.cell, side.side});
        }
        EXPECT_NEAR(area, dimension == 2 ? 10 : 32, 1e-12);
        std::set<std::array<int, 3>> in_set;
        for (const Side& side : side_set_named(mesh, "surface").sides)
          in_set.insert({side.block, side.cell, side.side});
        EXPECT_EQ(in_set, on_surface);
      }
}

TEST(RefineTest, FieldsAreContinuousAcrossHangingSides) {
  for (const int dimension : {2, 3})
    for (const int order : {1, 2})
      for (int number = 0; number < all_cases; ++number) {
        SCOPED_TRACE(testing::Message() << dimension << "D, order " << order << ", case " << number);
        Mesh mesh = turned_grid(dimension, order);
        refine(mesh, cases(dimension, number), order);
        check_cells(mesh);
        EXPECT_NEAR(test::volume(mesh), dimension == 2 ? 6 : 12, 1e-12);
        const std::vector<double> values = rough_field(mesh);
        ASSERT_FALSE(mesh.hanging_sides.empty());
        int compared = 0;
        for (const Side& fine : mesh.hanging_sides)
          for (const Side& coarse : mesh.hanging_sides) {
            if (fine.block == coarse.block && fine.cell == coarse.cell) continue;
            if (!near(mesh, fine, coarse)) continue;
            const auto corners = corners_of(mesh, fine);
            const int n = dimension == 2 ? 2 : 4;
            // Points in the middle and near a corner of the side.
            for (const double share : {1.0 / n, 0.8, 0.4}) {
              std::array<double, 3> place{};
              for (int a = 0; a < n; ++a)
                for (int i = 0; i < dimension; ++i)
                  place[static_cast<std::size_t>(i)] +=
                      (a == 0 ? share : (1 - share) / (n - 1)) *
                      mesh.coordinates[static_cast<std::size_t>(corners[static_cast<std::size_t>(a)] * dimension + i)];
              bool in_coarse = false, in_fine = false;
              const double there = at_point(mesh, values, coarse, place, in_coarse);
              const double here = at_point(mesh, values, fine, place, in_fine);
              if (!in_coarse) continue;
              ++compared;
              ASSERT_NEAR(here, there, 1e-12);
            }
          }
        EXPECT_GT(compared, 0);
      }
}

TEST(RefineTest, PolynomialsOfTheCellsAreReproduced) {
  for (const int dimension : {2, 3})
    for (const int order : {1, 2})
      for (int number = 0; number < all_cases; ++number) {
        Mesh mesh = grid(dimension, order);
        refine(mesh, cases(dimension, number), order);
        const auto f = [&](const double* x) {
          const double z = dimension == 3 ? x[2] : 0;
          return 1 + 2 * x[0] - x[1] + 3 * z + (order == 2 ? x[0] * x[0] - x[1] * z + 0.5 * x[1] * x[1] : 0);
        };
        const std::vector<double> values = field(mesh, f);
        const auto d = static_cast<std::size_t>(dimension);
        for (std::size_t node = 0; node < values.size(); ++node)
          EXPECT_NEAR(values[node], f(&mesh.coordinates[node * d]), 1e-12);
      }
}

TEST(RefineTest, RegionsAreAsFineAsAskedAndNeighboursDifferByOneLevel) {
  Mesh mesh = grid(2, 1);
  refine(mesh, {ball(2, 4)}, 1);
  double least = 10;
  std::map<std::pair<double, double>, double> size;
  const ElementBlock& block = mesh.blocks[0];
  for (int cell = 0; cell < block.cells(); ++cell) {
    const CornerBox box = box_around(mesh, {&block.nodes[cell_entry(cell, 4)], &block.nodes[cell_entry(cell, 4)] + 4});
    const double h = box.upper[0] - box.lower[0];
    EXPECT_NEAR(box.upper[1] - box.lower[1], h, 1e-12);
    least = std::min(least, h);
    const double x = (box.lower[0] + box.upper[0]) / 2 - 1.7, y = (box.lower[1] + box.upper[1]) / 2 - 1.1;
    if (std::hypot(x, y) < 0.35) {
      EXPECT_DOUBLE_EQ(h, 1.0 / 16);
    }
  }
  EXPECT_DOUBLE_EQ(least, 1.0 / 16);
  for (const auto& [a, b, middle] : mesh.hanging_edges) {
    // No node hangs on a half of an edge that has one itself.
    for (const auto& [c, e, other] : mesh.hanging_edges)
      EXPECT_FALSE((c == a && e == middle) || (e == a && c == middle) || (c == b && e == middle) ||
                   (e == b && c == middle));
  }
}

TEST(RefineTest, ChosenDirectionsAloneAreHalved) {
  Mesh mesh = grid(3, 1);
  refine(mesh, {corner(3, 2, "x")}, 1);
  for (int node = 0; node < mesh.nodes(); ++node)
    for (std::size_t i = 1; i < 3; ++i) {
      const double x = mesh.coordinates[static_cast<std::size_t>(node) * 3 + i];
      EXPECT_EQ(x, std::round(x));
    }
  EXPECT_EQ(mesh.cells(), 12 + 3 + 3);  // one cell into four, and those beside it whose edges would have three nodes
}

TEST(RefineTest, NearASideSet) {
  Mesh mesh = grid(2, 1);
  RefinedRegion region;
  region.levels = 2;
  region.side_set = "bottom";
  region.distance = 0.3;
  refine(mesh, {{"bottom", region}}, 1);
  // Cells of 1/4 up to 0.3 from the bottom: two rows, 24 cells; one row of 1/2; the rest as it was.
  EXPECT_EQ(mesh.cells(), 24 + 6 + 3);
  EXPECT_EQ(side_set_named(mesh, "bottom").sides.size(), 12U);
}

TEST(RefineTest, WholeMeshesThatAreRefinedAreThoseOfTheGenerator) {
  for (const int order : {1, 2}) {
    Mesh mesh = grid(3, order);
    RefinedRegion all;
    all.lower = {-1, -1, -1};
    refine(mesh, {{"all", all}}, order);
    EXPECT_TRUE(mesh.ties.empty());
    EXPECT_TRUE(mesh.hanging_sides.empty());
    BoxShape shape;
    shape.dimension = 3;
    shape.lengths = {3, 2, 2};
    shape.divisions = {6, 4, 4};
    Mesh fine = box(shape);
    if (order == 2) raise_order(fine);
    EXPECT_EQ(mesh.nodes(), fine.nodes());
    EXPECT_EQ(mesh.cells(), fine.cells());
    for (std::size_t s = 0; s < fine.side_sets.size(); ++s)
      EXPECT_EQ(mesh.side_sets[s].sides.size(), fine.side_sets[s].sides.size());
    for (std::size_t s = 0; s < fine.node_sets.size(); ++s)
      EXPECT_EQ(std::set<int>(mesh.node_sets[s].nodes.begin(), mesh.node_sets[s].nodes.end()).size(),
                std::set<int>(fine.node_sets[s].nodes.begin(), fine.node_sets[s].nodes.end()).size());
  }
}

TEST(RefineTest, NodeSetsWithoutSidesGetTheNodesBetweenTheirOwn) {
  for (const int order : {1, 2}) {
    Mesh mesh = grid(3, order);
    const auto left = [&mesh] {
      std::set<int> nodes;
      for (int node = 0; node < mesh.nodes(); ++node)
        if (mesh.coordinates[static_cast<std::size_t>(node) * 3] == 0) nodes.insert(node);
      return nodes;
    };
    const std::set<int> before = left();
    mesh.node_sets.push_back({"a plane", {before.begin(), before.end()}});
    refine(mesh, cases(3, 1), order);
    const NodeSet& after = mesh.node_sets.back();
    EXPECT_GT(after.nodes.size(), before.size());
    EXPECT_EQ(after.nodes.size(), left().size());
    EXPECT_EQ(std::set<int>(after.nodes.begin(), after.nodes.end()), left());
  }
}

TEST(RefineTest, RanksSeeWhatTheirNodesFollow) {
  Mesh mesh = grid(3, 1);
  refine(mesh, cases(3, 2), 1);
  std::vector<int> owner(static_cast<std::size_t>(mesh.nodes()));
  for (std::size_t node = 0; node < owner.size(); ++node) owner[node] = static_cast<int>(node % 3);
  long long owned = 0, tied = 0;
  for (int rank = 0; rank < 3; ++rank) {
    const LocalMesh local = localize(mesh, owner, rank, 3);
    owned += local.owned_nodes;
    EXPECT_EQ(local.global_nodes + local.global_tied, mesh.nodes());
    for (int node = local.ties.first(); node < local.nodes(); ++node) {
      tied += local.owns(node) ? 1 : 0;
      for (const NodeTies::Share* share = local.ties.begin(node); share != local.ties.end(node); ++share)
        EXPECT_LT(share->master, local.ties.first());
    }
  }
  EXPECT_EQ(owned, mesh.nodes() - static_cast<long long>(mesh.ties.size()));
  EXPECT_EQ(tied, static_cast<long long>(mesh.ties.size()));
}

TEST(RefineTest, ForecastsComeNearTheNumberOfCells) {
  for (const int dimension : {2, 3}) {
    RefinedRegion near, thin;
    near.side_set = thin.side_set = "bottom";
    near.levels = 9 - dimension;
    near.distance = 0.2;
    thin.levels = 7;
    thin.directions = "y";
    for (const NamedRegion& region : {corner(dimension, 9 - dimension), ball(dimension, 9 - dimension),
                                      NamedRegion{"near", near}, NamedRegion{"thin", thin}}) {
      Mesh mesh = grid(dimension, 1), other = mesh;
      std::vector<RegionSearch> regions;
      regions.emplace_back(mesh, region.region);
      CellTree tree(mesh);
      tree.split(regions, {region.name}, most_refined_cells);
      double leaves = 0;
      tree.for_each_leaf([&](const TreeCell&) { ++leaves; });
      const double ratio = CellTree(other).forecast(regions.front(), 300) / leaves;
      EXPECT_GT(ratio, 0.6) << dimension << region.name << leaves;  // without the cells between regions and the rest
      EXPECT_LT(ratio, 1.2) << dimension << region.name << leaves;
    }
  }
}

TEST(RefineTest, ASmallRegionMayBeFarDeeperThanALargeOne) {
  BoxShape shape;
  shape.lengths = {60, 50, 1};
  shape.divisions = {60, 50, 1};
  Mesh mesh = box(shape);
  RefinedRegion all, small;
  all.lower = {0, 0};
  all.levels = 2;
  small.upper = {0.01, 0.01};
  small.levels = 12;
  EXPECT_NO_THROW(refine(mesh, {{"all", all}, {"small", small}}, 1));
}

TEST(RefineTest, RefusesWhatItCannotDo) {
  const auto with = [](const RefinedRegion& region) {
    return [region] {
      Mesh mesh = grid(2, 1);
      refine(mesh, {{"here", region}}, 1);
    };
  };
  RefinedRegion nowhere, far, plane, set, axis, three;
  const auto expect = [](const auto& action, const char* words) {
    test::expect_contains(test::refusal(action), words);
  };
  expect(with(nowhere), "here: nothing tells where");
  far.lower = {50, 50};
  expect(with(far), "here: no cell of the mesh meets the region");
  three.lower = {0, 0, 0};
  expect(with(three), "Lower has 3 coordinates");
  set.side_set = "botom";
  expect(with(set), "bottom");
  far.lower = {0, 0};
  far.levels = 30;
  expect(with(far), "here: the refined mesh would have about ");
  axis.lower = {0, 0};
  axis.directions = "z";
  expect(with(axis), "no axis");
  expect(
      [] {
        Mesh mesh = grid(2, 1);
        refine(mesh, {corner(2, 1)}, 1);
        refine(mesh, {corner(2, 1)}, 1);
      },
      "tied");
}

}  // namespace
}  // namespace ixos
