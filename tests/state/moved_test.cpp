// Histories at other points: bounds, tangent planes and determinants stay, and turned inputs give turned results.
#include "state/moved.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "state/history.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

constexpr std::size_t numbers = 11;

/// Two cells with two points each.
LocalMesh two_cells() {
  BoxShape shape;
  shape.divisions = {2, 1, 1};
  shape.dimension = 2;
  const Mesh mesh = box(shape);
  return localize(mesh, partition_nodes(mesh, 1), 0, 1);
}

PointColumns columns() {
  static const LocalMesh mesh = two_cells();
  return {{{"rate", ColumnKind::Scalar, 1},
           {"slip", ColumnKind::Growing, 1},
           {"traction", ColumnKind::SurfaceVector, 3},
           {"branch", ColumnKind::UnimodularTensor, 6}},
          PointData(mesh.blocks.front(), 2, numbers)};
}

double at(const PointColumns& c, std::size_t cell, std::size_t point, std::size_t i) {
  return double(c.values(cell / pack_width, point, i)[cell % pack_width]);
}
void set(PointColumns& c, std::size_t cell, std::size_t point, const std::vector<double>& values,
         std::size_t first = 0) {
  for (std::size_t i = 0; i < values.size(); ++i)
    c.values(cell / pack_width, point, first + i)[cell % pack_width] = values[i];
}

using Matrix = std::array<std::array<double, 3>, 3>;

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}
Matrix transposed(const Matrix& a) {
  Matrix c{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) c[i][j] = a[j][i];
  return c;
}
Matrix rotation(double angle, std::size_t i, std::size_t j) {
  Matrix r{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  r[i][i] = r[j][j] = std::cos(angle);
  r[j][i] = std::sin(angle);
  r[i][j] = -r[j][i];
  return r;
}
/// The numbers of C: xx, xy, xz, yy, yz, zz of C - I.
std::vector<double> numbers_of(const Matrix& c) {
  return {c[0][0] - 1, c[0][1], c[0][2], c[1][1] - 1, c[1][2], c[2][2] - 1};
}
Matrix tensor_at(const PointColumns& c, std::size_t cell, std::size_t point) {
  const auto n = [&](std::size_t k) { return at(c, cell, point, 5 + k); };
  return {{{1 + n(0), n(1), n(2)}, {n(1), 1 + n(3), n(4)}, {n(2), n(4), 1 + n(5)}}};
}
double determinant(const Matrix& c) {
  return c[0][0] * (c[1][1] * c[2][2] - c[1][2] * c[2][1]) - c[0][1] * (c[1][0] * c[2][2] - c[1][2] * c[2][0]) +
         c[0][2] * (c[1][0] * c[2][1] - c[1][1] * c[2][0]);
}
Matrix stretch(double a, double b) { return {{{a, 0, 0}, {0, b, 0}, {0, 0, 1 / (a * b)}}}; }
Matrix turned(const Matrix& c, const Matrix& r) { return product(product(r, c), transposed(r)); }

TEST(MovedTest, AMeanStaysBetweenTheNumbers) {
  PointColumns from = columns(), to = columns();
  set(from, 0, 0, {-2, 1});
  set(from, 1, 1, {4, 3});
  move_columns(from, {{1, 0, {{0, 0, 0.25}, {1, 1, 0.75}}, {}}}, to);
  EXPECT_DOUBLE_EQ(at(to, 1, 0, 0), 0.25 * -2 + 0.75 * 4);
  EXPECT_DOUBLE_EQ(at(to, 1, 0, 1), 2.5);
  EXPECT_EQ(at(to, 0, 0, 1), 0) << "a point without a source";
}

TEST(MovedTest, AMarkIsThatOfTheNearestPoint) {
  static const LocalMesh mesh = two_cells();
  const PointColumns empty{{{"bond", ColumnKind::Nearest, 1}}, PointData(mesh.blocks.front(), 2, 1)};
  PointColumns from = empty, to = empty;
  set(from, 0, 0, {-1});
  set(from, 1, 1, {0.5});
  move_columns(from, {{1, 0, {{0, 0, 0.25}, {1, 1, 0.75}}, {}}, {0, 1, {{0, 0, 0.6}, {1, 1, 0.4}}, {}}}, to);
  EXPECT_EQ(at(to, 1, 0, 0), 0.5);
  EXPECT_EQ(at(to, 0, 1, 0), -1);
}

TEST(MovedTest, OneSourceIsCopiedToTheLastBit) {
  PointColumns from = columns(), to = columns();
  std::vector<double> values;
  for (std::size_t i = 0; i < numbers; ++i) values.push_back(std::sqrt(0.1 + static_cast<double>(i)));
  set(from, 1, 0, values);
  move_columns(from, {{0, 1, {{1, 0, 1.0}}, {}}}, to);
  for (std::size_t i = 0; i < numbers; ++i) EXPECT_EQ(at(to, 0, 1, i), values[i]);
}

TEST(MovedTest, VectorsStayInTheTangentPlane) {
  PointColumns from = columns(), to = columns();
  set(from, 0, 0, {1, 0, 0.5}, 2);
  set(from, 1, 0, {0, 1, -0.25}, 2);
  const double s = std::sqrt(0.5);
  move_columns(from, {{0, 0, {{0, 0, 0.5}, {1, 0, 0.5}}, {s, 0, s}}}, to);
  const double along = s * (0.5 + 0.125);
  EXPECT_NEAR(at(to, 0, 0, 2), 0.5 - along * s, 1e-15);
  EXPECT_NEAR(at(to, 0, 0, 3), 0.5, 1e-15);
  EXPECT_NEAR(at(to, 0, 0, 4), 0.125 - along * s, 1e-15);
  EXPECT_NEAR(s * (at(to, 0, 0, 2) + at(to, 0, 0, 4)), 0, 1e-15);
}

TEST(MovedTest, TensorsKeepTheirDeterminantAndTurnWithTheBody) {
  const Matrix a = turned(stretch(3, 0.2), rotation(0.7, 0, 1)), b = turned(stretch(0.5, 1.5), rotation(-1.1, 1, 2));
  const Matrix r = product(rotation(0.4, 0, 2), rotation(1.9, 0, 1));
  const std::vector<PointSource> mean{{0, 0, {{0, 0, 0.3}, {1, 0, 0.7}}, {}}};
  Matrix result[2];
  for (const bool turn : {false, true}) {
    PointColumns from = columns(), to = columns();
    set(from, 0, 0, numbers_of(turn ? turned(a, r) : a), 5);
    set(from, 1, 0, numbers_of(turn ? turned(b, r) : b), 5);
    move_columns(from, mean, to);
    result[turn ? 1 : 0] = tensor_at(to, 0, 0);
    EXPECT_NEAR(determinant(result[turn ? 1 : 0]), 1, 1e-13);
  }
  const Matrix expected = turned(result[0], r);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(result[1][i][j], expected[i][j], 1e-13);
}

// Tensors with the same axes have the geometric mean of their stretches; small strains keep their digits.
TEST(MovedTest, TheMeanOfTensorsIsTheGeometricOne) {
  PointColumns from = columns(), to = columns();
  set(from, 0, 0, numbers_of(stretch(4, 0.25)), 5);
  set(from, 1, 0, numbers_of(stretch(9, 1)), 5);
  set(from, 0, 1, {1e-20, 0, 0, -1e-20, 0, 0}, 5);
  set(from, 1, 1, {3e-20, 0, 0, -3e-20, 0, 0}, 5);
  move_columns(from, {{0, 0, {{0, 0, 0.5}, {1, 0, 0.5}}, {}}, {1, 1, {{0, 1, 0.5}, {1, 1, 0.5}}, {}}}, to);
  EXPECT_NEAR(tensor_at(to, 0, 0)[0][0], 6, 1e-14);
  EXPECT_NEAR(tensor_at(to, 0, 0)[1][1], 0.5, 1e-15);
  EXPECT_NEAR(at(to, 1, 1, 5), 2e-20, 1e-34);
}

TEST(MovedTest, WrongSharesAndColumnsAreRefused) {
  const PointColumns from = columns();
  PointColumns to = columns(), other = columns();
  other.columns[0].kind = ColumnKind::Growing;
  EXPECT_THROW(move_columns(from, {{0, 0, {{0, 0, 0.5}}, {}}}, to), std::logic_error);
  EXPECT_THROW(move_columns(from, {{0, 0, {{0, 0, 1.5}, {1, 0, -0.5}}, {}}}, to), std::logic_error);
  EXPECT_THROW(move_columns(from, {}, other), std::logic_error);
}

TEST(MovedTest, AStateMovesWithItsTimeAndHistories) {
  State state;
  state.u = {0, 0, 2, 4};
  state.v = {1, 1, 1, 1};
  state.time = 0.3;
  state.histories = TermHistories({TermHistory{{columns()}, {}, {}}});
  set(state.histories.of(0).points[0], 0, 0, {7, 5});
  StateSource source;
  source.dimension = 2;
  source.nodes = {{{0, 1.0}}, {{0, 0.5}, {1, 0.5}}, {{1, 1.0}}};
  source.points = {{{1, 1, {{0, 0, 1.0}}, {}}}};
  const State there = moved(state, source, TermHistories({TermHistory{{columns()}, {}, {}}}));
  EXPECT_EQ(there.u, (std::vector<double>{0, 0, 1, 2, 2, 4}));
  EXPECT_EQ(there.v, (std::vector<double>{1, 1, 1, 1, 1, 1}));
  EXPECT_TRUE(there.a.empty());
  EXPECT_EQ(there.time, 0.3);
  const PointColumns& found = there.histories.of(0).points[0];
  EXPECT_EQ(at(found, 1, 1, 0), 7);
  EXPECT_EQ(at(found, 1, 1, 1), 5);
}

}  // namespace
}  // namespace ixos
