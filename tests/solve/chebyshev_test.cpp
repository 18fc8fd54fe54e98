// Chebyshev's polynomial as a preconditioner, on a matrix whose spectrum is known.
#include "solve/iterative/chebyshev_preconditioner.hpp"

#include <gtest/gtest.h>

#include <Thyra_DefaultLinearOpSource.hpp>
#include <Thyra_PreconditionerFactoryHelpers.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <cmath>

#include "solve/thyra.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;

constexpr int n = 100;

/// Rows (-1, diagonal, -1): its eigenvectors are sin(j pi i/(n + 1)), i = 1 to n, and its eigenvalues over its diagonal
/// 1 - 2/diagonal cos(j pi/(n + 1)).
Teuchos::RCP<CrsMatrix> tridiagonal(double diagonal) {
  const auto map = Teuchos::rcp(new Map(n, 0, world()));
  const auto matrix = Teuchos::rcp(new CrsMatrix(map, 3));
  for (std::size_t i = 0; i < map->getMyGlobalIndices().extent(0); ++i) {
    const GlobalId row = map->getGlobalElement(static_cast<LocalId>(i));
    for (GlobalId column : {row - 1, row, row + 1})
      if (column >= 0 && column < n) {
        const double value = column == row ? diagonal : -1;
        matrix->insertGlobalValues(row, 1, &value, &column);
      }
  }
  matrix->fillComplete();
  return matrix;
}

double eigenvalue(double diagonal, int j) { return 1 - 2 / diagonal * std::cos(j * M_PI / (n + 1)); }

Vector eigenvector(const Teuchos::RCP<const Map>& map, int j) {
  Vector v(map);
  const auto view = v.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t i = 0; i < view.extent(0); ++i)
    view(i, 0) = std::sin(j * M_PI / (n + 1) * static_cast<double>(map->getGlobalElement(static_cast<LocalId>(i)) + 1));
  return v;
}

class ChebyshevTest : public testing::Test {
 protected:
  void prepare(double diagonal, int degree, double ratio) {
    diagonal_ = diagonal;
    matrix_ = tridiagonal(diagonal);
    const auto list = Teuchos::rcp(new Teuchos::ParameterList);
    list->set("Degree", degree).set("Eigenvalue Ratio", ratio);
    factory_.setParameterList(list);
    const auto space = vector_space(matrix_->getRowMap());
    preconditioner_ = factory_.createPrec();
    factory_.initializePrec(Thyra::defaultLinearOpSource(const_linear_op(matrix_, space)), preconditioner_.get(),
                            Thyra::SUPPORT_SOLVE_UNSPECIFIED);
  }
  /// p(x) for the eigenvalue x.
  double polynomial(int j) {
    const Vector v = eigenvector(matrix_->getRowMap(), j);
    Vector y(matrix_->getRowMap());
    const auto x = Teuchos::rcp(new Vector(v, Teuchos::Copy)), result = Teuchos::rcp(new Vector(matrix_->getRowMap()));
    const auto space = vector_space(matrix_->getRowMap());
    Thyra::apply(*preconditioner_->getUnspecifiedPrecOp(), Thyra::NOTRANS,
                 *Thyra::createConstVector<double, LocalId, GlobalId, Node>(x, space),
                 Thyra::createVector<double, LocalId, GlobalId, Node>(result, space).ptr());
    const double value = result->dot(v) / v.dot(v);
    result->update(-value, v, 1.0);
    EXPECT_LT(result->norm2(), 1e-12 * std::abs(value) * v.norm2()) << "an eigenvector stays one";
    return diagonal_ * value;
  }

  double diagonal_ = 2;
  Teuchos::RCP<CrsMatrix> matrix_;
  ChebyshevPreconditionerFactory factory_;
  Teuchos::RCP<Thyra::PreconditionerBase<double>> preconditioner_;
};

TEST_F(ChebyshevTest, ItIsTheBestPolynomialOfItsDegree) {
  // On [a, b] the best polynomial p has max |1 - x p(x)| = 1/T_k((b + a)/(b - a)), and takes that value with
  // alternating signs (Saad 2003, theorem 6.25). b is a bound that exceeds the largest eigenvalue, 2, by a little.
  const double ratio = 20;
  for (int degree : {1, 2, 3, 6}) {
    prepare(2, degree, ratio);
    const double least = 1 / std::cosh(degree * std::acosh((ratio + 1) / (ratio - 1)));
    double largest = 0;
    for (int j = 1; j <= n; ++j) {
      const double x = eigenvalue(2, j), p = polynomial(j);
      EXPECT_GT(p, 0) << degree << ", " << j;
      if (x > 2.1 / ratio) largest = std::max(largest, std::abs(1 - x * p));
    }
    EXPECT_LT(largest, least * (1 + 1e-12)) << degree;
    EXPECT_GT(largest, 0.97 * least) << degree;
  }
}

TEST_F(ChebyshevTest, ItTakesInNoMoreThanTheSpectrum) {
  // Eigenvalues from 1/2 to 3/2: whatever ratio is allowed, three applications leave 1/T_3(2) = 1/26.
  prepare(4, 3, 1000.0);
  double largest = 0;
  for (int j = 1; j <= n; ++j) largest = std::max(largest, std::abs(1 - eigenvalue(4, j) * polynomial(j)));
  EXPECT_LT(largest, 1.5 / 26);
  EXPECT_GT(largest, 1.0 / 26);
}

}  // namespace
}  // namespace ixos
