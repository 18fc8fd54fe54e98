// Bodies of revolution against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "discretization/nodal_measure.hpp"
#include "histories/time_function.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "model/conditions.hpp"
#include "support/contact_element.hpp"
#include "support/reports.hpp"
#include "support/solids.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

/// Places of a unit square's points.
using Map = std::function<std::array<double, 2>(double s, double t)>;

Mesh section(int across, int along, const Map& map, int order = 1) {
  BoxShape shape;
  shape.divisions = {across, along, 1};
  Mesh mesh = box(shape);
  if (order == 2) raise_order(mesh);
  mesh.axisymmetric = true;
  for (std::size_t k = 0; k < mesh.coordinates.size(); k += 2) {
    const auto x = map(mesh.coordinates[k], mesh.coordinates[k + 1]);
    mesh.coordinates[k] = x[0];
    mesh.coordinates[k + 1] = x[1];
  }
  return mesh;
}

/// Prescribes value(X, Y) of component i for the nodes of a set that it holds for; NaN leaves a node free.
void hold(Model& model, const std::string& set, int i, const std::function<double(double, double)>& value) {
  const LocalMesh& mesh = model.mesh();
  const auto motion = value_ramp(1.0, 0.0, 1.0, RampShape::Linear);
  for (const int node : mesh.node_sets[mesh.node_set(set)]) {
    const double* x = &mesh.coordinates[2 * static_cast<std::size_t>(node)];
    if (!model.constraints().holds(2 * node + i)) model.constraints().add(2 * node + i, value(x[0], x[1]), motion);
  }
}

std::vector<double> equilibrium(Model& model) {
  Integrator integrator = test::direct(model, static_equilibrium());
  integrator.initialize(test::at_rest(model), test::at_rest(model), 0.0);
  const StepResult result = integrator.step(1.0);
  EXPECT_TRUE(result.converged) << result.reason;
  return integrator.state().u;
}

/// Returns the root of the mean square of u - expected(X, Y) over the volume. (Along the axis, the largest error of
/// bilinear elements converges more slowly by a logarithm.)
double error(const Model& model, const std::vector<double>& u,
             const std::function<std::array<double, 2>(double, double)>& expected) {
  const LocalMesh& mesh = model.mesh();
  std::vector<double> volume(static_cast<std::size_t>(mesh.nodes()), 0.0);
  for (const LocalBlock& block : mesh.blocks) add_block_measure(mesh, block, volume);
  double sums[2] = {0, 0};
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.owned_nodes); ++node) {
    if (mesh.is_derivative(node)) continue;
    const auto value = expected(mesh.coordinates[2 * node], mesh.coordinates[2 * node + 1]);
    sums[0] += volume[node];
    for (std::size_t i = 0; i < 2; ++i) sums[1] += volume[node] * std::pow(u[2 * node + i] - value[i], 2);
  }
  model.space().sum(sums, 2);
  return std::sqrt(sums[1] / sums[0]);
}

constexpr double nu = 0.3, inner = 1, outer = 3;
const Lame lame = lame_constants(1, nu);

// Lame: u_r = p a^2/(b^2 - a^2) [(1 - 2 nu) r + b^2/r]/(2 mu) in a pipe held along its axis (Timoshenko and Goodier
// 1970, section 28).
TEST(AxisymmetryVerification, PipeUnderPressure) {
  const double p = 0.1, factor = p * inner * inner / (outer * outer - inner * inner) / (2 * lame.mu);
  double before = 0;
  for (const int divisions : {8, 16, 32}) {
    const auto model = test::model_of(section(divisions, 2,
                                              [](double s, double t) {
                                                return std::array{inner + (outer - inner) * s, t};
                                              }),
                                      test::elastic(linear_elastic, nu), Inertia::None);
    for (const char* set : {"bottom", "top"}) prescribe(*model, set, "y");
    add_traction(*model, "left", {p, 0.0}, value_ramp(1.0, 0.0, 1.0, RampShape::Linear));
    const double now = error(*model, equilibrium(*model), [&](double r, double) {
      return std::array{factor * ((1 - 2 * nu) * r + outer * outer / r), 0.0};
    });
    if (before > 0) {
      EXPECT_NEAR(std::log2(before / now), 2, 0.1) << divisions;
    }
    before = now;
  }
  EXPECT_LT(before, 2e-4);
}

/// Returns the errors of the displacement and of the elastic energy of a hollow half sphere whose inner radius grows by
/// `swell`. Lame: u_r = A r + B/r^2, free outside: B = 3 K A b^3/(4 mu) (Timoshenko and Goodier 1970, section 136). The
/// energy is half the work of the pressure p = -3 K A + 4 mu B/a^3 over the inner surface 2 pi a^2. Its error is
/// relative.
std::array<double, 2> errors_of_a_hollow_sphere(Formulation formulation, int order, int divisions, double poisson,
                                                double swell) {
  const Lame constants = lame_constants(1, poisson);
  const double bulk = constants.lambda + 2 * constants.mu / 3;
  const double ratio = 3 * bulk * outer * outer * outer / (4 * constants.mu);  // B/A
  const double a = swell / (inner + ratio / (inner * inner)), b = ratio * a;
  const double pressure = -3 * bulk * a + 4 * constants.mu * b / (inner * inner * inner);
  const double energy = 0.5 * pressure * swell * 2 * M_PI * inner * inner;
  Material material = test::elastic(linear_elastic, poisson);
  material.formulation = formulation;
  const auto quarter = [](double s, double t) {
    const double r = inner + (outer - inner) * s, phi = M_PI / 2 * t;
    return std::array{r * std::cos(phi), r * std::sin(phi)};
  };
  const auto model = test::model_of(section(divisions, divisions, quarter, order), material, Inertia::None);
  prescribe(*model, "bottom", "y");
  for (int i = 0; i < 2; ++i) hold(*model, "left", i, [&](double x, double y) { return swell * (i == 0 ? x : y); });
  const std::vector<double> u = equilibrium(*model);
  return {error(*model, u,
                [&](double x, double y) {
                  const double r = std::hypot(x, y), stretch = a + b / (r * r * r);
                  return std::array{stretch * x, stretch * y};
                }),
          std::abs(test::ReportAt(*model, u.data()).energy(Part::Elastic) / energy - 1)};
}

TEST(AxisymmetryVerification, HollowSphereBlownUp) {
  const double swell = 0.01;
  for (const Formulation formulation : {Formulation::Standard, Formulation::MeanDilatation, Formulation::Enhanced}) {
    std::array<double, 2> before{};
    for (const int divisions : {8, 16, 32}) {
      const std::array<double, 2> now = errors_of_a_hollow_sphere(formulation, 1, divisions, nu, swell);
      for (std::size_t k = 0; k < 2; ++k) {
        if (before[k] > 0) {
          EXPECT_GT(std::log2(before[k] / now[k]), 1.7) << divisions << ", " << k;
        }
      }
      before = now;
    }
    EXPECT_LT(before[0], 2e-3 * swell);
    EXPECT_LT(before[1], 5e-3);
  }
}

TEST(AxisymmetryVerification, HollowSphereOfQuadraticCellsBlownUp) {
  const double swell = 0.01;
  for (const double poisson : {0.3, 0.49}) {
    const auto errors = [&](int divisions) {
      return errors_of_a_hollow_sphere(Formulation::MeanDilatation, 2, divisions, poisson, swell);
    };
    const std::array<double, 2> coarse = errors(4), fine = errors(8);
    EXPECT_GT(std::log2(coarse[0] / fine[0]), 2.5) << poisson;
    EXPECT_GT(std::log2(coarse[1] / fine[1]), 2.5) << poisson;
    EXPECT_LT(fine[0], 2e-3 * swell);
    EXPECT_LT(fine[1], 5e-3);
  }
}

// A bar with free sides stays homogeneous: mu (b - 1) + lambda ln(l b) = 0 for the stretches l along and sqrt(b)
// across.
TEST(AxisymmetryVerification, BarWithFreeSidesIsStretched) {
  const double along = 1.3, radius = 2, height = 3;
  double b = 1;
  for (int k = 0; k < 50; ++k)
    b -= (lame.mu * (b - 1) + lame.lambda * std::log(along * b)) / (lame.mu + lame.lambda / b);
  const double across = std::sqrt(b), j = along * b;
  const double density =
      lame.mu / 2 * (2 * b + along * along - 3) - lame.mu * std::log(j) + lame.lambda / 2 * std::log(j) * std::log(j);
  for (const ContactElement element :
       {ContactElement::Q1C1, ContactElement::Q1C3, ContactElement::Q1CH, ContactElement::Q2C2, ContactElement::Q2C4})
    for (const Formulation formulation : {Formulation::Standard, Formulation::MeanDilatation, Formulation::Enhanced}) {
      Mesh mesh = section(3, 4, [&](double s, double t) {
        const double bump = 0.3 * std::sin(M_PI * s) * std::sin(M_PI * t);
        return std::array{radius * s + bump, height * t + bump};
      });
      if (test::is_of_quadratic_cells(element) && formulation == Formulation::Enhanced) continue;  // refused
      if (element != ContactElement::Q1C1) test::give_contact_element(mesh, "bottom", element, 0);
      Material material = test::elastic(neo_hooke, nu);
      material.formulation = formulation;
      const auto model = test::model_of(mesh, material, Inertia::None);
      prescribe(*model, "bottom", "y");
      hold(*model, "top", 1, [&](double, double y) { return (along - 1) * y; });
      const std::vector<double> u = equilibrium(*model);
      EXPECT_LT(error(*model, u,
                      [&](double x, double y) {
                        return std::array{(across - 1) * x, (along - 1) * y};
                      }),
                1e-9)
          << static_cast<int>(element) << ", " << static_cast<int>(formulation);
      const double volume = M_PI * radius * radius * height;
      EXPECT_NEAR(test::ReportAt(*model, u.data()).energy(Part::Elastic), volume * density, 1e-9 * volume * density);
      // The whole force at the top is area times first Piola-Kirchhoff stress.
      const std::vector<double> f = test::ReportAt(*model, u.data()).nodal_force(Part::Elastic);
      const LocalMesh& local = model->mesh();
      double force = 0;
      for (const int node : local.node_sets[local.node_set("top")])
        if (node < local.owned_nodes) force += f[2 * static_cast<std::size_t>(node) + 1];
      model->space().sum(&force, 1);
      EXPECT_NEAR(force, M_PI * radius * radius * lame.mu * (along - b / along), 1e-9);
    }
}

}  // namespace
}  // namespace ixos
