#include "run/history_row.hpp"

#include <limits>

#include "model/grips.hpp"
#include "model/set_reactions.hpp"
#include "model/state_report.hpp"
#include "model/strain_extent.hpp"
#include "model/traits.hpp"
#include "scene/history_columns.hpp"

namespace ixos {
namespace {

constexpr double empty = std::numeric_limits<double>::quiet_NaN();

void append(std::vector<double>& row, const std::vector<double>& values) {
  row.insert(row.end(), values.begin(), values.end());
}

}  // namespace

HistoryRow::HistoryRow(Simulation& simulation)
    : simulation_(simulation), norms_(simulation.output().norms, simulation.model()) {
  const Model& model = simulation.model();
  HistoryColumns columns = history_columns(simulation);
  columns_ = std::move(columns.names);
  force_columns_ = std::move(columns.reactions);
  for (const std::string& set : simulation.output().reactions) reaction_sets_.push_back(model.mesh().node_set(set));
  const bool single = has_interaction_columns(simulation.output(), simulation.interactions().size());
  const std::vector<std::string> names = model.interaction_names();
  if (single || (simulation.output().interaction && names.size() == 1)) contact_names_ = names;
  if (single) interactions_ = names;
  for (const std::string& name : names)
    if (has_friction(model, name)) frictions_.push_back(name);
}

std::vector<double> HistoryRow::set_forces() const {
  if (reaction_sets_.empty()) return {};
  return set_reactions(simulation_.model(), simulation_.integrator().state().reaction, reaction_sets_);
}

/// Returns force and, if there is one, moment of each grip, and adds the forces.
std::vector<double> HistoryRow::grip_columns(std::vector<double>& forces) const {
  const Integrator& integrator = simulation_.integrator();
  const Model& model = simulation_.model();
  const State& state = integrator.state();
  std::vector<double> row;
  for (const Grip& grip : model.grips()) {
    const GripReaction own = grip_reaction(model, grip, integrator.time(), state.u, state.v, state.reaction);
    append(forces, own.force);
    append(row, own.force);
    append(row, own.moment);
  }
  return row;
}

/// Returns displacement and velocity of the centre of each rigid body, and unless the mesh is axisymmetric its rotation
/// vector and its spin.
std::vector<double> HistoryRow::body_columns() const {
  const Model& model = simulation_.model();
  const State& state = simulation_.integrator().state();
  const int d = model.mesh().dimension;
  std::vector<double> row;
  for (std::size_t i = 0; i < model.rigid_bodies().size(); ++i) {
    const RigidBody& body = model.rigid_bodies()[i];
    const std::size_t first = model.first_number(i);
    const double *const u = &state.u[first], *const v = &state.v[first];
    row.insert(row.end(), u, u + d);
    row.insert(row.end(), v, v + d);
    if (model.mesh().axisymmetric) continue;
    for (const std::array<double, 3>& turning : {body.rotation_vector(u), body.spin_in_space(u, v)})
      row.insert(row.end(), turning.begin() + (d == 2 ? 2 : 0), turning.end());
  }
  return row;
}

std::vector<double> HistoryRow::forces() const {
  std::vector<double> forces = set_forces();
  grip_columns(forces);
  return forces;
}

/// Returns force, moment, contact measure and least gap of each interaction that has columns.
std::vector<double> HistoryRow::interaction_columns(RowValues& values) const {
  const StateReport state(simulation_.model(), simulation_.integrator().state());
  std::vector<double> row;
  for (const std::string& name : interactions_) {
    const InteractionGroup interaction = state.interaction(name);
    const InteractionReport report = interaction.report();
    append(row, report.force);
    append(row, interaction.moment());
    append(row, {report.measure, report.least_gap});
    values.measures.push_back(report.measure);
  }
  if (interactions_.empty()) values.measures.push_back(values.contact_measure);
  return row;
}

/// Returns the friction on the bodies, the slip and the measures of each interaction with friction.
std::vector<double> HistoryRow::friction_columns(RowValues& values) const {
  const StateReport state(simulation_.model(), simulation_.integrator().state());
  std::vector<double> row;
  for (const std::string& name : frictions_) {
    const InteractionGroup own = state.interaction(name);
    const FrictionReport report = own.friction_report();
    append(row, own.friction_force());
    append(row, {report.mean_slip(), report.sliding, report.sticking});
    values.friction_reports.push_back(report);
  }
  return row;
}

RowValues HistoryRow::values(const RowCounts& counts) const {
  const Model& model = simulation_.model();
  const Integrator& integrator = simulation_.integrator();
  const State& state = integrator.state();
  const OutputOptions& output = simulation_.output();
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  const std::size_t spins = d == 2 ? 1 : 3;
  const StateReport report(model, state);
  RowValues values;
  values.balance = values.contact_measure = empty;
  std::vector<double>& row = values.row;
  row = {static_cast<double>(counts.step), integrator.time(), counts.time_step};

  Momenta momenta{empty, std::vector<double>(d, empty), std::vector<double>(spins, empty)};
  if (output.energies || output.momenta) momenta = report.momenta();
  if (output.energies) {
    const double external_work = integrator.external_work();
    values.kinetic = momenta.kinetic_energy;
    values.elastic = report.elastic_energy();
    values.contact = model.has_interactions() ? report.energy(Part::Interaction) : 0.0;
    const double total = values.kinetic + values.elastic + values.contact;
    values.balance = total - external_work + integrator.dissipated_energy();
    append(row, {values.kinetic, values.elastic, values.contact, external_work, integrator.dissipated_energy(), total});
  } else {
    row.insert(row.end(), 6, empty);
  }
  if (output.momenta) {
    append(row, momenta.linear);
    append(row, momenta.angular);
  } else {
    row.insert(row.end(), d + spins, empty);
  }
  if (output.interaction && model.has_interactions()) {
    const InteractionReport contact = report.interaction_report();
    append(row, contact.force);
    append(row, {contact.measure, contact.least_gap});
    values.contact_measure = contact.measure;
  } else {
    row.insert(row.end(), d + 2, empty);
  }
  append(row, {static_cast<double>(counts.newton_iterations), static_cast<double>(counts.linear_iterations),
               counts.wall_seconds});
  values.forces = set_forces();
  append(row, values.forces);
  append(row, grip_columns(values.forces));
  for (const Probe& probe : simulation_.probes())
    for (const std::vector<double>* field : {&state.u, &state.v}) append(row, probe.point.value(model.space(), *field));
  append(row, body_columns());
  append(row, interaction_columns(values));
  append(row, friction_columns(values));
  for (double dissipated : integrator.dissipations()) row.push_back(output.energies ? dissipated : empty);
  append(row, norms_.values(simulation_.integrator()));
  if (output.strains) {
    const StrainExtent extent = strain_extent(model.mesh(), state.u);
    const DofSpace& space = model.space();
    append(row, {space.maximum(extent.rotation), space.minimum(extent.least), space.maximum(extent.largest)});
  }
  return values;
}

}  // namespace ixos
