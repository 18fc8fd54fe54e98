// The list of the factories that factorise: it chooses the factorisation of a matrix.
#include "solve/direct/factorization_list.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterListAcceptor.hpp>
#include <Teuchos_ParameterListExceptions.hpp>
#include <Tpetra_Vector.hpp>

#include "support/scene_text.hpp"
#include "support/tridiagonal.hpp"

namespace ixos {
namespace {

using test::tridiagonal;
using test::world;

/// Thyra's factories take lists by the same interface.
class Factory final : public WithFactorizationList<Teuchos::ParameterListAcceptor> {
 public:
  using WithFactorizationList<Teuchos::ParameterListAcceptor>::renew;

  void choose(const std::string& type) {
    const auto list = Teuchos::parameterList();
    list->set("Solver Type", type);
    setParameterList(list);
  }
};

double relative_residual(const KeptFactorization& kept, const CrsMatrix& a) {
  Vector b(a.getRowMap()), x(a.getRowMap()), r(a.getRowMap());
  b.randomize();
  kept.solve(b, x);
  a.apply(x, r);
  r.update(1.0, b, -1.0);
  return r.norm2() / b.norm2();
}

/// Expects a solution of single precision, which MUMPS Single alone gives.
void expect_single(const KeptFactorization& kept, const CrsMatrix& a) {
  const double residual = relative_residual(kept, a);
  EXPECT_LT(residual, 1e-5);
  EXPECT_GT(residual, 1e-9);
}

TEST(FactorizationListTest, ListsMayNameTheFactorizationsOfThisBuild) {
  Factory factory;
  EXPECT_EQ(factory.getValidParameters()->get<std::string>("Solver Type"), first_rank_factorization());
  for (const std::string& type : factorizations()) {
    EXPECT_NO_THROW(factory.choose(type)) << type;
    EXPECT_EQ(factory.getParameterList()->get<std::string>("Solver Type"), type);
  }
  EXPECT_THROW(factory.choose("Cramer"), Teuchos::Exceptions::InvalidParameter);
  factory.setParameterList(Teuchos::parameterList());
  EXPECT_EQ(factory.getParameterList()->get<std::string>("Solver Type"), first_rank_factorization());
}

TEST(FactorizationListTest, TheListChoosesTheFactorization) {
  const auto symmetric = tridiagonal(200, 2.5, 0, world()), skew = tridiagonal(200, 2.5, 0.4, world());
  Factory factory;
  KeptFactorization klu, mumps, single;
  factory.choose("KLU");
  factory.renew(skew, klu);
  EXPECT_LT(relative_residual(klu, *skew), 1e-13) << "the others take symmetric matrices only";
  factory.choose("MUMPS");
  factory.renew(symmetric, mumps);
  EXPECT_LT(relative_residual(mumps, *symmetric), 1e-13);
  factory.choose("MUMPS Single");
  factory.renew(symmetric, single);
  expect_single(single, *symmetric);
}

TEST(FactorizationListTest, WithoutAListTheFirstRankFactorizes) {
  const auto matrix = tridiagonal(200, 2.5, 0, world());
  Factory factory;
  KeptFactorization before, after;
  factory.renew(matrix, before);
  EXPECT_LT(relative_residual(before, *matrix), 1e-13);
  factory.choose("MUMPS Single");
  factory.unsetParameterList();
  factory.renew(matrix, after);
  EXPECT_LT(relative_residual(after, *matrix), 1e-13);
}

TEST(FactorizationListTest, AKeptFactorizationStaysWithItsMatrix) {
  const auto matrix = tridiagonal(200, 2.5, 0, world()), other = tridiagonal(200, 2.5, 0, world());
  Factory factory;
  KeptFactorization kept;
  factory.choose("MUMPS Single");
  factory.renew(matrix, kept);
  factory.choose("MUMPS");
  matrix->resumeFill();
  matrix->scale(2.0);
  matrix->fillComplete();
  factory.renew(matrix, kept);
  expect_single(kept, *matrix);
  factory.renew(other, kept);
  EXPECT_LT(relative_residual(kept, *other), 1e-13);
}

}  // namespace
}  // namespace ixos
