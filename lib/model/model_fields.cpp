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
    if (body.viscoelasticity != nullptr) body.viscoelasticity->add_cell_stress(u, stress[body.block]);
  }
  return stress;
}

std::vector<double> Model::nodal_gap(const double* u) const { return all_interactions().gap(u); }

std::vector<double> Model::nodal_force(Part part, const double* u) const {
  std::vector<double> f(static_cast<std::size_t>(space_.local()));
  if (!force(part, {nullptr, nullptr, u, time_}, end_rule(), f.data()))
    std::fill(f.begin(), f.end(), std::numeric_limits<double>::quiet_NaN());
  return f;
}

std::vector<double> Model::interaction_traction(const double* u) const { return all_interactions().traction(u); }

std::vector<double> Model::contact_pressure(const double* u) const { return all_interactions().pressure(u); }

}  // namespace ixos
