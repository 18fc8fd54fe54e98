// A rectangular matrix and, in the place of its inverse, its transpose: sizes and arguments cannot be confused.
#include "solve/tpetra_preconditioner.hpp"

#include <gtest/gtest.h>

#include <Thyra_MultiVectorStdOps.hpp>
#include <Thyra_VectorSpaceBase.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <typeinfo>

#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::world;
using Columns = Teuchos::RCP<Thyra::MultiVectorBase<double>>;

constexpr int rows = 5, columns = 3;

/// Entries 10 row + column.
struct Rectangle {
  Teuchos::RCP<const Map> row_map = Teuchos::rcp(new Map(rows, 0, world()));
  Teuchos::RCP<const Map> column_map = Teuchos::rcp(new Map(columns, 0, world()));
  Teuchos::RCP<const CrsMatrix> matrix = [this] {
    const auto result = Teuchos::rcp(new CrsMatrix(row_map, columns));
    for (GlobalId row = 0; row < rows; ++row)
      for (GlobalId column = 0; column < columns && row_map->isNodeGlobalElement(row); ++column)
        result->insertGlobalValues(row, Teuchos::tuple<GlobalId>(column),
                                   Teuchos::tuple<double>(static_cast<double>(10 * row + column)));
    result->fillComplete(column_map, row_map);
    return result;
  }();
  Teuchos::RCP<const Thyra::LinearOpBase<double>> op = Thyra::createConstLinearOp<double, LocalId, GlobalId, Node>(
      matrix, vector_space(row_map), vector_space(column_map));
};

class Transpose : public TpetraPreconditioner {
 public:
  void set(const Rectangle& rectangle) {
    op_ = rectangle.op;
    matrix_ = rectangle.matrix;
  }
  void transfer(Record&) override {}

 private:
  void precondition(const MultiVector& x, MultiVector& y, double alpha, double beta) const override {
    matrix_->apply(x, y, Teuchos::TRANS, alpha, beta);
  }
  Teuchos::RCP<const CrsMatrix> matrix_;
};
class Other final : public Transpose {};

/// Returns two columns of a space; value(id, column) fills them.
template <class Value>
Columns make(const VectorSpace& space, const Value& value) {
  const Columns result = Thyra::createMembers(space, 2);
  const auto tpetra = Extract::getTpetraMultiVector(result);
  const auto view = tpetra->getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t i = 0; i < view.extent(0); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      view(i, k) = value(static_cast<double>(tpetra->getMap()->getGlobalElement(static_cast<LocalId>(i))),
                         static_cast<double>(k));
  return result;
}

TEST(TpetraPreconditionerTest, SpacesAreThoseOfAnInverse) {
  const Rectangle rectangle;
  Transpose inverse;
  inverse.set(rectangle);
  EXPECT_EQ(inverse.domain()->dim(), rows);
  EXPECT_EQ(inverse.range()->dim(), columns);
  EXPECT_TRUE(inverse.domain()->isCompatible(*rectangle.op->range()));
  EXPECT_TRUE(inverse.range()->isCompatible(*rectangle.op->domain()));
}

// The sum of (10 i + c) (i + 1) over the rows i is 400 + 15 c. All numbers are whole.
TEST(TpetraPreconditionerTest, AppliesWithBothFactorsToEachColumn) {
  const Rectangle rectangle;
  Transpose inverse;
  inverse.set(rectangle);
  const Columns x = make(inverse.domain(), [](double id, double k) { return (1 - 2 * k) * (id + 1); });
  for (const auto& [alpha, beta] :
       {std::pair{1.0, 0.0}, std::pair{2.0, 0.0}, std::pair{1.0, 1.0}, std::pair{2.0, -3.0}}) {
    const Columns y = make(inverse.range(), [](double id, double k) { return 7 * id - k; });
    Thyra::apply<double>(inverse, Thyra::NOTRANS, *x, y.ptr(), alpha, beta);
    const auto found = Extract::getTpetraMultiVector(y);
    const auto view = found->getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t i = 0; i < view.extent(0); ++i)
      for (std::size_t k = 0; k < 2; ++k) {
        const auto id = static_cast<double>(found->getMap()->getGlobalElement(static_cast<LocalId>(i)));
        const auto column = static_cast<double>(k);
        EXPECT_EQ(view(i, k), alpha * (1 - 2 * column) * (400 + 15 * id) + beta * (7 * id - column)) << id << ' ' << k;
      }
  }
}

TEST(TpetraPreconditionerTest, HasNoTranspose) {
  const Rectangle rectangle;
  Transpose inverse;
  inverse.set(rectangle);
  EXPECT_TRUE(Thyra::opSupported<double>(inverse, Thyra::NOTRANS));
  EXPECT_FALSE(Thyra::opSupported<double>(inverse, Thyra::TRANS));
  EXPECT_FALSE(Thyra::opSupported<double>(inverse, Thyra::CONJTRANS));
}

TEST(TpetraPreconditionerTest, AWrapperHoldsOnePreconditioner) {
  const auto wrapped = wrapped_preconditioner<Transpose>();
  Transpose& inverse = unwrapped<Transpose>(*wrapped);
  EXPECT_EQ(&unwrapped<Transpose>(*wrapped), &inverse);
  EXPECT_EQ(wrapped->getUnspecifiedPrecOp().get(), static_cast<const Thyra::LinearOpBase<double>*>(&inverse));
  EXPECT_TRUE(wrapped->getLeftPrecOp().is_null());
  EXPECT_TRUE(wrapped->getRightPrecOp().is_null());
  EXPECT_THROW(unwrapped<Other>(*wrapped), std::bad_cast);
  EXPECT_NE(&unwrapped<Transpose>(*wrapped_preconditioner<Transpose>()), &inverse);
}

}  // namespace
}  // namespace ixos
