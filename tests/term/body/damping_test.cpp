// Rayleigh damping, C = alpha_1 M + alpha_2 K(0), against closed forms and the matrices that it is made of.
#include "term/body/damping.hpp"

#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>
#include <cmath>
#include <stdexcept>

#include "mesh/generators/shapes.hpp"
#include "model/term_sums.hpp"
#include "support/by_hand.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

constexpr double alpha_1 = 0.3, alpha_2 = 0.2, density = 0.7, nu = 0.3;

/// Returns a rubber block of 3 by 2.
std::unique_ptr<Model> block() {
  BoxShape shape;
  shape.lengths = {3, 2, 0};
  shape.divisions = {4, 3, 0};
  Material material = test::elastic(neo_hooke, nu);
  material.density = density;
  material.mass_damping = alpha_1;
  material.stiffness_damping = alpha_2;
  return test::model_of(box(shape), material, Inertia::Consistent);
}

/// Returns the velocity v = (a + b x + c y, -c x).
std::vector<double> velocity(const Model& model, double a, double b, double c) {
  std::vector<double> v = test::at_rest(model);
  for (std::size_t i = 0; i < v.size(); i += 2) {
    const double x = model.mesh().coordinates[i], y = model.mesh().coordinates[i + 1];
    v[i] = a + b * x + c * y;
    v[i + 1] = -c * x;
  }
  return v;
}

/// Returns 2 C v for owned nodes.
std::vector<double> forces(const Model& model, const std::vector<double>& v) {
  std::vector<double> f(static_cast<std::size_t>(model.space().owned()), 0.0);
  model.damping()->multiply_add(2.0, v.data(), f.data());
  return f;
}

double dissipation(const Model& model, const std::vector<double>& v) {
  const std::vector<double> f = forces(model, v);
  double sum = 0;
  for (std::size_t i = 0; i < f.size(); ++i) sum += f[i] * v[i] / 2;
  model.space().sum(&sum, 1);
  return sum;
}

// A rigid velocity v dissipates alpha_1 times the integral of rho v.v. A strain rate b in x adds alpha_2 times the
// integral of (lambda + 2 mu) b^2. The origin is a corner.
TEST(DampingTest, DissipatesWhatMassAndStrainRateSay) {
  const auto model = block();
  const Lame lame = lame_constants(1, nu);
  EXPECT_NEAR(dissipation(*model, velocity(*model, 2, 0, 0)), alpha_1 * density * 6 * 4, 1e-13);
  const double squares = 6 * (9 + 4) / 3.0;  // of the distances from the origin
  EXPECT_NEAR(dissipation(*model, velocity(*model, 0, 0, 0.5)), alpha_1 * density * 0.25 * squares, 1e-13);
  const double stretched = alpha_1 * density * 6 * 9 / 3.0 + alpha_2 * 6 * (lame.lambda + 2 * lame.mu);
  EXPECT_NEAR(dissipation(*model, velocity(*model, 0, 1, 0)), stretched, 1e-12);
}

TEST(DampingTest, TheMatrixIsThatOfItsParts) {
  const auto model = block();
  const Damping& damping = *model->damping();
  const auto values = [&] { return model->pattern().create_matrix(model->space()); };
  const auto c = values(), expected = values();
  double* entries = expected->getLocalMatrixHost().values.data();
  const std::vector<double> rest = test::at_rest(*model);
  Rule stiffness = end_rule();
  stiffness.points[0].weight = 5 * alpha_2;
  TermSums(*model).add_tangent(Part::Elastic, {nullptr, nullptr, rest.data()}, stiffness, Tangent::Exact, entries);
  model->mass()->add_to(5 * alpha_1, entries);
  damping.add_to(5.0, c->getLocalMatrixHost().values.data());
  const auto found = c->getLocalMatrixHost(), wanted = expected->getLocalMatrixHost();
  std::vector<double> sums(static_cast<std::size_t>(model->space().owned())), diagonal(sums.size(), 1.0),
      mass_diagonal(sums.size(), 0.0);
  damping.add_row_sums(nullptr, sums.data());
  damping.add_mass_diagonal(2.0, diagonal.data());
  model->mass()->add_diagonal(1.0, mass_diagonal.data());
  for (std::size_t row = 0; row < sums.size(); ++row) {
    double sum = 0;
    for (auto k = found.graph.row_map(row); k < found.graph.row_map(row + 1); ++k) {
      EXPECT_NEAR(found.values(k), wanted.values(k), 1e-14);
      sum += std::abs(wanted.values(k)) / 5;
    }
    EXPECT_NEAR(sums[row], sum, 1e-14);
    EXPECT_NEAR(diagonal[row], 1 + 2 * alpha_1 * mass_diagonal[row], 1e-15);
  }
}

TEST(DampingTest, WithoutAMatrixItIsTheSame) {
  const auto kept = block(), free = block();
  free->do_without_matrices();
  const std::vector<double> v = velocity(*kept, 0.3, 0.7, -0.4), expected = forces(*kept, v), found = forces(*free, v);
  double largest = 0;
  for (double force : expected) largest = std::max(largest, std::abs(force));
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-6 * largest);  // single
  std::vector<double> sums(expected.size()), mass(expected.size(), 0.0), product(expected.size());
  EXPECT_THROW(free->damping()->add_row_sums(nullptr, sums.data()), std::logic_error);
  free->damping()->multiply_add_mass(1.0, v.data(), mass.data());
  free->mass()->multiply(v.data(), product.data());
  for (std::size_t i = 0; i < mass.size(); ++i) EXPECT_NEAR(mass[i], alpha_1 * product[i], 1e-15);
}

// C = alpha_1 M for a body that moves as one: alpha_1 m times its velocity.
TEST(DampingTest, WorkOnARigidBodyIsSummedAsTheSchemeSays) {
  const auto model = block();
  const double c = alpha_1 * density * 6, u_n = 0.1, v_n = 0.3, u = 0.5, v = -0.2, dt = 0.1, du = u - u_n;
  const auto along_x = [&](double value) {
    std::vector<double> field = test::at_rest(*model);
    for (std::size_t i = 0; i < field.size(); i += 2) field[i] = value;
    return field;
  };
  const std::vector<double> fields[] = {along_x(u_n), along_x(v_n), along_x(9), along_x(0.6), along_x(u), along_x(v)};
  const auto state = [&](std::size_t i) { return KnownState{fields[2 * i].data(), fields[2 * i + 1].data(), nullptr}; };
  const auto work = [&](const Row& damping, const WorkSum& sum) {
    StageStart start;
    start.known = {state(0)};
    start.velocity = start.damping = &damping;
    start.dt = start.length = dt;
    test::ByHand<const Model> steps(*model);
    steps.begin_stage(start);
    return steps.accept({{state(0), state(1), state(2)}, &sum, dt}).dissipated[0];
  };
  const Row change = unknown_displacement() - displacement(0);
  // Momentum form: dt C v is C (u - u_n), and the work a square. The trapezoid: v = 2 (u - u_n)/dt - v_n.
  EXPECT_NEAR(work(change, {}), c * du * du / dt, 1e-12);
  EXPECT_NEAR(work(2 * change - ixos::velocity(0), {}), c * du * (2 * du / dt - v_n), 1e-12);
  EXPECT_NEAR(work(change, {WorkSum::Form::EndMean, {}}), c * du * (v_n + v) / 2, 1e-12);
  EXPECT_NEAR(work(change, {WorkSum::Form::Stages, {0.2, 0.5, 0.3}}),
              dt * c * (0.2 * v_n * v_n + 0.5 * 0.6 * 0.6 + 0.3 * v * v), 1e-12);
}

}  // namespace
}  // namespace ixos
