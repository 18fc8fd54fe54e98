/// The merit function of NOX's own line searches.
#pragma once
#include <NOX_MeritFunction_Generic.H>
#include <string>

#include "solve/newton/nonlinear_problem.hpp"

namespace ixos {

/// merit = potential, slope = f . d, if f is a gradient; otherwise merit = |f|^2/2, slope = f . J d with the tangent J.
/// Until prescribed values are reached, the merit is the way left to them times a number so large that every step on
/// that way decreases it. It is infinite if f cannot be evaluated.
class IncrementalPotential final : public NOX::MeritFunction::Generic {
 public:
  explicit IncrementalPotential(NonlinearProblem& problem) : problem_(problem) {}

  double computef(const NOX::Abstract::Group& group) const override;
  double computeSlope(const NOX::Abstract::Vector& direction, const NOX::Abstract::Group& group) const override;
  /// Throws std::runtime_error if f is no gradient and the tangent has no transpose.
  void computeGradient(const NOX::Abstract::Group& group, NOX::Abstract::Vector& result) const override;
  double computeQuadraticModel(const NOX::Abstract::Vector& direction,
                               const NOX::Abstract::Group& group) const override;
  void computeQuadraticMinimizer(const NOX::Abstract::Group& group, NOX::Abstract::Vector& result) const override;
  const std::string& name() const override { return name_; }

 private:
  /// Returns d . B d, where B is the tangent J, or J^T J if f is no gradient.
  double curvature(const NOX::Abstract::Vector& direction, const NOX::Abstract::Group& group) const;

  static constexpr double way_weight = 1e100;
  NonlinearProblem& problem_;
  std::string name_ = "Incremental Potential";
};

}  // namespace ixos
