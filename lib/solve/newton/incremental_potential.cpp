#include "solve/newton/incremental_potential.hpp"

#include <NOX_Abstract_Group.H>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "solve/newton/nox_vector.hpp"

namespace ixos {

double IncrementalPotential::computef(const NOX::Abstract::Group& group) const {
  if (!group.isF() || !std::isfinite(group.getNormF())) return std::numeric_limits<double>::infinity();
  const auto x = tpetra(group.getX());
  const double way = problem_.way_left(*x);
  if (way > 0) return way_weight * way;
  return problem_.is_gradient() ? problem_.potential(*x).value : group.getNormF() * group.getNormF() / 2;
}

double IncrementalPotential::computeSlope(const NOX::Abstract::Vector& direction,
                                          const NOX::Abstract::Group& group) const {
  // Newton's step goes the whole way.
  const double way = problem_.way_left(*tpetra(group.getX()));
  if (way > 0) return -2 * way_weight * way;
  if (problem_.is_gradient()) return group.getF().innerProduct(direction);
  const auto product = direction.clone(NOX::ShapeCopy);
  if (!group.isJacobian() || group.applyJacobian(direction, *product) != NOX::Abstract::Group::Ok)
    return -group.getNormF() * group.getNormF();  // that of Newton's step, J d = -f
  return group.getF().innerProduct(*product);
}

void IncrementalPotential::computeGradient(const NOX::Abstract::Group& group, NOX::Abstract::Vector& result) const {
  if (problem_.is_gradient())
    result = group.getF();
  else if (group.applyJacobianTranspose(group.getF(), result) != NOX::Abstract::Group::Ok)
    throw std::runtime_error("the tangent has no transpose, which the gradient of |f|^2 needs");
}

double IncrementalPotential::curvature(const NOX::Abstract::Vector& direction,
                                       const NOX::Abstract::Group& group) const {
  const auto product = direction.clone(NOX::ShapeCopy);
  group.applyJacobian(direction, *product);
  return (problem_.is_gradient() ? direction : *product).innerProduct(*product);
}

double IncrementalPotential::computeQuadraticModel(const NOX::Abstract::Vector& direction,
                                                   const NOX::Abstract::Group& group) const {
  return computef(group) + computeSlope(direction, group) + 0.5 * curvature(direction, group);
}

void IncrementalPotential::computeQuadraticMinimizer(const NOX::Abstract::Group& group,
                                                     NOX::Abstract::Vector& result) const {
  // Along the steepest descent (Cauchy's point).
  computeGradient(group, result);
  result.scale(-result.innerProduct(result) / curvature(result, group));
}

}  // namespace ixos
