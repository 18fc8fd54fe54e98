/// NOX line search that stays in the admissible region.
#pragma once
#include <NOX_LineSearch_Generic.H>
#include <NOX_LineSearch_UserDefinedFactory.H>

#include "solve/nonlinear_problem.hpp"

namespace ixos {

/// Takes the full Newton step, shortened to the problem's admissible step; halves it where the residual cannot be
/// evaluated all the same (an inverted element), at most 10 times.
class AdmissibleLineSearch final : public NOX::LineSearch::Generic {
 public:
  explicit AdmissibleLineSearch(NonlinearProblem& problem) : problem_(problem) {}
  bool compute(NOX::Abstract::Group& group, double& step, const NOX::Abstract::Vector& direction,
               const NOX::Solver::Generic& solver) override;

 private:
  NonlinearProblem& problem_;
};

/// Hands NOX the line search for a problem.
class AdmissibleLineSearchFactory final : public NOX::LineSearch::UserDefinedFactory {
 public:
  explicit AdmissibleLineSearchFactory(NonlinearProblem& problem) : problem_(problem) {}
  Teuchos::RCP<NOX::LineSearch::Generic> buildLineSearch(const Teuchos::RCP<NOX::GlobalData>&,
                                                         Teuchos::ParameterList&) const override {
    return Teuchos::rcp(new AdmissibleLineSearch(problem_));
  }

 private:
  NonlinearProblem& problem_;
};

}  // namespace ixos
