#include "solve/iterative/mass_operator.hpp"

#include <Tpetra_Vector.hpp>
#include <cmath>

namespace ixos {

MassOperator::MassOperator(const Model& model)
    : model_(model),
      x_(static_cast<std::size_t>(model.space().local())),
      product_(static_cast<std::size_t>(model.space().owned()), 0.0) {}

void MassOperator::apply(const MultiVector& x, MultiVector& y, Teuchos::ETransp, double alpha, double beta) const {
  for (std::size_t j = 0; j < x.getNumVectors(); ++j) {
    model_.space().import(*x.getVector(j), x_.data());
    if (model_.mass() != nullptr) model_.mass()->multiply(x_.data(), product_.data());
    const auto to = y.getVectorNonConst(j)->getLocalViewHost(Tpetra::Access::ReadWrite);
    for (std::size_t i = 0; i < product_.size(); ++i)
      to(i, 0) = beta == 0 ? alpha * product_[i] : alpha * product_[i] + beta * to(i, 0);
  }
}

ScaledMass::ScaledMass(const Model& model)
    : model_(model),
      scale_(static_cast<std::size_t>(model.space().owned()), 0.0),
      x_(static_cast<std::size_t>(model.space().local())),
      product_(scale_.size()) {
  model.mass()->add_diagonal(1.0, scale_.data());
  for (double& s : scale_) s = 1 / std::sqrt(s);
  for (int dof : model.constraints().dofs())
    if (static_cast<std::size_t>(dof) < scale_.size()) scale_[static_cast<std::size_t>(dof)] = 1;
}

void ScaledMass::apply(const MultiVector& x, MultiVector& y, Teuchos::ETransp, double alpha, double beta) const {
  for (std::size_t j = 0; j < x.getNumVectors(); ++j) {
    const auto from = x.getVector(j)->getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t i = 0; i < scale_.size(); ++i) x_[i] = scale_[i] * from(i, 0);
    for (int dof : model_.constraints().dofs()) x_[static_cast<std::size_t>(dof)] = 0;
    const NodePlanes& planes = model_.constraints().planes();
    planes.project(x_.data(), model_.mesh().owned_nodes);
    model_.space().update_ghosts(x_.data());
    model_.mass()->multiply(x_.data(), product_.data());
    for (std::size_t i = 0; i < scale_.size(); ++i) product_[i] *= scale_[i];
    for (int dof : model_.constraints().dofs()) {
      const auto i = static_cast<std::size_t>(dof);
      if (i < scale_.size()) product_[i] = from(i, 0);
    }
    planes.project(product_.data(), model_.mesh().owned_nodes);
    planes.add_across(1, from.data(), product_.data(), model_.mesh().owned_nodes);
    const auto to = y.getVectorNonConst(j)->getLocalViewHost(Tpetra::Access::ReadWrite);
    for (std::size_t i = 0; i < scale_.size(); ++i)
      to(i, 0) = beta == 0 ? alpha * product_[i] : alpha * product_[i] + beta * to(i, 0);
  }
}

}  // namespace ixos
