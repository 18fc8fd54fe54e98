/// Energies, forces, gaps and stresses of a model in a state.
#pragma once
#include <string>
#include <vector>

#include "model/interaction_group.hpp"
#include "model/model.hpp"
#include "state/state.hpp"

namespace ixos {

/// Quantities that the model stores and moves, summed over all ranks.
struct Momenta {
  double kinetic_energy = 0;
  std::vector<double> linear;   ///< all are zero without inertia; of an axisymmetric mesh the first, too
  std::vector<double> angular;  ///< about the origin: z in 2D, x, y, z in 3D; zero of an axisymmetric mesh
};

/// A model and one of its states, both of which must outlive it: `StateReport(model, integrator.state()).gap()`. Local
/// arrays are valid for owned nodes. Functions that sum over all ranks are collective; they say so.
class StateReport {
 public:
  StateReport(const Model& model, const State& state) : model_(model), state_(&state) {}
  /// `at`: with histories unless no term keeps any, and with a velocity for what depends on it.
  StateReport(const Model& model, const Place& at) : model_(model), given_(at) {}
  StateReport(const Model& model, const State&& state) = delete;

  /// Returns this rank's share of the part's potential energy, or the sum over all ranks (collective) [E0 L0^D]. In
  /// these the driven ends of springs rest in their first places.
  double local_energy(Part part) const;
  double energy(Part part) const;
  /// Returns the energy of elasticity and of the springs of grips, whose driven ends are where they are at the state's
  /// time [E0 L0^D]. Collective.
  double elastic_energy() const;
  /// Adds the gradient of elastic_energy() by u, less that of energy(Part::Elastic), to a local array; valid for owned
  /// nodes [E0 L0^(D-1)].
  void add_stretch_gradient(double* f) const;
  /// Returns the gradient of the part's energy by u, all NaN if the state is inadmissible on this rank [E0 L0^(D-1)].
  /// The forces on the body are minus these.
  std::vector<double> nodal_force(Part part) const;
  /// Collective.
  Momenta momenta() const;

  /// Returns the interactions of all names, or of one. Throws InputError that names the nearest name if there is none.
  InteractionGroup interactions() const;
  InteractionGroup interaction(const std::string& name) const;
  /// Return what the interactions of all names say, see InteractionGroup.
  InteractionReport interaction_report() const { return interactions().report(); }
  std::vector<double> nodal_gap() const { return interactions().gap(); }
  std::vector<double> interaction_traction() const { return interactions().traction(); }
  std::vector<double> contact_pressure() const { return interactions().pressure(); }

  /// Returns the fields by block, local cells. The stress invariant is that of cell_stress() if the state has a
  /// velocity, else that of the elastic law alone.
  std::vector<CellFields> cell_fields() const;
  /// Returns the mean Cauchy stress over each cell's reference volume, by block and local cell: that of elasticity, of
  /// Kelvin-Voigt viscosity and of Maxwell branches, without Rayleigh damping [E0].
  std::vector<std::vector<SymmetricTensor>> cell_stress() const;

 private:
  void add_inelastic_stress(const Body& body, std::vector<SymmetricTensor>& stress) const;

  /// The state as it is now: it may have gone on.
  Place at() const { return state_ != nullptr ? state_->place() : given_; }
  const TermHistories& past() const;

  const Model& model_;
  const State* state_ = nullptr;
  Place given_;  ///< without a state
};

}  // namespace ixos
