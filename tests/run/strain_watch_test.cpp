#include "run/strain_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/generators/shapes.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

/// 3 x 2 unit squares, nu = 0.
std::unique_ptr<Model> block() {
  BoxShape shape;
  shape.lengths = {3, 2, 1};
  shape.divisions = {3, 2, 1};
  return test::model_of(box(shape), test::elastic(neo_hooke, 0.0), Inertia::None);
}

/// u = (a X + b Y, c Y).
std::vector<double> field(const Model& model, double a, double b, double c) {
  std::vector<double> u = test::at_rest(model);
  for (std::size_t k = 0; k < u.size(); k += 2) {
    const double x = model.mesh().coordinates[k], y = model.mesh().coordinates[k + 1];
    u[k] = a * x + b * y;
    u[k + 1] = c * y;
  }
  return u;
}

TEST(StrainWatchTest, ExtremesOfUniformStrains) {
  const auto model = block();
  StrainWatch watch;
  watch.look(*model, {field(*model, -0.6, 0, 0).data(), 1});   // J = 0.4
  watch.look(*model, {field(*model, 1.5, 0, 0.2).data(), 2});  // J = 2.5 * 1.2
  const StrainExtremes& extremes = watch.extremes();
  EXPECT_NEAR(extremes.least_jacobian, 0.4, 1e-13);
  EXPECT_NEAR(extremes.largest_jacobian, 3, 1e-13);
  EXPECT_GT(extremes.largest_invariant, 0.5);
  EXPECT_NEAR(extremes.least_scaled_jacobian, 1, 1e-13);  // rectangles remain rectangles
}

TEST(StrainWatchTest, AShearDistortsCells) {
  const auto model = block();
  StrainWatch watch;
  watch.look(*model, {field(*model, 0, 3, 0).data(), 7});
  watch.look(*model, {field(*model, 0, 1, 0).data(), 8});
  EXPECT_NEAR(watch.extremes().least_scaled_jacobian, 1 / std::sqrt(10.0), 1e-13);  // det 1, edges 1 and sqrt(1 + 9)
  EXPECT_EQ(watch.extremes().time, 7);
  EXPECT_NEAR(watch.extremes().least_jacobian, 1, 1e-13);
}

}  // namespace
}  // namespace ixos
