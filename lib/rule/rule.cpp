#include "rule/rule.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "fem/quadrature.hpp"
#include "rule/straight_points.hpp"

namespace ixos {

bool Rule::uses_velocity() const {
  return std::any_of(points.begin(), points.end(), [](const RulePoint& point) { return point.velocity != 0; });
}

bool Rule::has_end() const {
  return std::any_of(points.begin(), points.end(),
                     [](const RulePoint& point) { return point.to == 1 && point.from == 0 && point.velocity == 0; });
}

double Rule::end_weight() const {
  double sum = 0;
  for (const RulePoint& point : points) sum += point.weight * point.to;
  return sum;
}

double Rule::mean_time() const {
  if (mean != Mean::Points) return 0.5;
  double sum = 0, weights = 0;
  for (const RulePoint& point : points) {
    sum += point.weight * point.time;
    weights += point.weight;
  }
  return weights != 0 ? sum / weights : 1;
}

bool Rule::uses_start() const {
  return mean != Mean::Points ||
         std::any_of(points.begin(), points.end(), [](const RulePoint& point) { return point.from != 0; });
}

bool Rule::is_path_mean() const {
  if (mean != Mean::Points) return true;
  if (!has_straight_points(*this) || kept_weight != 0) return false;
  double sums[3] = {-1, -1.0 / 2, -1.0 / 3};
  for (const RulePoint& point : points) {
    sums[0] += point.weight;
    sums[1] += point.weight * point.to;
    sums[2] += point.weight * point.to * point.to;
  }
  return std::all_of(std::begin(sums), std::end(sums), [](double sum) { return std::abs(sum) < 1e-12; });
}

double Rule::total_weight() const {
  double sum = kept_weight + (mean == Mean::Points ? 0 : 1);
  for (const RulePoint& point : points) sum += point.weight;
  return sum;
}

Rule end_rule(double weight) { return {{{weight, 0.0, 0.0, 1.0}}, 0.0}; }

Rule exact_rule() { return {{}, 0.0, Mean::Exact}; }

Rule discrete_gradient_rule() { return {{}, 0.0, Mean::DiscreteGradient}; }

Rule point_rule(const std::vector<double>& xi, const std::vector<double>& weights, Path path) {
  Rule rule;
  for (std::size_t i = 0; i < xi.size(); ++i) {
    const double x = xi[i];
    if (x == 0)
      rule.kept_weight += weights[i];
    else if (path == Path::Linear)
      rule.points.push_back({weights[i], 1 - x, 0.0, x, x});
    else
      rule.points.push_back({weights[i], 1 - x * x, x * (1 - x), x * x, x});
  }
  return rule;
}

Rule gauss_rule(int n, Path path) {
  const Quadrature gauss = gauss_legendre_unit(n);
  return point_rule(gauss.points, gauss.weights, path);
}

}  // namespace ixos
