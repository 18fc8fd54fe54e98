#include "element/point_gradients.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "element/element_nodes.hpp"

namespace ixos {
namespace {

/// One element; its fields are without order.
template <class Shape>
struct Body : test::ElementNodes<Shape> {
  using Element = Shape;
  using test::ElementNodes<Shape>::D;
  using test::ElementNodes<Shape>::N;
  using Gradients = PointGradients<Shape>;
  using Nodal = Small<double, N, D>;

  /// The element's own table, tables of 1 to 4 points along each direction, and of other numbers that have as many
  /// points as 2 or 3 along each.
  static std::vector<ShapeTable<Shape>> tables() {
    std::vector<ShapeTable<Shape>> all(1);
    for (int count : {1, 2, 3, 4}) {
      std::array<int, D> counts;
      counts.fill(count);
      all.emplace_back(product_rule(counts));
    }
    for (std::size_t along = 0; along < D; ++along) {
      std::array<int, D> counts;
      counts.fill(1);
      counts[along] = 1 << D;
      all.emplace_back(product_rule(counts));
      counts[along] = 1 << (D - 1);
      counts[(along + 1) % D] = 2;
      all.emplace_back(product_rule(counts));
      counts.fill(3);
      counts[along] = 1;
      counts[(along + 1) % D] = 9;
      all.emplace_back(product_rule(counts));
    }
    return all;
  }

  static std::array<double, D> interpolated(const Nodal& u, const std::array<double, D>& xi) {
    std::array<double, N> value;
    Small<double, N, D> gradient;
    Shape::evaluate(xi, value, gradient);
    std::array<double, D> result{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t i = 0; i < D; ++i) result[i] += value[a] * u[a][i];
    return result;
  }

  /// Returns the derivatives along a direction by a difference that is exact up to degree 4.
  static std::array<double, D> slope(const Nodal& u, const std::array<double, D>& xi, std::size_t direction) {
    const double h = 0.25;
    std::array<double, D> result{};
    for (const auto& [steps, weight] :
         {std::pair{1, 8.0}, std::pair{-1, -8.0}, std::pair{2, -1.0}, std::pair{-2, 1.0}}) {
      std::array<double, D> there = xi;
      there[direction] += steps * h;
      const std::array<double, D> value = interpolated(u, there);
      for (std::size_t i = 0; i < D; ++i) result[i] += weight * value[i] / (12 * h);
    }
    return result;
  }

  static std::vector<Small<double, D>> stresses(std::size_t points) {
    std::vector<Small<double, D>> result(points);
    double phase = 0.4;
    for (auto& stress : result)
      for (auto& row : stress)
        for (double& entry : row) entry = std::sin(phase += 1.3);
    return result;
  }
  static std::vector<std::array<double, D>> values(std::size_t points) {
    std::vector<std::array<double, D>> result(points);
    double phase = 0.9;
    for (auto& value : result)
      for (double& entry : value) entry = std::sin(phase += 1.9);
    return result;
  }
};

template <class B>
class PointGradientsTest : public testing::Test {};
using Bodies = testing::Types<Body<Quad4>, Body<Hex8>, Body<Quad4C3>, Body<Quad4CH>, Body<Hex8C2>, Body<Quad9>,
                              Body<Hex27>, Body<Tri6>, Body<Tet10>>;
TYPED_TEST_SUITE(PointGradientsTest, Bodies);

TYPED_TEST(PointGradientsTest, AreThoseOfTheInterpolatedField) {
  constexpr std::size_t D = TypeParam::D;
  const typename TypeParam::Nodal u = TypeParam::wave(1.0, 0.3);
  for (const auto& table : TypeParam::tables()) {
    std::vector<Small<double, D>> gradients(table.size()), alone(table.size());
    std::vector<std::array<double, D>> values(table.size());
    TypeParam::Gradients::template evaluate<true>(table, u, gradients.data(), values.data());
    TypeParam::Gradients::template evaluate<false>(table, u, alone.data(),
                                                   static_cast<std::array<double, D>*>(nullptr));
    for (std::size_t q = 0; q < table.size(); ++q) {
      const auto value = TypeParam::interpolated(u, table.point[q]);
      for (std::size_t i = 0; i < D; ++i) EXPECT_NEAR(values[q][i], value[i], 1e-13) << q << ' ' << i;
      for (std::size_t d = 0; d < D; ++d) {
        const auto slope = TypeParam::slope(u, table.point[q], d);
        for (std::size_t i = 0; i < D; ++i) {
          EXPECT_NEAR(gradients[q][i][d], slope[i], 1e-12) << q << ' ' << i << ' ' << d;
          EXPECT_NEAR(alone[q][i][d], slope[i], 1e-12) << q << ' ' << i << ' ' << d;
        }
      }
    }
  }
}

// f . w = sum over points of stress : grad w + value . w for every w.
TYPED_TEST(PointGradientsTest, IntegrationIsTheTransposeOfEvaluation) {
  constexpr std::size_t D = TypeParam::D;
  const typename TypeParam::Nodal w = TypeParam::wave(1.0, 0.8);
  for (const auto& table : TypeParam::tables()) {
    const auto stresses = TypeParam::stresses(table.size());
    const auto values = TypeParam::values(table.size());
    std::vector<Small<double, D>> gradient(table.size());
    std::vector<std::array<double, D>> value(table.size());
    TypeParam::Gradients::template evaluate<true>(table, w, gradient.data(), value.data());
    double of_stresses = 0, of_values = 0;
    for (std::size_t q = 0; q < table.size(); ++q)
      for (std::size_t i = 0; i < D; ++i) {
        of_values += values[q][i] * value[q][i];
        for (std::size_t d = 0; d < D; ++d) of_stresses += stresses[q][i][d] * gradient[q][i][d];
      }
    typename TypeParam::Nodal both = TypeParam::wave(1.0, 2.2), alone = both;  // forces are added to what is there
    const typename TypeParam::Nodal before = both;
    TypeParam::Gradients::template integrate<true>(table, stresses.data(), values.data(), both);
    TypeParam::Gradients::template integrate<false>(table, stresses.data(), values.data(), alone);
    double work_of_both = 0, work_alone = 0;
    for (std::size_t a = 0; a < TypeParam::N; ++a)
      for (std::size_t i = 0; i < D; ++i) {
        work_of_both += (both[a][i] - before[a][i]) * w[a][i];
        work_alone += (alone[a][i] - before[a][i]) * w[a][i];
      }
    EXPECT_NEAR(work_of_both, of_stresses + of_values, 1e-12);
    EXPECT_NEAR(work_alone, of_stresses, 1e-12);
  }
}

TYPED_TEST(PointGradientsTest, PacksEqualDoublesLaneByLane) {
  constexpr std::size_t D = TypeParam::D, N = TypeParam::N;
  const ShapeTable<typename TypeParam::Element> table;  // of the points that a faster specialisation serves
  Small<Pack, N, D> u{}, f{};
  for (std::size_t i = 0; i < Pack::size(); ++i)
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d) u[a][d][i] = TypeParam::wave(1.0, static_cast<double>(i))[a][d];
  std::vector<Small<Pack, D>> gradients(table.size());
  std::vector<std::array<Pack, D>> values(table.size());
  TypeParam::Gradients::template evaluate<true>(table, u, gradients.data(), values.data());
  TypeParam::Gradients::template integrate<true>(table, gradients.data(), values.data(), f);
  for (std::size_t i = 0; i < Pack::size(); ++i) {
    typename TypeParam::Nodal force{};
    std::vector<Small<double, D>> gradient(table.size());
    std::vector<std::array<double, D>> value(table.size());
    TypeParam::Gradients::template evaluate<true>(table, TypeParam::wave(1.0, static_cast<double>(i)), gradient.data(),
                                                  value.data());
    TypeParam::Gradients::template integrate<true>(table, gradient.data(), value.data(), force);
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d) EXPECT_NEAR(lane(f[a][d], i), force[a][d], 1e-13) << i << ' ' << a;
  }
}

}  // namespace
}  // namespace ixos
