// Fields of surfaces and cells that only an output asks for.
#include <algorithm>
#include <limits>

#include "model/model.hpp"

namespace ixos {

std::vector<std::vector<SymmetricTensor>> Model::cell_stress(const double* u, const double* v) const {
  std::vector<std::vector<SymmetricTensor>> stress(mesh_.blocks.size());
  for (const Body& body : bodies_) {
    body.term->cell_stress(u, stress[body.block]);
    if (body.viscosity != nullptr) body.viscosity->add_cell_stress(u, v, stress[body.block]);
  }
  return stress;
}

std::vector<double> Model::nodal_gap(const double* u) const {
  std::vector<double> gap(static_cast<std::size_t>(mesh_.nodes()), std::numeric_limits<double>::quiet_NaN());
  for (const Interaction* term : interactions_) term->lower_nodal_gap(u, gap.data());
  return gap;
}

std::vector<double> Model::nodal_force(Part part, const double* u) const {
  std::vector<double> f(static_cast<std::size_t>(space_.local()));
  if (!force(part, {nullptr, nullptr, u}, end_rule(), f.data()))
    std::fill(f.begin(), f.end(), std::numeric_limits<double>::quiet_NaN());
  return f;
}

const std::vector<double>& Model::surface_measure() const {
  if (!surface_measure_.empty()) return surface_measure_;
  surface_measure_.resize(static_cast<std::size_t>(mesh_.nodes()));
  CountedSides counted;
  for (const Interaction* term : interactions_) term->add_nodal_measure(counted, surface_measure_.data());
  return surface_measure_;
}

std::vector<double> Model::interaction_traction(const double* u) const {
  const auto d = static_cast<std::size_t>(mesh_.dimension);
  std::vector<double> traction(static_cast<std::size_t>(space_.local()), 0.0);
  if (interactions_.empty()) return traction;
  force(Part::Interaction, {nullptr, nullptr, u}, end_rule(), traction.data());
  const std::vector<double>& measure = surface_measure();
  for (std::size_t i = 0; i < traction.size(); ++i)
    traction[i] = measure[i / d] > 0 && !mesh_.is_derivative(i / d) ? -traction[i] / measure[i / d] : 0.0;
  return traction;
}

std::vector<double> Model::contact_pressure(const double* u) const {
  std::vector<double> pressure(static_cast<std::size_t>(mesh_.nodes()), 0.0);
  for (const Interaction* term : interactions_) term->add_nodal_pressure(u, pressure.data());
  const std::vector<double>& measure = surface_measure();
  for (std::size_t node = 0; node < pressure.size(); ++node)
    pressure[node] = measure[node] > 0 && !mesh_.is_derivative(node) ? pressure[node] / measure[node] : 0.0;
  return pressure;
}

}  // namespace ixos
