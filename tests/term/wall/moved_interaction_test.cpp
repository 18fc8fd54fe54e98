#include "term/wall/moved_interaction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "interaction/catalogue.hpp"
#include "interaction/van_der_waals.hpp"
#include "support/comparison.hpp"
#include "support/solids.hpp"
#include "support/time_functions.hpp"
#include "term/wall/surface_terms.hpp"

namespace ixos {
namespace {

using Triple = std::array<double, 3>;

const std::vector<std::pair<int, ContactElement>> bodies = {
    {2, ContactElement::Q1C1}, {2, ContactElement::Q1C3}, {2, ContactElement::Q1CH}, {2, ContactElement::Q2C2},
    {2, ContactElement::Q2C4}, {3, ContactElement::Q1C1}, {3, ContactElement::Q1C2}, {3, ContactElement::Q1CH},
    {3, ContactElement::Q2C2}, {3, ContactElement::Q2C4}};

/// A translation and, in 2D about z, in 3D about an oblique axis, a rotation; both accelerate.
RigidMotion motion(int dimension, bool turns) {
  RigidMotionOptions options;
  options.translation = {test::polynomial(0.05, -0.02), test::polynomial(-0.02, 0.01), test::polynomial(-0.03, 0.01)};
  options.translation.resize(static_cast<std::size_t>(dimension));
  options.point = {0.2, -0.4, 0.1};
  options.point.resize(static_cast<std::size_t>(dimension));
  if (turns) options.angle = test::polynomial(0.04, 0.02);
  if (turns && dimension == 3) options.axis = {1, 2, 2};
  return {dimension, options};
}

const std::shared_ptr<const GapLaw>& law() {
  static const std::shared_ptr<const GapLaw> law = gap_law(VanDerWaals(2.5, 25));
  return law;
}

Interactions terms(const Model& model, const std::shared_ptr<const Obstacle>& obstacle, const RigidMotion* motion) {
  const LocalMesh& mesh = model.mesh();
  const auto& sides = mesh.side_sets[mesh.side_set("bottom")];
  Interactions result = make_surface_terms(mesh, sides, model.pattern(), law(), obstacle, {});
  if (motion == nullptr) return result;
  for (auto& term : result)
    term = std::make_unique<MovedInteraction>(std::move(term), *motion, mesh, sides, model.pattern());
  return result;
}

std::shared_ptr<const Obstacle> sphere(int dimension) {
  std::vector<double> center(static_cast<std::size_t>(dimension), 0.3);
  center.back() = -3.2;
  return make_obstacle("Sphere", static_cast<std::size_t>(dimension), {{"Radius", 3.0}, {"Center", center}});
}

std::vector<double> force(const Interactions& terms, const Segment& segment, const Rule& rule, std::size_t size) {
  std::vector<double> f(size, 0.0);
  for (const auto& term : terms) EXPECT_TRUE(term->add_force(segment, rule, f.data()));
  return f;
}

double energy(const Model& model, const Interactions& terms, const double* u, double time) {
  double sum = 0;
  for (const auto& term : terms) sum += term->energy({u, time});
  model.space().sum(&sum, 1);
  return sum;
}

double work(const Model& model, const Interactions& terms, const Segment& segment, const Rule& rule) {
  double sum = 0;
  for (const auto& term : terms) sum += term->motion()->work(segment, rule);
  model.space().sum(&sum, 1);
  return sum;
}

std::vector<double> product(const Model& model, const Interactions& terms, const Segment& segment, const Rule& rule,
                            const std::vector<double>& x) {
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  // Entries of other terms, 0.7, must stay.
  std::vector<double> values(static_cast<std::size_t>(model.pattern().pairs()) * d * d, 0.7);
  for (const auto& term : terms) term->add_tangent(segment, rule, Tangent::Exact, values.data());
  std::vector<double> y(static_cast<std::size_t>(model.space().owned()), 0.0);
  model.pattern().for_each_row(values.data(), [&](int row, const auto& entries) {
    entries([&](int column, double value) {
      y[static_cast<std::size_t>(row)] += (value - 0.7) * x[static_cast<std::size_t>(column)];
    });
  });
  return y;
}

/// A plane that has been moved is another plane.
TEST(MovedInteractionTest, AMovedPlaneIsThePlaneAtItsPlace) {
  for (const auto& [dimension, element] : bodies)
    for (const bool turns : {false, true}) {
      const auto model = test::box_with_contact(dimension, element);
      const RigidMotion way = motion(dimension, turns);
      const double time = 1.5;
      const RigidPose pose = way.pose(time);
      HalfSpace wall;
      wall.normal = dimension == 2 ? Triple{0.28, 0.96, 0} : Triple{0, 0.28, 0.96};
      wall.point = {-0.2, -0.3, -0.1};
      HalfSpace there = wall;
      there.point = MovingFrame::from_frame(pose, wall.point);
      const Triple turning = pose.turning(pose.angle, wall.normal);
      for (std::size_t i = 0; i < 3; ++i) there.normal[i] += turning[i];
      const Interactions moved = terms(*model, flat_wall(wall), &way), fixed = terms(*model, flat_wall(there), nullptr);
      const std::vector<double> u = test::smooth_field(*model, 0.03), x = test::smooth_field(*model, -2);
      const Segment state{nullptr, nullptr, u.data(), time};
      const auto f = force(moved, state, end_rule(), u.size()), g = force(fixed, state, end_rule(), u.size());
      const auto owned = static_cast<std::size_t>(model->space().owned());
      for (std::size_t k = 0; k < owned; ++k) EXPECT_NEAR(f[k], g[k], 1e-13);
      const auto a = product(*model, moved, state, end_rule(), x), b = product(*model, fixed, state, end_rule(), x);
      for (std::size_t k = 0; k < owned; ++k) EXPECT_NEAR(a[k], b[k], 1e-11);
      EXPECT_NEAR(energy(*model, moved, u.data(), time), energy(*model, fixed, u.data(), time), 1e-14);
      const auto nodes = static_cast<std::size_t>(model->mesh().nodes());
      for (std::size_t i = 0; i < moved.size(); ++i) {
        InteractionReport own, other;
        moved[i]->reports().report({u.data(), time}, own);
        fixed[i]->reports().report({u.data(), time}, other);
        for (std::size_t j = 0; j < other.force.size(); ++j) EXPECT_NEAR(own.force[j], other.force[j], 1e-13);
        EXPECT_NEAR(own.measure, other.measure, 1e-14);
        const LowestPoint p = moved[i]->admissibility().lowest_point({u.data(), time}),
                          q = fixed[i]->admissibility().lowest_point({u.data(), time});
        if (std::isfinite(q.gap)) {  // the rank has sides
          EXPECT_NEAR(own.least_gap, other.least_gap, 1e-14);
          EXPECT_NEAR(p.gap, q.gap, 1e-14);
          for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(p.place[j], q.place[j], 1e-14);
        }
        std::vector<double> gaps(nodes, std::nan("")), others(gaps), pressure(nodes, 0.0), pressures(nodes, 0.0);
        moved[i]->reports().lower_nodal_gap({u.data(), time}, gaps.data());
        fixed[i]->reports().lower_nodal_gap({u.data(), time}, others.data());
        moved[i]->reports().add_nodal(SurfaceNumber::Pressure, {u.data(), time}, pressure.data());
        fixed[i]->reports().add_nodal(SurfaceNumber::Pressure, {u.data(), time}, pressures.data());
        for (std::size_t n = 0; n < nodes; ++n) {
          EXPECT_NEAR(pressure[n], pressures[n], 1e-13);
          EXPECT_EQ(std::isnan(gaps[n]), std::isnan(others[n]));
          if (std::isnan(gaps[n])) continue;
          EXPECT_NEAR(gaps[n], others[n], 1e-13);
        }
      }
    }
}

TEST(MovedInteractionTest, TangentsAreDerivativesOfForces) {
  for (const auto& [dimension, element] : bodies)
    for (const bool turns : {false, true}) {
      const auto model = test::box_with_contact(dimension, element);
      const RigidMotion way = motion(dimension, turns);
      const Interactions moved = terms(*model, sphere(dimension), &way);
      const std::vector<double> from = test::smooth_field(*model, 0.02), to = test::smooth_field(*model, -0.03),
                                x = test::smooth_field(*model, 1);
      const auto owned = static_cast<std::size_t>(model->space().owned());
      const double h = 1e-5;
      std::vector<double> ahead = to, behind = to;
      for (std::size_t k = 0; k < to.size(); ++k) {
        ahead[k] += h * x[k];
        behind[k] -= h * x[k];
      }
      const auto along = [&](const std::vector<double>& u) {
        return Segment{from.data(), nullptr, u.data(), 0.5, 0.8};
      };
      for (const Rule& rule : {end_rule(), gauss_rule(3), exact_rule()}) {
        const auto f1 = force(moved, along(ahead), rule, to.size()), f0 = force(moved, along(behind), rule, to.size());
        const auto y = product(*model, moved, along(to), rule, x);
        for (std::size_t k = 0; k < owned; ++k) EXPECT_NEAR((f1[k] - f0[k]) / (2 * h), y[k], 2e-6);
        if (moved.size() > 1 || !moved.front()->is_gradient(rule)) continue;
        const auto action = moved.front()->create_action();
        action->linearize(along(to), rule, Tangent::Exact, {});
        std::vector<double> z(to.size(), 0.0), diagonal(to.size(), 0.0);
        action->add_product(x.data(), z.data());
        for (std::size_t k = 0; k < owned; ++k) EXPECT_NEAR(z[k], y[k], 1e-11);
      }
    }
}

/// Returns the values of the tangent, what was kept if there is some.
std::vector<double> tangent(const Model& model, const Interaction& term, const Segment& segment, const Rule& rule,
                            Tangent kind, const KeptPoints* kept) {
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  std::vector<double> values(static_cast<std::size_t>(model.pattern().pairs()) * d * d, 0.7);
  if (kept != nullptr)
    term.add_kept_tangent(segment, rule, kind, *kept, values.data());
  else
    term.add_tangent(segment, rule, kind, values.data());
  return values;
}

// One place serves several rules, as it does for the stages of a scheme. Another displacement shows what is kept: the
// ends of segments and the mean, not other points in time.
TEST(MovedInteractionTest, KeptTangentsAreThoseOfTheForce) {
  for (const auto& [dimension, element] : bodies)
    for (const bool turns : {false, true}) {
      const auto model = test::box_with_contact(dimension, element);
      const RigidMotion way = motion(dimension, turns);
      const std::vector<double> from = test::smooth_field(*model, 0.02), to = test::smooth_field(*model, -0.03);
      const Segment segment{from.data(), nullptr, to.data(), 0.5, 0.8},
          other{to.data(), nullptr, from.data(), 0.5, 0.8};
      for (const auto& term : terms(*model, flat_wall({}), &way)) EXPECT_EQ(term->create_kept(), nullptr);
      for (const auto& term : terms(*model, sphere(dimension), &way)) {
        const auto kept = term->create_kept();
        ASSERT_NE(kept, nullptr);
        for (const Rule& rule : {gauss_rule(3), end_rule(0.7), exact_rule(), gauss_rule(2), end_rule()}) {
          std::vector<double> f(to.size(), 0.0), g = f;
          EXPECT_TRUE(term->add_force_and_keep(segment, rule, *kept, f.data()));
          EXPECT_TRUE(term->add_force(segment, rule, g.data()));
          EXPECT_LT(test::distance(f, g), 1e-13);
          const auto values = [&](const Segment& at, Tangent kind, bool is_kept) {
            return tangent(*model, *term, at, rule, kind, is_kept ? kept.get() : nullptr);
          };
          for (const Tangent kind : {Tangent::Exact, Tangent::Convex})
            EXPECT_LT(test::distance(values(segment, kind, true), values(segment, kind, false)), 1e-11);
          if (turns ||
              test::distance(values(segment, Tangent::Exact, false), values(other, Tangent::Exact, false)) < 1e-6)
            continue;  // the rank has no sides
          const bool is_kept = rule.mean == Mean::Exact || rule.has_end();
          EXPECT_EQ(values(other, Tangent::Exact, true) == values(segment, Tangent::Exact, true), is_kept);
        }
      }
    }
}

/// Pi_1 - Pi_0 = (u_1 - u_0) . f + work, exactly for the mean of the gaps, to quadrature for points.
TEST(MovedInteractionTest, TheObstaclesWorkClosesTheBalance) {
  for (const auto& [dimension, element] : bodies)
    for (const bool turns : {false, true}) {
      const auto model = test::box_with_contact(dimension, element);
      const RigidMotion way = motion(dimension, turns);
      const Interactions moved = terms(*model, sphere(dimension), &way);
      const std::vector<double> from = test::smooth_field(*model, 0.02), to = test::smooth_field(*model, -0.03);
      const Segment segment{from.data(), nullptr, to.data(), 0.5, 0.8};
      const double change = energy(*model, moved, to.data(), 1.3) - energy(*model, moved, from.data(), 0.5);
      for (const auto& [rule, bound] : {std::pair{exact_rule(), 1e-14}, std::pair{gauss_rule(20), 1e-12}}) {
        const auto f = force(moved, segment, rule, to.size());
        double sum = 0;
        for (std::size_t k = 0; k < static_cast<std::size_t>(model->space().owned()); ++k)
          sum += f[k] * (to[k] - from[k]);
        model->space().sum(&sum, 1);
        EXPECT_NEAR(sum + work(*model, moved, segment, rule), change, bound);
      }
    }
}

/// The work of the mean of the gaps is the one by quadrature in the limit of short steps, of order 2: with tenfold
/// shorter steps, a hundredth of the difference, per length of the way.
TEST(MovedInteractionTest, TheWorkOfTheMeanConvergesToThePhysicalOne) {
  const auto model = test::box_with_contact(2, ContactElement::Q1C1);
  const RigidMotion way = motion(2, true);
  const Interactions moved = terms(*model, sphere(2), &way);
  const std::vector<double> from = test::smooth_field(*model, 0.02), speed = test::smooth_field(*model, -0.05);
  double difference[2];
  for (int k = 0; k < 2; ++k) {
    const double length = k == 0 ? 0.4 : 0.04;
    std::vector<double> to = from;
    for (std::size_t i = 0; i < to.size(); ++i) to[i] += length * speed[i];
    const Segment segment{from.data(), nullptr, to.data(), 0.5, length};
    difference[k] =
        std::abs(work(*model, moved, segment, exact_rule()) - work(*model, moved, segment, gauss_rule(20))) / length;
  }
  EXPECT_GT(difference[0], 1e-9);
  EXPECT_LT(difference[1], 0.02 * difference[0]);
}

/// The wall comes 0.1 L0 nearer over the segment: of a gap of 0.3 a Newton step may take what the wall has left.
TEST(MovedInteractionTest, StepsAreAdmissibleBeforeTheWallThatHasMoved) {
  const auto model = test::box_with_contact(2, ContactElement::Q1C1);
  RigidMotionOptions options;
  options.translation = {nullptr, test::polynomial(0.1, 0)};
  const RigidMotion way(2, options);
  const Interactions moved = terms(*model, flat_wall({}), &way);
  const std::vector<double> rest = test::at_rest(*model);
  std::vector<double> down = rest;
  for (std::size_t k = 1; k < down.size(); k += 2) down[k] = -1;
  double step = 1;
  for (const auto& term : moved)
    step = std::min(step, term->admissibility().admissible_step({rest.data(), nullptr, rest.data(), 0, 1},
                                                                gauss_rule(2), down.data()));
  EXPECT_NEAR(model->space().minimum(step), 0.2 * (1 - 0.8), 1e-14);
  for (const auto& term : moved) {
    std::vector<double> f(rest.size(), 0.0);
    const bool empty = std::isinf(term->admissibility().lowest_point({rest.data()}).gap);
    EXPECT_EQ(term->add_force({rest.data(), nullptr, rest.data(), 0, 3.5}, gauss_rule(1), f.data()), empty)
        << "the wall is beyond the surface at the end, though not in the middle";
  }
}

/// A ball that flies through the surface between two ends outside: seen from it, points cut straight through a ball.
TEST(MovedInteractionTest, AWayThroughTheSurfaceIsNoticed) {
  const auto model = test::box_with_contact(2, ContactElement::Q1C1);
  const auto ball = make_obstacle("Sphere", 2, {{"Radius", 0.5}, {"Center", std::vector<double>{-10, 0}}});
  RigidMotionOptions options;
  options.translation = {test::polynomial(20, 0), nullptr};  // the centre passes the origin half way
  const RigidMotion way(2, options);
  const std::vector<double> rest = test::at_rest(*model);
  const Segment segment{rest.data(), nullptr, rest.data(), 0, 1};
  double ratio = 1, ends_apart = 1, noticed = 0, deepest = 1;
  for (const auto& term : terms(*model, ball, &way)) {
    ratio = std::max(ratio, term->admissibility().gap_ratio(segment));
    deepest = std::min(deepest, term->admissibility().passage(segment).gap);
    std::vector<double> f(rest.size(), 0.0);
    if (!term->add_force(segment, end_rule(), f.data())) ends_apart = 0;
    if (!term->add_force(segment, point_rule({0.5}, {1.0}), f.data())) noticed = 1;
  }
  EXPECT_EQ(model->space().minimum(ends_apart), 1);
  EXPECT_EQ(model->space().maximum(noticed), 1);
  EXPECT_GT(model->space().maximum(ratio), 1e5);
  EXPECT_NEAR(model->space().minimum(deepest), 0.3 - 0.5, 1e-3);  // the points are 0.3 above the centre
  options.angle = test::polynomial(0.2, 0);
  const RigidMotion turning(2, options);
  for (const auto& term : terms(*model, ball, &turning)) {
    EXPECT_FALSE(term->admissibility().passage(segment).gap < 0) << "ways are not straight";
  }
}

}  // namespace
}  // namespace ixos
