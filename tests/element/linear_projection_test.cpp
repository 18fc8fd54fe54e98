// The projection on linear functions: an orthogonal projection in the sum over the points, wherever the element is.
#include "element/linear_projection.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ixos {
namespace {

struct Point {
  double weight;
};

/// Points without order, with uneven weights, stretched along x and moved far away.
struct Sample {
  explicit Sample(double stretch = 1, double offset = 0) {
    for (std::size_t q = 0; q < 9; ++q) {
      const auto phase = static_cast<double>(q);
      points.push_back({0.5 + 0.3 * std::sin(1.9 * phase)});
      places.push_back({offset + stretch * std::sin(2.3 * phase + 0.4), offset + std::cos(1.1 * phase)});
    }
  }
  std::vector<double> projected(const std::vector<double>& values) const {
    std::vector<double> result(values.size());
    LinearProjection<double, 2>(points, places).project(points, values.data(), result.data());
    return result;
  }
  std::vector<double> linear(double constant, double x, double y) const {
    std::vector<double> values;
    for (const auto& place : places) values.push_back(constant + x * place[0] + y * place[1]);
    return values;
  }
  double product(const std::vector<double>& a, const std::vector<double>& b) const {
    double sum = 0;
    for (std::size_t q = 0; q < points.size(); ++q) sum += points[q].weight * a[q] * b[q];
    return sum;
  }

  std::vector<Point> points;
  std::vector<std::array<double, 2>> places;
};

std::vector<double> noise(double phase) {
  std::vector<double> values;
  for (std::size_t q = 0; q < 9; ++q) values.push_back(std::sin(phase += 2.7));
  return values;
}

TEST(LinearProjectionTest, LinearFieldsStayAsTheyAre) {
  for (const double stretch : {1e-6, 1.0, 1e6}) {
    const Sample sample(stretch);
    const std::vector<double> field = sample.linear(0.3, 1.7 / stretch, -0.4), same = sample.projected(field);
    for (std::size_t q = 0; q < field.size(); ++q) EXPECT_NEAR(same[q], field[q], 1e-14) << stretch;
  }
}

TEST(LinearProjectionTest, TheRestIsOrthogonalToLinearFields) {
  const Sample sample;
  const std::vector<double> field = noise(0.2);
  std::vector<double> rest = sample.projected(field);
  for (std::size_t q = 0; q < rest.size(); ++q) rest[q] -= field[q];
  for (const auto& test : {sample.linear(1, 0, 0), sample.linear(0, 1, 0), sample.linear(0, 0, 1)})
    EXPECT_NEAR(sample.product(rest, test), 0, 1e-14);
  EXPECT_GT(sample.product(rest, rest), 0.1);
}

TEST(LinearProjectionTest, ItIsSymmetricInTheSumOverThePoints) {
  const Sample sample;
  const std::vector<double> a = noise(0.2), b = noise(1.3);
  EXPECT_NEAR(sample.product(sample.projected(a), b), sample.product(a, sample.projected(b)), 1e-14);
}

TEST(LinearProjectionTest, ThePlaceOfTheElementDoesNotMatter) {
  const std::vector<double> field = noise(0.2), here = Sample().projected(field);
  const std::vector<double> far = Sample(1, 1e4).projected(field);
  for (std::size_t q = 0; q < field.size(); ++q) EXPECT_NEAR(far[q], here[q], 1e-10);
}

TEST(LinearProjectionTest, FunctionsAreOrthonormal) {
  const Sample sample(1e3);
  const LinearProjection<double, 2> projection(sample.points, sample.places);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      double sum = 0;
      for (std::size_t q = 0; q < 9; ++q) sum += sample.points[q].weight * projection.at(q)[i] * projection.at(q)[j];
      EXPECT_NEAR(sum, i == j ? 1 : 0, 1e-14) << i << ' ' << j;
    }
}

// Then the projection is on functions of the other coordinate.
TEST(LinearProjectionTest, ACoordinateThatIsTheSameAtAllPointsIsLeftOut) {
  Sample sample;
  for (auto& place : sample.places) place[0] = 1.0 / 3;
  const std::vector<double> field = sample.linear(0.3, 0, -0.4), same = sample.projected(field);
  for (std::size_t q = 0; q < field.size(); ++q) EXPECT_NEAR(same[q], field[q], 1e-14);
}

}  // namespace
}  // namespace ixos
