/// The energies of a simulation's present state.
#pragma once
#include "scene/simulation.hpp"

namespace ixos {

/// Energies over all ranks [E0 L0^D].
struct Energies {
  double kinetic = 0, elastic = 0, contact = 0;  ///< elastic: with the springs of grips
  double total() const { return kinetic + elastic + contact; }
  double largest() const;  ///< magnitude of one of them
  /// Adds the change from one state to another.
  void add_change(const Energies& from, const Energies& to) {
    kinetic += to.kinetic - from.kinetic;
    elastic += to.elastic - from.elastic;
    contact += to.contact - from.contact;
  }
};

/// Collective.
Energies energies_of(const Simulation& simulation);

}  // namespace ixos
