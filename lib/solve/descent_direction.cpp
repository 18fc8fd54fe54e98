#include "solve/descent_direction.hpp"

#include <NOX_Abstract_Group.H>
#include <NOX_Solver_Generic.H>

#include <new>

#include "solve/nox_vector.hpp"

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
    try {
      if (!newton_.compute(direction, group, solver)) continue;
    } catch (const std::bad_alloc&) {
      throw;
    } catch (...) {
      if (level == highest_level) throw;
      continue;
    }
    problem_.complete_direction(*tpetra(group.getX()), *tpetra(direction));
    if (!problem_.is_gradient() || group.getF().innerProduct(direction) < 0) return true;
  }
  return false;
}

}  // namespace ixos
