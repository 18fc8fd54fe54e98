// Sums along a path are those of the law, point by point.
#include "material/neo_hooke_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include "material/linear_elastic.hpp"
#include "material/neo_hooke.hpp"
#include "support/displacement_gradients.hpp"

namespace ixos {
namespace {

constexpr Lame lame = lame_constants(1.0, 0.2);

/// Weights and points of a path.
const std::vector<std::pair<double, double>> points{{0.2, 0.05}, {0.3, 0.4}, {0.15, 0.75}, {0.35, 1.0}};

template <class Law, std::size_t Dim>
struct Sample {
  static constexpr std::size_t D = Dim;
  using Matrix = Small<double, D>;
  using Moduli = Small<double, D * D>;
  using Path = typename Law::template Path<D, double>;

  Matrix at(double t) const {
    Matrix h;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) h[i][j] = (1 - t) * start[i][j] + t * end[i][j];
    return h;
  }
  Matrix stress() const {
    Matrix sum{}, p;
    for (const auto& [weight, t] : points) {
      law.stress(at(t), p);
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) sum[i][j] += weight * p[i][j];
    }
    return sum;
  }
  /// Those by the end of the path.
  Moduli moduli() const {
    Moduli sum{}, a;
    Matrix p;
    for (const auto& [weight, t] : points) {
      law.stress_and_moduli(at(t), p, a);
      for (std::size_t r = 0; r < D * D; ++r)
        for (std::size_t c = 0; c < D * D; ++c) sum[r][c] += weight * t * a[r][c];
    }
    return sum;
  }

  Law law{lame};
  Matrix start{}, end{};
};

/// Strains from tiny to moderate, small steps; not rotated and rotated by two radians.
template <class Law, std::size_t D>
std::vector<std::pair<Sample<Law, D>, double>> samples() {
  std::vector<std::pair<Sample<Law, D>, double>> result;
  for (double size : {1e-8, 1e-4, 1e-2, 0.08})
    for (double angle : {0.0, 2.0}) {
      Sample<Law, D> s;
      s.start = test::sample<D>(size);
      s.end = test::sample<D>(std::min(size, 3e-3), 2.0);
      const double cosine = std::cos(angle), sine = std::sin(angle);
      for (std::size_t j = 0; j < D; ++j) {
        for (std::size_t i = 0; i < D; ++i) s.end[i][j] += s.start[i][j];
        for (auto* h : {&s.start, &s.end}) {
          const double x = (*h)[0][j] + (j == 0 ? 1 : 0), y = (*h)[1][j] + (j == 1 ? 1 : 0);
          (*h)[0][j] = cosine * x - sine * y - (j == 0 ? 1 : 0);
          (*h)[1][j] = sine * x + cosine * y - (j == 1 ? 1 : 0);
        }
      }
      result.emplace_back(s, angle == 0 ? size : 1.0);
    }
  return result;
}

template <class S>
class PathTest : public testing::Test {};
using Samples =
    testing::Types<Sample<NeoHooke, 2>, Sample<NeoHooke, 3>, Sample<LinearElastic, 2>, Sample<LinearElastic, 3>>;
TYPED_TEST_SUITE(PathTest, Samples);

TYPED_TEST(PathTest, StressesAreThoseOfTheLaw) {
  using Law = decltype(TypeParam::law);
  for (const auto& [s, size] : samples<Law, TypeParam::D>()) {
    typename TypeParam::Path path(s.law, s.start, s.end);
    typename TypeParam::Matrix p;
    for (const auto& [weight, t] : points)
      EXPECT_NEAR(path.add_stress(weight, t), s.law.stress(s.at(t), p), 1e-14) << size;
    ASSERT_TRUE(path.is_near()) << size;
    const auto sum = path.stress(1.5), expected = s.stress();
    for (std::size_t i = 0; i < TypeParam::D; ++i)
      for (std::size_t j = 0; j < TypeParam::D; ++j)
        EXPECT_NEAR(sum[i][j], 1.5 * expected[i][j], 3e-15 * size) << i << ' ' << j << ", size " << size;
  }
}

TYPED_TEST(PathTest, ModuliAreThoseOfTheLaw) {
  using Law = decltype(TypeParam::law);
  for (const auto& [s, size] : samples<Law, TypeParam::D>()) {
    typename TypeParam::Path path(s.law, s.start, s.end);
    for (const auto& [weight, t] : points) path.add_moduli(weight * t, t);
    ASSERT_TRUE(path.is_near()) << size;
    typename TypeParam::Moduli sum;
    path.moduli(1.5, sum);
    const auto expected = s.moduli();
    for (std::size_t r = 0; r < sum.size(); ++r)
      for (std::size_t c = 0; c < sum.size(); ++c) EXPECT_NEAR(sum[r][c], 1.5 * expected[r][c], 1e-14) << r << ' ' << c;
  }
}

template <class D>
class NeoHookePathTest : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<std::size_t, 2>, std::integral_constant<std::size_t, 3>>;
TYPED_TEST_SUITE(NeoHookePathTest, Dimensions);

TYPED_TEST(NeoHookePathTest, TheStressesKeepWhatModuliNeed) {
  constexpr std::size_t D = TypeParam::value;
  for (const auto& [s, size] : samples<NeoHooke, D>()) {
    NeoHookePath<D, double> path(s.law, s.start, s.end);
    for (const auto& [weight, t] : points) path.template add_stress<true>(weight, t);
    Small<double, D * D> sum;
    NeoHookePath<D, double>::moduli(s.law, path.sums(), 1.0, sum);
    const auto expected = s.moduli();
    for (std::size_t r = 0; r < sum.size(); ++r)
      for (std::size_t c = 0; c < sum.size(); ++c) EXPECT_NEAR(sum[r][c], expected[r][c], 1e-14) << r << ' ' << c;
  }
}

/// Stretches along the first axis, from and to.
template <std::size_t D, class T>
bool is_near(const T& from, const T& to) {
  Small<T, D> h0{}, h1{};
  h0[0][0] = from - 1.0;
  h1[0][0] = to - 1.0;
  NeoHookePath<D, T> path(NeoHooke{lame}, h0, h1);
  for (const auto& [weight, t] : points) path.add_stress(weight, t);
  return path.is_near();
}

TYPED_TEST(NeoHookePathTest, LeavesLargeStepsAndStrainsToTheLaw) {
  constexpr std::size_t D = TypeParam::value;
  EXPECT_TRUE((is_near<D, double>(1.0, 1.01)));
  EXPECT_TRUE((is_near<D, double>(0.8, 0.79)));
  EXPECT_FALSE((is_near<D, double>(1.0, 1.1)));
  EXPECT_FALSE((is_near<D, double>(1.4, 1.4)));
  EXPECT_FALSE((is_near<D, double>(0.6, 0.6)));
  EXPECT_FALSE((is_near<D, double>(-1.0, -1.0)));
  Pack from = 1.0, to = 1.001;
  EXPECT_TRUE((is_near<D, Pack>(from, to)));
  to[Pack::size() - 1] = -1.0;
  EXPECT_FALSE((is_near<D, Pack>(from, to)));
}

}  // namespace
}  // namespace ixos
