#include "solve/admissible_line_search.hpp"

#include <NOX_Abstract_Group.H>
#include <NOX_Solver_Generic.H>
#include <NOX_Thyra_Vector.H>

#include <cmath>

#include "solve/thyra.hpp"

namespace ixos {
namespace {

Teuchos::RCP<const Vector> tpetra(const NOX::Abstract::Vector& vector) {
  return Extract::getConstTpetraVector(dynamic_cast<const NOX::Thyra::Vector&>(vector).getThyraRCPVector());
}

}  // namespace

bool AdmissibleLineSearch::compute(NOX::Abstract::Group& group, double& step, const NOX::Abstract::Vector& direction,
                                   const NOX::Solver::Generic& solver) {
  const NOX::Abstract::Group& old = solver.getPreviousSolutionGroup();
  step = problem_.admissible_step(*tpetra(old.getX()), *tpetra(direction));
  for (int halving = 0; halving < 10 && step > 0; ++halving, step /= 2) {
    group.computeX(old, direction, step);
    // Thyra drops the mark of a failed evaluation on its way to NOX; the NaN in f stays.
    if (group.computeF() == NOX::Abstract::Group::Ok && std::isfinite(group.getNormF())) return true;
  }
  step = 0;  // tells NOX that the search failed
  return false;
}

}  // namespace ixos
