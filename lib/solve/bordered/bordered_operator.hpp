/// A tangent with a border: nodal unknowns, and a few others.
#pragma once
#include <Tpetra_Operator.hpp>
#include <vector>

#include "base/tpetra.hpp"
#include "discretization/dof_space.hpp"
#include "term/border.hpp"

namespace ixos {

/// | K       columns | on vectors of DofSpace::unknown_map(); K has the owned map, so that no solver or preconditioner
/// | rows^T  block   | of it sees the border. The space must outlive it.
class BorderedOperator final : public Operator {
 public:
  BorderedOperator(Teuchos::RCP<Operator> nodal, const DofSpace& space);

  const Teuchos::RCP<Operator>& nodal() const { return nodal_; }
  std::size_t size() const { return space_.globals().free.size(); }
  /// Takes the border: its columns are valid in owned rows, rows and block are shares of ranks. Collective.
  void set_border(Border& border);

  /// Returns whether some column has an entry that is not 0. Equal on all ranks.
  bool has_columns() const { return has_columns_; }
  /// Returns the columns, and one more, which is room for a solver's right-hand side.
  const Teuchos::RCP<MultiVector>& columns() const { return columns_; }
  /// Returns rows^T x, row by row, of vectors whose first entries are the nodes'. Collective.
  std::vector<double> rows_times(const MultiVector& x) const;
  const std::vector<double>& block() const { return block_; }  ///< row by row
  /// Return the globals of a vector of the unknown map, on all ranks (collective), and set them there.
  std::vector<double> globals_of(const Vector& x) const;
  void set_globals(const std::vector<double>& values, Vector& x) const;

  Teuchos::RCP<const Map> getDomainMap() const override { return space_.unknown_map(); }
  Teuchos::RCP<const Map> getRangeMap() const override { return space_.unknown_map(); }
  void apply(const MultiVector& x, MultiVector& y, Teuchos::ETransp mode = Teuchos::NO_TRANS, double alpha = 1,
             double beta = 0) const override;

 private:
  Teuchos::RCP<Operator> nodal_;
  const DofSpace& space_;
  Teuchos::RCP<MultiVector> columns_;
  bool has_columns_ = false;
  std::vector<std::vector<double>> rows_;  ///< local
  std::vector<double> block_;
  mutable std::vector<double> x_;  ///< scratch, local
};

}  // namespace ixos
