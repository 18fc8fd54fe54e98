// Triangles, tetrahedra, prisms and pyramids: their functions, what these reproduce, and their quadrature.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/error.hpp"
#include "fem/cell_info.hpp"
#include "fem/shape_table.hpp"
#include "fem/simplex_rules.hpp"
#include "fem/with_element.hpp"

namespace ixos {
namespace {

double factorial(int n) { return std::tgamma(n + 1.0); }

/// Calls test(TypeTag<Element>, name) for the cells of these shapes.
template <class Test>
void for_each_simplex(const Test& test) {
  for (const CellInfo& info : cell_infos())
    with_element(info.type, [&](auto tag) {
      if constexpr (HasRule<typename decltype(tag)::type>::value) test(tag, std::string(info.name));
    });
}

/// Points inside a cell.
template <class Element>
auto inner_points() {
  return Element::own_rule(true).points;
}

TEST(SimplicesTest, FunctionsAreOneAtTheirNodeAndZeroAtTheOthers) {
  for_each_simplex([](auto tag, const std::string& name) {
    using Element = typename decltype(tag)::type;
    std::array<double, Element::nodes> value;
    std::array<std::array<double, Element::dimension>, Element::nodes> gradient;
    for (std::size_t a = 0; a < value.size(); ++a) {
      Element::evaluate(Element::place(a), value, gradient);
      for (std::size_t b = 0; b < value.size(); ++b) EXPECT_NEAR(value[b], a == b ? 1 : 0, 4e-15) << name << a << b;
    }
  });
}

TEST(SimplicesTest, GradientsAreDifferenceQuotients) {
  for_each_simplex([](auto tag, const std::string& name) {
    using Element = typename decltype(tag)::type;
    constexpr std::size_t D = Element::dimension, N = Element::nodes;
    std::array<double, N> value, up, down;
    std::array<std::array<double, D>, N> gradient, unused;
    for (const auto& xi : inner_points<Element>()) {
      Element::evaluate(xi, value, gradient);
      for (std::size_t d = 0; d < D; ++d) {
        auto above = xi, below = xi;
        above[d] += 1e-5;
        below[d] -= 1e-5;
        Element::evaluate(above, up, unused);
        Element::evaluate(below, down, unused);
        for (std::size_t a = 0; a < N; ++a) EXPECT_NEAR((up[a] - down[a]) / 2e-5, gradient[a][d], 1e-7) << name;
      }
    }
  });
}

/// Linear cells reproduce 1, x, y, z; quadratic ones all products of two of them.
TEST(SimplicesTest, ReproducePolynomialsOfTheirOrder) {
  for_each_simplex([](auto tag, const std::string& name) {
    using Element = typename decltype(tag)::type;
    constexpr std::size_t D = Element::dimension, N = Element::nodes;
    const auto polynomial = [](const std::array<double, D>& x) {
      double f = 0.3;
      for (std::size_t d = 0; d < D; ++d) f += (1.0 + static_cast<double>(d)) * x[d];
      return CellTraits<Element>::order == 1 ? f : f * f - 2 * x[0] * x[D - 1];
    };
    std::array<double, N> value;
    std::array<std::array<double, D>, N> gradient;
    for (const auto& xi : inner_points<Element>()) {
      Element::evaluate(xi, value, gradient);
      double sum = 0;
      for (std::size_t a = 0; a < N; ++a) sum += value[a] * polynomial(Element::place(a));
      EXPECT_NEAR(sum, polynomial(xi), 2e-14) << name;
    }
  });
}

/// The integral of x^i y^j z^k over the tetrahedron is i! j! k! / (i + j + k + 3)!.
TEST(SimplicesTest, RulesOfTetrahedraAreExactToTheirDegree) {
  const auto expect_exact = [](const QuadratureRule<3>& rule, int degree) {
    for (const double weight : rule.weights) EXPECT_GT(weight, 0);
    for (const auto& point : rule.points) EXPECT_TRUE(is_inside<ReferenceShape::Tetrahedron>(point, 0));
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; i + j <= degree; ++j)
        for (int k = 0; i + j + k <= degree; ++k) {
          double sum = 0;
          for (std::size_t q = 0; q < rule.size(); ++q)
            sum += rule.weights[q] * std::pow(rule.points[q][0], i) * std::pow(rule.points[q][1], j) *
                   std::pow(rule.points[q][2], k);
          EXPECT_NEAR(sum, factorial(i) * factorial(j) * factorial(k) / factorial(i + j + k + 3), 1e-15) << degree;
        }
  };
  expect_exact(four_point_rule(), 2);
  for (const auto& [along, degree] : {std::pair{1, 1}, {2, 3}, {3, 5}, {4, 7}, {5, 9}, {8, 15}})
    expect_exact(tetrahedron_rule(along), degree);
  EXPECT_THROW(tetrahedron_rule(0), InputError);
  EXPECT_THROW(tetrahedron_rule(65), InputError);
}

/// Over the pyramid x = (1 - z) a, y = (1 - z) b the integral of (1 - z)^m a^i b^j z^k has the factor (1 - z)^2.
TEST(SimplicesTest, RulesOfPyramidsAndPrismsAreExactToTheirDegree) {
  const auto even = [](int i) { return i % 2 == 0 ? 2.0 / (i + 1) : 0.0; };
  for (const int along : {1, 2, 3, 4, 6}) {
    const QuadratureRule<3> rule = pyramid_rule(along);
    for (const auto& point : rule.points) EXPECT_TRUE(is_inside<ReferenceShape::Pyramid>(point, 0));
    for (int i = 0; i < 2 * along; ++i)
      for (int k = 0; k < 2 * along; ++k) {
        double sum = 0;
        for (std::size_t q = 0; q < rule.size(); ++q) {
          const auto [x, y, z] = rule.points[q];
          sum += rule.weights[q] * std::pow(x / (1 - z), i) * std::pow(y / (1 - z), i) * std::pow(z, k);
        }
        // int_0^1 (1 - z)^2 z^k dz = 2 k! / (k + 3)!
        EXPECT_NEAR(sum, even(i) * even(i) * 2 * factorial(k) / factorial(k + 3), 4e-15 * (1 + sum)) << along;
      }
  }
  const QuadratureRule<3> prism = prism_rule(triangle_rule(2), 2);
  double sum = 0;
  for (std::size_t q = 0; q < prism.size(); ++q) {
    const auto [x, y, z] = prism.points[q];
    EXPECT_TRUE((is_inside<ReferenceShape::Prism, 3>({x, y, z}, 0)));
    sum += prism.weights[q] * x * x * y * y * z * z;
  }
  EXPECT_NEAR(sum, factorial(2) * factorial(2) / factorial(6) * 2 / 3, 1e-15);
  EXPECT_THROW(pyramid_rule(0), InputError);
  for (const int power : {1, 2})
    for (const int n : {1, 2, 5, 20, 64}) {
      const Quadrature rule = gauss_jacobi_unit(n, power);
      for (const int degree : {0, 1, 2 * n - 1}) {
        double moment = 0;
        for (std::size_t q = 0; q < rule.points.size(); ++q)
          moment += rule.weights[q] * std::pow(rule.points[q], degree);
        const double exact = std::exp(std::lgamma(degree + 1.0) + std::lgamma(power + 1.0) -
                                      std::lgamma(degree + power + 2.0));  // the beta function
        EXPECT_NEAR(moment, exact, 1e-12 * exact) << n << ", " << power;
      }
    }
  EXPECT_THROW(gauss_jacobi_unit(0, 1), InputError);
}

/// The integral of each function, which the nodal weights are.
TEST(SimplicesTest, NodalWeightsAreTheIntegralsOfTheFunctionsAndPositive) {
  int listed = 0;
  for_each_simplex([&listed](auto tag, const std::string& name) {
    using Element = typename decltype(tag)::type;
    constexpr std::size_t D = Element::dimension, N = Element::nodes;
    std::array<double, N> value, integral{};
    std::array<std::array<double, D>, N> gradient;
    const auto rule = Element::mass_rule();
    double volume = 0;
    for (std::size_t q = 0; q < rule.size(); ++q) {
      Element::evaluate(rule.points[q], value, gradient);
      for (std::size_t a = 0; a < N; ++a) integral[a] += rule.weights[q] * value[a];
      volume += rule.weights[q];
    }
    if constexpr (CellTraits<Element>::bubbles) {
      for (const double own : integral) EXPECT_GT(own, 0) << name;
    }
    if constexpr (std::is_same_v<Element, Tri7> || std::is_same_v<Element, Tet15> || std::is_same_v<Element, Prism21>) {
      ++listed;
      const auto weights = Element::nodal_weights();
      for (std::size_t a = 0; a < N; ++a) EXPECT_NEAR(weights[a], integral[a], 1e-15) << name << a;
    }
    EXPECT_NEAR(volume,
                D == 2                                                      ? 0.5
                : CellTraits<Element>::shape == ReferenceShape::Tetrahedron ? 1.0 / 6
                : CellTraits<Element>::shape == ReferenceShape::Prism       ? 1.0
                                                                            : 4.0 / 3,
                1e-14)
        << name;
  });
  EXPECT_EQ(listed, 3);
}

TEST(SimplicesTest, InsideMeansTheShape) {
  EXPECT_TRUE((is_inside<ReferenceShape::Tetrahedron, 3>({0.3, 0.3, 0.3}, 0)));
  EXPECT_FALSE((is_inside<ReferenceShape::Tetrahedron, 3>({0.4, 0.4, 0.3}, 0)));
  EXPECT_TRUE((is_inside<ReferenceShape::Pyramid, 3>({0, 0, 1}, 0)));
  EXPECT_FALSE((is_inside<ReferenceShape::Pyramid, 3>({0.6, 0, 0.5}, 0)));
  EXPECT_FALSE((is_inside<ReferenceShape::Pyramid, 3>({0, 0, -0.1}, 0)));
  EXPECT_TRUE((is_inside<ReferenceShape::Prism, 3>({0.5, 0.5, -1}, 1e-12)));
  EXPECT_FALSE((is_inside<ReferenceShape::Prism, 3>({0.2, 0.2, 1.1}, 0)));
  EXPECT_FALSE((is_inside<ReferenceShape::Prism, 3>({0.2, std::nan(""), 0}, 0)));
}

/// The map of a cell between others' faces is defined at the apex, too.
TEST(SimplicesTest, PyramidsHaveFiniteFunctionsAtTheApex) {
  const auto expect_finite = [](auto tag) {
    using Element = typename decltype(tag)::type;
    std::array<double, Element::nodes> value;
    std::array<std::array<double, 3>, Element::nodes> gradient;
    Element::evaluate({0, 0, 1}, value, gradient);
    double sum = 0;
    for (const auto& own : gradient) sum += own[2];
    for (const double own : value) EXPECT_TRUE(std::isfinite(own));
    EXPECT_NEAR(sum, 0, 1e-13);
  };
  expect_finite(TypeTag<Pyr5>{});
  expect_finite(TypeTag<Pyr14>{});
  expect_finite(TypeTag<Pyr19>{});
}

}  // namespace
}  // namespace ixos
