// Surfaces before obstacles of any shape.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "interaction/catalogue.hpp"
#include "interaction/van_der_waals.hpp"
#include "parameters/validation.hpp"
#include "support/solids.hpp"
#include "support/tangents.hpp"
#include "term/wall/surface_terms.hpp"

namespace ixos {
namespace {

const std::shared_ptr<const GapLaw>& law() {
  static const std::shared_ptr<const GapLaw> law = gap_law(VanDerWaals(2.5, 25));
  return law;
}

Interactions terms(const Model& model, const std::shared_ptr<const Obstacle>& obstacle, bool curved,
                   const std::shared_ptr<const GapLaw>& own = law()) {
  const LocalMesh& mesh = model.mesh();
  const auto& sides = mesh.side_sets[mesh.side_set("bottom")];
  return curved ? make_curved_terms(mesh, sides, model.pattern(), own, obstacle, {})
                : make_surface_terms(mesh, sides, model.pattern(), own, obstacle, {});
}

std::shared_ptr<const Obstacle> sphere(double radius, int dimension) {
  Teuchos::ParameterList valid, user;
  obstacles().declare(valid);
  user.set("Obstacle", "Sphere");
  user.sublist("Sphere").set("Radius", radius);
  Teuchos::Array<double> center(dimension, 0.0);
  center.back() = -radius;
  user.sublist("Sphere").set("Center", center);
  const Teuchos::ParameterList list = validated(user, valid);
  return obstacles().make(SceneNode(list, ""), static_cast<std::size_t>(dimension));
}

std::vector<double> force(const Interactions& terms, const Segment& segment, const Rule& rule, std::size_t size) {
  std::vector<double> f(size, 0.0);
  for (const auto& term : terms) EXPECT_TRUE(term->add_force(segment, rule, f.data()));
  return f;
}

double energy(const Interactions& terms, const double* u) {
  double sum = 0;
  for (const auto& term : terms) sum += term->energy({u});
  return sum;
}

/// Returns K x of the assembled tangent, rows of owned nodes.
std::vector<double> product(const Model& model, const Interactions& terms, const Segment& segment, const Rule& rule,
                            Tangent kind, const std::vector<double>& x) {
  std::vector<double> values = test::no_values(model);
  for (const auto& term : terms) term->add_tangent(segment, rule, kind, values.data());
  return test::matrix_product(model, values.data(), x);
}

const std::vector<std::pair<int, ContactElement>> bodies = {
    {2, ContactElement::Q1C1}, {2, ContactElement::Q1C3}, {2, ContactElement::Q1CH}, {2, ContactElement::Q2C2},
    {2, ContactElement::Q2C4}, {3, ContactElement::Q1C1}, {3, ContactElement::Q1C2}, {3, ContactElement::Q1CH},
    {3, ContactElement::Q2C2}, {3, ContactElement::Q2C4}};

/// A half-space is an obstacle like any other: both paths agree to rounding.
TEST(CurvedSurfaceTermTest, BeforeAHalfSpaceItIsTheFlatTerm) {
  for (const auto& [dimension, element] : bodies) {
    const auto model = test::box_with_contact(dimension, element);
    HalfSpace wall;
    wall.normal = dimension == 2 ? std::array<double, 3>{0.6, 0.8, 0} : std::array<double, 3>{0, 0.6, 0.8};
    wall.point = {-1.2, -0.8, -0.4};
    const auto flat = terms(*model, flat_wall(wall), false), curved = terms(*model, flat_wall(wall), true);
    const std::vector<double> from = test::smooth_field(*model, 0.02), to = test::smooth_field(*model, -0.03),
                              way = test::smooth_field(*model, -2);
    const Segment segment{from.data(), nullptr, to.data()};
    for (const Rule& rule : {end_rule(), gauss_rule(3), exact_rule()}) {
      const auto f = force(flat, segment, rule, to.size()), g = force(curved, segment, rule, to.size());
      for (std::size_t k = 0; k < f.size(); ++k) EXPECT_NEAR(f[k], g[k], 1e-14);
      for (Tangent kind : {Tangent::Exact, Tangent::Convex}) {
        const auto a = product(*model, flat, segment, rule, kind, way);
        const auto b = product(*model, curved, segment, rule, kind, way);
        for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-13);
      }
    }
    EXPECT_NEAR(energy(flat, to.data()), energy(curved, to.data()), 1e-14);
    InteractionReport a, b;
    for (std::size_t i = 0; i < flat.size(); ++i) {
      const Place there{to.data()};
      const Admissibility &of_flat = flat[i]->admissibility(), &of_curved = curved[i]->admissibility();
      flat[i]->reports().report(there, a);
      curved[i]->reports().report(there, b);
      EXPECT_NEAR(of_flat.admissible_step(segment, end_rule(), way.data()),
                  of_curved.admissible_step(segment, end_rule(), way.data()), 1e-12);
      EXPECT_NEAR(of_flat.gap_ratio(segment), of_curved.gap_ratio(segment), 1e-12);
      EXPECT_NEAR(flat[i]->rounding(there), curved[i]->rounding(there), 1e-12 * flat[i]->rounding(there));
    }
    EXPECT_NEAR(a.least_gap, b.least_gap, 1e-14);
    EXPECT_NEAR(a.measure, b.measure, 1e-14);
    for (std::size_t i = 0; i < a.force.size(); ++i) EXPECT_NEAR(a.force[i], b.force[i], 1e-14);
  }
}

/// Force, tangent and the work of the exact mean before a sphere, whose surface touches y = 0 or z = 0 from below.
TEST(CurvedSurfaceTermTest, ForceAndTangentAreDerivatives) {
  for (const auto& [dimension, element] : bodies) {
    const auto model = test::box_with_contact(dimension, element);
    const auto round = terms(*model, sphere(3, dimension), true);
    const auto d = static_cast<std::size_t>(dimension);
    std::vector<double> from = test::smooth_field(*model, 0.02), to = test::smooth_field(*model, -0.03);
    const std::vector<double> way = test::smooth_field(*model, 1);
    const auto owned = static_cast<std::size_t>(model->space().owned());
    const double h = 1e-5;
    const std::vector<double> ahead = test::moved(to, h, way), behind = test::moved(to, -h, way);
    double sums[2] = {energy(round, ahead.data()) - energy(round, behind.data()), 0};
    const auto f = force(round, {nullptr, nullptr, to.data()}, end_rule(), to.size());
    for (std::size_t k = 0; k < owned; ++k) sums[1] += f[k] * way[k];
    model->space().sum(sums, 2);
    EXPECT_NEAR(sums[0] / (2 * h), sums[1], 1e-8);
    for (const Rule& rule : {end_rule(), gauss_rule(4), exact_rule()}) {
      const auto f1 = force(round, {from.data(), nullptr, ahead.data()}, rule, to.size());
      const auto f0 = force(round, {from.data(), nullptr, behind.data()}, rule, to.size());
      const auto k_way = product(*model, round, {from.data(), nullptr, to.data()}, rule, Tangent::Exact, way);
      for (std::size_t k = 0; k < owned; ++k) EXPECT_NEAR((f1[k] - f0[k]) / (2 * h), k_way[k], 1e-6);
      const auto action = round.front()->create_action();
      if (round.size() > 1) continue;
      action->linearize({from.data(), nullptr, to.data()}, rule, Tangent::Exact, {});
      std::vector<double> y(to.size(), 0.0), diagonal(to.size(), 0.0);
      action->add_product(way.data(), y.data());
      for (std::size_t k = 0; k < owned; ++k) EXPECT_NEAR(y[k], k_way[k], 1e-13);
    }
    // The exact mean does the work that the energy loses, and has no moment about the centre at the mean place.
    const auto mean = force(round, {from.data(), nullptr, to.data()}, exact_rule(), to.size());
    double work[2] = {0, energy(round, to.data()) - energy(round, from.data())};
    for (std::size_t k = 0; k < owned; ++k) work[0] += mean[k] * (to[k] - from[k]);
    model->space().sum(work, 2);
    EXPECT_NEAR(work[0], work[1], 1e-13);
    if (element != ContactElement::Q1C1) continue;  // derivative nodes have no place
    double moment = 0;
    const LocalMesh& mesh = model->mesh();
    for (std::size_t node = 0; node < owned / d; ++node) {
      double y[3] = {};
      for (std::size_t i = 0; i < d; ++i)
        y[i] = mesh.coordinates[node * d + i] + (from[node * d + i] + to[node * d + i]) / 2 + (i + 1 == d ? 3 : 0);
      moment += y[d - 2] * mean[node * d + d - 1] - y[d - 1] * mean[node * d + d - 2];
    }
    model->space().sum(&moment, 1);
    EXPECT_NEAR(moment, 0, 1e-13);
  }
}

/// Obstacles of every other kind, below the body or around it.
std::vector<std::shared_ptr<const Obstacle>> other_obstacles(int dimension) {
  const auto d = static_cast<std::size_t>(dimension);
  std::vector<double> below(d, 0.0), above(d, 0.0);
  below.back() = -3;
  above.back() = 7;
  const Settings wave{{"Amplitude", 0.05}, {"Period", 4.0}},
      vertical{{"Amplitude", 0.05}, {"Period", 4.0}, {"Gap", "Vertical"}};
  Settings cylinder{{"Radius", 3.0}, {"Center", below}};
  if (d == 3) cylinder.push_back({"Axis", {0.3, 1.0, 0.0}});
  return {make_obstacle("Sphere", d, {{"Radius", 7.0}, {"Center", above}, {"Cavity", true}}),
          make_obstacle("Cylinder", d, cylinder), make_obstacle("Cone", d, {{"Radius", 0.5}, {"Half Angle", 70.0}}),
          make_obstacle("Sine Wall", d, wave), make_obstacle("Sine Wall", d, vertical)};
}

// Gaps are from 0.3 to 0.5. The first range leaves out some points, the second one all.
TEST(CurvedSurfaceTermTest, NothingActsBeyondTheRange) {
  for (const double range : {0.4, 0.2})
    for (const int dimension : {2, 3})
      for (const auto& obstacle : {sphere(3, dimension), other_obstacles(dimension)[3]}) {
        const auto model = test::box_with_contact(dimension, ContactElement::Q1C1);
        const auto cut = terms(*model, obstacle, true, law()->cut_off(range));
        const std::vector<double> u = test::smooth_field(*model, 0.02), way = test::smooth_field(*model, 1);
        const double h = 1e-5;
        std::vector<double> ahead = u, behind = u;
        for (std::size_t k = 0; k < u.size(); ++k) {
          ahead[k] += h * way[k];
          behind[k] -= h * way[k];
        }
        const auto f = force(cut, {nullptr, nullptr, u.data()}, end_rule(), u.size());
        double sums[2] = {energy(cut, ahead.data()) - energy(cut, behind.data()), 0};
        for (std::size_t k = 0; k < static_cast<std::size_t>(model->space().owned()); ++k) sums[1] += f[k] * way[k];
        model->space().sum(sums, 2);
        EXPECT_NEAR(sums[0] / (2 * h), sums[1], 1e-8);
        EXPECT_EQ(sums[1] == 0, range < 0.3) << range;
      }
}

/// The tangent from kept points is that of add_tangent(). The exact mean does the work that the energy loses.
TEST(CurvedSurfaceTermTest, BeforeEveryObstacleTangentsAreDerivativesKeptOrNot) {
  for (const auto& [dimension, element] : bodies)
    for (const auto& obstacle : other_obstacles(dimension)) {
      const auto model = test::box_with_contact(dimension, element);
      const auto own = terms(*model, obstacle, true);
      const std::vector<double> from = test::smooth_field(*model, 0.02), to = test::smooth_field(*model, -0.03),
                                way = test::smooth_field(*model, 1);
      const auto owned = static_cast<std::size_t>(model->space().owned());
      const double h = 1e-5;
      std::vector<double> ahead = to, behind = to;
      for (std::size_t k = 0; k < to.size(); ++k) {
        ahead[k] += h * way[k];
        behind[k] -= h * way[k];
      }
      for (const Rule& rule : {end_rule(), gauss_rule(4), exact_rule()}) {
        const Segment segment{from.data(), nullptr, to.data()};
        const auto f1 = force(own, {from.data(), nullptr, ahead.data()}, rule, to.size());
        const auto f0 = force(own, {from.data(), nullptr, behind.data()}, rule, to.size());
        const auto k_way = product(*model, own, segment, rule, Tangent::Exact, way);
        // The second derivatives before a cone jump.
        for (std::size_t k = 0; k < owned; ++k) EXPECT_NEAR((f1[k] - f0[k]) / (2 * h), k_way[k], 2e-5);
        for (const auto& term : own) {
          const auto kept = term->create_kept();
          std::vector<double> g(to.size(), 0.0), alone(to.size(), 0.0);
          EXPECT_TRUE(term->add_force_and_keep(segment, rule, *kept, g.data()));
          EXPECT_TRUE(term->add_force(segment, rule, alone.data()));
          EXPECT_EQ(g, alone);
          const auto d = static_cast<std::size_t>(dimension);
          for (Tangent kind : {Tangent::Exact, Tangent::Convex}) {
            std::vector<double> a(static_cast<std::size_t>(model->pattern().pairs()) * d * d, 0.0), b = a;
            term->add_kept_tangent(segment, rule, kind, *kept, a.data());
            term->add_tangent(segment, rule, kind, b.data());
            for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-14);
          }
        }
      }
      const auto mean = force(own, {from.data(), nullptr, to.data()}, exact_rule(), to.size());
      double work[2] = {0, energy(own, to.data()) - energy(own, from.data())};
      for (std::size_t k = 0; k < owned; ++k) work[0] += mean[k] * (to[k] - from[k]);
      model->space().sum(work, 2);
      EXPECT_NEAR(work[0], work[1], 1e-13);
    }
}

/// Returns the gap ratio of a rigid motion from x = -2 to 2 at this height above the start, over all ranks.
double ratio_past_a_sphere(const Model& model, double height) {
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  std::vector<double> from(model.mesh().coordinates.size(), 0.0), to = from;
  for (std::size_t node = 0; node < static_cast<std::size_t>(model.mesh().nodes()); ++node) {
    if (model.mesh().is_derivative(node)) continue;
    from[node * d] = -2;
    to[node * d] = 2;
    from[node * d + d - 1] = to[node * d + d - 1] = height;
  }
  double largest = 1;
  for (const auto& term : terms(model, sphere(3, model.mesh().dimension), true))
    largest = std::max(largest, term->admissibility().gap_ratio({from.data(), nullptr, to.data()}));
  return model.space().maximum(largest);
}

// The bottom passes the apex of the sphere at a gap of 0.3. Points near the bottom's end at x = 1 come nearest to that
// and end farthest from the sphere.
TEST(CurvedSurfaceTermTest, TheGapRatioSeesWhatThePathPasses) {
  const auto gap_after = [](double x) { return std::hypot(2 + x, 3.3) - 3; };
  for (const auto& [dimension, element] : bodies) {
    const auto model = test::box_with_contact(dimension, element);
    const double ratio = ratio_past_a_sphere(*model, 0);
    EXPECT_GT(ratio, gap_after(0.95) / 0.3);
    EXPECT_LT(ratio, gap_after(1) / 0.3 + 1e-12);
    // 0.4 lower, the path cuts the sphere between two ends outside.
    const double through = ratio_past_a_sphere(*model, -0.4);
    EXPECT_GT(through, 1e5);
    EXPECT_TRUE(std::isfinite(std::log(through)));
  }
}

TEST(CurvedSurfaceTermTest, RowSumsBoundTheTangent) {
  const auto model = test::box_with_contact(2, ContactElement::Q1C1);
  const auto round = terms(*model, sphere(3, 2), true);
  const std::vector<double> u = test::smooth_field(*model, 0.02);
  std::vector<double> sums(u.size(), 0.0);
  for (const auto& term : round) EXPECT_TRUE(term->add_row_sums({nullptr, nullptr, u.data()}, sums.data()));
  for (const double sign : {1.0, -1.0}) {
    std::vector<double> x(u.size());
    for (std::size_t k = 0; k < x.size(); ++k) x[k] = k % 2 == 0 ? 1.0 : sign;
    const auto y = product(*model, round, {nullptr, nullptr, u.data()}, end_rule(), Tangent::Exact, x);
    for (std::size_t k = 0; k < y.size(); ++k) EXPECT_LE(std::abs(y[k]), sums[k] + 1e-14);
  }
}

/// A body that jumps over a sphere has passed through it, with every law and element; one that ends above the centre or
/// beside the sphere, or moves away, has not.
TEST(CurvedSurfaceTermTest, AJumpThroughASphereIsAPassage) {
  for (const auto& own : {law(), make_gap_law("Penalty"), make_gap_law("Morse")})
    for (const auto& [dimension, element] : bodies) {
      const auto model = test::box_with_contact(dimension, element);  // its bottom is at 0.3
      const LocalMesh& mesh = model->mesh();
      const auto d = static_cast<std::size_t>(dimension);
      std::vector<double> center(d, 0.0);
      center.back() = -1;
      const auto ball = make_obstacle("Sphere", d, {{"Radius", 0.5}, {"Center", center}});
      const auto surface = terms(*model, ball, true, own);
      const std::vector<double> rest = test::at_rest(*model);
      const auto gap_on_the_way = [&](double along, double aside) {
        std::vector<double> u = rest;
        for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.nodes()); ++node) {
          if (mesh.is_derivative(node)) continue;
          u[d * node] = aside;
          u[d * node + d - 1] = along;
        }
        double gap = 1;
        for (const auto& term : surface)
          gap = std::min(gap, term->admissibility().passage({rest.data(), nullptr, u.data()}).gap);
        return model->space().minimum(gap);
      };
      EXPECT_LT(gap_on_the_way(-3, 0), -0.15) << dimension;
      EXPECT_GE(gap_on_the_way(-3, 0), -0.5 - 1e-12) << dimension;
      EXPECT_LT(gap_on_the_way(-3, 0.1), 0) << dimension;
      EXPECT_FALSE(gap_on_the_way(-0.9, 0) < 0) << dimension;
      EXPECT_FALSE(gap_on_the_way(3, 0) < 0) << dimension;
      EXPECT_FALSE(gap_on_the_way(0, 30) < 0) << dimension;
    }
}

}  // namespace
}  // namespace ixos
