#include "solve/incremental_potential.hpp"

#include <NOX_Abstract_Group.H>

#include <cmath>
#include <limits>

#include "solve/nox_vector.hpp"

namespace ixos {

double IncrementalPotential::computef(const NOX::Abstract::Group& group) const {
  if (!group.isF() || !std::isfinite(group.getNormF())) return std::numeric_limits<double>::infinity();
  const auto x = tpetra(group.getX());
  const double way = problem_.way_left(*x);
  return way > 0 ? way_weight * way : problem_.potential(*x).value;
}

double IncrementalPotential::computeSlope(const NOX::Abstract::Vector& direction,
                                          const NOX::Abstract::Group& group) const {
  // Newton's step goes the whole way.
  const double way = problem_.way_left(*tpetra(group.getX()));
  return way > 0 ? -2 * way_weight * way : group.getF().innerProduct(direction);
}

void IncrementalPotential::computeGradient(const NOX::Abstract::Group& group, NOX::Abstract::Vector& result) const {
  result = group.getF();
}

double IncrementalPotential::computeQuadraticModel(const NOX::Abstract::Vector& direction,
                                                   const NOX::Abstract::Group& group) const {
  const auto product = direction.clone(NOX::ShapeCopy);
  group.applyJacobian(direction, *product);
  return computef(group) + computeSlope(direction, group) + 0.5 * direction.innerProduct(*product);
}

void IncrementalPotential::computeQuadraticMinimizer(const NOX::Abstract::Group& group,
                                                     NOX::Abstract::Vector& result) const {
  // Along the steepest descent (Cauchy's point).
  const auto product = group.getF().clone(NOX::ShapeCopy);
  group.applyJacobian(group.getF(), *product);
  const double square = group.getF().innerProduct(group.getF());
  result.update(-square / group.getF().innerProduct(*product), group.getF(), 0.0);
}

}  // namespace ixos
