#include "run/energies.hpp"

#include <algorithm>
#include <cmath>

#include "model/state_report.hpp"

namespace ixos {

double Energies::largest() const { return std::max({kinetic, std::abs(elastic), std::abs(contact)}); }

Energies energies_of(const Simulation& simulation) {
  const Model& model = simulation.model();
  const StateReport report(model, simulation.integrator().state());
  return {report.momenta().kinetic_energy, report.elastic_energy(),
          model.has_interactions() ? report.energy(Part::Interaction) : 0.0};
}

}  // namespace ixos
