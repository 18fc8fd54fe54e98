#include "solve/choice/linear_solver.hpp"

#include <Thyra_LinearOpWithSolveFactoryHelpers.hpp>
#include <Thyra_VectorStdOps.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include "base/error.hpp"
#include "parameters/parameter_entries.hpp"
#include "solve/choice/linear_solver_defaults.hpp"
#include "solve/direct/direct_solver.hpp"
#include "solve/direct/klu2_repair.hpp"
#include "solve/iterative/lagged_solver.hpp"
#include "solve/iterative/rigid_body_modes.hpp"
#include "solve/operator_preconditioner.hpp"
#include "solve/solver_library.hpp"
#include "solve/thyra.hpp"

namespace ixos {

using ThyraFactory = Thyra::LinearOpWithSolveFactoryBase<double>;

namespace {

/// Makes the direct solver, whose list is given.
class DirectBuilder final : public SolverBuilder {
 public:
  explicit DirectBuilder(const Teuchos::ParameterList& list) : list_(list) {}
  Teuchos::RCP<ThyraFactory> solver() const override {
    const auto factory = Teuchos::rcp(new DirectSolverFactory);
    factory->setParameterList(Teuchos::rcp(new Teuchos::ParameterList(list_)));
    return factory;
  }
  Teuchos::RCP<PreconditionerFactory> preconditioner() const override { return Teuchos::null; }

 private:
  Teuchos::ParameterList list_;
};

/// Returns whether the list asks for a factorisation and nothing else: there is nothing that Stratimikos could refuse.
bool is_direct_only(const Teuchos::ParameterList& list) {
  for (const auto& [name, entry] : entries(list)) {
    const bool text = entry.isType<std::string>();
    const bool type = name == "Linear Solver Type" && text && Teuchos::getValue<std::string>(entry) == "Direct";
    const bool none = name == "Preconditioner Type" && text && Teuchos::getValue<std::string>(entry) == "None";
    const bool types = name == "Linear Solver Types" && entry.isList() && list.sublist(name).numParams() == 1 &&
                       list.sublist(name).isSublist("Direct");
    if (!type && !none && !types) return false;
  }
  return list.isSublist("Linear Solver Types") && list.isParameter("Linear Solver Type");
}

std::unique_ptr<SolverBuilder> make_builder(const Teuchos::ParameterList& list) {
  if (!is_direct_only(list)) return solver_library().stratimikos(list);
  const Teuchos::ParameterList& direct = list.sublist("Linear Solver Types").sublist("Direct");
  const bool mumps = direct.isType<std::string>("Solver Type") && direct.get<std::string>("Solver Type") == "MUMPS";
  if (mumps) solver_library();  // a missing library is reported now
  return std::make_unique<DirectBuilder>(direct);
}

/// Removes Ixos' list "Reuse" and returns its one entry.
double take_setup_cost(Teuchos::ParameterList& list) {
  if (!list.isSublist("Reuse")) return 0;
  const Teuchos::ParameterList reuse = list.sublist("Reuse");
  list.remove("Reuse");
  double cost = 20;
  for (const auto& [name, entry] : entries(reuse)) {
    if (name != "Setup Cost")
      throw InputError("Linear Solver/Reuse: there is no parameter \"" + name + "\" here; allowed: \"Setup Cost\"");
    const bool whole = entry.isType<int>();
    cost = whole ? Teuchos::getValue<int>(entry) : entry.isType<double>() ? Teuchos::getValue<double>(entry) : -1;
    if (!(cost >= 0)) throw InputError("Linear Solver/Reuse/Setup Cost: it must be a number of at least 0");
  }
  return cost;
}

/// Returns the largest number of iterations of CG; 0 if the list asks for another method, or for more of CG and of
/// Belos than that number.
int cg_iterations(const Teuchos::ParameterList& list) {
  const auto is = [](const Teuchos::ParameterList& l, const char* name, const std::string& value) {
    return l.isType<std::string>(name) && l.get<std::string>(name) == value;
  };
  const std::string cg = "Pseudo Block CG";
  Teuchos::ParameterList copy(list);  // asking it for a list that is not there adds one
  const Teuchos::ParameterList& belos = copy.sublist("Linear Solver Types").sublist("Belos");
  if (!is(list, "Linear Solver Type", "Belos") || !is(belos, "Solver Type", cg)) return 0;
  for (const auto& [name, entry] : entries(belos))
    if (name != "Solver Type" && name != "Solver Types" && name != "VerboseObject") return 0;
  const Teuchos::ParameterList settings =
      copy.sublist("Linear Solver Types").sublist("Belos").sublist("Solver Types").sublist(cg);
  for (const auto& [name, entry] : entries(settings))
    if (name != "Maximum Iterations" && !(name == "Verbosity" && entry.isType<int>() && settings.get<int>(name) == 0))
      return 0;
  return settings.isType<int>("Maximum Iterations") ? settings.get<int>("Maximum Iterations") : 0;
}

/// Returns whether the list asks for a kind of CG of Belos. Its other solvers have other names: "BiCGStab" is none.
bool is_cg(const Teuchos::ParameterList& list) {
  Teuchos::ParameterList copy(list);
  const Teuchos::ParameterList& belos = copy.sublist("Linear Solver Types").sublist("Belos");
  const std::string type = belos.isType<std::string>("Solver Type") ? belos.get<std::string>("Solver Type") : "";
  return type.size() >= 2 && type.compare(type.size() - 2, 2, "CG") == 0;
}

}  // namespace

struct LinearSolverFactory::Implementation : std::enable_shared_from_this<Implementation> {
  Teuchos::RCP<const ThyraFactory> strategy() const {
    const Teuchos::RCP<ThyraFactory> krylov = keeping_this(krylov_builder->solver());
    krylov->setVerbLevel(Teuchos::VERB_NONE);
    if (!preconditioned) return krylov;
    return Teuchos::rcp(new LaggedSolverFactory(krylov, preconditioner_factory(), lagged, statistics));
  }
  Teuchos::RCP<PreconditionerFactory> preconditioner_factory() const {
    return keeping_this(preconditioner_builder->preconditioner());
  }

  // The builders' factories refer to them, so each of these factories keeps this alive.
  template <class Factory>
  Teuchos::RCP<Factory> keeping_this(Teuchos::RCP<Factory> factory) const {
    Teuchos::set_extra_data(shared_from_this(), "builders", Teuchos::inOutArg(factory));
    return factory;
  }
  std::unique_ptr<SolverBuilder> krylov_builder, preconditioner_builder;
  bool preconditioned = false;
  bool matrix_free = false;
  LaggedOptions lagged;
  std::shared_ptr<LinearStatistics> statistics = std::make_shared<LinearStatistics>();
};

LinearSolverFactory::LinearSolverFactory(const Teuchos::ParameterList& user, const Model* model, bool restartable)
    : implementation_(std::make_shared<Implementation>()) {
  Implementation& self = *implementation_;
  anchor_klu2_repair();  // MueLu's coarsest level is solved with KLU2
  Teuchos::ParameterList list(user);
  self.lagged.setup_cost = take_setup_cost(list);
  self.matrix_free = list.get("Operator", "Assembled") == std::string("Matrix-Free");
  list.remove("Operator");
  const auto preconditioner = list.get("Preconditioner Type", std::string("None"));
  self.preconditioned = preconditioner != "None";
  self.lagged.from_scratch = preconditioner == "MueLu";
  self.lagged.factorizes = preconditioner == "Direct";
  self.lagged.of_matrix = !preconditions_without_matrix(preconditioner);
  self.lagged.restartable = restartable;
  self.lagged.is_cg = is_cg(list);
  self.lagged.cg_iterations = cg_iterations(list);
  // The polynomial is cheap, and meant to need no sums over ranks.
  self.lagged.spares_last = self.lagged.cg_iterations > 0 && preconditioner != "Chebyshev";
  if (model != nullptr && preconditioner == "MueLu") {
    Teuchos::ParameterList& muelu = list.sublist("Preconditioner Types").sublist("MueLu");
    muelu.set("Nullspace", rigid_body_modes(*model));
    muelu.set("Coordinates", node_coordinates(*model));
  }
  try {
    Teuchos::ParameterList plain(list);
    plain.set("Preconditioner Type", "None");
    self.krylov_builder = make_builder(plain);
    if (self.preconditioned) self.preconditioner_builder = make_builder(list);
    self.strategy();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const FileError&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(std::string("Linear Solver: Stratimikos refuses the list: ") + last_paragraph(error.what()));
  }
}

LinearSolverFactory::~LinearSolverFactory() = default;

Teuchos::RCP<const ThyraFactory> LinearSolverFactory::strategy() const { return implementation_->strategy(); }

Teuchos::RCP<OperatorPreconditioner> LinearSolverFactory::preconditioner() const {
  const Implementation& self = *implementation_;
  if (!self.preconditioned) return Teuchos::null;
  return Teuchos::rcp(new OperatorPreconditioner(self.preconditioner_factory(), self.lagged.of_matrix));
}

bool LinearSolverFactory::matrix_free() const { return implementation_->matrix_free; }

const LinearStatistics& LinearSolverFactory::statistics() const { return *implementation_->statistics; }

struct LinearSystem::Implementation {
  bool solve(const Vector& b, Vector& x) {
    if (solver.is_null()) solver = factory->createOp();
    if (!fresh) Thyra::initializeOp<double>(*factory, op, solver.ptr());
    fresh = true;
    const auto rhs = Thyra::createConstVector<double, LocalId, GlobalId, Node>(Teuchos::rcpFromRef(b), space);
    const auto solution = Thyra::createVector<double, LocalId, GlobalId, Node>(Teuchos::rcpFromRef(x), space);
    Thyra::assign(solution.ptr(), 0.0);
    const Thyra::SolveCriteria<double> criteria(
        Thyra::SolveMeasureType(Thyra::SOLVE_MEASURE_NORM_RESIDUAL, Thyra::SOLVE_MEASURE_NORM_RHS), 1e-12);
    const auto status =
        Thyra::solve<double>(*solver, Thyra::NOTRANS, *rhs, solution.ptr(), Teuchos::constPtr(criteria));
    return status.solveStatus == Thyra::SOLVE_STATUS_CONVERGED;
  }

  Teuchos::RCP<const ThyraFactory> factory;
  VectorSpace space;
  Teuchos::RCP<const Thyra::LinearOpBase<double>> op;
  Teuchos::RCP<Thyra::LinearOpWithSolveBase<double>> solver;
  bool fresh = false;
};

LinearSystem::LinearSystem(const LinearSolverFactory& factory, const Teuchos::RCP<const Operator>& op)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->factory = factory.strategy();
  implementation_->space = vector_space(op->getRangeMap());
  implementation_->op = const_linear_op(op, implementation_->space);
}

LinearSystem::~LinearSystem() = default;

void LinearSystem::refresh() { implementation_->fresh = false; }

bool LinearSystem::solve(const Vector& b, Vector& x) {
  try {
    return implementation_->solve(b, x);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const FileError&) {
    throw;
  } catch (const std::exception&) {
    return false;  // a singular matrix, or an iteration that broke down
  }
}

}  // namespace ixos
