// Friction between two bodies that turn as one, and whose cells have their nodes in another order.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/vector3.hpp"
#include "fem/cell_type.hpp"
#include "support/comparison.hpp"
#include "term/pair/pair_friction.hpp"
#include "term/rubbing.hpp"

namespace ixos {
namespace {

using test::Rubbing;
using test::rubbing_bodies;

/// Returns a vector turned about the axis (0.3, 0.5, 0.8), in the plane about z.
Vec<3> turned(const Vec<3>& v, double angle, std::size_t dimension) {
  const Vec<3> axis = dimension == 2 ? Vec<3>{0, 0, 1} : 1 / std::sqrt(0.98) * Vec<3>{0.3, 0.5, 0.8};
  return std::cos(angle) * v + std::sin(angle) * cross(axis, v) + (1 - std::cos(angle)) * inner(axis, v) * axis;
}

/// Returns the displacement of that rotation of both bodies.
std::vector<double> turned(const Model& model, const std::vector<double>& u, double angle) {
  std::vector<double> result = u;
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  const std::vector<double>& x = model.mesh().coordinates;
  for (std::size_t k = 0; k < u.size(); k += d) {
    Vec<3> place{};
    for (std::size_t i = 0; i < d; ++i) place[i] = x[k + i] + u[k + i];
    const Vec<3> now = turned(place, angle, d);
    for (std::size_t i = 0; i < d; ++i) result[k + i] = now[i] - x[k + i];
  }
  return result;
}

/// Turns both bodies as one by a right angle, with a stored elastic slip. Returns the largest of three changes: the
/// work that is dissipated and the change of the energy, over that energy, and the difference from the turned force
/// over its size.
double change_by_turning(const Rubbing& bodies, int steps) {
  const Model& model = *bodies.model;
  const std::vector<double> start = bodies.slid(0.002, 0.001);  // less than the elastic slip, 0.006
  bodies.steps->initialize(start.data());
  bodies.step(test::at_rest(model), start);
  const Vec<3> before = bodies.force_on_second(start);
  const double stored = bodies.total(bodies.term->energy(bodies.steps->at(start.data())));
  EXPECT_GT(stored, 1e-6);
  std::vector<double> now = start;
  double lost = 0;
  for (int n = 1; n <= steps; ++n) {
    const std::vector<double> next = turned(model, start, n * M_PI / 2 / steps);
    lost += bodies.step(now, next);
    now = next;
  }
  const Vec<3> difference = bodies.force_on_second(now) - turned(before, M_PI / 2, bodies.between.size());
  return std::max({std::abs(bodies.total(lost)) / stored,
                   std::abs(bodies.total(bodies.term->energy(bodies.steps->at(now.data()))) - stored) / stored,
                   length(difference) / length(before)});
}

/// The elastic slip turns with the bodies, in steps of any size.
TEST(PairFrictionTest, BodiesThatTurnAsOneDoNotSlip) {
  for (const Smoothing smoothing : {Smoothing::None, Smoothing::CatmullRom, Smoothing::Spline})
    for (const Rubbing& bodies : rubbing_bodies(FrictionType::ConstantStress, smoothing))
      for (const int steps : {1, 5}) EXPECT_LT(change_by_turning(bodies, steps), 1e-9) << steps;
}

TEST(PairFrictionTest, BoxesThatTurnAsOneInShortStepsDoNotSlip) {
  for (const bool swapped : {false, true}) {
    const Rubbing boxes(test::two_boxes(0.26), swapped ? "lower_top" : "upper_bottom",
                        swapped ? "upper_bottom" : "lower_top", {0, 0, 0.2}, FrictionType::ConstantStress);
    for (const int steps : {20, 80, 320}) EXPECT_LT(change_by_turning(boxes, steps), 1e-9) << steps;
  }
}

/// A hexahedron's node that stands at a place after `turns` quarter turns about its third axis.
std::size_t turned_corner(std::size_t corner, std::size_t turns) { return corner / 4 * 4 + (corner + turns) % 4; }

/// Turns the nodes of all hexahedra. If `mirrored`, the mesh is its mirror image in x = 0.
Mesh relabelled(Mesh mesh, std::size_t turns, bool mirrored) {
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    ElementBlock& block = mesh.blocks[b];
    std::array<std::size_t, 8> from;  // the place of a node among those of before
    for (std::size_t k = 0; k < 8; ++k) {
      from[k] = turned_corner(k, turns);
      if (mirrored) from[k] = from[k] / 4 * 4 + (5 - from[k] % 4) % 4;  // 1, 0, 3, 2
    }
    const std::vector<int> before = block.nodes;
    for (std::size_t n = 0; n < before.size(); ++n) block.nodes[n] = before[n / 8 * 8 + from[n % 8]];
    const auto corners = [&](int side, bool old) {
      std::vector<std::size_t> result;
      for (const int k : side_nodes(block.type, side)) {
        const auto corner = static_cast<std::size_t>(k);
        result.push_back(old ? corner : from[corner]);
      }
      std::sort(result.begin(), result.end());
      return result;
    };
    for (SideSet& set : mesh.side_sets)
      for (Side& side : set.sides) {
        if (side.block != static_cast<int>(b)) continue;
        int now = 0;
        while (corners(now, false) != corners(side.side, true)) ++now;
        side.side = now;
      }
  }
  if (mirrored)
    for (std::size_t k = 0; k < mesh.coordinates.size(); k += 3) mesh.coordinates[k] = -mesh.coordinates[k];
  return mesh;
}

/// Returns forces on the second body and energies over steps that slide and bend both bodies; those of a mirror image
/// are mirrored back.
std::vector<double> life(const Mesh& mesh, Smoothing smoothing, const std::vector<double>& center, std::size_t turns,
                         bool mirrored) {
  const bool balls = center[0] != 0;
  std::vector<double> between = center;
  if (mirrored) between[0] = -between[0];
  const Rubbing bodies(relabelled(mesh, turns, mirrored), balls ? "a_surface" : "upper_bottom",
                       balls ? "b_surface" : "lower_top", between, FrictionType::ConstantStress, smoothing);
  const std::vector<double>& x = bodies.model->mesh().coordinates;
  const auto at = [&](double way, double bend) {
    std::vector<double> u(x.size(), 0.0);
    for (std::size_t k = 0; k < u.size(); k += 3) {
      const double side = mirrored ? -1 : 1, a = side * x[k], b = x[k + 1], c = x[k + 2];
      u[k] = side * bend * (a * b + 0.3 * std::sin(b + c));
      u[k + 1] = bend * (b * c - 0.4 * std::cos(a));
      u[k + 2] = bend * 0.1 * std::sin(2 * a + b);
      if (!bodies.is_second(k)) continue;
      u[k] += side * way;
      u[k + 1] += 0.4 * way;
    }
    return u;
  };
  std::vector<double> results, now = at(0, 0);
  const std::pair<double, double> steps[] = {{0.003, 0.01}, {0.02, 0.04}, {0.01, -0.02}};
  for (const auto& [way, bend] : steps) {
    const std::vector<double> next = at(way, bend);
    results.push_back(bodies.total(bodies.step(now, next)));
    now = next;
    Vec<3> force = bodies.force_on_second(now);
    if (mirrored) force[0] = -force[0];
    results.insert(results.end(), force.begin(), force.end());
    results.push_back(bodies.total(bodies.term->energy(bodies.steps->at(now.data()))));
  }
  return results;
}

/// Neither the corner at which a cell's nodes begin nor a mirror changes the friction.
TEST(PairFrictionTest, TheOrderOfACellsNodesChangesNothing) {
  const struct {
    Mesh mesh;
    std::vector<double> between;
  } all[] = {{test::two_boxes(0.26), {0, 0, 0.2}}, {test::two_balls(2, {2.37, 1.97, 2.8}, 4, 1), {2.37, 1.97, 2.8}}};
  for (const Smoothing smoothing : {Smoothing::None, Smoothing::CatmullRom, Smoothing::Spline})
    for (const auto& bodies : all) {
      const std::vector<double> first = life(bodies.mesh, smoothing, bodies.between, 0, false);
      double largest = 0;
      for (const double value : first) largest = std::max(largest, std::abs(value));
      EXPECT_GT(largest, 1e-3);
      const auto expect_same = [&](std::size_t turns, bool mirrored) {
        const std::vector<double> other = life(bodies.mesh, smoothing, bodies.between, turns, mirrored);
        for (std::size_t i = 0; i < first.size(); ++i) EXPECT_NEAR(other[i], first[i], 1e-9 * largest) << i;
      };
      for (const std::size_t turns : {1U, 2U, 3U}) expect_same(turns, false);
      expect_same(0, true);
      expect_same(3, true);
    }
}

}  // namespace
}  // namespace ixos
