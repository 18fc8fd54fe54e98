// The elastic term of one block: closed forms of homogeneous states; energy, force and tangent agree with one another.
#include "term/body/elastic_term.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "material/neo_hooke.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "support/derivative.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using Matrix = Small<double, 2>;

constexpr double youngs = 1.5, area = 3.0 * 2.0;
constexpr Lame lame = lame_constants(youngs, 0.3);
constexpr NeoHooke rubber{lame};
const Matrix strain{{{0.1, -0.05}, {0.2, -0.08}}};

/// Only `to` is set.
Segment end(const std::vector<double>& u) {
  Segment segment;
  segment.to = u.data();
  return segment;
}

/// This rank's part of a rectangle of quadrilaterals.
struct Body {
  explicit Body(const std::array<int, 3>& divisions = {5, 3, 1})
      : mesh(part(divisions)), pattern(mesh), space(mesh, test::world()) {}

  static LocalMesh part(const std::array<int, 3>& divisions) {
    BoxShape shape;
    shape.lower = {-0.5, 0.25, 0.0};
    shape.lengths = {3.0, 2.0, 1.0};
    shape.divisions = divisions;
    const Mesh whole = box(shape);
    const Comm comm = test::world();
    return localize(whole, partition_nodes(whole, comm->getSize()), comm->getRank(), comm->getSize());
  }

  std::unique_ptr<Elasticity> term(const std::shared_ptr<const ElasticLaw>& law, int points = 0,
                                   Formulation formulation = Formulation::Standard) const {
    return make_elastic_term(mesh, mesh.blocks[0], pattern, law, points, formulation);
  }

  std::vector<double> zeros() const { return std::vector<double>(static_cast<std::size_t>(space.local()), 0.0); }
  /// Returns H X.
  std::vector<double> affine(const Matrix& h) const {
    std::vector<double> u = zeros();
    for (std::size_t k = 0; k < u.size(); ++k)
      for (std::size_t j = 0; j < 2; ++j) u[k] += h[k % 2][j] * mesh.coordinates[k - k % 2 + j];
    return u;
  }
  /// Returns numbers without order, the same on every rank.
  std::vector<double> noise(double size, double phase) const {
    std::vector<double> u = zeros();
    for (std::size_t k = 0; k < u.size(); ++k)
      u[k] =
          size * std::sin(phase + 1.7 * static_cast<double>(2 * mesh.original_ids[k / 2]) + static_cast<double>(k % 2));
    return u;
  }
  static std::vector<double> sum(std::vector<double> a, double factor, const std::vector<double>& b) {
    for (std::size_t k = 0; k < a.size(); ++k) a[k] += factor * b[k];
    return a;
  }

  /// These are sums over the ranks.
  double total(double value) const {
    space.sum(&value, 1);
    return value;
  }
  double dot(const std::vector<double>& a, const std::vector<double>& b) const {
    double product = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(space.owned()); ++k) product += a[k] * b[k];
    return total(product);
  }

  std::vector<double> force(const Elasticity& term, const Segment& segment, const Rule& rule = end_rule()) const {
    std::vector<double> f = zeros();
    EXPECT_TRUE(term.add_force(segment, rule, f.data()));
    return f;
  }
  std::vector<double> tangent(const Elasticity& term, const std::vector<double>& u) const {
    std::vector<double> values(static_cast<std::size_t>(pattern.pairs()) * 4, 0.0);
    term.add_tangent(end(u), end_rule(), Tangent::Exact, values.data());
    return values;
  }
  /// Returns the product of a matrix and a local array.
  std::vector<double> times(const std::vector<double>& matrix, const std::vector<double>& x) const {
    std::vector<double> y = zeros();
    pattern.for_each_row(matrix.data(), [&](int row, const auto& entries) {
      entries([&](int column, double value) {
        y[static_cast<std::size_t>(row)] += value * x[static_cast<std::size_t>(column)];
      });
    });
    return y;
  }
  /// Expects equal entries of owned nodes.
  void expect_near(const std::vector<double>& a, const std::vector<double>& b, double tolerance) const {
    for (std::size_t k = 0; k < static_cast<std::size_t>(space.owned()); ++k) EXPECT_NEAR(a[k], b[k], tolerance) << k;
  }

  LocalMesh mesh;
  Pattern pattern;
  DofSpace space;
};

TEST(ElasticTermTest, HomogeneousStatesHaveTheEnergyAndTheForcesOfTheLaw) {
  const Body body;
  const std::vector<double> u = body.affine(strain);
  Matrix stress{};
  rubber.stress(strain, stress);
  const Matrix change{{{0.3, 0.7}, {-0.4, 0.2}}};
  double power = 0;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) power += stress[i][j] * change[i][j];
  for (int points : {0, 1, 3})
    for (const auto& term :
         {body.term(neo_hooke(lame), points), body.term(neo_hooke(lame), points, Formulation::MeanDilatation)}) {
      EXPECT_EQ(term->part(), Part::Elastic);
      EXPECT_NEAR(body.total(term->energy({u.data()})), area * rubber.energy(strain), 1e-13) << points;
      EXPECT_NEAR(body.dot(body.force(*term, end(u)), body.affine(change)), area * power, 1e-13) << points;
    }
}

TEST(ElasticTermTest, CellFieldsAreMeansOverEachCell) {
  const Body body;
  CellFields fields;
  body.term(neo_hooke(lame))->cell_fields(body.affine(strain).data(), fields);
  Matrix stress{};
  const double jacobian = rubber.stress(strain, stress);
  // tr(sigma) = P:F/J, and the stress out of the plane.
  double trace = rubber.out_of_plane_stress(strain);
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) trace += stress[i][j] * (strain[i][j] + (i == j ? 1 : 0)) / jacobian;
  const auto cells = static_cast<std::size_t>(body.mesh.blocks[0].cells());
  ASSERT_EQ(fields.jacobian.size(), cells);
  ASSERT_EQ(fields.energy_density.size(), cells);
  ASSERT_EQ(fields.stress_invariant.size(), cells);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    EXPECT_NEAR(fields.jacobian[cell], jacobian, 1e-14);
    EXPECT_NEAR(fields.energy_density[cell], rubber.energy(strain), 1e-14);
    EXPECT_NEAR(fields.stress_invariant[cell], trace / youngs, 1e-14);
  }
}

TEST(ElasticTermTest, TheForceOfALinearBodyIsTheTangentTimesTheDisplacement) {
  const Body body;
  const std::vector<double> u = body.noise(0.1, 0.3);
  for (const auto& term :
       {body.term(linear_elastic(lame)), body.term(linear_elastic(lame), 0, Formulation::MeanDilatation)}) {
    const std::vector<double> force = body.force(*term, end(u));
    body.expect_near(force, body.times(body.tangent(*term, body.noise(0.2, 1.0)), u), 1e-13);
    EXPECT_NEAR(body.total(term->energy({u.data()})), body.dot(force, u) / 2, 1e-13);
  }
}

TEST(ElasticTermTest, ForceAndTangentAreDerivatives) {
  const Body body;
  const std::vector<double> u = body.noise(0.05, 0.3), v = body.noise(0.2, 1.1), w = body.noise(0.2, 2.3);
  const auto term = body.term(neo_hooke(lame));
  const auto energy = [&](double s) { return body.total(term->energy({Body::sum(u, s, v).data()})); };
  EXPECT_NEAR(body.dot(body.force(*term, end(u)), v), test::derivative(energy), 1e-8);
  const auto power = [&](double s) {
    const std::vector<double> moved = Body::sum(u, s, v);
    return body.dot(body.force(*term, end(moved)), w);
  };
  EXPECT_NEAR(body.dot(body.times(body.tangent(*term, u), v), w), test::derivative(power), 1e-7);
}

// Long steps are not kept as sums over the points in time, but computed again.
TEST(ElasticTermTest, KeptTangentsAreThoseOfTheSegment) {
  const Body body;
  const std::vector<double> u = body.noise(0.05, 0.3);
  const auto term = body.term(neo_hooke(lame));
  const auto kept = term->create_kept();
  const std::vector<double> velocity = body.noise(0.01, 2.0);
  ASSERT_NE(kept, nullptr);
  for (double change : {1e-3, 0.05}) {
    const std::vector<double> start = body.sum(u, 1.0, body.noise(change, 1.4));
    Segment step = end(u);
    step.from = start.data();
    step.velocity = velocity.data();
    for (const Rule& rule : {end_rule(), gauss_rule(4), gauss_rule(3, Path::Kinematic)}) {
      std::vector<double> f = body.zeros(), matrix(static_cast<std::size_t>(body.pattern.pairs()) * 4, 0.0),
                          expected = matrix;
      EXPECT_TRUE(term->add_force_and_keep(step, rule, *kept, f.data()));
      body.expect_near(f, body.force(*term, step, rule), 1e-15);
      term->add_kept_tangent(step, rule, Tangent::Exact, *kept, matrix.data());
      term->add_tangent(step, rule, Tangent::Exact, expected.data());
      for (std::size_t k = 0; k < matrix.size(); ++k) EXPECT_NEAR(matrix[k], expected[k], 1e-13) << k;
    }
  }
}

TEST(ElasticTermTest, DiagonalAndRowSumsAreThoseOfTheTangent) {
  for (bool one_cell : {true, false}) {
    const Body body(one_cell ? std::array<int, 3>{1, 1, 1} : std::array<int, 3>{5, 3, 1});
    const std::vector<double> u = body.noise(0.05, 0.3);
    const auto term = body.term(neo_hooke(lame));
    std::vector<double> diagonal = body.zeros(), sums = body.zeros(), expected_diagonal = diagonal, rows = sums;
    term->add_diagonal(end(u), diagonal.data());
    EXPECT_TRUE(term->add_row_sums(end(u), sums.data()));
    const std::vector<double> matrix = body.tangent(*term, u);
    body.pattern.for_each_row(matrix.data(), [&](int row, const auto& entries) {
      entries([&](int column, double value) {
        const auto r = static_cast<std::size_t>(row);
        if (column == row) expected_diagonal[r] = value;
        rows[r] += std::abs(value);
      });
    });
    body.expect_near(diagonal, expected_diagonal, 1e-13);
    if (one_cell) body.expect_near(sums, rows, 1e-13);
    // Entries of several cells may cancel in the matrix.
    for (std::size_t k = 0; k < static_cast<std::size_t>(body.space.owned()); ++k) EXPECT_GE(sums[k], rows[k] - 1e-13);
  }
}

// The products keep single precision.
TEST(ElasticTermTest, ProductsWithoutAMatrixAreThoseOfTheTangents) {
  const Body body;
  const std::vector<double> u = body.noise(0.05, 0.3), v = body.noise(0.2, 1.1);
  const auto term = body.term(neo_hooke(lame));
  const auto action = term->create_action();
  ASSERT_NE(action, nullptr);
  for (double rest : {0.0, 0.4}) {
    action->linearize(end(u), end_rule(), Tangent::Exact, {rest, 0.0});
    std::vector<double> product = body.zeros(), diagonal = body.zeros(), exact_diagonal = body.zeros(),
                        rest_diagonal = body.zeros();
    action->add_product(v.data(), product.data());
    body.expect_near(
        product,
        Body::sum(body.times(body.tangent(*term, u), v), rest, body.times(body.tangent(*term, body.zeros()), v)), 1e-5);
    action->add_diagonal(diagonal.data());
    const std::vector<double> zeros = body.zeros();
    term->add_diagonal(end(u), exact_diagonal.data());
    term->add_diagonal(end(zeros), rest_diagonal.data());
    body.expect_near(diagonal, Body::sum(exact_diagonal, rest, rest_diagonal), 1e-5);
  }
}

// Refinement the step quarters the difference, until single precision shows.
TEST(ElasticTermTest, ProductsOfMeansOverAPathAreThoseOfTheTangentToSecondOrder) {
  const Body body;
  const std::vector<double> u = body.noise(0.05, 0.3), v = body.noise(0.2, 1.1), change = body.noise(0.05, 1.4);
  const auto term = body.term(neo_hooke(lame));
  const auto action = term->create_action();
  const auto difference = [&](double share) {
    const std::vector<double> start = Body::sum(u, share, change);
    Segment step = end(u);
    step.from = start.data();
    std::vector<double> matrix(static_cast<std::size_t>(body.pattern.pairs()) * 4, 0.0), product = body.zeros();
    term->add_tangent(step, gauss_rule(4), Tangent::Exact, matrix.data());
    action->linearize(step, gauss_rule(4), Tangent::Exact, {});
    action->add_product(v.data(), product.data());
    const std::vector<double> rest = Body::sum(product, -1, body.times(matrix, v));
    return std::sqrt(body.dot(rest, rest));
  };
  const double whole = difference(1.0);
  EXPECT_GT(whole, 1e-4);
  EXPECT_NEAR(whole / difference(0.5), 4.0, 0.5);
}

// A translation meets no stiffness: x . W x is the factor times the mass of unit density times |x|^2.
TEST(ElasticTermTest, ProductsWithoutAMatrixIncludeAMassOfTheDefaultPoints) {
  const Body body;
  const std::vector<double> u = body.affine(strain);
  std::vector<double> translation = body.zeros(), product = body.zeros();
  for (std::size_t k = 0; k < translation.size(); ++k) translation[k] = k % 2 == 0 ? 0.6 : -0.8;
  const auto term = body.term(neo_hooke(lame)), fine = body.term(neo_hooke(lame), 3);
  const auto action = term->create_action();
  EXPECT_TRUE(action->applies_mass());
  EXPECT_FALSE(fine->create_action()->applies_mass());
  action->linearize(end(u), end_rule(), Tangent::Exact, {0.0, 2.5});
  action->add_product(translation.data(), product.data());
  EXPECT_NEAR(body.dot(translation, product), 2.5 * area, 1e-5);
}

TEST(ElasticTermTest, OnlyTheStandardElementHasProductsWithoutAMatrix) {
  EXPECT_EQ(Body().term(neo_hooke(lame), 0, Formulation::MeanDilatation)->create_action(), nullptr);
}

TEST(ElasticTermTest, TheDiscreteGradientDoesTheWorkOfTheEnergy) {
  const Body body;
  const std::vector<double> from = body.noise(0.05, 0.3), to = body.noise(0.05, 2.0);
  Segment segment = end(to);
  segment.from = from.data();
  const auto term = body.term(neo_hooke(lame));
  EXPECT_NEAR(body.dot(body.force(*term, segment, discrete_gradient_rule()), Body::sum(to, -1, from)),
              body.total(term->energy({to.data()}) - term->energy({from.data()})), 1e-13);
  std::vector<double> f = body.zeros();
  EXPECT_THROW(body.term(neo_hooke(lame), 0, Formulation::MeanDilatation)
                   ->add_force(segment, discrete_gradient_rule(), f.data()),
               std::logic_error);
}

TEST(ElasticTermTest, InvertedCellsAreInadmissible) {
  const Body body;
  const std::vector<double> mirrored = body.affine({{{-2.0, 0.0}, {0.0, 0.0}}});
  std::vector<double> f = body.zeros();
  for (const Formulation formulation : {Formulation::Standard, Formulation::MeanDilatation}) {
    const auto admissible = [&](const std::shared_ptr<const ElasticLaw>& law) {
      return body.term(law, 0, formulation)->add_force(end(mirrored), end_rule(), f.data());
    };
    EXPECT_FALSE(admissible(neo_hooke(lame)));
    EXPECT_TRUE(admissible(linear_elastic(lame))) << "linear laws cannot";
  }
}

}  // namespace
}  // namespace ixos
