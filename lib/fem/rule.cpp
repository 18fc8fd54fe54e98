#include "fem/rule.hpp"

#include <algorithm>
#include <cstddef>

#include "fem/quadrature.hpp"

namespace ixos {

bool Rule::uses_velocity() const {
  return std::any_of(points.begin(), points.end(), [](const RulePoint& point) { return point.velocity != 0; });
}

double Rule::end_weight() const {
  double sum = 0;
  for (const RulePoint& point : points) sum += point.weight * point.to;
  return sum;
}

bool Rule::uses_start() const {
  return mean != Mean::Points ||
         std::any_of(points.begin(), points.end(), [](const RulePoint& point) { return point.from != 0; });
}

double Rule::total_weight() const {
  double sum = kept_weight + (mean == Mean::Points ? 0 : 1);
  for (const RulePoint& point : points) sum += point.weight;
  return sum;
}

Rule end_rule() { return {{{1.0, 0.0, 0.0, 1.0}}, 0.0}; }

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
