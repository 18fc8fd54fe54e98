#include "solve/loaded/stratimikos_builder.hpp"

#include <Stratimikos_DefaultLinearSolverBuilder.hpp>
#include <Teuchos_AbstractFactoryStd.hpp>
#include <Thyra_Ifpack2PreconditionerFactory.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include "solve/direct/direct_preconditioner.hpp"
#include "solve/direct/direct_solver.hpp"
#include "solve/iterative/chebyshev_preconditioner.hpp"
#include "solve/loaded/muelu_factory.hpp"
#include "solve/loaded/two_level_preconditioner.hpp"
#include "solve/operator_preconditioner.hpp"
#include "solve/thyra.hpp"

namespace ixos {
namespace {

using SolverFactory = Thyra::LinearOpWithSolveFactoryBase<double>;

/// How Teuchos::AbstractFactoryStd makes MueLu's factory.
struct MakeMueLu {
  using ptr_t = Teuchos::RCP<PreconditionerFactory>;
  ptr_t allocate() const { return make_muelu_factory(); }
};

class StratimikosBuilder final : public SolverBuilder {
 public:
  explicit StratimikosBuilder(const Teuchos::ParameterList& list) {
    builder_.setLinearSolveStrategyFactory(Teuchos::abstractFactoryStd<SolverFactory, DirectSolverFactory>(), "Direct");
    builder_.setPreconditioningStrategyFactory(
        Teuchos::abstractFactoryStd<PreconditionerFactory, PreconditionerFactory>(MakeMueLu()), "MueLu");
    add<Thyra::Ifpack2PreconditionerFactory<CrsMatrix>>("Ifpack2");
    add<DirectPreconditionerFactory>("Direct");
    add<ChebyshevPreconditionerFactory>("Chebyshev");
    add<TwoLevelPreconditionerFactory>("Two-Level");
    builder_.setParameterList(Teuchos::rcp(new Teuchos::ParameterList(list)));
  }

  Teuchos::RCP<SolverFactory> solver() const override { return builder_.createLinearSolveStrategy(""); }
  Teuchos::RCP<PreconditionerFactory> preconditioner() const override {
    return builder_.createPreconditioningStrategy("");
  }

 private:
  template <class Factory>
  void add(const char* name) {
    builder_.setPreconditioningStrategyFactory(Teuchos::abstractFactoryStd<PreconditionerFactory, Factory>(), name);
  }

  Stratimikos::DefaultLinearSolverBuilder builder_;
};

}  // namespace

std::unique_ptr<SolverBuilder> make_stratimikos_builder(const Teuchos::ParameterList& list) {
  return std::make_unique<StratimikosBuilder>(list);
}

}  // namespace ixos
