#include "solve/admissible_line_search.hpp"

#include <NOX_Abstract_Group.H>
#include <NOX_Solver_Generic.H>
#include <NOX_Thyra_Vector.H>

#include <algorithm>
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
  const double slope = old.getF().innerProduct(direction);
  step = problem_.admissible_step(*tpetra(old.getX()), *tpetra(direction));
  for (int trial = 0; trial < 12 && step > 0; ++trial) {
    group.computeX(old, direction, step);
    // Thyra drops the mark of a failed evaluation on its way to NOX; the NaN in f stays.
    if (group.computeF() != NOX::Abstract::Group::Ok || !std::isfinite(group.getNormF())) {
      step /= 2;
      continue;
    }
    const double overshoot = group.getF().innerProduct(direction) / -slope;
    if (!(slope < 0) || overshoot <= 0.8) return true;
    step *= std::max(0.1, 1 / (1 + overshoot));  // the zero of the slope, by the secant
  }
  const bool evaluated = step > 0 && std::isfinite(group.getNormF());
  if (!evaluated) step = 0;  // tells NOX that the search failed
  return evaluated;
}

}  // namespace ixos
