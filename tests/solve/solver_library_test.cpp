#include "solve/solver_library.hpp"

#include <gtest/gtest.h>

#include <Tpetra_Vector.hpp>

#include "solve/direct/factorization.hpp"
#include "support/scene_text.hpp"
#include "support/tridiagonal.hpp"

namespace ixos {
namespace {

TEST(SolverLibraryTest, StratimikosMakesWhatTheListNames) {
  Teuchos::ParameterList list;
  list.set("Linear Solver Type", "Belos").set("Preconditioner Type", "Chebyshev");
  const auto builder = solver_library().stratimikos(list);
  EXPECT_TRUE(nonnull(builder->solver()));
  EXPECT_TRUE(nonnull(builder->preconditioner()));
  list.set("Preconditioner Type", "Prayer");
  EXPECT_ANY_THROW(solver_library().stratimikos(list)->preconditioner());
}

TEST(SolverLibraryTest, MumpsSolvesOnAnyNumberOfRanks) {
  const auto a = test::tridiagonal(40, 2.5, 0, test::world());
  for (const bool single : {false, true}) {
    const auto mumps = solver_library().mumps(single);
    mumps->analyze(a);
    mumps->factor();
    Vector b(a->getRowMap()), x(a->getRowMap()), r(a->getRowMap());
    b.randomize();
    mumps->solve(b, x);
    a->apply(x, r);
    r.update(1.0, b, -1.0);
    EXPECT_LT(r.norm2() / b.norm2(), single ? 1e-5 : 1e-13);
  }
}

}  // namespace
}  // namespace ixos
