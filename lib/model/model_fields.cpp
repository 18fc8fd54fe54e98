// Fields of the model that only an output asks for.
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

std::vector<double> Model::contact_pressure(const double* u) const {
  std::vector<double> pressure(static_cast<std::size_t>(mesh_.nodes()), 0.0), measure = pressure;
  for (const Interaction* term : interactions_) {
    term->add_nodal_pressure(u, pressure.data());
    term->add_nodal_measure(measure.data());
  }
  for (std::size_t node = 0; node < pressure.size(); ++node)
    pressure[node] = measure[node] > 0 && !mesh_.is_derivative(node) ? pressure[node] / measure[node] : 0.0;
  return pressure;
}

}  // namespace ixos
