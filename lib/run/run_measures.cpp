#include "run/run_measures.hpp"

#include <algorithm>
#include <cmath>

#include "interaction/gap_law.hpp"
#include "model/branch_reports.hpp"
#include "model/crossing.hpp"
#include "model/traits.hpp"

namespace ixos {
namespace {

double finest_face(const Simulation& simulation) {
  double finest = 0;
  for (const SurfaceNumbers& surface : simulation.characteristic_numbers().surfaces)
    finest = finest == 0 ? surface.face_length : std::min(finest, surface.face_length);
  return finest;
}

/// Returns the shortest cohesive zone of an adhesive surface; 0: the error of a step does not depend on the front,
/// since the state is an equilibrium without a history, or there is no such surface.
double shortest_zone(const Simulation& simulation) {
  const Model& model = simulation.model();
  if (is_static(simulation.integrator().table()) && !has_histories(model)) return 0;
  double shortest = 0;
  for (const SurfaceNumbers& surface : simulation.characteristic_numbers().surfaces)
    if (surface.work > 0) shortest = shortest == 0 ? surface.cohesive_zone : std::min(shortest, surface.cohesive_zone);
  return shortest;
}

}  // namespace

// In three dimensions the contact is an area, whose change does not tell how far its front has moved.
RunMeasures::RunMeasures(const Simulation& simulation)
    : simulation_(simulation),
      contact_(simulation.model().mesh().body_dimension() == 2 ? finest_face(simulation) : 0),
      front_(shortest_zone(simulation), simulation.model().mesh().body_dimension()),
      interval_(is_explicit(simulation.integrator().table()) ? 500 : 20),
      face_measure_(std::pow(finest_face(simulation), simulation.model().mesh().body_dimension() - 1)) {
  for (const SceneInteraction& interaction : simulation.interactions()) {
    const GapLaw& law = *interaction.law;
    if (law.domain() == GapDomain::All)
      scale_ = scale_ == 0 ? law.equilibrium_gap() : std::min(scale_, law.equilibrium_gap());
  }
}

void RunMeasures::look_at_cells() {
  const Integrator& integrator = simulation_.integrator();
  strains_.look(simulation_.model(), integrator.state().place());
}

void RunMeasures::step(long steps, double dt) {
  steps_ = steps;
  const Model& model = simulation_.model();
  const State& state = simulation_.integrator().state();
  if (has_viscoelasticity(model)) relaxation_.step(history_stresses(model, state.histories), dt);
  if (steps % interval_ == 0) look_at_cells();
  if (scale_ > 0) deepest_ = std::min(deepest_, least_free_gap(model, state.place()));
}

void RunMeasures::row(const History& history) {
  contact_.row(simulation_.integrator().time(), history.contact_measure(), history.forces());
  front_.row(steps_, history.contact_measure());
  if (history.jump().released > 0) return;  // friction does not act along a jump
  for (const FrictionReport& report : history.friction_reports()) {
    friction_work_ += report.work;
    friction_lag_ += std::abs(report.lag);
  }
}

RunFacts RunMeasures::finish(const History& history) {
  look_at_cells();
  RunFacts facts;
  facts.body_dimension = simulation_.model().mesh().body_dimension();
  facts.has_inertia = !is_static(simulation_.integrator().table());
  facts.energy_error = history.max_energy_error();
  facts.largest_energy = history.largest_energy();
  facts.strains = strains_.extremes();
  facts.first_scaled_jacobian = simulation_.mesh_quality().least_scaled_jacobian;
  facts.crossings = crossings_;
  facts.deepest = deepest_;
  facts.scale = scale_;
  facts.fall = contact_.largest_fall();
  facts.largest_measure = contact_.largest_measure();
  facts.face_measure = face_measure_;
  facts.ripple = contact_.ripple();
  facts.jumps = history.jumps();
  facts.friction_lag = friction_work_ > 0 ? friction_lag_ / friction_work_ : 0;
  facts.front = front_.front();
  facts.relaxation_error = relaxation_.share();
  facts.relaxation_order = 2;
  for (const Material& material : simulation_.materials())
    if (!material.branches.empty() && material.history_update != HistoryUpdate::SecondOrder) facts.relaxation_order = 1;
  return facts;
}

void RunMeasures::transfer(Record& record, History& history) {
  const Record::Section section(record, "run measures");
  strains_.transfer(record);
  contact_.transfer(record);
  history.transfer_jumps(record);
  record.number("crossings", crossings_);
  record.number("deepest", deepest_);
  front_.transfer(record);
  relaxation_.transfer(record);
  record.number("steps", steps_);
  record.number("friction work", friction_work_);
  record.number("friction lag", friction_lag_);
}

}  // namespace ixos
