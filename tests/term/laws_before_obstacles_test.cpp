// Every interaction law before every obstacle: forces and tangents are derivatives, and exact means do the work.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "interaction/catalogue.hpp"
#include "mesh/generators/shapes.hpp"
#include "support/by_hand.hpp"
#include "support/derivative.hpp"
#include "support/obstacle_geometry.hpp"
#include "support/solids.hpp"
#include "support/tangents.hpp"
#include "term/wall/surface_terms.hpp"

namespace ixos {
namespace {

constexpr double width = 0.2, gap = 0.3;

/// Returns the law's settings that keep kinks away from the gaps.
std::map<std::string, double> without_kinks(const std::string& law) {
  if (law == "Penalty") return {{"Gap", 1.0}};
  if (law == "Log Barrier") return {{"Range", 1.0}};
  if (law == "Smooth Dugdale" || law == "Capillary") return {{"Smoothing", 1.0}};
  return {};
}

class LawsBeforeObstaclesSerialTest : public testing::TestWithParam<std::tuple<std::string, std::string, int>> {
 protected:
  using Vector = std::vector<double>;

  LawsBeforeObstaclesSerialTest() {
    const auto& [law_name, obstacle_name, dimension] = GetParam();
    const Teuchos::ParameterList law = test::complete(laws(), law_name, without_kinks(law_name)),
                                 wall = test::complete(obstacles(), obstacle_name);
    const auto obstacle = obstacles().make(SceneNode(wall, ""), static_cast<std::size_t>(dimension));
    BoxShape shape;
    shape.dimension = dimension;
    shape.lengths = {width, width, width};
    shape.divisions = {1, 1, 1};
    shape.lower = {-width / 2, dimension == 2 ? 0 : -width / 2, 0};
    model_ = test::model_of(box(shape), test::elastic(neo_hooke, 0.3), Inertia::None);
    const LocalMesh& mesh = model_->mesh();
    terms_ = make_surface_terms(mesh, mesh.side_sets[mesh.side_set("bottom")], model_->pattern(),
                                laws().make(SceneNode(law, "")), obstacle, {});
    for (auto& term : terms_) steps_.push_back(std::make_unique<test::ByHand<Interaction>>(*term));
    // The middle of the bottom moves to a point at that gap.
    PackPoint x = {0.3, 2.4, dimension == 3 ? 1.9 : 0.0};
    for (int round = 0; round < 50; ++round) {
      const ObstacleGap found = obstacle->at(x);
      for (std::size_t i = 0; i < 3; ++i) x[i] -= (found.gap - gap) * found.normal[i];
    }
    from_ = field(x, 0.01, 0.0);
    to_ = field(x, -0.02, 0.4);
    way_ = field({0.0, 0.0, 0.0}, 1, 0.9);
  }

  /// A translation and a smooth displacement.
  Vector field(const PackPoint& place, double size, double phase) const {
    const auto d = static_cast<std::size_t>(model_->mesh().dimension);
    Vector u(model_->mesh().coordinates.size());
    for (std::size_t k = 0; k < u.size(); ++k)
      u[k] = place[k % d][0] + size * std::sin(3 * model_->mesh().coordinates[k] + static_cast<double>(k % d) + phase);
    return u;
  }
  static Vector sum(Vector u, const Vector& way, double step) {
    for (std::size_t k = 0; k < u.size(); ++k) u[k] += step * way[k];
    return u;
  }
  static double dot(const Vector& a, const Vector& b) {
    double result = 0;
    for (std::size_t k = 0; k < a.size(); ++k) result += a[k] * b[k];
    return result;
  }

  /// Returns the way of a term from the start to a displacement.
  Segment segment(std::size_t term, const Vector& to) const {
    return steps_[term]->segment(from_.data(), nullptr, to.data());
  }
  double energy(const Vector& u) const {
    double result = 0;
    for (std::size_t k = 0; k < terms_.size(); ++k) result += terms_[k]->energy(steps_[k]->at(u.data()));
    return result;
  }
  Vector force(const Vector& to, const Rule& rule) const {
    Vector f(to.size(), 0.0);
    for (std::size_t k = 0; k < terms_.size(); ++k) {
      EXPECT_TRUE(terms_[k]->add_force(segment(k, to), rule, f.data()));
    }
    return f;
  }
  Vector product(const Rule& rule, const Vector& x) const {
    Vector values = test::no_values(*model_);
    for (std::size_t k = 0; k < terms_.size(); ++k)
      terms_[k]->add_tangent(segment(k, to_), rule, Tangent::Exact, values.data());
    return test::matrix_product(*model_, values.data(), x);
  }

  std::unique_ptr<Model> model_;
  Interactions terms_;
  std::vector<std::unique_ptr<test::ByHand<Interaction>>> steps_;  ///< of the terms
  Vector from_, to_, way_;
};

TEST_P(LawsBeforeObstaclesSerialTest, ForceIsTheGradientAndTheExactMeanDoesTheWork) {
  const Vector f = force(to_, end_rule());
  const double scale = std::sqrt(dot(f, f));
  ASSERT_GT(scale, 0);
  EXPECT_NEAR(test::derivative([&](double s) { return energy(sum(to_, way_, s)); }, 1e-3), dot(f, way_), 1e-7 * scale);
  const double work = dot(force(to_, exact_rule()), sum(to_, from_, -1));
  EXPECT_NEAR(work, energy(to_) - energy(from_), 1e-13 * scale);
}

TEST_P(LawsBeforeObstaclesSerialTest, TangentIsTheDerivativeOfTheForce) {
  const Vector f = force(to_, end_rule());
  const double scale = std::sqrt(dot(f, f)) / gap;
  for (const Rule& rule : {end_rule(), gauss_rule(3), exact_rule()}) {
    const Vector along = product(rule, way_);
    for (std::size_t k = 0; k < along.size(); ++k)
      EXPECT_NEAR(test::derivative([&](double s) { return force(sum(to_, way_, s), rule)[k]; }, 1e-3), along[k],
                  1e-6 * scale)
          << k;
    const bool symmetric =
        std::all_of(terms_.begin(), terms_.end(), [&](const auto& term) { return term->is_gradient(rule); });
    if (symmetric) {
      EXPECT_NEAR(dot(product(rule, from_), way_), dot(along, from_), 1e-12 * scale);
    }
  }
}

TEST_P(LawsBeforeObstaclesSerialTest, ThePotentialOfTheExactMeanHasItsForce) {
  for (const auto& term : terms_)
    if (!term->is_gradient(exact_rule())) return;  // no gradient
  const Vector f = force(to_, exact_rule());
  const auto potential = [&](double s) {
    const Vector u = sum(to_, way_, s);
    double result = 0;
    for (std::size_t k = 0; k < terms_.size(); ++k) result += terms_[k]->mean_potential(segment(k, u));
    return result;
  };
  EXPECT_NEAR(test::derivative(potential, 1e-3), dot(f, way_), 1e-7 * std::sqrt(dot(f, f)));
}

template <class Catalogue>
std::vector<std::string> names(const Catalogue& catalogue) {
  std::vector<std::string> result;
  for (const auto& entry : catalogue.entries()) result.push_back(entry.name);
  return result;
}
INSTANTIATE_TEST_SUITE_P(All, LawsBeforeObstaclesSerialTest,
                         testing::Combine(testing::ValuesIn(names(laws())), testing::ValuesIn(names(obstacles())),
                                          testing::Values(2, 3)));

}  // namespace
}  // namespace ixos
