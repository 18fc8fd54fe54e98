// Preconditioners that a caller computes: exact ones are inverses, for every column.
#include "solve/operator_preconditioner.hpp"

#include <gtest/gtest.h>

#include <Thyra_MultiVectorStdOps.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include "solve/direct/factorization.hpp"
#include "solve/semi_discrete_bodies.hpp"

namespace ixos {
namespace {

Teuchos::ParameterList direct() {
  Teuchos::ParameterList list;
  list.set("Linear Solver Type", "Belos").set("Preconditioner Type", "Direct");
  list.sublist("Preconditioner Types").sublist("Direct").set("Solver Type", first_rank_factorization());
  return list;
}

/// |P W x - x| / |x| for the columns x.
double distance_from_inverse(const Thyra::LinearOpBase<double>& p, const Thyra::LinearOpBase<double>& w) {
  const auto x = Thyra::createMembers(w.domain(), 3), y = Thyra::createMembers(w.range(), 3),
             z = Thyra::createMembers(w.domain(), 3);
  Thyra::seed_randomize<double>(3);
  Thyra::randomize(-1.0, 1.0, x.ptr());
  Thyra::apply(w, Thyra::NOTRANS, *x, y.ptr());
  Thyra::apply(p, Thyra::NOTRANS, *y, z.ptr());
  double largest = 0;
  for (int column = 0; column < 3; ++column)
    largest = std::max(largest, test::relative_distance(*z->col(column), *x->col(column)));
  return largest;
}

TEST(OperatorPreconditionerTest, AFactorizationFollowsTheMatrixWhenItIsComputedAgain) {
  const auto s = test::held_block(2);
  const Model& model = s->model();
  const auto factory = test::solvers(model, direct());
  const auto preconditioner = factory->preconditioner();
  ASSERT_TRUE(nonnull(preconditioner));
  const std::vector<double> rest(static_cast<std::size_t>(model.space().local()), 0.0);
  const auto matrix = model.pattern().create_matrix(model.space());
  const auto w = linear_op(matrix, vector_space(model.space().owned_map()));
  set_semi_discrete_tangent(model, {2, 0, 1}, {rest.data(), 0, nullptr, nullptr, rest.data()}, *matrix);
  preconditioner->compute(w);
  EXPECT_LT(distance_from_inverse(*preconditioner->getUnspecifiedPrecOp(), *w), 1e-11);
  set_semi_discrete_tangent(model, {40, 0, 1}, {rest.data(), 0, nullptr, nullptr, rest.data()}, *matrix);
  EXPECT_GT(distance_from_inverse(*preconditioner->getUnspecifiedPrecOp(), *w), 0.1);
  preconditioner->compute(w);
  EXPECT_LT(distance_from_inverse(*preconditioner->getUnspecifiedPrecOp(), *w), 1e-11);
}

TEST(OperatorPreconditionerTest, AListWithoutPreconditionerHasNone) {
  Teuchos::ParameterList list;
  list.set("Linear Solver Type", "Direct").set("Preconditioner Type", "None");
  EXPECT_TRUE(LinearSolverFactory(list).preconditioner().is_null());
}

}  // namespace
}  // namespace ixos
