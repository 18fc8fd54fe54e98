/// Checks that every interaction of two surfaces must pass.
#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "support/comparison.hpp"
#include "support/pair_of_bodies.hpp"
#include "support/tangents.hpp"

namespace ixos::test {

/// Forces are minus the derivative of the energy, and the tangent, assembled or as a product, is that of the forces.
/// `points`: of the second rule; `rounding`: of a difference of forces; `least`: what the largest product exceeds.
/// The tangent may couple all nodes of both surfaces. Collective.
inline void expect_derivatives(const PairOfBodies& bodies, int points, double rounding, double least) {
  const std::vector<double> from = smooth_field(*bodies.model, 0.02), to = smooth_field(*bodies.model, -0.02),
                            way = noise(*bodies.model, 1);
  const auto owned = static_cast<std::size_t>(bodies.model->space().owned());
  const double h = 1e-6;
  const std::vector<double> ahead = moved(to, h, way), behind = moved(to, -h, way);
  const auto f = bodies.force({nullptr, nullptr, to.data()}, end_rule());
  double work = 0;
  for (std::size_t k = 0; k < owned; ++k) work += f[k] * way[k];
  bodies.model->space().sum(&work, 1);
  EXPECT_NEAR((bodies.energy(ahead) - bodies.energy(behind)) / (2 * h), work, 1e-8 * (1 + std::abs(work)));
  EXPECT_GT(std::abs(work), 1e-4);
  for (const Rule& rule : {end_rule(), gauss_rule(points)}) {
    const auto f1 = bodies.force({from.data(), nullptr, ahead.data()}, rule);
    const auto f0 = bodies.force({from.data(), nullptr, behind.data()}, rule);
    const Segment segment{from.data(), nullptr, to.data()};
    const auto k_way = bodies.product(segment, rule, way);
    double largest = 0;
    for (std::size_t k = 0; k < owned; ++k) largest = std::max(largest, std::abs(k_way[k]));
    largest = bodies.model->space().maximum(largest);
    for (std::size_t k = 0; k < owned; ++k) EXPECT_NEAR((f1[k] - f0[k]) / (2 * h), k_way[k], 1e-8 * largest + rounding);
    EXPECT_GT(largest, least);
    const auto action = bodies.term->create_action();
    action->linearize(segment, rule, Tangent::Exact, {});
    std::vector<double> y(to.size(), 0.0), diagonal(to.size(), 0.0), sums(to.size(), 0.0);
    action->add_product(way.data(), y.data());
    action->add_diagonal(diagonal.data());
    for (std::size_t k = 0; k < owned; ++k) EXPECT_NEAR(y[k], k_way[k], 1e-6 * largest);  // single precision
    if (!rule.has_end()) continue;
    EXPECT_TRUE(bodies.term->add_row_sums({nullptr, nullptr, to.data()}, sums.data()));
    for (std::size_t k = 0; k < owned; ++k) EXPECT_GE(sums[k], std::abs(diagonal[k]) - 1e-14);
  }
}

/// Forces on both bodies cancel, and so do their moments, to these parts of the sum of all forces, which exceeds
/// `least`. Collective.
inline void expect_no_net_force(const PairOfBodies& bodies, double of_force, double of_moment, double least) {
  const LocalMesh& mesh = bodies.model->mesh();
  const std::vector<double> u = smooth_field(*bodies.model, 0.02);
  const auto f = bodies.force({nullptr, nullptr, u.data()}, end_rule());
  const auto d = static_cast<std::size_t>(mesh.dimension);
  double sums[7] = {0, 0, 0, 0, 0, 0, 0};  // three components of the force, three of the moment, the size
  for (std::size_t k = 0; k < static_cast<std::size_t>(bodies.model->space().owned()); k += d)
    for (std::size_t i = 0; i < d; ++i) {
      sums[i] += f[k + i];
      sums[6] += std::abs(f[k + i]);
      const std::size_t j = (i + 1) % d;
      if (d == 3 || i == 0)
        sums[3 + i] +=
            (mesh.coordinates[k + i] + u[k + i]) * f[k + j] - (mesh.coordinates[k + j] + u[k + j]) * f[k + i];
    }
  bodies.model->space().sum(sums, 7);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(sums[i], 0, of_force * sums[6]);
  for (int i = 3; i < 6; ++i) EXPECT_NEAR(sums[i], 0, of_moment * sums[6]);
  EXPECT_GT(sums[6], least);
}

}  // namespace ixos::test
