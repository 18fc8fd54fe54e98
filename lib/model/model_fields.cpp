// Fields of surfaces and cells that only an output asks for.
#include <algorithm>
#include <limits>

#include "material/lame.hpp"
#include "model/model.hpp"

namespace ixos {

void Model::add_inelastic_stress(const Body& body, const double* u, const double* v,
                                 std::vector<SymmetricTensor>& stress) {
  if (body.viscosity != nullptr) body.viscosity->add_cell_stress(u, v, stress);
  if (body.viscoelasticity != nullptr) body.viscoelasticity->add_cell_stress(u, stress);
}

std::vector<std::vector<SymmetricTensor>> Model::cell_stress(const double* u, const double* v) const {
  std::vector<std::vector<SymmetricTensor>> stress(mesh_.blocks.size());
  for (const Body& body : bodies_) {
    body.term->cell_stress(u, stress[body.block]);
    add_inelastic_stress(body, u, v, stress[body.block]);
  }
  return stress;
}

std::vector<CellFields> Model::cell_fields(const double* u, const double* v) const {
  std::vector<CellFields> fields(mesh_.blocks.size());
  for (const Body& body : bodies_) {
    CellFields& own = fields[body.block];
    body.term->cell_fields(u, own);
    if (body.viscosity != nullptr) body.viscosity->cell_dissipation(own.dissipated);
    if (body.viscoelasticity != nullptr) {
      body.viscoelasticity->add_cell_dissipation(own.dissipated);
      body.viscoelasticity->add_cell_energy(u, own.energy_density);
    }
    if (v == nullptr || (body.viscosity == nullptr && body.viscoelasticity == nullptr)) continue;
    std::vector<SymmetricTensor> stress(own.stress_invariant.size());
    add_inelastic_stress(body, u, v, stress);
    const double scale = youngs_modulus(body.material.law->lame());
    for (std::size_t cell = 0; cell < stress.size(); ++cell)
      own.stress_invariant[cell] += (stress[cell][0] + stress[cell][1] + stress[cell][2]) / scale;
  }
  return fields;
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
