#include "solve/newton/newton.hpp"

#include <NOX.H>
#include <NOX_StatusTest_Generic.H>
#include <NOX_Thyra.H>
#include <fmt/format.h>
#include <Teuchos_oblackholestream.hpp>

#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <new>
#include <vector>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "parameters/parameter_entries.hpp"
#include "solve/bordered/bordered_solver.hpp"
#include "solve/kept_state.hpp"
#include "solve/newton/admissible_line_search.hpp"
#include "solve/newton/descent_direction.hpp"
#include "solve/newton/incremental_potential.hpp"
#include "solve/newton/problem_evaluator.hpp"

namespace ixos {
namespace {

/// The test that |f| is below the bound that the problem states at the current iterate.
class ForceTest final : public NOX::StatusTest::Generic {
 public:
  ForceTest(const NonlinearProblem& problem, const NewtonOptions& options)
      : problem_(problem), tolerance_(options.tolerance), watch_(options.watch) {}

  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic& solver, NOX::StatusTest::CheckType) override {
    norm_ = solver.getSolutionGroup().getNormF();
    bound_ = problem_.convergence_bound(tolerance_);
    status_ = norm_ <= bound_ ? NOX::StatusTest::Converged : NOX::StatusTest::Unconverged;
    if (watch_) watch_({solver.getNumIterations(), norm_, bound_});
    return status_;
  }
  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int indent) const override {
    for (int i = 0; i < indent; ++i) stream << ' ';
    return stream << status_ << "|f| = " << norm_ << " <= " << bound_ << '\n';
  }
  std::string describe() const { return fmt::format("|f| = {:.3g}, the tolerance requires {:.3g}", norm_, bound_); }

 private:
  const NonlinearProblem& problem_;
  double tolerance_;
  std::function<void(const NewtonIterate&)> watch_;
  double norm_ = 0;
  double bound_ = 0;
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
};

/// The test that the iterate is lost, see NonlinearProblem::is_lost().
class LostTest final : public NOX::StatusTest::Generic {
 public:
  explicit LostTest(const NonlinearProblem& problem) : problem_(problem) {}

  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic&, NOX::StatusTest::CheckType) override {
    status_ = problem_.is_lost() ? NOX::StatusTest::Failed : NOX::StatusTest::Unconverged;
    return status_;
  }
  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int indent) const override {
    for (int i = 0; i < indent; ++i) stream << ' ';
    return stream << status_ << "the iterate is within reach\n";
  }

 private:
  const NonlinearProblem& problem_;
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
};

/// NOX ignores lists that it does not know.
void check_names(const Teuchos::ParameterList& list) {
  const std::vector<std::string> known{"Nonlinear Solver", "Printing",     "Direction",   "Line Search",
                                       "Solver Options",   "Trust Region", "Status Tests"};
  for (const auto& [name, entry] : entries(list))
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw InputError("Nonlinear Solver/NOX: there is no \"" + name + "\" here; did you mean \"" +
                       closest_name(name, known) + "\"? Allowed: " + quoted_list(known));
}

Teuchos::RCP<Teuchos::ParameterList> nox_list(NonlinearProblem& problem, const NewtonOptions& options) {
  check_names(options.nox);
  auto list = Teuchos::rcp(new Teuchos::ParameterList(options.nox));
  list->get("Nonlinear Solver", "Line Search Based");
  Teuchos::ParameterList& printing = list->sublist("Printing");
  if (!printing.isParameter("Output Information")) {
    // A failure is a status here; NOX would also print it.
    const Teuchos::RCP<std::ostream> nowhere = Teuchos::rcp(new Teuchos::oblackholestream);
    printing.set("Output Information", 0).set("Output Stream", nowhere).set("Error Stream", nowhere);
  }
  Teuchos::ParameterList& direction = list->sublist("Direction");
  Teuchos::ParameterList& newton = direction.sublist("Newton");
  if (!direction.isParameter("Method")) {
    // If the user gives NOX an accuracy of the linear solves, that setting takes precedence.
    Teuchos::ParameterList& linear = newton.sublist("Linear Solver");
    const bool told = newton.isParameter("Forcing Term Method") || linear.isParameter("Tolerance");
    if (!told && options.linear_tolerance > 0) linear.set("Tolerance", options.linear_tolerance);
    const bool adaptive = !told && options.linear_tolerance == 0;
    direction.set("Method", "User Defined");
    const Teuchos::RCP<NOX::Direction::UserDefinedFactory> factory =
        Teuchos::rcp(new DescentDirectionFactory(problem, adaptive ? options.tolerance : 0));
    direction.set("User Defined Direction Factory", factory);
  }
  newton.get("Forcing Term Method", "Constant");
  newton.sublist("Linear Solver").get("Tolerance", 1e-6);
  Teuchos::ParameterList& options_list = list->sublist("Solver Options");
  options_list.get("Status Test Check Type", "Minimal");
  if (!options_list.isParameter("User Defined Merit Function")) {
    const Teuchos::RCP<NOX::MeritFunction::Generic> merit = Teuchos::rcp(new IncrementalPotential(problem));
    options_list.set("User Defined Merit Function", merit);
  }
  Teuchos::ParameterList& search = list->sublist("Line Search");
  if (!search.isParameter("Method")) {
    search.set("Method", "User Defined");
    const Teuchos::RCP<NOX::LineSearch::UserDefinedFactory> factory =
        Teuchos::rcp(new AdmissibleLineSearchFactory(problem, options.tolerance));
    search.set("User Defined Line Search Factory", factory);
  }
  return list;
}

}  // namespace

bool allows_mixed_steps(const NewtonOptions& options) {
  const auto is_own = [&](const char* list) {
    return !options.nox.isSublist(list) || !options.nox.sublist(list).isParameter("Method");
  };
  return options.mixed_steps && is_own("Direction") && is_own("Line Search");
}

struct NewtonSolver::Implementation {
  Implementation(NonlinearProblem& given, const LinearSolverFactory& linear_solver, const NewtonOptions& options)
      : problem(given),
        maximum_iterations(options.maximum_iterations),
        corrects(options.corrects),
        linear(linear_solver.strategy()),
        evaluator(Teuchos::rcp(new ProblemEvaluator(given, whole(given, linear)))),
        guess(Thyra::createMember(evaluator->get_x_space())),
        force(Teuchos::rcp(new ForceTest(given, options))),
        lost(Teuchos::rcp(new LostTest(given))),
        tests(Teuchos::rcp(new NOX::StatusTest::Combo(NOX::StatusTest::Combo::OR))),
        list(nox_list(given, options)) {
    tests->addStatusTest(Teuchos::rcp(new NOX::StatusTest::FiniteValue));
    tests->addStatusTest(force);
    tests->addStatusTest(lost);
    tests->addStatusTest(Teuchos::rcp(new NOX::StatusTest::MaxIters(options.maximum_iterations)));
  }

  /// Returns the solver of the whole system, given that of the nodes'.
  static ProblemEvaluator::Factory whole(const NonlinearProblem& problem, const ProblemEvaluator::Factory& nodal) {
    if (!problem.is_bordered()) return nodal;
    return Teuchos::rcp(new BorderedSolverFactory(nodal));
  }

  /// Reads NOX's list; evaluates nothing.
  void build() {
    const auto group = Teuchos::rcp(new NOX::Thyra::Group(NOX::Thyra::Vector(guess), evaluator));
    solver = NOX::Solver::buildSolver(group, tests, list);
  }

  NewtonResult run() {
    if (solver.is_null()) build();
    problem.begin_solve();
    solver->reset(NOX::Thyra::Vector(guess));
    const NOX::StatusTest::StatusType status = solver->solve();
    NewtonResult result;
    result.iterations = solver->getNumIterations();
    result.converged = status == NOX::StatusTest::Converged;
    if (result.converged) return result;
    const bool is_lost = lost->getStatus() == NOX::StatusTest::Failed;
    result.ran_out = !is_lost && result.iterations >= maximum_iterations;
    if (is_lost)
      result.reason =
          fmt::format("after {} iterations the body is farther away than any equilibrium can be", result.iterations);
    else if (result.ran_out)
      result.reason = fmt::format("Newton's iteration did not converge in {} iterations ({})", result.iterations,
                                  force->describe());
    else
      result.reason = fmt::format(
          "Newton's iteration broke down after {} iterations: at every step length tried an "
          "element inverts, a gap closes, a number overflows or the potential rises",
          result.iterations);
    return result;
  }

  /// Moves x, the solution, by a last solve with its residual, which is not evaluated again. A solve that fails leaves
  /// x as it is.
  void correct(Vector& x) const {
    const Teuchos::RCP<const KeptState> kept = keeper() == nullptr ? Teuchos::null : keeper()->latest();
    if (kept.is_null() || problem.is_bordered()) return;
    const auto& last = dynamic_cast<const NOX::Thyra::Vector&>(solver->getSolutionGroup().getF());
    const Teuchos::RCP<Thyra::VectorBase<double>> step = Thyra::createMember(evaluator->get_x_space());
    bool found = false;
    try {
      found = kept->correction(*last.getThyraRCPVector(), *step);
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception&) {  // the solution has converged without it
    }
    if (found) x.update(-1.0, *Extract::getTpetraVector(step), 1.0);
  }

  /// Returns the failure when the linear solver or NOX failed irrecoverably. The next solve starts from a new solver.
  NewtonResult broken(const std::string& what) {
    NewtonResult result;
    if (!solver.is_null()) result.iterations = solver->getNumIterations();
    solver = Teuchos::null;
    result.reason = fmt::format("the nonlinear solver stopped: {}", what);
    return result;
  }

  /// Returns the keeper of the linear solver's state; null if it keeps none.
  const StateKeeper* keeper() const { return dynamic_cast<const StateKeeper*>(linear.get()); }

  NonlinearProblem& problem;
  int maximum_iterations;
  bool corrects;
  ProblemEvaluator::Factory linear;
  Teuchos::RCP<ProblemEvaluator> evaluator;
  Teuchos::RCP<Thyra::VectorBase<double>> guess;
  Teuchos::RCP<ForceTest> force;
  Teuchos::RCP<LostTest> lost;
  Teuchos::RCP<NOX::StatusTest::Combo> tests;
  Teuchos::RCP<Teuchos::ParameterList> list;
  Teuchos::RCP<NOX::Solver::Generic> solver;
};

NewtonSolver::NewtonSolver(NonlinearProblem& problem, const LinearSolverFactory& linear_solver,
                           const NewtonOptions& options) {
  try {
    implementation_ = std::make_unique<Implementation>(problem, linear_solver, options);
    implementation_->build();
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError("Nonlinear Solver/NOX: NOX refuses the list: " + last_paragraph(error.what()));
  } catch (const char* error) {
    throw InputError(std::string("Nonlinear Solver/NOX: NOX refuses the list: ") + error);
  }
}

NewtonSolver::~NewtonSolver() = default;

void NewtonSolver::transfer(Record& record) {
  if (implementation_->solver.is_null()) implementation_->build();
  if (implementation_->keeper() != nullptr) implementation_->keeper()->latest()->transfer(record);
}

NewtonResult NewtonSolver::solve(Vector& x) {
  Implementation& self = *implementation_;
  NewtonResult result;
  if (self.keeper() != nullptr) self.keeper()->choose_family(self.problem.family());
  try {
    Extract::getTpetraVector(self.guess)->update(1.0, x, 0.0);
    result = self.run();
    const auto& solution = dynamic_cast<const NOX::Thyra::Vector&>(self.solver->getSolutionGroup().getX());
    x.update(1.0, *Extract::getConstTpetraVector(solution.getThyraRCPVector()), 0.0);
    if (self.corrects && result.converged && result.iterations > 0) self.correct(x);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const InputError&) {  // a checkpoint that does not fit
    throw;
  } catch (const FileError&) {
    throw;
  } catch (const std::exception& error) {
    result = self.broken(error.what());
  } catch (const char* error) {  // NOX throws its own errors as plain text
    result = self.broken(error);
  }
  return result;
}

}  // namespace ixos
