#include "solve/linear_solver.hpp"

#include <Stratimikos_DefaultLinearSolverBuilder.hpp>
#include <Teuchos_AbstractFactoryStd.hpp>
#include <Thyra_Ifpack2PreconditionerFactory.hpp>
#include <Thyra_LinearOpWithSolveFactoryHelpers.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include "base/error.hpp"
#include "solve/direct_solver.hpp"
#include "solve/thyra.hpp"

namespace ixos {

using ThyraFactory = Thyra::LinearOpWithSolveFactoryBase<double>;

struct LinearSolverFactory::Implementation {
  Stratimikos::DefaultLinearSolverBuilder builder;
  Teuchos::RCP<const ThyraFactory> factory;
};

LinearSolverFactory::LinearSolverFactory(const Teuchos::ParameterList& stratimikos)
    : implementation_(std::make_unique<Implementation>()) {
  Stratimikos::DefaultLinearSolverBuilder& builder = implementation_->builder;
  builder.setLinearSolveStrategyFactory(Teuchos::abstractFactoryStd<ThyraFactory, DirectSolverFactory>(), "Direct");
  builder.setPreconditioningStrategyFactory(
      Teuchos::abstractFactoryStd<Thyra::PreconditionerFactoryBase<double>,
                                  Thyra::Ifpack2PreconditionerFactory<CrsMatrix>>(),
      "Ifpack2");
  try {
    builder.setParameterList(Teuchos::rcp(new Teuchos::ParameterList(stratimikos)));
    const Teuchos::RCP<ThyraFactory> factory = builder.createLinearSolveStrategy("");
    factory->setVerbLevel(Teuchos::VERB_NONE);
    implementation_->factory = factory;
  } catch (const std::exception& error) {
    throw InputError(std::string("Linear Solver: Stratimikos refuses the list: ") + error.what());
  }
}

LinearSolverFactory::~LinearSolverFactory() = default;

const Teuchos::RCP<const ThyraFactory>& LinearSolverFactory::thyra() const { return implementation_->factory; }

struct LinearSystem::Implementation {
  Teuchos::RCP<const ThyraFactory> factory;
  VectorSpace space;
  Teuchos::RCP<const Thyra::LinearOpBase<double>> op;
  Teuchos::RCP<Thyra::LinearOpWithSolveBase<double>> solver;
  bool fresh = false;
};

LinearSystem::LinearSystem(const LinearSolverFactory& factory, const Teuchos::RCP<const CrsMatrix>& matrix)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->factory = factory.thyra();
  implementation_->space = vector_space(matrix->getRowMap());
  const Teuchos::RCP<const Operator> as_operator = matrix;
  implementation_->op = Thyra::createConstLinearOp<double, LocalId, GlobalId, Node>(as_operator, implementation_->space,
                                                                                    implementation_->space);
}

LinearSystem::~LinearSystem() = default;

void LinearSystem::refresh() { implementation_->fresh = false; }

bool LinearSystem::solve(const Vector& b, Vector& x) {
  Implementation& self = *implementation_;
  if (self.solver.is_null()) self.solver = self.factory->createOp();
  if (!self.fresh) Thyra::initializeOp<double>(*self.factory, self.op, self.solver.ptr());
  self.fresh = true;
  const auto rhs = Thyra::createConstVector<double, LocalId, GlobalId, Node>(Teuchos::rcpFromRef(b), self.space);
  const auto solution = Thyra::createVector<double, LocalId, GlobalId, Node>(Teuchos::rcpFromRef(x), self.space);
  Thyra::assign(solution.ptr(), 0.0);
  const Thyra::SolveCriteria<double> criteria(
      Thyra::SolveMeasureType(Thyra::SOLVE_MEASURE_NORM_RESIDUAL, Thyra::SOLVE_MEASURE_NORM_RHS), 1e-14);
  const auto status =
      Thyra::solve<double>(*self.solver, Thyra::NOTRANS, *rhs, solution.ptr(), Teuchos::constPtr(criteria));
  return status.solveStatus == Thyra::SOLVE_STATUS_CONVERGED;
}

}  // namespace ixos
