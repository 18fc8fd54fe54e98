// The local error from displacements.
#include "time/displacement_error.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/comparison.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

/// u = p + q t + r t^2 + c t^3, the coefficients from node to node as they come; |c| <= 0.3, reached on every rank.
std::vector<double> cubic(std::size_t size, double t, double c) {
  std::vector<double> u(size);
  for (std::size_t i = 0; i < size; ++i) {
    const double p = std::sin(static_cast<double>(i)), q = 1 - p, r = p * p;
    u[i] = p + t * (q + t * (r + t * (i == 0 ? c : 0.5 * c * p)));
  }
  return u;
}

TEST(DisplacementErrorTest, IsExactForCubicsWhateverTheSteps) {
  const Simulation s(test::scene(test::block_2d(0) + test::time_integrator("Average Vector Field", 0.1, 1)), world());
  const Table& table = s.integrator().table();
  const auto size = static_cast<std::size_t>(s.model().space().local());
  for (double c : {0.3, -0.3, 0.0})
    for (const auto& [h2, h1, dt] :
         {std::array{0.1, 0.1, 0.1}, std::array{0.05, 0.1, 0.07}, std::array{0.2, 0.1, 0.3}}) {
      std::vector<State> states(2);
      states[0].u = cubic(size, 0, c);
      states[1].u = cubic(size, dt, c);
      states[1].v.assign(size, 1e3);  // it does not look at velocities
      const std::vector<double> later = cubic(size, -h1, c), earlier = cubic(size, -h1 - h2, c);
      const double error = displacement_error(s.model(), table, states, dt, {later, earlier, h1, h2});
      EXPECT_NEAR(error, std::abs(table.error_constant * 6 * c) * dt * dt * dt, 1e-12);
    }
}

}  // namespace
}  // namespace ixos
