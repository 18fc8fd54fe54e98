#include "solve/newton/descent_direction.hpp"

#include <NOX_Abstract_Group.H>
#include <NOX_Solver_Generic.H>

#include <exception>
#include <new>

#include "base/error.hpp"
#include "solve/newton/nox_vector.hpp"

namespace ixos {
namespace {

constexpr int highest_level = 8;

/// Relaxes a problem's tangent for as long as it lives.
class Relaxed {
 public:
  Relaxed(NonlinearProblem& problem, int level) : problem_(problem) { problem_.relax_tangent(level); }
  ~Relaxed() { problem_.relax_tangent(0); }
  Relaxed(const Relaxed&) = delete;
  Relaxed& operator=(const Relaxed&) = delete;

 private:
  NonlinearProblem& problem_;
};

/// Returns whether the exception in flight says that a linear system could not be solved. A checkpoint that does not
/// fit, a file that cannot be read and a lack of memory are no such failures, nor is an exception of unknown type.
bool is_failed_solve() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return false;
  } catch (const InputError&) {
    return false;
  } catch (const FileError&) {
    return false;
  } catch (const std::exception&) {
    return true;
  } catch (const char*) {  // NOX throws its own errors as plain text
    return true;
  } catch (...) {
    return false;
  }
}

}  // namespace

bool DescentDirection::compute(NOX::Abstract::Vector& direction, NOX::Abstract::Group& group,
                               const NOX::Solver::Generic& solver) {
  if (tolerance_ > 0)
    list_->sublist("Newton")
        .sublist("Linear Solver")
        .set("Tolerance",
             forcing_(solver.getNumIterations(), group.getNormF(), problem_.convergence_bound(tolerance_)));
  for (int level = 0; level <= highest_level; ++level) {
    const Relaxed relaxed(problem_, level);
    if (level > 0) group.setX(group.getX());  // forgets the matrix
    // NOX would evaluate these inside compute(). An exception of the problem is no failure of the linear solver.
    group.computeF();
    group.computeJacobian();
    try {
      if (!newton_.compute(direction, group, solver)) continue;
    } catch (...) {
      if (level == highest_level || !is_failed_solve()) throw;
      continue;
    }
    const auto along = tpetra(direction);
    problem_.complete_direction(*tpetra(group.getX()), *along);
    if (!problem_.is_gradient() || inner_product(*tpetra(group.getF()), *along) < 0) return true;
  }
  return false;
}

}  // namespace ixos
