// Sum factorisation against the products with the table.
#include "element/tensor_gradients.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <type_traits>
#include <vector>

#include "base/pack.hpp"
#include "element/point_gradients.hpp"
#include "fem/quadratic_elements.hpp"

namespace ixos {
namespace {

template <class ElementType, class ScalarType>
struct Case {
  using Element = ElementType;
  using Scalar = ScalarType;
};

template <class C>
class TensorGradientsTest : public testing::Test {
 protected:
  using Element = typename C::Element;
  using T = typename C::Scalar;
  using Tensor = TensorGradients<Element>;
  using Tabulated = TabulatedGradients<Element>;
  static constexpr std::size_t D = Element::dimension;
  static constexpr std::size_t N = Element::nodes;
  using Nodal = Small<T, N, D>;
  struct Field {
    std::vector<Small<T, D>> gradients = std::vector<Small<T, D>>(N);
    std::vector<std::array<T, D>> values = std::vector<std::array<T, D>>(N);
  };

  T random() {
    const auto one = [&](auto) { return distribution_(engine_); };
    if constexpr (std::is_same_v<T, double>)
      return one(0);
    else
      return T(one);
  }
  Nodal random_nodal() {
    Nodal u;
    for (auto& node : u)
      for (T& entry : node) entry = random();
    return u;
  }
  Field random_field() {
    Field field;
    for (std::size_t q = 0; q < N; ++q)
      for (std::size_t i = 0; i < D; ++i) {
        field.values[q][i] = random();
        for (T& entry : field.gradients[q][i]) entry = random();
      }
    return field;
  }
  static double difference(const T& a, const T& b) {
    using std::abs;
    return -least(T(-abs(a - b)));
  }

  const ShapeTable<Element> table_;  ///< three points along each direction
  std::mt19937 engine_{20};
  std::uniform_real_distribution<double> distribution_{-1, 1};
};

using Cases = testing::Types<Case<Quad9, double>, Case<Quad9, Pack>, Case<Hex27, double>, Case<Hex27, Pack>>;
TYPED_TEST_SUITE(TensorGradientsTest, Cases);

TYPED_TEST(TensorGradientsTest, EvaluationEqualsThatOfTheTable) {
  using Tested = TestFixture;
  for (int trial = 0; trial < 20; ++trial) {
    const typename Tested::Nodal u = this->random_nodal();
    typename Tested::Field fast, alone, slow;
    Tested::Tensor::template evaluate<true>(u, fast.gradients.data(), fast.values.data());
    Tested::Tensor::template evaluate<false>(u, alone.gradients.data(), alone.values.data());
    Tested::Tabulated::template evaluate<true>(this->table_, u, slow.gradients.data(), slow.values.data());
    for (std::size_t q = 0; q < Tested::N; ++q)
      for (std::size_t i = 0; i < Tested::D; ++i) {
        EXPECT_LT(this->difference(fast.values[q][i], slow.values[q][i]), 5e-15) << q << ' ' << i;
        for (std::size_t d = 0; d < Tested::D; ++d) {
          EXPECT_LT(this->difference(fast.gradients[q][i][d], slow.gradients[q][i][d]), 2e-14) << q << ' ' << i;
          EXPECT_LT(this->difference(alone.gradients[q][i][d], slow.gradients[q][i][d]), 2e-14) << q << ' ' << i;
        }
      }
  }
}

TYPED_TEST(TensorGradientsTest, IntegrationEqualsThatOfTheTable) {
  using Tested = TestFixture;
  for (int trial = 0; trial < 20; ++trial) {
    const typename Tested::Field field = this->random_field();
    const typename Tested::Nodal before = this->random_nodal();
    typename Tested::Nodal fast = before, slow = before, fast_alone = before, slow_alone = before;
    Tested::Tensor::template integrate<true>(field.gradients.data(), field.values.data(), fast);
    Tested::Tabulated::template integrate<true>(this->table_, field.gradients.data(), field.values.data(), slow);
    Tested::Tensor::template integrate<false>(field.gradients.data(), field.values.data(), fast_alone);
    Tested::Tabulated::template integrate<false>(this->table_, field.gradients.data(), field.values.data(), slow_alone);
    for (std::size_t a = 0; a < Tested::N; ++a)
      for (std::size_t i = 0; i < Tested::D; ++i) {
        EXPECT_LT(this->difference(fast[a][i], slow[a][i]), 2e-14) << a << ' ' << i;
        EXPECT_LT(this->difference(fast_alone[a][i], slow_alone[a][i]), 2e-14) << a << ' ' << i;
      }
  }
}

// <E u, s> = <u, I s>, the sum of all lanes.
TYPED_TEST(TensorGradientsTest, IntegrationIsTheTransposeOfEvaluation) {
  using Tested = TestFixture;
  for (int trial = 0; trial < 20; ++trial) {
    const typename Tested::Nodal u = this->random_nodal();
    const typename Tested::Field field = this->random_field();
    typename Tested::Field of_u;
    Tested::Tensor::template evaluate<true>(u, of_u.gradients.data(), of_u.values.data());
    typename Tested::Nodal f{};
    Tested::Tensor::template integrate<true>(field.gradients.data(), field.values.data(), f);
    double at_points = 0, at_nodes = 0;
    for (std::size_t q = 0; q < Tested::N; ++q)
      for (std::size_t i = 0; i < Tested::D; ++i) {
        at_points += total(of_u.values[q][i] * field.values[q][i]);
        at_nodes += total(u[q][i] * f[q][i]);
        for (std::size_t d = 0; d < Tested::D; ++d)
          at_points += total(of_u.gradients[q][i][d] * field.gradients[q][i][d]);
      }
    EXPECT_NEAR(at_points, at_nodes, 1e-12);
  }
}

TYPED_TEST(TensorGradientsTest, OnlyThreePointsAlongEachDirectionAreServed) {
  using Tested = TestFixture;
  EXPECT_TRUE(Tested::Tensor::serves(this->table_));
  std::array<int, Tested::D> counts;
  for (int count : {1, 2, 4, 5}) {
    counts.fill(count);
    EXPECT_FALSE(Tested::Tensor::serves(ShapeTable<typename Tested::Element>(product_rule(counts)))) << count;
  }
  for (std::size_t along = 0; along < Tested::D; ++along) {
    counts.fill(3);
    counts[along] = 9;
    counts[(along + 1) % Tested::D] = 1;
    EXPECT_FALSE(Tested::Tensor::serves(ShapeTable<typename Tested::Element>(product_rule(counts)))) << along;
  }
}

TEST(TiedQuad9, TakesTheTable) {
  for (unsigned tied = 1; tied < 16; ++tied)
    EXPECT_FALSE(TensorGradients<Quad9>::serves(ShapeTable<Quad9>(own_rule<Quad9>(), tied))) << tied;
}

}  // namespace
}  // namespace ixos
