#include "solve/bordered/bordered_operator.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/dot.hpp"

namespace ixos {

BorderedOperator::BorderedOperator(Teuchos::RCP<Operator> nodal, const DofSpace& space)
    : nodal_(std::move(nodal)),
      space_(space),
      columns_(Teuchos::rcp(new MultiVector(space.owned_map(), size() + 1))),
      rows_(size()),
      block_(size() * size()),
      x_(static_cast<std::size_t>(space.local())) {}

void BorderedOperator::set_border(Border& border) {
  const auto owned = static_cast<std::size_t>(space_.owned());
  const auto nodes = static_cast<std::ptrdiff_t>(space_.first_global());
  std::vector<double> sums(border.block());
  sums.push_back(0);
  const auto view = columns_->getLocalViewHost(Tpetra::Access::ReadWrite);
  for (std::size_t k = 0; k < size(); ++k) {
    const std::vector<double>&column = border.columns()[k], &row = border.rows()[k];
    if (owned > 0) std::copy_n(column.begin(), owned, &view(0, k));
    sums.back() += dot(column, column, owned);
    rows_[k].assign(row.begin(), row.begin() + nodes);
  }
  space_.sum(sums.data(), static_cast<int>(sums.size()));
  block_.assign(sums.begin(), sums.end() - 1);
  has_columns_ = sums.back() != 0;
}

std::vector<double> BorderedOperator::rows_times(const MultiVector& x) const {
  const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  const std::size_t count = view.extent(1);
  std::vector<double> result(size() * count);
  for (std::size_t column = 0; column < count; ++column) {
    if (space_.owned() > 0) std::copy_n(&view(0, column), space_.owned(), x_.begin());
    space_.update_ghosts(x_.data());
    for (std::size_t k = 0; k < size(); ++k) result[k * count + column] = dot(rows_[k], x_, rows_[k].size());
  }
  space_.sum(result.data(), static_cast<int>(result.size()));
  return result;
}

std::vector<double> BorderedOperator::globals_of(const Vector& x) const {
  std::vector<double> values(size());
  const Comm& comm = space_.comm();
  if (comm->getRank() == 0) {
    const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    std::copy_n(view.data() + space_.owned(), size(), values.begin());
  }
  if (comm->getSize() > 1) Teuchos::broadcast(*comm, 0, static_cast<int>(size()), values.data());
  return values;
}

void BorderedOperator::set_globals(const std::vector<double>& values, Vector& x) const {
  if (space_.comm()->getRank() != 0) return;
  const auto view = x.getLocalViewHost(Tpetra::Access::ReadWrite);
  std::copy_n(values.begin(), size(), view.data() + space_.owned());
}

void BorderedOperator::apply(const MultiVector& x, MultiVector& y, Teuchos::ETransp mode, double alpha,
                             double beta) const {
  if (mode != Teuchos::NO_TRANS) throw std::logic_error("a bordered tangent has no transpose");
  for (std::size_t column = 0; column < x.getNumVectors(); ++column) {
    const Teuchos::RCP<const Vector> from = x.getVector(column);
    const Teuchos::RCP<Vector> to = y.getVectorNonConst(column);
    const auto nodes = from->offsetView(space_.owned_map(), 0);
    const std::vector<double> globals = globals_of(*from), before = globals_of(*to);
    std::vector<double> result = rows_times(*from);
    const auto product = to->offsetViewNonConst(space_.owned_map(), 0);
    nodal_->apply(*nodes, *product, mode, alpha, beta);
    for (std::size_t k = 0; k < size(); ++k) {
      product->update(alpha * globals[k], *columns_->getVector(k), 1.0);
      for (std::size_t l = 0; l < size(); ++l) result[k] += block_[k * size() + l] * globals[l];
      result[k] = alpha * result[k] + (beta == 0 ? 0 : beta * before[k]);
    }
    set_globals(result, *to);
  }
}

}  // namespace ixos
