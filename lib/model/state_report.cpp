#include "model/state_report.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "material/elastic_law.hpp"
#include "material/lame.hpp"
#include "model/term_sums.hpp"
#include "model/traits.hpp"
#include "term/support/springs.hpp"

namespace ixos {

double StateReport::local_energy(Part part) const {
  double sum = 0;
  for (const NamedForceTerm& named : model_.force_terms())
    if (named.term->part() == part) sum += named.term->energy(at());
  return sum;
}

double StateReport::energy(Part part) const {
  double sum = local_energy(part);
  model_.space().sum(&sum, 1);
  return sum;
}

double StateReport::elastic_energy() const {
  double sum = energy(Part::Elastic);
  if (!has_springs(model_)) return sum;
  double stretch = 0;
  for (const Springs* const springs : model_.springs()) stretch += springs->stretch_energy(at().time, at().u);
  model_.space().sum(&stretch, 1);
  return sum + stretch;
}

void StateReport::add_stretch_gradient(double* f) const {
  for (const Springs* const springs : model_.springs()) springs->add_stretch_gradient(at().time, f);
}

std::vector<double> StateReport::nodal_force(Part part) const {
  std::vector<double> f(static_cast<std::size_t>(model_.space().local()));
  if (!TermSums(model_).force(part, segment_at(at()), end_rule(), f.data()))
    std::fill(f.begin(), f.end(), std::numeric_limits<double>::quiet_NaN());
  return f;
}

Momenta StateReport::momenta() const {
  const LocalMesh& mesh = model_.mesh();
  const Place here = at();
  const double *u = here.u, *v = here.v;
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> momentum(static_cast<std::size_t>(model_.space().owned()), 0.0);
  if (model_.mass() != nullptr) model_.mass()->multiply(v, momentum.data());
  std::vector<double> sums(1 + d + (d == 2 ? 1 : 3), 0.0);
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.owned_nodes); ++node) {
    const double* p = &momentum[node * d];
    double x[3] = {};
    for (std::size_t i = 0; i < d; ++i) {
      x[i] = mesh.coordinates[node * d + i] + u[node * d + i];
      sums[0] += 0.5 * v[node * d + i] * p[i];
      if (!mesh.is_derivative(node)) sums[1 + i] += p[i];
    }
    if (d == 2) {
      sums[3] += x[0] * p[1] - x[1] * p[0];
    } else {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        sums[4 + i] += x[j] * p[k] - x[k] * p[j];
      }
    }
  }
  model_.space().sum(sums.data(), static_cast<int>(sums.size()));
  const RigidBodies& rigid = model_.rigid_bodies();
  for (std::size_t i = 0; i < rigid.size() && model_.mass() != nullptr; ++i) {
    const auto first = model_.first_number(i);
    sums[0] += rigid[i].kinetic_energy(v + first);
    const std::array<double, 3> linear = rigid[i].momentum(v + first);
    const std::array<double, 3> angular = rigid[i].angular_momentum(u + first, v + first);
    for (std::size_t k = 0; k < d; ++k) sums[1 + k] += linear[k];
    for (std::size_t k = d == 2 ? 2 : 0; k < 3; ++k) sums[(d == 2 ? 1 : 4) + k] += angular[k];
  }
  if (mesh.axisymmetric) sums[1] = sums[3] = 0;  // the ring's radial momenta cancel
  const auto first = sums.begin() + 1;
  const auto middle = first + static_cast<std::ptrdiff_t>(d);
  return {sums[0], {first, middle}, {middle, sums.end()}};
}

InteractionGroup StateReport::interactions() const {
  std::vector<const Interaction*> terms;
  for (const NamedInteraction& named : model_.interactions()) terms.push_back(named.term);
  return {model_.mesh(), model_.space(), std::move(terms), at()};
}

InteractionGroup StateReport::interaction(const std::string& name) const {
  std::vector<const Interaction*> own;
  for (const NamedInteraction& named : model_.interactions())
    if (named.name == name) own.push_back(named.term);
  if (own.empty()) throw InputError(no_such("interaction", name, model_.interaction_names(), "The model has"));
  return {model_.mesh(), model_.space(), std::move(own), at()};
}

/// Adds the stress of viscosity and of Maxwell branches by local cell of a block.
void StateReport::add_inelastic_stress(const Body& body, std::vector<SymmetricTensor>& stress) const {
  if (body.viscosity != nullptr) body.viscosity->add_cell_stress(at(), stress);
  if (body.viscoelasticity != nullptr) body.viscoelasticity->add_cell_stress(at(), stress);
}

std::vector<std::vector<SymmetricTensor>> StateReport::cell_stress() const {
  std::vector<std::vector<SymmetricTensor>> stress(model_.mesh().blocks.size());
  for (const Body& body : model_.bodies()) {
    body.term->cell_stress(at().u, stress[body.block]);
    add_inelastic_stress(body, stress[body.block]);
  }
  return stress;
}

const TermHistories& StateReport::past() const {
  const TermHistories* const kept = at().histories;
  if (kept == nullptr) throw std::logic_error("the report needs the histories of a state");
  return *kept;
}

std::vector<CellFields> StateReport::cell_fields() const {
  std::vector<CellFields> fields(model_.mesh().blocks.size());
  for (const Body& body : model_.bodies()) {
    CellFields& own = fields[body.block];
    body.term->cell_fields(at().u, own);
    if (body.viscosity != nullptr) body.viscosity->cell_dissipation(past(), own.dissipated);
    if (body.viscoelasticity != nullptr) {
      body.viscoelasticity->add_cell_dissipation(past(), own.dissipated);
      body.viscoelasticity->add_cell_energy(at(), own.energy_density);
    }
    if (at().v == nullptr || (body.viscosity == nullptr && body.viscoelasticity == nullptr)) continue;
    std::vector<SymmetricTensor> stress(own.stress_invariant.size());
    add_inelastic_stress(body, stress);
    const double scale = youngs_modulus(body.material.law->lame());
    for (std::size_t cell = 0; cell < stress.size(); ++cell)
      own.stress_invariant[cell] += (stress[cell][0] + stress[cell][1] + stress[cell][2]) / scale;
  }
  return fields;
}

}  // namespace ixos
