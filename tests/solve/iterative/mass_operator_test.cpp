// The mass, against sums that are known; the scaled consistent mass, against its assembled matrix and against
// eigenvalues that are known.
#include "solve/iterative/mass_operator.hpp"

#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Vector.hpp>
#include <array>
#include <cmath>
#include <limits>

#include "mesh/generators/shapes.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

/// A box whose cells are parallelepipeds of different sizes: graded along x, then sheared.
struct Body {
  explicit Body(int dimension) {
    BoxShape shape;
    shape.dimension = dimension;
    shape.lengths = {3, 2, 1};
    shape.divisions = {4, 3, 2};
    Mesh mesh = box(shape);
    const auto d = static_cast<std::size_t>(dimension);
    for (std::size_t i = 0; i < mesh.coordinates.size(); i += d) {
      long sum = 0;
      for (std::size_t k = 0; k < d; ++k)
        sum += std::lround(mesh.coordinates[i + k] * shape.divisions[k] / shape.lengths[k]);
      sign.push_back(sum % 2 == 0 ? 1 : -1);
      double& x = mesh.coordinates[i];
      x += 0.4 * x * x + 0.3 * mesh.coordinates[i + 1];
    }
    Material material = test::elastic(linear_elastic, 0.2);
    material.density = 0.7;
    model = test::model_of(mesh, material, Inertia::Consistent);
  }

  /// Holds all components but the last at the left end.
  void hold() const {
    const LocalMesh& mesh = model->mesh();
    for (int node : mesh.node_sets[mesh.node_set("left")])
      for (int i = 0; i + 1 < mesh.dimension; ++i) model->constraints().add(node * mesh.dimension + i, 1.0, nullptr);
  }

  std::vector<double> sign;  ///< by node of the whole mesh: as on a checkerboard
  std::unique_ptr<Model> model;
};

double distance(const Vector& a, const Vector& b) {
  Vector difference(a, Teuchos::Copy);
  difference.update(-1.0, b, 1.0);
  return difference.norm2();
}

Vector scale_of(const ScaledMass& op) {
  Vector result(op.getRangeMap());
  const auto view = result.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t i = 0; i < view.extent(0); ++i) view(i, 0) = op.scale()[i];
  return result;
}

TEST(ScaledMassTest, IsTheMatrixScaledFromBothSides) {
  for (int dimension : {2, 3}) {
    const Body body(dimension);
    body.hold();
    const Model& model = *body.model;
    const ScaledMass op(model);
    const auto matrix = model.pattern().create_matrix(model.space());
    double* values = matrix->getLocalMatrixHost().values.data();
    model.mass()->add_to(1.0, values);
    model.constrained_entries().constrain(1.0, values);
    const auto map = model.space().owned_map();
    const Vector scale = scale_of(op);
    Vector x(map), scaled(map), product(map), expected(map), found(map);
    x.randomize();
    scaled.elementWiseMultiply(1.0, scale, x, 0.0);
    matrix->apply(scaled, product);
    expected.elementWiseMultiply(1.0, scale, product, 0.0);
    op.apply(x, found);
    EXPECT_LT(distance(found, expected), 1e-13 * x.norm2());
    // S is the root of the inverse diagonal; it is 1 where the matrix has a 1 in the place of a held degree of freedom.
    Vector diagonal(map);
    matrix->getLocalDiagCopy(diagonal);
    const auto view = diagonal.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t i = 0; i < view.extent(0); ++i) EXPECT_NEAR(view(i, 0) * op.scale()[i] * op.scale()[i], 1, 1e-14);
  }
}

// Along a line of linear elements of any lengths, M 1 = 3/2 D 1, D the diagonal of M, and the vector that changes its
// sign from node to node has 1/2 in the place of 3/2. The box is a product of such lines.
TEST(ScaledMassTest, EigenvaluesAtBothEndsAreTheSameOnEveryMesh) {
  for (int dimension : {2, 3}) {
    const Body body(dimension);
    const Model& model = *body.model;
    const ScaledMass op(model);
    const auto map = model.space().owned_map();
    const double least = std::pow(0.5, dimension), largest = std::pow(1.5, dimension);
    const auto d = static_cast<std::size_t>(dimension);
    Vector x(map), y(map);
    for (bool checkerboard : {false, true}) {
      {
        const auto view = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
        for (std::size_t i = 0; i < view.extent(0); ++i) {
          const auto node = static_cast<std::size_t>(model.mesh().original_ids[i / d]);
          view(i, 0) = (checkerboard ? body.sign[node] : 1) * static_cast<double>(1 + i % d) / op.scale()[i];
        }
      }
      op.apply(x, y);
      const double size = x.norm2();
      x.scale(checkerboard ? least : largest);
      EXPECT_LT(distance(y, x), 1e-13 * size) << checkerboard;
    }
    x.randomize();
    op.apply(x, y);
    const double quotient = x.dot(y) / x.dot(x);
    EXPECT_GT(quotient, least);
    EXPECT_LT(quotient, largest);
  }
}

TEST(ScaledMassTest, HeldDegreesOfFreedomAreLeftAlone) {
  const Body body(2);
  body.hold();
  const Model& model = *body.model;
  const ScaledMass op(model);
  Vector held(model.space().owned_map()), free(model.space().owned_map()), y(model.space().owned_map());
  held.randomize();
  free.randomize();
  for (int dof = 0; dof < model.space().owned(); ++dof)
    (model.constraints().holds(dof) ? free : held).replaceLocalValue(dof, 0.0);
  ASSERT_GT(held.norm2(), 0);
  op.apply(held, y);
  EXPECT_EQ(distance(y, held), 0) << "a 1 on the diagonal, and nothing beside it";
  op.apply(free, y);
  for (int dof = 0; dof < model.space().owned(); ++dof)
    if (model.constraints().holds(dof)) {
      EXPECT_EQ(y.getLocalViewHost(Tpetra::Access::ReadOnly)(static_cast<std::size_t>(dof), 0), 0);
    }
}

TEST(ScaledMassTest, AppliesToSeveralColumnsAndAddsToWhatIsThere) {
  const Body body(2);
  const ScaledMass op(*body.model);
  const auto map = body.model->space().owned_map();
  MultiVector x(map, 2), y(map, 2);
  x.randomize();
  y.putScalar(std::numeric_limits<double>::quiet_NaN());
  op.apply(x, y, Teuchos::NO_TRANS, 2.0, 0.0);  // what was there does not count
  for (std::size_t column : {0U, 1U}) {
    Vector product(map);
    op.apply(*x.getVector(column), product);
    product.scale(2.0);
    EXPECT_LT(distance(*y.getVector(column), product), 1e-15 * product.norm2());
  }
  MultiVector sum(x, Teuchos::Copy);
  op.apply(x, sum, Teuchos::TRANS, -4.0, 3.0);  // symmetric
  for (std::size_t column : {0U, 1U}) {
    Vector expected(*x.getVector(column), Teuchos::Copy);
    expected.update(-2.0, *y.getVector(column), 3.0);
    EXPECT_LT(distance(*sum.getVector(column), expected), 1e-14 * expected.norm2());
  }
}

// Every column of the plain mass: e_i.M e_j is the body's mass if i = j, whatever is held.
TEST(MassOperatorTest, SumsToTheMassOfTheBodyAlongEachAxis) {
  for (int dimension : {2, 3})
    for (const Inertia inertia : {Inertia::Consistent, Inertia::Lumped, Inertia::None}) {
      BoxShape shape;
      shape.dimension = dimension;
      shape.lengths = {3, 2, 1};
      shape.divisions = {4, 3, 2};
      const auto model = test::model_of(box(shape), test::elastic(linear_elastic, 0.2), inertia);
      model->constraints().add(0, 1.0, nullptr);
      const auto d = static_cast<std::size_t>(dimension);
      MultiVector x(model->space().owned_map(), d), y(model->space().owned_map(), d);
      {
        const auto view = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
        for (std::size_t i = 0; i < view.extent(0); ++i)
          for (std::size_t j = 0; j < d; ++j) view(i, j) = i % d == j ? 1.0 : 0.0;
      }
      y.putScalar(1.0);
      const MassOperator mass(*model);
      mass.apply(x, y, Teuchos::NO_TRANS, 2.0, 0.5);
      std::vector<double> sums(d);
      y.dot(x, Teuchos::ArrayView<double>(sums.data(), dimension));
      const double nodes = static_cast<double>(model->space().global()) / dimension;
      for (const double sum : sums) EXPECT_NEAR(sum, (inertia == Inertia::None ? 0 : 2 * 6) + 0.5 * nodes, 1e-11);
    }
}

}  // namespace
}  // namespace ixos
