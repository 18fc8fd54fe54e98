// Tangents of mixed steps: beyond the force's derivative they have the curvature of the volume times what its
// linearisation foresaw.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "element/locking_body.hpp"
#include "material/revolved_law.hpp"

namespace ixos {
namespace {

template <class B>
using Vector = typename B::template Nodal<double>;

/// The logarithm of J at the points of a body.
template <class B>
std::vector<double> logarithms(const B& body, const Vector<B>& u) {
  const auto geometry = B::Kernel::geometry(B::table(), body.x);
  std::vector<double> all;
  for (std::size_t q = 0; q < geometry.points.size(); ++q)
    all.push_back(
        std::log(determinant(deformation_gradient(B::Kernel::gradient(u, B::Kernel::shape_gradients(geometry, q))))));
  return all;
}

/// a + factor b.
template <class V>
V sum(const V& a, double factor, const V& b) {
  V result = a;
  for (std::size_t n = 0; n < a.size(); ++n)
    for (std::size_t i = 0; i < a[n].size(); ++i) result[n][i] += factor * b[n][i];
  return result;
}

/// Where a time point of a rule is.
template <class B>
Vector<B> at(const B& body, const RulePoint& point, const Vector<B>& end) {
  return sum(sum(sum(Vector<B>{}, point.to, end), point.from, body.from), point.velocity, body.velocity);
}

/// The linearisation of a function of u at `iterate` less its value at `here`, by a difference quotient; of `way` of
/// the way between them.
template <class B, class Function>
auto excess(const Vector<B>& iterate, const Vector<B>& here, double way, const Function& function) {
  const double h = 1e-4;
  const Vector<B> along = sum(here, -1, iterate);
  auto result = function(iterate);
  const auto right = function(sum(iterate, h, along)), left = function(sum(iterate, -h, along)), last = function(here);
  for (std::size_t q = 0; q < result.size(); ++q) result[q] += way * (right[q] - left[q]) / (2 * h) - last[q];
  return result;
}

/// x . K x of the tangent from an iterate.
template <class B>
double form(const B& body, const Vector<B>* iterate, double way, const Rule& rule, const Vector<B>& x) {
  typename B::template Matrix<double> k{};
  B::Kernel::add_tangent(body.law, B::Kernel::geometry(B::table(), body.x),
                         {&body.from, &body.velocity, &body.to, iterate, way}, rule, k);
  double result = 0;
  for (std::size_t r = 0; r < k.size(); ++r)
    for (std::size_t c = 0; c < k.size(); ++c) result += x[r / B::D][r % B::D] * k[r][c] * x[c / B::D][c % B::D];
  return result;
}

/// Compares with the second derivative of `stress`(body, geometry, iterate, here, way) . `volume`(body, u), numbers at
/// the points, the first of which is constant.
template <class B, class Stress, class Volume>
void expect_curvature_of_the_volume(const Stress& stress, const Volume& volume) {
  B body;
  if constexpr (IsRevolved<typename B::Element>::value)
    for (auto& place : body.x) place[0] += 3;  // off the axis
  const double kappa = body.law.lame.lambda;
  const auto iterate = B::Nodes::wave(0.15, 5.0);
  const auto geometry = B::Kernel::geometry(B::table(), body.x);
  for (const Rule& rule : {end_rule(), Rule{{{0.4, 0.7, 0.1, 0.3}, {0.6, 0.2, 0.3, 0.8}}}})
    for (const double way : {1.0, 0.0})
      for (const double phase : {1.0, 2.0, 4.0}) {
        const auto x = B::Nodes::wave(1.0, phase);
        double expected = 0;
        for (const RulePoint& point : rule.points) {
          const auto here = at(body, point, body.to);
          const std::vector<double> p = stress(body, geometry, at(body, point, iterate), here, way);
          const double h = 1e-3;
          const auto right = volume(body, sum(here, h, x)), middle = volume(body, here),
                     left = volume(body, sum(here, -h, x));
          for (std::size_t q = 0; q < p.size(); ++q)
            expected += point.weight * point.to * geometry.points[q].weight * kappa * p[q] *
                        (right[q] - 2 * middle[q] + left[q]) / (h * h);
        }
        const double found = form(body, &iterate, way, rule, x) - form<B>(body, nullptr, 1, rule, x);
        EXPECT_NEAR(found, expected, 1e-4 * std::abs(expected)) << rule.points.size() << ' ' << way << ' ' << phase;
        EXPECT_GT(std::abs(expected), 1e-6) << "it measures nothing";
      }
}

template <class B>
void expect_curvature_of_logarithms() {
  expect_curvature_of_the_volume<B>(
      [](const B& body, const auto&, const Vector<B>& iterate, const Vector<B>& here, double way) {
        return excess<B>(iterate, here, way, [&](const Vector<B>& u) { return logarithms(body, u); });
      },
      logarithms<B>);
}
TEST(MixedStepsTest, StandardCellsLineariseTheVolumeAtEachPoint) {
  expect_curvature_of_logarithms<test::Plain<Quad4, NeoHooke>>();
  expect_curvature_of_logarithms<test::Plain<Hex8, NeoHooke>>();
  expect_curvature_of_logarithms<test::Plain<Revolved<Quad4>, RevolvedLaw<NeoHooke>>>();
}

template <class B>
void expect_curvature_of_projections() {
  expect_curvature_of_the_volume<B>(
      [](const B& body, const auto& geometry, const Vector<B>& iterate, const Vector<B>& here, double way) {
        const auto own = excess<B>(iterate, here, way, [&](const Vector<B>& u) { return logarithms(body, u); });
        auto result = own;
        geometry.projection.project(geometry.points, own.data(), result.data());
        return result;
      },
      logarithms<B>);
}
TEST(MixedStepsTest, QuadraticCellsWithMeanDilatationLineariseItsProjection) {
  expect_curvature_of_projections<test::Mean<Quad9, NeoHooke>>();
  expect_curvature_of_projections<test::Mean<Revolved<Quad9>, RevolvedLaw<NeoHooke>>>();
}

template <class B>
void expect_curvature_of_means() {
  const auto ratios = [](const B& body, const Vector<B>& u) {
    std::vector<double> all = logarithms(body, u);
    for (double& value : all) value = std::exp(value);
    return all;
  };
  expect_curvature_of_the_volume<B>(
      [&](const B& body, const auto& geometry, const Vector<B>& iterate, const Vector<B>& here, double way) {
        const auto mean = [&](const Vector<B>& u) {
          const std::vector<double> all = ratios(body, u);
          std::vector<double> result(1);
          double volume = 0;
          for (std::size_t q = 0; q < all.size(); ++q) {
            result[0] += geometry.points[q].weight * all[q];
            volume += geometry.points[q].weight;
          }
          result[0] /= volume;
          return result;
        };
        const double now = mean(here)[0];
        return std::vector<double>(geometry.points.size(), excess<B>(iterate, here, way, mean)[0] / (now * now));
      },
      ratios);
}
TEST(MixedStepsTest, LinearCellsWithMeanDilatationLineariseTheirMean) {
  expect_curvature_of_means<test::Mean<Quad4, NeoHooke>>();
  expect_curvature_of_means<test::Mean<Hex8, NeoHooke>>();
}

// There Newton's step is that of the force alone, and so is the rate of convergence.
template <class B>
void expect_plain_tangent_at_the_iterate() {
  B body;
  for (const double phase : {1.0, 2.0, 4.0}) {
    const auto x = B::Nodes::wave(1.0, phase);
    const double plain = form<B>(body, nullptr, 1, end_rule(), x);
    EXPECT_NEAR(form(body, &body.to, 1, end_rule(), x), plain, 1e-12 * std::abs(plain));
    const auto other = B::Nodes::wave(0.12, 5.0);
    EXPECT_GT(std::abs(form(body, &other, 1, end_rule(), x) - plain), 1e-6 * std::abs(plain));
  }
}
TEST(MixedStepsTest, WithoutAStepTheTangentIsTheDerivative) {
  expect_plain_tangent_at_the_iterate<test::Plain<Quad9, NeoHooke>>();
  expect_plain_tangent_at_the_iterate<test::Mean<Quad4, NeoHooke>>();
  expect_plain_tangent_at_the_iterate<test::Mean<Hex27, NeoHooke>>();
}

}  // namespace
}  // namespace ixos
