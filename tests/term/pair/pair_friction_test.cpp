// Friction between two surfaces.
#include "term/pair/pair_friction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/comparison.hpp"
#include "term/rubbing.hpp"

namespace ixos {
namespace {

using test::friction_types;
using test::Rubbing;
using test::rubbing_bodies;

// With the elastic slip of the step before, at small slips and at large ones.
TEST(PairFrictionTest, ForceAndTangentAreDerivatives) {
  for (const FrictionType type : friction_types)
    for (const Rubbing& bodies : rubbing_bodies(type)) {
      const Model& model = *bodies.model;
      const auto owned = static_cast<std::size_t>(model.space().owned());
      const std::vector<double> start = bodies.slid(0.003, 0.001), way = test::noise(model, 1);
      bodies.step(test::at_rest(model), start);
      bodies.steps->begin_step(start.data(), 0, 1);
      for (const double more : {0.001, 0.02}) {
        const std::vector<double> to = bodies.slid(0.003 + more, 0.0015);
        const double h = 1e-6;
        const std::vector<double> ahead = test::moved(to, h, way), behind = test::moved(to, -h, way);
        const auto work = [&](const std::vector<double>& f) {
          return bodies.total(
              std::inner_product(f.begin(), f.begin() + static_cast<std::ptrdiff_t>(owned), way.begin(), 0.0));
        };
        const Segment segment{start.data(), nullptr, to.data()};
        const double at_end = work(bodies.force(segment, end_rule())), mean = work(bodies.force(segment, exact_rule()));
        EXPECT_GT(std::abs(at_end), 1e-4);
        EXPECT_NEAR(bodies.total(bodies.term->energy(bodies.steps->at(ahead.data())) -
                                 bodies.term->energy(bodies.steps->at(behind.data()))) /
                        (2 * h),
                    at_end, 1e-6 * std::abs(at_end) + 1e-9);
        if (bodies.term->is_gradient(exact_rule())) {
          EXPECT_NEAR(
              bodies.total(bodies.term->mean_potential(bodies.steps->in({start.data(), nullptr, ahead.data()})) -
                           bodies.term->mean_potential(bodies.steps->in({start.data(), nullptr, behind.data()}))) /
                  (2 * h),
              mean, 1e-4 * std::abs(mean) + 1e-9);  // a quadrature
        }
        for (const Rule& rule : {end_rule(), gauss_rule(1), gauss_rule(4), exact_rule()}) {
          const auto f1 = bodies.force({start.data(), nullptr, ahead.data()}, rule);
          const auto f0 = bodies.force({start.data(), nullptr, behind.data()}, rule);
          std::vector<double> values = test::no_values(model), z(to.size(), 0.0);
          bodies.term->add_tangent(bodies.steps->in(segment), rule, Tangent::Exact, values.data());
          const std::vector<double> y = test::matrix_product(model, values.data(), way);
          if (bodies.term->is_gradient(rule)) {
            const auto action = bodies.term->create_action();
            action->linearize(bodies.steps->in(segment), rule, Tangent::Exact, {});
            action->add_product(way.data(), z.data());
          } else {
            z = y;
          }
          double largest = 0;
          for (double value : y) largest = std::max(largest, std::abs(value));
          largest = model.space().maximum(largest);
          // In the plane, what slides resists with a constant force.
          EXPECT_TRUE(largest > 1e-3 || more > 0.01);
          largest = std::max(largest, 1e-3);
          for (std::size_t k = 0; k < owned; ++k) {
            EXPECT_NEAR((f1[k] - f0[k]) / (2 * h), y[k], 1e-5 * largest);
            EXPECT_NEAR(z[k], y[k], 1e-5 * largest);  // single precision
          }
        }
      }
    }
}

/// The work of the mean force over the path is the change of the potential.
TEST(PairFrictionTest, TheMeanForceDoesTheWorkOfThePotential) {
  for (const FrictionType type : friction_types)
    for (const Rubbing& bodies : rubbing_bodies(type)) {
      const Model& model = *bodies.model;
      const std::vector<double> start = bodies.slid(0.003, 0.001);
      bodies.step(test::at_rest(model), start);
      bodies.steps->begin_step(start.data(), 0, 1);
      const double before = bodies.total(bodies.term->energy(bodies.steps->at(start.data())));
      for (const double more : {1e-4, 0.01, 0.1}) {
        const std::vector<double> to = bodies.slid(0.003 + more, 0.002);
        const auto f = bodies.force({start.data(), nullptr, to.data()}, exact_rule());
        double work = 0;
        for (std::size_t k = 0; k < static_cast<std::size_t>(model.space().owned()); ++k)
          work += f[k] * (to[k] - start[k]);
        EXPECT_NEAR(bodies.total(work), bodies.total(bodies.term->energy(bodies.steps->at(to.data()))) - before, 1e-13);
        EXPECT_GT(std::abs(bodies.total(work)), 1e-8);
      }
    }
}

/// Expects no net force, and no net moment about the nodes' places at a displacement.
void expect_no_net_force(const Rubbing& bodies, const std::vector<double>& f, const std::vector<double>& u) {
  const LocalMesh& mesh = bodies.model->mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  double sums[7] = {0, 0, 0, 0, 0, 0, 0};  // three components of the force, three of the moment, the size
  for (std::size_t k = 0; k < static_cast<std::size_t>(bodies.model->space().owned()); k += d)
    for (std::size_t i = 0; i < d; ++i) {
      const std::size_t j = (i + 1) % d;
      sums[i] += f[k + i];
      sums[6] += std::abs(f[k + i]);
      if (d == 3 || i == 0)
        sums[3 + i] +=
            (mesh.coordinates[k + i] + u[k + i]) * f[k + j] - (mesh.coordinates[k + j] + u[k + j]) * f[k + i];
    }
  bodies.model->space().sum(sums, 7);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(sums[i], 0, 1e-14 * sums[6]);
  for (int i = 3; i < 6; ++i) EXPECT_NEAR(sums[i], 0, 1e-12 * sums[6]);
  EXPECT_GT(sums[6], 1e-3);
}

/// In the plane moments are those about the places of the start. In space they are those about the present places, and
/// about the mean places where the primary surface does not change its shape.
TEST(PairFrictionTest, NetForceAndNetMomentVanish) {
  for (const Smoothing smoothing : {Smoothing::None, Smoothing::CatmullRom, Smoothing::Spline})
    for (const Rubbing& bodies : rubbing_bodies(FrictionType::ConstantStress, smoothing)) {
      const bool in_space = bodies.between.size() == 3;
      const std::vector<double> start = bodies.slid(0.01, 0.002), to = bodies.slid(0.05, 0.002),
                                bent = bodies.slid(0.03, 0.01);
      bodies.steps->begin_step(start.data(), 0, 1);
      std::vector<double> mean = start;
      for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += (to[k] - start[k]) / 2;
      expect_no_net_force(bodies, bodies.force({start.data(), nullptr, to.data()}, exact_rule()),
                          in_space ? mean : start);
      expect_no_net_force(bodies, bodies.force({start.data(), nullptr, bent.data()}, end_rule()),
                          in_space ? bent : start);
    }
}

/// Two passes have half of the friction each: before a flat surface they add up to one.
TEST(PairFrictionTest, TwoPassesShareTheFriction) {
  const Mesh mesh = test::two_blocks(0.26, 4, 4);
  double forces[2] = {0, 0};
  for (const Passes passes : {Passes::One, Passes::Two}) {
    const Rubbing bodies(mesh, "upper_bottom", "lower_top", {0, 0.2}, FrictionType::ConstantStress, Smoothing::None,
                         passes);
    const std::vector<double> start = test::at_rest(*bodies.model), to = bodies.slid(0.1, 0);
    double& sum = forces[passes == Passes::One ? 0 : 1];
    for (const NamedInteraction& named : bodies.model->interactions()) {
      if (!named.term->has_friction()) continue;
      test::ByHand<Interaction> steps(*named.term, *bodies.model);
      steps.initialize(start.data());
      steps.begin_step(start.data(), 0, 1);
      std::vector<double> f(to.size(), 0.0);
      named.term->add_force(steps.segment(start.data(), nullptr, to.data()), end_rule(), f.data());
      for (std::size_t k = 0; k < static_cast<std::size_t>(bodies.model->space().owned()); k += 2)
        if (bodies.model->mesh().coordinates[k + 1] > 0.1) sum += f[k];
    }
    sum = bodies.total(sum);
  }
  EXPECT_NEAR(forces[0], 0.03 * 2, 0.03 * 2 * 0.3);  // the threshold is below tau at this gap
  EXPECT_GT(forces[0], 0.03);
  EXPECT_NEAR(forces[1], forces[0], 0.15 * forces[0]);  // the ends of the longer block reach beyond the other one
}

}  // namespace
}  // namespace ixos
