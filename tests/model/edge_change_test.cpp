#include "model/edge_change.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

/// Returns the displacements F X - X + shift of a block's nodes, with F = [[a, b], [c, d]].
std::vector<double> affine(const Model& model, double a, double b, double c, double d, double shift = 0) {
  const std::vector<double>& x = model.mesh().coordinates;
  std::vector<double> u(x.size());
  for (std::size_t i = 0; i + 1 < x.size(); i += 2) {
    u[i] = a * x[i] + b * x[i + 1] - x[i] + shift;
    u[i + 1] = c * x[i] + d * x[i + 1] - x[i + 1] + shift;
  }
  return u;
}

TEST(EdgeChangeTest, IsTheChangeOfTheGradientForAffineMotions) {
  const Simulation simulation(test::scene(test::block_2d(0) + test::time_integrator("Newmark", 0.1, 1)), test::world());
  const Model& model = simulation.model();
  const auto change = [&](const std::vector<double>& u0, const std::vector<double>& u1) {
    return edge_change(model, u0.data(), u1.data());
  };
  const std::vector<double> rest = affine(model, 1, 0, 0, 1);
  EXPECT_EQ(change(rest, rest), 0);
  EXPECT_NEAR(change(rest, affine(model, 1, 0, 0, 1, 1000)), 0, 1e-12);  // a translation
  // A stretch to 1.1 in x: half-way the edge is 1.05 long.
  EXPECT_NEAR(change(rest, affine(model, 1.1, 0, 0, 1)), 0.1 / 1.05, 1e-12);
  EXPECT_NEAR(change(affine(model, 1.1, 0, 0, 1), rest), 0.1 / 1.05, 1e-12);
  for (const double angle : {1e-3, 0.3}) {
    const double c = std::cos(angle), s = std::sin(angle);
    EXPECT_NEAR(change(rest, affine(model, c, -s, s, c)), 2 * std::tan(angle / 2), 1e-12);
  }
}

}  // namespace
}  // namespace ixos
