#include "fem/simplex_rules.hpp"

#include <cmath>

namespace ixos {
namespace {

/// Adds the points of an orbit: (a, a, 1 - 2a) in barycentric coordinates. Tables have weights for a triangle of
/// area 1.
void add_three(QuadratureRule<2>& rule, double a, double weight) {
  for (const std::array<double, 2>& point : {std::array{a, a}, std::array{1 - 2 * a, a}, std::array{a, 1 - 2 * a}}) {
    rule.points.push_back(point);
    rule.weights.push_back(weight / 2);
  }
}

/// Adds the six permutations of (a, b, 1 - a - b).
void add_six(QuadratureRule<2>& rule, double a, double b, double weight) {
  const double c = 1 - a - b;
  for (const auto& [x, y] : {std::pair{a, b}, {b, a}, {a, c}, {c, a}, {b, c}, {c, b}}) {
    rule.points.push_back({x, y});
    rule.weights.push_back(weight / 2);
  }
}

void add_centre(QuadratureRule<2>& rule, double weight) {
  rule.points.push_back({1.0 / 3, 1.0 / 3});
  rule.weights.push_back(weight / 2);
}

/// Adds the four points (a, a, a, 1 - 3a). Tables have weights for a tetrahedron of volume 1.
void add_four(QuadratureRule<3>& rule, double a, double weight) {
  const double b = 1 - 3 * a;
  for (const std::array<double, 3>& point :
       {std::array{a, a, a}, std::array{b, a, a}, std::array{a, b, a}, std::array{a, a, b}}) {
    rule.points.push_back(point);
    rule.weights.push_back(weight / 6);
  }
}

/// Adds the six points (b, b, 1/2 - b, 1/2 - b).
void add_six(QuadratureRule<3>& rule, double b, double weight) {
  const double c = 0.5 - b;
  for (const std::array<double, 3>& point : {std::array{b, b, c}, std::array{b, c, b}, std::array{c, b, b},
                                             std::array{c, c, b}, std::array{c, b, c}, std::array{b, c, c}}) {
    rule.points.push_back(point);
    rule.weights.push_back(weight / 6);
  }
}

}  // namespace

QuadratureRule<2> triangle_rule(int along) {
  QuadratureRule<2> rule;
  if (along == 1) {
    add_centre(rule, 1);
  } else if (along == 2) {
    add_three(rule, 0.44594849091596483, 0.22338158967801128);
    add_three(rule, 0.091576213509770826, 0.10995174365532204);
  } else if (along == 3) {
    const double root = std::sqrt(15.0);
    add_centre(rule, 0.225);
    add_three(rule, (6 + root) / 21, (155 + root) / 1200);
    add_three(rule, (6 - root) / 21, (155 - root) / 1200);
  } else if (along == 4) {
    add_three(rule, 0.24928674517089836, 0.11678627572640074);
    add_three(rule, 0.063089014491504974, 0.050844906370210517);
    add_six(rule, 0.053145049844807841, 0.31035245103379355, 0.082851075618361025);
  } else if (along == 5) {
    add_centre(rule, 0.14431560767778701);
    add_three(rule, 0.45929258829272301, 0.095091634267284994);
    add_three(rule, 0.17056930775176, 0.103217370534718);
    add_three(rule, 0.050547228317031, 0.032458497623198);
    add_six(rule, 0.00839477740995800, 0.263112829634638, 0.027230314174435);
  } else {
    const Quadrature across = gauss_legendre_unit(along), up = gauss_jacobi_unit(along, 1);
    for (std::size_t j = 0; j < up.points.size(); ++j)
      for (std::size_t i = 0; i < across.points.size(); ++i) {
        rule.points.push_back({across.points[i] * (1 - up.points[j]), up.points[j]});
        rule.weights.push_back(across.weights[i] * up.weights[j]);
      }
  }
  return rule;
}

QuadratureRule<2> three_point_rule() {
  QuadratureRule<2> rule;
  add_three(rule, 1.0 / 6, 1.0 / 3);
  return rule;
}

QuadratureRule<3> tetrahedron_rule(int along) {
  QuadratureRule<3> rule;
  if (along == 1) {
    rule.points.push_back({0.25, 0.25, 0.25});
    rule.weights.push_back(1.0 / 6);
  } else if (along == 2) {
    add_four(rule, 0.32805469671142662, 0.13852796651186211);
    add_four(rule, 0.10695227393293071, 0.1114720334881379);
  } else if (along == 3) {
    add_four(rule, 0.3108859192633005, 0.1126879257180162);
    add_four(rule, 0.092735250310891207, 0.073493043116361997);
    add_six(rule, 0.045503704125649698, 0.042546020777081202);
  } else {
    const Quadrature x = gauss_legendre_unit(along), y = gauss_jacobi_unit(along, 1), z = gauss_jacobi_unit(along, 2);
    for (std::size_t k = 0; k < z.points.size(); ++k)
      for (std::size_t j = 0; j < y.points.size(); ++j)
        for (std::size_t i = 0; i < x.points.size(); ++i) {
          const double below = 1 - z.points[k], left = below * (1 - y.points[j]);
          rule.points.push_back({x.points[i] * left, y.points[j] * below, z.points[k]});
          rule.weights.push_back(x.weights[i] * y.weights[j] * z.weights[k]);
        }
  }
  return rule;
}

QuadratureRule<3> four_point_rule() {
  QuadratureRule<3> rule;
  add_four(rule, (5 - std::sqrt(5.0)) / 20, 0.25);
  return rule;
}

QuadratureRule<3> prism_rule(const QuadratureRule<2>& triangle, int along) {
  const Quadrature line = gauss_legendre(along);
  QuadratureRule<3> rule;
  for (std::size_t k = 0; k < line.points.size(); ++k)
    for (std::size_t q = 0; q < triangle.size(); ++q) {
      rule.points.push_back({triangle.points[q][0], triangle.points[q][1], line.points[k]});
      rule.weights.push_back(triangle.weights[q] * line.weights[k]);
    }
  return rule;
}

QuadratureRule<3> pyramid_rule(int along) {
  const Quadrature plane = gauss_legendre(along), up = gauss_jacobi_unit(along, 2);
  QuadratureRule<3> rule;
  for (std::size_t k = 0; k < up.points.size(); ++k)
    for (std::size_t j = 0; j < plane.points.size(); ++j)
      for (std::size_t i = 0; i < plane.points.size(); ++i) {
        const double half = 1 - up.points[k];
        rule.points.push_back({half * plane.points[i], half * plane.points[j], up.points[k]});
        rule.weights.push_back(plane.weights[i] * plane.weights[j] * up.weights[k]);
      }
  return rule;
}

}  // namespace ixos
