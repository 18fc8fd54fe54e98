/// A sparse factorisation as a preconditioner.
#pragma once
#include <Thyra_PreconditionerFactoryBase.hpp>
#include <string>

namespace ixos {

/// Makes the inverse of the matrix itself the preconditioner. With LaggedSolverFactory a factorisation so outlives
/// Newton steps and time steps: a Krylov iteration costs a product and a triangular solve, a small part of a new
/// factorisation. The symbolic part is kept as long as the matrix is the same object. A matrix that cannot be factored
/// throws std::runtime_error.
class DirectPreconditionerFactory final : public Thyra::PreconditionerFactoryBase<double> {
  using Source = Thyra::LinearOpSourceBase<double>;
  using Preconditioner = Thyra::PreconditionerBase<double>;
  using List = Teuchos::RCP<Teuchos::ParameterList>;

 public:
  bool isCompatible(const Source& source) const override;
  Teuchos::RCP<Preconditioner> createPrec() const override;
  void initializePrec(const Teuchos::RCP<const Source>& source, Preconditioner* preconditioner,
                      Thyra::ESupportSolveUse use) const override;
  void uninitializePrec(Preconditioner* preconditioner, Teuchos::RCP<const Source>* source,
                        Thyra::ESupportSolveUse* use) const override;

  void setParameterList(const List& list) override;
  List getNonconstParameterList() override { return list_; }
  List unsetParameterList() override { return std::exchange(list_, Teuchos::null); }
  Teuchos::RCP<const Teuchos::ParameterList> getParameterList() const override { return list_; }
  Teuchos::RCP<const Teuchos::ParameterList> getValidParameters() const override;

 private:
  List list_;
};

}  // namespace ixos
