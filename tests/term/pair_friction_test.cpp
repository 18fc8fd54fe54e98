// Friction between two surfaces.
#include "term/pair_friction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "support/comparison.hpp"
#include "support/tangents.hpp"
#include "support/two_bodies.hpp"
#include "term/friction_fixture.hpp"

namespace ixos {
namespace {

/// A model with one pair; its last term is the friction.
struct Rubbing {
  std::unique_ptr<Model> model;
  Interaction* term;
  std::vector<double> between;  ///< twice a point between the bodies, seen from the origin

  Rubbing(const Mesh& mesh, const std::string& secondary, const std::string& primary, std::vector<double> center,
          FrictionType type, Smoothing smoothing = Smoothing::CatmullRom, Passes passes = Passes::One)
      : model(test::model_of_bodies(mesh, {secondary, primary})), between(std::move(center)) {
    SurfacePair pair;
    pair.secondary = secondary;
    pair.primary = primary;
    pair.law = gap_law(VanDerWaals(2.5, 25));
    pair.smoothing = smoothing;
    pair.passes = passes;
    pair.friction = test::friction(type, false);
    add_pair(*model, pair);
    std::vector<int> all(static_cast<std::size_t>(model->mesh().nodes()));
    std::iota(all.begin(), all.end(), 0);
    model->couple({all});  // the pair's own coupling leaves out what is far
    term = const_cast<Interaction*>(dynamic_cast<const Interaction*>(model->force_terms().back().term));
    term->initialize({test::at_rest(*model).data()});
  }
  std::vector<double> force(const Segment& segment, const Rule& rule) const {
    std::vector<double> f(static_cast<std::size_t>(model->space().local()), 0.0);
    EXPECT_TRUE(term->add_force(segment, rule, f.data()));
    return f;
  }
  /// Moves to u in a step of length 1.
  double step(const std::vector<double>& from, const std::vector<double>& to) const {
    term->begin_step({from.data()}, 0, 1);
    AcceptedStep accepted;
    accepted.dt = 1;
    accepted.states = {{to.data()}};
    return term->accept(accepted);
  }
  double total(double value) const {
    model->space().sum(&value, 1);
    return value;
  }
  bool is_second(std::size_t dof) const {
    const std::size_t d = between.size(), node = dof / d * d;
    double along = 0;
    for (std::size_t i = 0; i < d; ++i) along += between[i] * (model->mesh().coordinates[node + i] - between[i] / 2);
    return along > 0;
  }
  /// Returns a displacement: the second body moves across the line between both, and both deform.
  std::vector<double> slid(double way, double size) const {
    std::vector<double> u = test::smooth_field(*model, size);
    const std::size_t d = between.size();
    const double length = std::hypot(between[0], between[d - 1]);
    for (std::size_t k = 0; k < u.size(); k += d) {
      if (!is_second(k)) continue;
      u[k] += way * between[d - 1] / length;
      u[k + d - 1] -= way * between[0] / length;
    }
    return u;
  }
  /// Returns the force on the second body between steps, along x and along the last direction.
  std::array<double, 2> force_on_second(const std::vector<double>& u) const {
    const std::size_t d = between.size();
    const std::vector<double> f = force({nullptr, nullptr, u.data()}, end_rule());
    std::array<double, 2> sum{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(model->space().owned()); k += d)
      if (is_second(k)) sum = {sum[0] + f[k], sum[1] + f[k + d - 1]};
    return {total(sum[0]), total(sum[1])};
  }
};

constexpr FrictionType types[] = {FrictionType::ConstantStress, FrictionType::ExtendedAmontons, FrictionType::Smoothed};

/// Two blocks, boxes, disks and balls near the equilibrium gap.
std::vector<Rubbing> cases(FrictionType type, Smoothing smoothing = Smoothing::CatmullRom) {
  std::vector<Rubbing> all;
  all.emplace_back(test::two_blocks(0.26), "upper_bottom", "lower_top", std::vector<double>{0, 0.2}, type, smoothing);
  all.emplace_back(test::two_boxes(0.26), "upper_bottom", "lower_top", std::vector<double>{0, 0, 0.2}, type, smoothing);
  all.emplace_back(test::two_disks(3, {5, 3.72}), "a_surface", "b_surface", std::vector<double>{5, 3.72}, type,
                   smoothing);
  all.emplace_back(test::two_balls(2, {2.37, 1.97, 2.8}, 4, 1), "a_surface", "b_surface",
                   std::vector<double>{2.37, 1.97, 2.8}, type, smoothing);
  return all;
}

// With the elastic slip of the step before, at small slips and at large ones.
TEST(PairFrictionTest, ForceAndTangentAreDerivatives) {
  for (const FrictionType type : types)
    for (const Rubbing& bodies : cases(type)) {
      const Model& model = *bodies.model;
      const auto owned = static_cast<std::size_t>(model.space().owned());
      const std::vector<double> start = bodies.slid(0.003, 0.001), way = test::noise(model, 1);
      bodies.step(test::at_rest(model), start);
      bodies.term->begin_step({start.data()}, 0, 1);
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
        EXPECT_NEAR(bodies.total(bodies.term->energy(ahead.data()) - bodies.term->energy(behind.data())) / (2 * h),
                    at_end, 1e-6 * std::abs(at_end) + 1e-9);
        EXPECT_NEAR(bodies.total(bodies.term->mean_potential({start.data(), nullptr, ahead.data()}) -
                                 bodies.term->mean_potential({start.data(), nullptr, behind.data()})) /
                        (2 * h),
                    mean, 1e-4 * std::abs(mean) + 1e-9);  // a quadrature
        for (const Rule& rule : {end_rule(), gauss_rule(1), gauss_rule(4), exact_rule()}) {
          const auto f1 = bodies.force({start.data(), nullptr, ahead.data()}, rule);
          const auto f0 = bodies.force({start.data(), nullptr, behind.data()}, rule);
          std::vector<double> values = test::no_values(model), z(to.size(), 0.0);
          bodies.term->add_tangent(segment, rule, Tangent::Exact, values.data());
          const std::vector<double> y = test::matrix_product(model, values.data(), way);
          const auto action = bodies.term->create_action();
          action->linearize(segment, rule, Tangent::Exact, {});
          action->add_product(way.data(), z.data());
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
  for (const FrictionType type : types)
    for (const Rubbing& bodies : cases(type)) {
      const Model& model = *bodies.model;
      const std::vector<double> start = bodies.slid(0.003, 0.001);
      bodies.step(test::at_rest(model), start);
      bodies.term->begin_step({start.data()}, 0, 1);
      const double before = bodies.total(bodies.term->energy(start.data()));
      for (const double more : {1e-4, 0.01, 0.1}) {
        const std::vector<double> to = bodies.slid(0.003 + more, 0.002);
        const auto f = bodies.force({start.data(), nullptr, to.data()}, exact_rule());
        double work = 0;
        for (std::size_t k = 0; k < static_cast<std::size_t>(model.space().owned()); ++k)
          work += f[k] * (to[k] - start[k]);
        EXPECT_NEAR(bodies.total(work), bodies.total(bodies.term->energy(to.data())) - before, 1e-13);
        EXPECT_GT(std::abs(bodies.total(work)), 1e-8);
      }
    }
}

TEST(PairFrictionTest, NetForceAndNetMomentAboutTheStartVanish) {
  for (const Smoothing smoothing : {Smoothing::None, Smoothing::CatmullRom})
    for (const Rubbing& bodies : cases(FrictionType::ConstantStress, smoothing)) {
      const LocalMesh& mesh = bodies.model->mesh();
      const auto d = static_cast<std::size_t>(mesh.dimension);
      const std::vector<double> start = bodies.slid(0.01, 0.002), to = bodies.slid(0.05, 0.002);
      bodies.term->begin_step({start.data()}, 0, 1);
      const auto f = bodies.force({start.data(), nullptr, to.data()}, exact_rule());
      double sums[7] = {0, 0, 0, 0, 0, 0, 0};  // three components of the force, three of the moment, the size
      for (std::size_t k = 0; k < static_cast<std::size_t>(bodies.model->space().owned()); k += d)
        for (std::size_t i = 0; i < d; ++i) {
          const std::size_t j = (i + 1) % d;
          sums[i] += f[k + i];
          sums[6] += std::abs(f[k + i]);
          if (d == 3 || i == 0)
            sums[3 + i] += (mesh.coordinates[k + i] + start[k + i]) * f[k + j] -
                           (mesh.coordinates[k + j] + start[k + j]) * f[k + i];
        }
      bodies.model->space().sum(sums, 7);
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(sums[i], 0, 1e-14 * sums[6]);
      for (int i = 3; i < 6; ++i) EXPECT_NEAR(sums[i], 0, 1e-12 * sums[6]);
      EXPECT_GT(sums[6], 1e-3);
    }
}

/// Returns the displacement of a rotation about the origin by an angle, in the plane of x and the last direction.
std::vector<double> turned(const Model& model, const std::vector<double>& u, double angle) {
  std::vector<double> result = u;
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  const std::vector<double>& x = model.mesh().coordinates;
  for (std::size_t k = 0; k < u.size(); k += d) {
    const double a = x[k] + u[k], b = x[k + d - 1] + u[k + d - 1];
    result[k] = std::cos(angle) * a - std::sin(angle) * b - x[k];
    result[k + d - 1] = std::sin(angle) * a + std::cos(angle) * b - x[k + d - 1];
  }
  return result;
}

/// Turns both bodies as one by a right angle, with a stored elastic slip. Returns the largest of three changes: the
/// work that is dissipated and the change of the energy, over that energy, and the difference from the turned force
/// over its size.
double change_by_turning(const Rubbing& bodies, int steps) {
  const Model& model = *bodies.model;
  const std::vector<double> start = bodies.slid(0.002, 0);  // less than the elastic slip, 0.006
  bodies.term->initialize({start.data()});
  bodies.step(test::at_rest(model), start);
  const std::array<double, 2> before = bodies.force_on_second(start);
  const double stored = bodies.total(bodies.term->energy(start.data()));
  EXPECT_GT(stored, 1e-6);
  std::vector<double> now = start;
  double lost = 0;
  for (int n = 1; n <= steps; ++n) {
    const std::vector<double> next = turned(model, start, n * M_PI / 2 / steps);
    lost += bodies.step(now, next);
    now = next;
  }
  const std::array<double, 2> after = bodies.force_on_second(now);
  return std::max({std::abs(bodies.total(lost)) / stored,
                   std::abs(bodies.total(bodies.term->energy(now.data())) - stored) / stored,
                   std::hypot(after[0] + before[1], after[1] - before[0]) / std::hypot(before[0], before[1])});
}

/// The elastic slip turns with the bodies. In space a step of the angle a slips by a^2 times the gap where the surfaces
/// are aslant.
TEST(PairFrictionTest, BodiesThatTurnAsOneDoNotSlip) {
  for (const Rubbing& bodies : cases(FrictionType::ConstantStress)) {
    if (bodies.between.size() == 2) {
      EXPECT_LT(change_by_turning(bodies, 10), 1e-9);
    } else {
      const double coarse = change_by_turning(bodies, 100), fine = change_by_turning(bodies, 400);
      EXPECT_LT(fine, 0.3 * coarse + 1e-9);
      EXPECT_LT(fine, 0.3);
    }
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
    for (const auto& named : bodies.model->force_terms()) {
      const auto* own = dynamic_cast<const Interaction*>(named.term);
      if (own == nullptr || !own->has_friction()) continue;
      const_cast<Interaction*>(own)->initialize({start.data()});
      const_cast<Interaction*>(own)->begin_step({start.data()}, 0, 1);
      std::vector<double> f(to.size(), 0.0);
      own->add_force({start.data(), nullptr, to.data()}, end_rule(), f.data());
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
