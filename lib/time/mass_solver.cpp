#include "time/mass_solver.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <cmath>

#include "solve/choice/linear_solver_defaults.hpp"
#include "solve/iterative/mass_operator.hpp"

namespace ixos {

bool MassSolver::solve(std::vector<double> b, double* x) {
  const auto owned = static_cast<std::size_t>(model_.space().owned());
  if (!system_) prepare();
  for (std::size_t i = 0; i < scale_.size(); ++i) b[i] *= scale_[i];
  Vector rhs(model_.space().owned_map());
  Vector solution(model_.space().owned_map());
  {
    const auto view = rhs.getLocalViewHost(Tpetra::Access::OverwriteAll);
    std::copy_n(b.data(), view.extent(0), view.data());
  }
  if (!system_->solve(rhs, solution) || !std::isfinite(solution.norm2())) return false;
  if (!scale_.empty()) {
    const auto view = solution.getLocalViewHost(Tpetra::Access::ReadWrite);
    for (std::size_t i = 0; i < owned; ++i) view(i, 0) *= scale_[i];
  }
  model_.space().import(solution, x);
  return true;
}

void MassSolver::prepare() {
  if (!linear_solver_ || linear_solver_->matrix_free()) {
    const auto mass = Teuchos::rcp(new ScaledMass(model_));
    scale_ = mass->scale();
    Teuchos::ParameterList conjugate_gradients;
    conjugate_gradients.set("Linear Solver Type", "Belos").set("Preconditioner Type", "None");
    conjugate_gradients_ = std::make_unique<LinearSolverFactory>(completed_linear_solver(conjugate_gradients, {}));
    system_ = std::make_unique<LinearSystem>(*conjugate_gradients_, mass);
    return;
  }
  const auto matrix = model_.pattern().create_matrix(model_.space());
  double* values = matrix->getLocalMatrixHost().values.data();
  model_.mass()->add_to(1.0, values);
  if (!model_.constraints().empty()) model_.constrained_entries().constrain(1.0, values);
  system_ = std::make_unique<LinearSystem>(*linear_solver_, matrix);
}

}  // namespace ixos
