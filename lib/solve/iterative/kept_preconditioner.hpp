/// A preconditioner that remembers the matrices that it came from.
#pragma once
#include <Thyra_PreconditionerFactoryBase.hpp>
#include <memory>
#include <vector>

#include "base/record.hpp"
#include "solve/iterative/lagged_solver.hpp"

namespace ixos {

/// A preconditioner that outlives its matrix, and what makes it again, to the last bit: the values of the matrices that
/// left traces in it. A renewed multigrid keeps prolongators of its first matrix. The matrix of a source must have the
/// same pattern each time.
class KeptPreconditioner {
  using Source = Teuchos::RCP<const Thyra::LinearOpSourceBase<double>>;

 public:
  /// Counts its set-ups in `statistics`, whose numbers tell those of one factory apart.
  KeptPreconditioner(Teuchos::RCP<Thyra::PreconditionerFactoryBase<double>> factory, const LaggedOptions& options,
                     std::shared_ptr<LinearStatistics> statistics)
      : factory_(std::move(factory)),
        options_(options),
        statistics_(std::move(statistics)),
        preconditioner_(factory_->createPrec()) {}

  const Teuchos::RCP<Thyra::PreconditionerBase<double>>& get() const { return preconditioner_; }

  /// Makes it from the matrix's present values. If that throws, it has to be renewed again.
  void renew(const Source& source);
  /// Takes a new object, without traces of earlier matrices. It has to be renewed.
  void start_over();
  /// Makes it as it was in the record, if it was loaded since the last call. `stale`: it will be renewed before its
  /// next use, so that only the traces of the first matrix count. Throws InputError if the record's matrices have
  /// another size.
  void rebuild(const Source& source, bool stale);

  /// Writes or reads the matrices. In memory, a preconditioner that has not changed since is left alone. Throws
  /// InputError if its state is to be kept in memory, but the options forbid that.
  void transfer(Record& record);

 private:
  bool transfer_setup(Record& record);
  void make(const Source& source);
  void note_matrix(const Source& source);
  void force() const;

  Teuchos::RCP<Thyra::PreconditionerFactoryBase<double>> factory_;
  LaggedOptions options_;
  std::shared_ptr<LinearStatistics> statistics_;
  Teuchos::RCP<Thyra::PreconditionerBase<double>> preconditioner_;
  bool loaded_ = false;                        ///< from a record: the preconditioner is yet to be made
  long setup_ = 0;                             ///< its number in the statistics; 0: none yet, -1: it failed
  int matrices_ = 0;                           ///< kept: none, the last one, or the first and the last one
  std::vector<double> first_matrix_, matrix_;  ///< values
};

}  // namespace ixos
