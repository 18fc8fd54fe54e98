// Two bodies: one pass and two, and what must not matter.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "interaction/van_der_waals.hpp"
#include "model/term_sums.hpp"
#include "support/pair_of_bodies.hpp"
#include "support/refusal.hpp"
#include "verification/collision.hpp"

namespace ixos {
namespace {

using test::Collision;
using test::count;
using test::word;

constexpr double dt = 0.001;
constexpr int steps = 45;
const std::string points = count("Interaction Points", 5);
const std::string two = word("Passes", "Two");

/// Displacements by node of the whole mesh. Serial: the mesh's own numbers.
std::vector<double> end_of(Collision collision) {
  double least = 1;
  for (int step = 0; step < steps; ++step) {
    EXPECT_TRUE(collision.simulation().integrator().step(dt).converged);
    least = std::min(least, collision.least_gap());
  }
  EXPECT_LT(least, 0.3);
  const LocalMesh& mesh = collision.simulation().model().mesh();
  const std::vector<double>& u = collision.simulation().integrator().state().u;
  std::vector<double> whole(u.size());
  for (std::size_t k = 0; k < whole.size(); ++k)
    whole[2 * static_cast<std::size_t>(mesh.original_ids[k / 2]) + k % 2] = u[k];
  return whole;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

Collision collide(const std::string& pair, const Mesh& mesh, const char* secondary = "a_surface",
                  const char* primary = "b_surface", double angle = 0) {
  return Collision("Average Vector Field", dt, points, pair, mesh, secondary, primary, angle);
}

const Mesh& disks() {
  static const Mesh mesh = test::two_disks(3, {6.1, 2.4});
  return mesh;
}

TEST(PairSymmetrySerialTest, TwoPassesTreatBothBodiesAlike) {
  const auto there = end_of(collide(two, disks())), back = end_of(collide(two, disks(), "b_surface", "a_surface"));
  EXPECT_LT(largest_difference(there, back), 1e-10);
  const auto one = end_of(collide("", disks())), other = end_of(collide("", disks(), "b_surface", "a_surface"));
  EXPECT_GT(largest_difference(one, other), 1e-7) << "one pass does not";
}

TEST(PairSymmetrySerialTest, AMovedFrameMovesTheResult) {
  const double angle = 0.7, c = std::cos(angle), s = std::sin(angle);
  const auto turn = [&](std::vector<double>& x) {
    for (std::size_t k = 0; k < x.size(); k += 2) {
      const double along = x[k], across = x[k + 1];
      x[k] = c * along - s * across;
      x[k + 1] = s * along + c * across;
    }
  };
  Mesh turned = disks();
  turn(turned.coordinates);
  for (const std::string& pair : {std::string(), two}) {
    auto plain = end_of(collide(pair, disks()));
    turn(plain);
    EXPECT_LT(largest_difference(plain, end_of(collide(pair, turned, "a_surface", "b_surface", angle))), 1e-9);
  }
}

TEST(PairSymmetrySerialTest, NumbersOfNodesDoNotMatter) {
  Mesh renumbered = disks();
  const int last = renumbered.nodes() - 1;
  const auto place = [&](int node) { return last - node; };
  for (ElementBlock& block : renumbered.blocks)
    for (int& node : block.nodes) node = place(node);
  for (NodeSet& set : renumbered.node_sets)
    for (int& node : set.nodes) node = place(node);
  for (int node = 0; node <= last; ++node)
    for (std::size_t i = 0; i < 2; ++i)
      renumbered.coordinates[2 * static_cast<std::size_t>(place(node)) + i] =
          disks().coordinates[2 * static_cast<std::size_t>(node) + i];
  const auto plain = end_of(collide("", disks())), other = end_of(collide("", renumbered));
  std::vector<double> back(other.size());
  for (std::size_t k = 0; k < back.size(); ++k)
    back[k] = other[2 * static_cast<std::size_t>(place(static_cast<int>(k / 2))) + k % 2];
  EXPECT_LT(largest_difference(plain, back), 1e-10);
}

/// Forces on bodies that are a mirror image, in the mirrored state, are mirrored.
TEST(PairSymmetrySerialTest, AMirrorMirrorsTheForces) {
  for (const Passes passes : {Passes::One, Passes::Two, Passes::DoubleIntegral}) {
    const auto forces = [&](double side) {
      const test::PairOfBodies bodies(test::two_disks(3, {5, side * 3.6}), "a_surface", "b_surface",
                                      Smoothing::CatmullRom, 0, gap_law(VanDerWaals(2.5, 25)), passes);
      const std::vector<double>& x = bodies.model->mesh().coordinates;
      std::vector<double> u(x.size()), f(x.size(), 0.0);
      for (std::size_t k = 0; k < u.size(); k += 2) {
        u[k] = 0.05 * std::sin(x[k] + 0.5 * side * x[k + 1]);
        u[k + 1] = side * 0.05 * std::cos(1.3 * x[k] - side * x[k + 1]);
      }
      EXPECT_TRUE(TermSums(*bodies.model).force(Part::Interaction, {nullptr, nullptr, u.data()}, end_rule(), f.data()));
      std::vector<std::array<double, 4>> rows;  // place and force, mirrored to the first side
      for (std::size_t k = 0; k < u.size(); k += 2) rows.push_back({x[k], side * x[k + 1], f[k], side * f[k + 1]});
      return rows;
    };
    const auto there = forces(1), mirrored = forces(-1);
    double largest = 0, difference = 0;
    for (const auto& own : there) {
      const auto image = std::min_element(mirrored.begin(), mirrored.end(), [&](const auto& a, const auto& b) {
        return std::hypot(a[0] - own[0], a[1] - own[1]) < std::hypot(b[0] - own[0], b[1] - own[1]);
      });
      ASSERT_LT(std::hypot((*image)[0] - own[0], (*image)[1] - own[1]), 1e-9);
      largest = std::max(largest, std::hypot(own[2], own[3]));
      difference = std::max(difference, std::hypot((*image)[2] - own[2], (*image)[3] - own[3]));
    }
    EXPECT_GT(largest, 1e-4);
    EXPECT_LT(difference, 1e-12 * largest);
  }
}

/// Returns the errors of a collision of disks whose meshes are turned against each other.
test::KeptErrors errors_of(const std::string& pair) {
  Mesh mesh = disks();
  const double c = std::cos(0.3), s = std::sin(0.3);
  for (std::size_t k = 0; k < mesh.coordinates.size(); k += 2) {
    const double x = mesh.coordinates[k] - 6.1, y = mesh.coordinates[k + 1] - 2.4;
    if (x < -3.05) continue;
    mesh.coordinates[k] = 6.1 + c * x - s * y;
    mesh.coordinates[k + 1] = 2.4 + s * x + c * y;
  }
  Collision collision = collide(pair, mesh);
  return test::kept_errors(collision, dt, 60);
}

/// With reactions energy and linear momentum stay. Without, the forces on both bodies differ, and neither stays.
TEST(PairSymmetryTest, PassesWithoutReactionLoseEnergyAndMomentum) {
  const test::KeptErrors with = errors_of(two), without = errors_of(word("Passes", "Two Without Reaction"));
  EXPECT_LT(with.energy, 1e-5);
  EXPECT_LT(with.linear, 1e-12);
  EXPECT_LT(with.angular, 1e-2);
  EXPECT_GT(without.energy, 1e-2);
  EXPECT_GT(without.linear, 1e-2);
}

TEST(PairSymmetryTest, WhatTwoPassesCannotServeIsRefused) {
  const auto refusal = [](const std::string& scheme, const std::string& pair, const char* primary = "b_surface") {
    return test::refusal([&] { Collision(scheme, dt, "", pair, disks(), "a_surface", primary); });
  };
  EXPECT_NE(refusal("Newmark", two + test::number("Exclusion", 3) + test::number("Cutoff", 1), "a_surface").find("One"),
            std::string::npos);
  EXPECT_NE(refusal("Newmark", two + word("Factor", "1 + 0*x")).find("use \"One\""), std::string::npos);
  EXPECT_NE(refusal("Energy-Momentum", word("Passes", "Two Without Reaction")).find("Interactions/Pair/Passes"),
            std::string::npos);
}

}  // namespace
}  // namespace ixos
