/// NOX direction: Newton's, or the nearest that decreases the problem's potential.
#pragma once
#include <NOX_Direction_Generic.H>
#include <NOX_Direction_Newton.H>
#include <NOX_Direction_UserDefinedFactory.H>

#include "solve/newton/forcing_term.hpp"
#include "solve/newton/nonlinear_problem.hpp"

namespace ixos {

/// NOX's Newton direction. If `tolerance`, that of |f|, is not 0, a ForcingTerm sets the accuracy of its linear solves.
/// Prescribed values go the whole way, exactly. If the residual f is a gradient and f . d >= 0, or the linear solver
/// breaks down, the tangent is not positive definite: the direction is computed again with the tangent relaxed step by
/// step (see NonlinearProblem::relax_tangent). Fails if the last step gives no descent either. Exceptions of the
/// problem pass through, and so do those of the linear solver that a relaxed tangent does not cure: InputError,
/// FileError and std::bad_alloc.
class DescentDirection final : public NOX::Direction::Generic {
 public:
  DescentDirection(NonlinearProblem& problem, double tolerance, const Teuchos::RCP<NOX::GlobalData>& data,
                   Teuchos::ParameterList& list)
      : problem_(problem), tolerance_(tolerance), list_(&list), newton_(data, list) {}

  bool reset(const Teuchos::RCP<NOX::GlobalData>& data, Teuchos::ParameterList& list) override {
    list_ = &list;
    return newton_.reset(data, list);
  }
  bool compute(NOX::Abstract::Vector& direction, NOX::Abstract::Group& group,
               const NOX::Solver::Generic& solver) override;

 private:
  NonlinearProblem& problem_;
  double tolerance_;
  ForcingTerm forcing_;
  Teuchos::ParameterList* list_;
  NOX::Direction::Newton newton_;
};

/// A factory that gives NOX the direction for a problem.
class DescentDirectionFactory final : public NOX::Direction::UserDefinedFactory {
 public:
  DescentDirectionFactory(NonlinearProblem& problem, double tolerance) : problem_(problem), tolerance_(tolerance) {}
  Teuchos::RCP<NOX::Direction::Generic> buildDirection(const Teuchos::RCP<NOX::GlobalData>& data,
                                                       Teuchos::ParameterList& list) const override {
    return Teuchos::rcp(new DescentDirection(problem_, tolerance_, data, list));
  }

 private:
  NonlinearProblem& problem_;
  double tolerance_;
};

}  // namespace ixos
