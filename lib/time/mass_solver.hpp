/// Systems with the consistent mass.
#pragma once
#include <memory>
#include <vector>

#include "model/model.hpp"
#include "solve/choice/linear_solver.hpp"

namespace ixos {

/// A solver for M x = b with the consistent mass, constrained degrees of freedom decoupled with 1 on the diagonal. The
/// matrix is made at the first request; without a linear solver, or if its tangents are matrix-free, plain CG (to
/// 1e-12) takes its place. The model must outlive it. Collective.
class MassSolver {
 public:
  MassSolver(const Model& model, std::shared_ptr<const LinearSolverFactory> linear_solver)
      : model_(model), linear_solver_(std::move(linear_solver)) {}

  /// Forgets the mass matrix, for a pattern that has changed.
  void renew() { system_.reset(); }
  /// Sets x, a local array, from b, an owned one. Returns false if the solve fails.
  bool solve(std::vector<double> b, double* x);

 private:
  void prepare();

  const Model& model_;
  std::shared_ptr<const LinearSolverFactory> linear_solver_;
  std::unique_ptr<LinearSolverFactory> conjugate_gradients_;  ///< of a mass that is applied without a matrix
  std::unique_ptr<LinearSystem> system_;
  std::vector<double> scale_;  ///< see ScaledMass; empty if the mass is a matrix
};

}  // namespace ixos
