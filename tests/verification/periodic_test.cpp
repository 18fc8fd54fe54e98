// Bodies with periodic sides: a wave that runs through them, and pressure without lateral strain.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "material/elastic_law.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/joined_parts.hpp"
#include "mesh/mortar/tied_surfaces.hpp"
#include "mesh/periodic_sides.hpp"
#include "mesh/selection.hpp"
#include "mesh/splitting/refine.hpp"
#include "mesh/tied_nodes.hpp"
#include "model/conditions.hpp"
#include "model/set_reactions.hpp"
#include "model/state_report.hpp"
#include "support/comparison.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"
#include "support/simplices.hpp"
#include "support/solids.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

constexpr double pi = 3.14159265358979323846;

Mesh bar(int dimension, int along, double length) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {length, 1, 1};
  shape.divisions = {along, 2, 2};
  return box(shape);
}

/// Two bars of length 2, one upon the other, with 4 and 3 cells along: the parts "lower" and "upper".
Mesh stacked_bars() {
  BoxShape upper;
  upper.dimension = 2;
  upper.lower = {0, 1, 0};
  upper.lengths = {2, 1, 1};
  upper.divisions = {3, 2, 1};
  return joined_parts({{"lower", bar(2, 4, 2)}, {"upper", box(upper)}});
}

/// Refines below, away from the left and right, and in space from front to back.
void refine_middle(Mesh& mesh) {
  RefinedRegion middle;
  middle.lower.assign(static_cast<std::size_t>(mesh.dimension), -1);
  middle.upper.assign(static_cast<std::size_t>(mesh.dimension), 0.4);
  middle.lower[0] = 0.9;
  middle.upper[0] = 1.1;
  if (mesh.dimension == 3) middle.upper[1] = 2;
  refine(mesh, {{"middle", middle}}, 1);
}

/// Length 2, n cells along; the wave's amplitude is small.
double error_of_wave(int n) {
  Mesh mesh = bar(2, n, 2);
  make_periodic(mesh, "right", "left", 0);
  const Material rubber = test::elastic(linear_elastic, 0.25);
  const auto model = test::model_of(mesh, rubber, Inertia::Consistent);
  for (const char* set : {"top", "bottom"}) prescribe(*model, set, "y", nullptr);
  const Lame lame = rubber.law->lame();
  const double c = std::sqrt(lame.lambda + 2 * lame.mu), k = pi, size = 1e-3;
  const LocalMesh& local = model->mesh();
  std::vector<double> u = test::at_rest(*model), v = u;
  for (std::size_t node = 0; node < static_cast<std::size_t>(local.nodes()); ++node) {
    u[2 * node] = size * std::cos(k * local.coordinates[2 * node]);
    v[2 * node] = size * k * c * std::sin(k * local.coordinates[2 * node]);
  }
  Integrator integrator = test::direct(*model, midpoint());
  integrator.initialize(u, v, 0.0);
  const int steps = 4 * n;  // once through the bar
  for (int step = 0; step < steps; ++step) EXPECT_TRUE(integrator.step(2 / c / steps).converged);
  EXPECT_LT(std::abs(StateReport(*model, integrator.state()).momenta().linear[0]), 1e-12);
  return test::distance(integrator.state().u, u) / size;
}

TEST(PeriodicTest, AWaveComesInWhereItHasLeft) {
  const double coarse = error_of_wave(8), fine = error_of_wave(16);
  EXPECT_LT(fine, 0.05);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.2);
}

TEST(PeriodicTest, PressureWithoutLateralStrainHasTheModulusOfThePlaneWave) {
  for (const int dimension : {2, 3})
    for (const bool refined : {false, true}) {
      Mesh mesh = bar(dimension, 4, 2);
      if (refined) refine_middle(mesh);
      make_periodic(mesh, "right", "left", 0);

      if (dimension == 3) make_periodic(mesh, "back", "front", 0);
      const Material rubber = test::elastic(linear_elastic, 0.3);
      const auto model = test::model_of(mesh, rubber, Inertia::None);
      const std::string axis = dimension == 2 ? "y" : "z";
      prescribe(*model, "bottom", "all", nullptr);
      prescribe(*model, "top", axis, rate_ramp(-0.01, 0.0, 0.0, RampShape::Linear));
      Integrator integrator = test::direct(*model, static_equilibrium());
      integrator.initialize(test::at_rest(*model), test::at_rest(*model), 0.0);
      ASSERT_TRUE(integrator.step(1.0).converged);
      const Lame lame = rubber.law->lame();
      const std::vector<double> reaction = set_reaction(*model, integrator.state().reaction, "top");
      EXPECT_NEAR(reaction.back(), -0.01 * (lame.lambda + 2 * lame.mu) * 2, 1e-9) << dimension << "D";
    }
}

TEST(PeriodicTest, SidesThatDoNotFitAreRefusedWithNamesAndPlaces) {
  const auto expect = [](const std::string& secondary, const std::string& primary, const char* words,
                         bool split = false) {
    test::expect_contains(test::refusal([&] {
                            Mesh mesh = bar(2, 4, 2);
                            if (split) {
                              RefinedRegion corner;
                              corner.upper = {0.1, 0.1};
                              refine(mesh, {{"corner", corner}}, 1);
                            }
                            make_periodic(mesh, secondary, primary, 0);
                          }),
                          words);
  };
  expect("right", "lef", "\"left\"");
  expect("top", "left", "share node");
  expect("surface", "surface", "share node");
  expect("right", "left", "periodic sides have the same mesh", true);
  test::expect_contains(test::refusal([] {
                          Mesh mesh = bar(2, 4, 2);
                          mesh.coordinates[2 * 5 + 1] += 0.1;
                          make_periodic(mesh, "right", "left", 0);
                        }),
                        "has no partner in \"left\"");
}

PeriodicNodes both(PeriodicNodes all, const PeriodicNodes& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

TEST(PeriodicTest, NodesThatFollowOthersAlreadyAreRefused) {
  const auto refusal = [](const std::string& first, const std::string& second) {
    return test::refusal([&] {
      Mesh mesh = bar(2, 4, 2);
      const PeriodicNodes own = make_periodic(mesh, first, second, 0), more = make_periodic(mesh, "right", "left", 0);
      require_periodic(mesh, both(own, more));
    });
  };
  EXPECT_EQ(refusal("top", "bottom"), "");  // a corner of both has one partner in the end
  EXPECT_EQ(refusal("right", "left"), "");  // said twice
  Mesh mesh = stacked_bars();
  tie_surfaces(mesh, "upper_bottom", "lower_top", 0);
  const PeriodicNodes left = make_periodic(mesh, "upper_bottom", "upper_top", 0);
  test::expect_contains(test::refusal([&] { require_periodic(mesh, left); }),
                        "follows other nodes already: it hangs on a coarser cell, or belongs to a tied surface");
}

/// Nodes of both parts stand at the ends of the joint: each set has two of one place, or the list of each part one that
/// follows the other part's.
TEST(PeriodicTest, TiedPartsMayBePeriodicTogetherOrEachByItself) {
  const auto joined = [] {
    Mesh mesh = stacked_bars();
    for (const char* side : {"left", "right"}) {
      SideSet both{side, side_set_named(mesh, std::string("lower_") + side).sides};
      const std::vector<Side>& more = side_set_named(mesh, std::string("upper_") + side).sides;
      both.sides.insert(both.sides.end(), more.begin(), more.end());
      mesh.side_sets.push_back(std::move(both));
    }
    tie_surfaces(mesh, "upper_bottom", "lower_top", 0);
    return mesh;
  };
  Mesh together = joined(), apart = joined();
  const PeriodicNodes all = make_periodic(together, "right", "left", 0);
  EXPECT_NO_THROW(require_periodic(together, all));
  const PeriodicNodes own = make_periodic(apart, "upper_right", "upper_left", 0),
                      more = make_periodic(apart, "lower_right", "lower_left", 0);
  EXPECT_FALSE(both(own, more).empty());
  EXPECT_NO_THROW(require_periodic(apart, both(own, more)));
  const std::vector<Tie> one = resolved_ties(together), other = resolved_ties(apart);
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].node, other[k].node);
    EXPECT_EQ(one[k].masters, other[k].masters);
  }
}

TEST(PeriodicTest, OneNodeHasOnePartner) {
  Mesh mesh = bar(2, 4, 2);
  for (int node = 0; node < mesh.nodes(); ++node) {  // the middle of the right side comes near its upper end
    double* const x = &mesh.coordinates[2 * static_cast<std::size_t>(node)];
    if (x[0] > 1.9 && x[1] > 0.4 && x[1] < 0.6) x[1] = 0.9;
  }
  test::expect_contains(test::refusal([&] { make_periodic(mesh, "right", "left", 1); }), "have the same partner");
}

TEST(PeriodicTest, ABodyOfRevolutionRepeatsAlongItsAxis) {
  Mesh ring = bar(2, 4, 2);
  ring.axisymmetric = true;
  Mesh rod = ring;
  EXPECT_NO_THROW(make_periodic(rod, "top", "bottom", 0));
  test::expect_contains(test::refusal([&] { make_periodic(ring, "right", "left", 0); }),
                        "the sides are 2 L0 apart along x, the radius");
}

/// A cube of five tetrahedra cuts opposite faces along crossing diagonals, one of six along the same.
TEST(PeriodicTest, TrianglesOfPeriodicSidesHaveTheSameDiagonals) {
  Mesh cube = bar(3, 1, 1);
  Mesh six = test::split_cells(cube, "tetrahedra");
  EXPECT_NO_THROW(make_periodic(six, "left", "right", 0));
  BoxShape shape;
  shape.dimension = 3;
  Mesh five = test::split_cells(box(shape), "tetrahedra");
  const std::vector<int> n(box(shape).blocks[0].nodes);
  five.blocks[0].nodes.clear();
  for (const auto& cell : {std::array{0, 1, 3, 4}, {1, 2, 3, 6}, {4, 6, 5, 1}, {4, 7, 6, 3}, {1, 3, 4, 6}})
    for (const int a : cell) five.blocks[0].nodes.push_back(n[static_cast<std::size_t>(a)]);
  SideSet left{"left", {}}, right{"right", {}};
  for (const Side& side : boundary_sides(five)) {
    const double x = centre_of(five, corners_of(five, side))[0];
    if (x < 1e-9) left.sides.push_back(side);
    if (x > 1 - 1e-9) right.sides.push_back(side);
  }
  five.side_sets = {left, right};
  test::expect_contains(test::refusal([&] { make_periodic(five, "left", "right", 0); }),
                        "its triangles are cut along another diagonal");
}

TEST(PeriodicTest, LoopsAreRefusedWhenRanksTakeTheirParts) {
  Mesh mesh = bar(2, 4, 2);
  make_periodic(mesh, "right", "left", 0);
  mesh.ties.push_back({mesh.ties.front().masters.front(), {mesh.ties.front().node}, {1.0}, false});
  test::expect_contains(
      test::refusal([&] { localize(mesh, std::vector<int>(static_cast<std::size_t>(mesh.nodes()), 0), 0, 1); }),
      "follows itself");
}

}  // namespace
}  // namespace ixos
