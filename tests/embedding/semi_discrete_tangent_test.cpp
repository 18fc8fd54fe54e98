// Mass, damping and stiffness, against difference quotients of the balance and against each other.
#include "embedding/semi_discrete_tangent.hpp"

#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>

#include "solve/semi_discrete_bodies.hpp"

namespace ixos {
namespace {

std::vector<double> local(const Model& model, const Vector& x) {
  std::vector<double> result(static_cast<std::size_t>(model.space().local()));
  model.space().import(x, result.data());
  return result;
}

Teuchos::RCP<CrsMatrix> matrix(const Model& model, const TangentWeights& weights, const Vector& u, const Vector& v) {
  auto result = model.pattern().create_matrix(model.space());
  const std::vector<double> here = local(model, u), rate = local(model, v);
  set_semi_discrete_tangent(model, weights, {here.data(), 0, nullptr, nullptr, rate.data()}, *result);
  return result;
}

/// The change of the balance over the step h of u, v or a along a direction, over 2 h.
Vector difference_quotient(const Model& model, const Vector& u, const Vector& v, const Vector& a, int which,
                           const Vector& direction) {
  const double h = 1e-5;
  Vector result(model.space().owned_map());
  SemiDiscreteBalance balance(model);
  for (const double sign : {1.0, -1.0}) {
    std::vector<Vector> state{Vector(u, Teuchos::Copy), Vector(v, Teuchos::Copy), Vector(a, Teuchos::Copy)};
    state[static_cast<std::size_t>(which)].update(sign * h, direction, 1.0);
    balance.set({&state[0], &state[1], &state[2], 0.0});
    const std::vector<double>& sum = balance.sum();
    const auto view = result.getLocalViewHost(Tpetra::Access::ReadWrite);
    for (std::size_t i = 0; i < view.extent(0); ++i) view(i, 0) += sign * sum[i] / (2 * h);
  }
  return result;
}

double distance(const Vector& x, const Vector& y) {
  Vector difference(x, Teuchos::Copy);
  difference.update(-1.0, y, 1.0);
  return difference.norm2() / y.norm2();
}

void expect_derivatives(int dimension, const std::string& material) {
  const auto s = test::held_block(dimension, material);
  const Model& model = s->model();
  const Vector u = test::wave(model, 0.02, 0), v = test::wave(model, 0.1, 1), a = test::wave(model, 0.3, 2),
               direction = test::wave(model, 1, 3);
  const TangentWeights weights[] = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
  for (int which = 0; which < 3; ++which) {
    Vector product(model.space().owned_map());
    matrix(model, weights[which], u, v)->apply(direction, product);
    EXPECT_LT(distance(product, difference_quotient(model, u, v, a, which, direction)), 1e-8)
        << material << ", derivative " << which << " in " << dimension << "D";
  }
}

TEST(SemiDiscreteTangentTest, IsTheDerivativeOfTheBalance) {
  for (int dimension : {2, 3}) expect_derivatives(dimension, "");
  expect_derivatives(2, test::number("Viscosity", 0.4));
}

TEST(SemiDiscreteTangentTest, MassSumsToTheMassOfTheBody) {
  for (int dimension : {2, 3}) {
    const auto s = test::held_block(dimension);
    const Model& model = s->model();
    const Vector zero(model.space().owned_map()), along_x = test::uniform(model, 1, 0);
    Vector product(model.space().owned_map());
    matrix(model, {1, 0, 0}, zero, zero)->apply(along_x, product);
    EXPECT_NEAR(along_x.dot(product), 0.7 * 8, 1e-12);
    EXPECT_NEAR(test::uniform(model, 1, 1).dot(product), 0, 1e-13);
    // A rigid translation meets damping by mass alone, and no elastic force.
    matrix(model, {0, 1, 0}, zero, zero)->apply(along_x, product);
    EXPECT_NEAR(along_x.dot(product), 0.3 * 0.7 * 8, 1e-12);
    matrix(model, {0, 0, 1}, zero, zero)->apply(along_x, product);
    EXPECT_NEAR(product.normInf(), 0, 1e-13);
  }
}

TEST(SemiDiscreteTangentTest, AMatrixOfAnotherSparsityIsRefused) {
  const auto s = test::held_block(2), other = test::held_block(3);
  const std::vector<double> rest(static_cast<std::size_t>(s->model().space().local()));
  const auto wrong = other->model().pattern().create_matrix(other->model().space());
  EXPECT_THROW(
      set_semi_discrete_tangent(s->model(), {1, 0, 0}, {rest.data(), 0, nullptr, nullptr, rest.data()}, *wrong),
      std::logic_error);
}

TEST(SemiDiscreteOperatorTest, IsTheMatrixWithoutOne) {
  const auto s = test::held_block(3);
  const Model& model = s->model();
  const Vector u = test::wave(model, 0.02, 0), direction = test::wave(model, 1, 3);
  const std::vector<double> here = local(model, u);
  SemiDiscreteOperator op(model);
  for (const TangentWeights& weights : {TangentWeights{4, 2, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 3}}) {
    const auto assembled = matrix(model, weights, u, u);
    model.constrained_entries().constrain(weights.constrained(), assembled->getLocalMatrixHost().values.data());
    Vector expected(model.space().owned_map()), product(expected);
    assembled->apply(direction, expected);
    op.linearize(weights, {here.data()});
    op.apply(direction, product);
    EXPECT_LT(distance(product, expected), 1e-6) << weights.mass;  // elastic actions keep single precision
    op.matrix()->apply(direction, product);
    EXPECT_LT(distance(product, expected), 1e-14) << weights.mass;
  }
  op.invalidate();
  Vector product(model.space().owned_map());
  op.apply(direction, product);
  EXPECT_TRUE(std::isnan(product.norm2()));
}

}  // namespace
}  // namespace ixos
