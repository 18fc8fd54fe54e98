// A bar with a Maxwell branch vibrates: its decay against the closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "material/linear_elastic.hpp"
#include "mesh/generators/shapes.hpp"
#include "model/conditions.hpp"
#include "support/solids.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

constexpr double pi = 3.14159265358979;

// The longest mode of a bar that is fixed at one end, in uniaxial strain, nu = 0: modulus 1 + g s tau/(1 + s tau), g =
// 0.2 from a branch of 3/4 g, tau = 0.02, L = 100, rho = 5e-7. Its s solves tau s^3 + s^2 + k^2 c^2 tau (1 + g) s + k^2
// c^2 = 0, k = pi/(2 L), c^2 = 1/rho.
TEST(ViscoelasticBarTest, ItDecaysAsItsComplexModulusSays) {
  BoxShape shape;
  shape.lengths = {100, 5, 1};
  shape.divisions = {40, 1, 1};
  Material material = test::elastic(linear_elastic, 0);
  material.density = 5e-7;
  material.branches = {{0.15, 0.02}};
  material.history_update = HistoryUpdate::SecondOrder;
  const auto model = test::model_of(box(shape), material, Inertia::Consistent);
  prescribe(*model, "left", "all");
  prescribe(*model, "bottom", "y");
  prescribe(*model, "top", "y");
  const std::vector<double>& x = model->mesh().coordinates;
  const auto mode = [&](std::size_t i) { return std::sin(pi / 200 * x[i]); };
  std::vector<double> v = test::at_rest(*model);
  for (std::size_t i = 0; i < v.size(); i += 2) v[i] = 0.02 * mode(i);
  Integrator integrator = test::direct(*model, average_vector_field(2, 1), 1e-13);
  integrator.initialize(test::at_rest(*model), v, 0);
  const double dt = 0.001;
  std::vector<double> amplitudes;
  for (int step = 0; step < 500; ++step) {
    ASSERT_TRUE(integrator.step(dt).converged);
    double share = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(model->space().owned()); i += 2)
      share += integrator.state().u[i] * mode(i);
    model->space().sum(&share, 1);
    amplitudes.push_back(share);
  }
  // The real root, -48, is gone after 300 steps. Then u(t + 2 T) = p u(t + T) + q u(t), p = 2 exp(a T) cos(b T), q =
  // -exp(2 a T) for s = a + i b.
  const auto u = [&](int step) { return amplitudes[static_cast<std::size_t>(300 + step)]; };
  const int stride = 70, later = 35;
  const double determinant = u(stride) * u(later) - u(0) * u(stride + later);
  const double p = (u(2 * stride) * u(later) - u(0) * u(2 * stride + later)) / determinant;
  const double q = (u(stride) * u(2 * stride + later) - u(2 * stride) * u(stride + later)) / determinant;
  const double decay = std::log(-q) / (2 * stride * dt), rate = std::acos(p / (2 * std::sqrt(-q))) / (stride * dt);
  EXPECT_NEAR(decay, -0.843156, 2e-3 * 0.843156);
  EXPECT_NEAR(rate, 22.583034, 2e-4 * 22.583034);
  EXPECT_NEAR(std::exp(decay * 2 * pi / rate), 0.790897, 5e-4);
}

}  // namespace
}  // namespace ixos
