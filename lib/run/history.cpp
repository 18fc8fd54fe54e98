#include "run/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "base/phase_timer.hpp"
#include "model/grips.hpp"
#include "model/set_reactions.hpp"
#include "model/state_report.hpp"
#include "model/strain_extent.hpp"
#include "model/traits.hpp"
#include "scene/history_columns.hpp"

namespace ixos {
namespace {

constexpr double empty = std::numeric_limits<double>::quiet_NaN();

}  // namespace

History::History(Simulation& simulation)
    : simulation_(simulation),
      max_energy_error_(simulation.output().energies ? 0.0 : empty),
      norms_(simulation.output().norms, simulation.model()) {
  const Model& model = simulation.model();
  const HistoryColumns columns = history_columns(simulation);
  columns_ = simulation.run_columns();
  for (const std::string& name : columns.names)
    places_.push_back(static_cast<std::size_t>(std::find(columns_.begin(), columns_.end(), name) - columns_.begin()));
  for (const std::string& column : columns.reactions) max_forces_.emplace_back(column, 0.0);
  forces_ = max_forces_;
  for (const std::string& set : simulation.output().reactions) reaction_sets_.push_back(model.mesh().node_set(set));
  const bool single = has_interaction_columns(simulation.output(), simulation.interactions().size());
  const std::vector<std::string> names = model.interaction_names();
  if (single || (simulation.output().interaction && names.size() == 1)) contacts_ = ContactEvents(names);
  for (const std::string& name : names) {
    if (single) interactions_.push_back(name);
    if (has_friction(model, name)) frictions_.push_back(name);
  }
}

void History::create(const std::string& path) {
  on_first_rank(simulation_.model().space().comm(), [&] { file_ = std::make_unique<HistoryFile>(path, columns_); });
}

void History::verify(const std::string& path) const {
  on_first_rank(simulation_.model().space().comm(), [&] { HistoryFile::verify(path, columns_, length_); });
}

void History::resume(const std::string& path) {
  on_first_rank(simulation_.model().space().comm(), [&] {
    file_.reset();  // it writes its last rows, which go then
    file_ = std::make_unique<HistoryFile>(path, length_);
  });
}

void History::go_on_from(History& before) {
  if (columns_ != before.columns_) {
    const auto [own, other] =
        std::mismatch(columns_.begin(), columns_.end(), before.columns_.begin(), before.columns_.end());
    const auto name = [](const std::vector<std::string>& all, auto at) { return at == all.end() ? "none" : *at; };
    throw InputError(
        fmt::format("history.csv cannot go on with the columns of another simulation: column {} is {}, "
                    "it was {}",
                    own - columns_.begin() + 1, name(columns_, own), name(before.columns_, other)));
  }
  file_ = std::move(before.file_);
  initial_energy_ = before.initial_energy_;
  balance_ = before.balance_;
  max_energy_error_ = before.max_energy_error_;
  largest_energy_ = before.largest_energy_;
  contacts_.go_on_from(before.contacts_);
  for (const auto& [name, largest] : before.max_forces_) largest_force(name) = largest;
  for (auto& [name, force] : forces_)
    for (const auto& [other, last] : before.forces_)
      if (other == name) force = last;
  contact_measure_ = before.contact_measure_;
}

/// Returns the largest force of a column; those of columns that only earlier stages have come last.
double& History::largest_force(const std::string& column) {
  for (auto& [name, largest] : max_forces_)
    if (name == column) return largest;
  return max_forces_.emplace_back(column, 0.0).second;
}

std::vector<double> History::reactions() {
  if (reaction_sets_.empty()) return {};
  std::vector<double> sums =
      set_reactions(simulation_.model(), simulation_.integrator().state().reaction, reaction_sets_);
  for (std::size_t k = 0; k < sums.size(); ++k) keep_force(k, sums[k]);
  return sums;
}

/// Returns force and, if there is one, moment of each grip.
std::vector<double> History::grip_reactions() {
  const Integrator& integrator = simulation_.integrator();
  const Model& model = simulation_.model();
  const State& state = integrator.state();
  std::vector<double> row;
  std::size_t column = reaction_sets_.size() * static_cast<std::size_t>(model.mesh().dimension);
  for (const Grip& grip : model.grips()) {
    const GripReaction own = grip_reaction(model, grip, integrator.time(), state.u, state.v, state.reaction);
    for (double force : own.force) keep_force(column++, force);
    row.insert(row.end(), own.force.begin(), own.force.end());
    row.insert(row.end(), own.moment.begin(), own.moment.end());
  }
  return row;
}

/// Returns force, moment, contact measure and least gap of each interaction that has columns.
std::vector<double> History::single_interactions() {
  const StateReport state(simulation_.model(), simulation_.integrator().state());
  std::vector<double> row, measures;
  for (const std::string& name : interactions_) {
    const InteractionGroup interaction = state.interaction(name);
    const InteractionReport report = interaction.report();
    const std::vector<double> moment = interaction.moment();
    row.insert(row.end(), report.force.begin(), report.force.end());
    row.insert(row.end(), moment.begin(), moment.end());
    row.insert(row.end(), {report.measure, report.least_gap});
    measures.push_back(report.measure);
  }
  if (interactions_.empty()) measures.push_back(contact_measure_);
  contacts_.row(simulation_.integrator().time(), measures);
  return row;
}

/// Returns the friction on the bodies, the slip and the measures of each interaction with friction.
std::vector<double> History::frictions() {
  const StateReport state(simulation_.model(), simulation_.integrator().state());
  std::vector<double> row;
  friction_reports_.clear();
  for (const std::string& name : frictions_) {
    const InteractionGroup own = state.interaction(name);
    const std::vector<double> force = own.friction_force();
    const FrictionReport report = own.friction_report();
    row.insert(row.end(), force.begin(), force.end());
    row.insert(row.end(), {report.mean_slip(), report.sliding, report.sticking});
    friction_reports_.push_back(report);
  }
  return row;
}

void History::keep_force(std::size_t column, double force) {
  forces_[column].second = force;
  if (!(std::abs(force) <= std::abs(max_forces_[column].second))) max_forces_[column].second = force;
}

void History::pass() {
  reactions();
  grip_reactions();
}

void History::record(const RowCounts& counts) {
  const TimedScope timed(Phase::Output);
  const Model& model = simulation_.model();
  const Integrator& integrator = simulation_.integrator();
  const State& state = integrator.state();
  const OutputOptions& output = simulation_.output();
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  const std::size_t spins = d == 2 ? 1 : 3;
  const StateReport report(model, state);
  std::vector<double> row{static_cast<double>(counts.step), integrator.time(), counts.time_step};

  Momenta momenta{empty, std::vector<double>(d, empty), std::vector<double>(spins, empty)};
  if (output.energies || output.momenta) momenta = report.momenta();
  if (output.energies) {
    const double elastic = report.elastic_energy();
    const double contact = model.has_interactions() ? report.energy(Part::Interaction) : 0.0;
    const double external_work = integrator.external_work();
    const double total = momenta.kinetic_energy + elastic + contact;
    balance_ = total - external_work + integrator.dissipated_energy();
    if (std::isnan(initial_energy_)) initial_energy_ = balance_;
    if (std::isnan(max_energy_error_)) max_energy_error_ = 0;  // a checkpoint of a run without energies
    const double error = balance_ - initial_energy_;
    largest_energy_ = std::max({largest_energy_, momenta.kinetic_energy, std::abs(elastic), std::abs(contact)});
    // Not std::max: a NaN must remain visible.
    if (!(std::abs(error) <= max_energy_error_)) max_energy_error_ = std::abs(error);
    row.insert(row.end(),
               {momenta.kinetic_energy, elastic, contact, external_work, integrator.dissipated_energy(), total});
  } else {
    row.insert(row.end(), 6, empty);
  }
  if (output.momenta) {
    row.insert(row.end(), momenta.linear.begin(), momenta.linear.end());
    row.insert(row.end(), momenta.angular.begin(), momenta.angular.end());
  } else {
    row.insert(row.end(), d + spins, empty);
  }
  if (output.interaction && model.has_interactions()) {
    const InteractionReport contact = report.interaction_report();
    row.insert(row.end(), contact.force.begin(), contact.force.end());
    row.insert(row.end(), {contact.measure, contact.least_gap});
    contact_measure_ = contact.measure;
  } else {
    row.insert(row.end(), d + 2, empty);
  }
  row.insert(row.end(), {static_cast<double>(counts.newton_iterations), static_cast<double>(counts.linear_iterations),
                         counts.wall_seconds});
  for (const std::vector<double>& forces : {reactions(), grip_reactions()})
    row.insert(row.end(), forces.begin(), forces.end());
  for (const Probe& probe : simulation_.probes())
    for (const std::vector<double>* field : {&state.u, &state.v}) {
      const std::vector<double> value = probe.point.value(model.space(), *field);
      row.insert(row.end(), value.begin(), value.end());
    }
  for (const std::vector<double>& values : {single_interactions(), frictions()})
    row.insert(row.end(), values.begin(), values.end());
  for (double dissipated : integrator.dissipations()) row.push_back(output.energies ? dissipated : empty);
  for (double norm : norms_.values(simulation_.integrator())) row.push_back(norm);
  if (output.strains) {
    const StrainExtent extent = strain_extent(model.mesh(), state.u);
    const DofSpace& space = model.space();
    row.insert(row.end(), {space.maximum(extent.rotation), space.minimum(extent.least), space.maximum(extent.largest)});
  }
  std::vector<double> line(columns_.size(), empty);
  for (std::size_t i = 0; i < row.size(); ++i) line[places_[i]] = row[i];
  together(model.space().comm(), [&] {
    if (file_) file_->write(line);
  });
}

void History::close() {
  together(simulation_.model().space().comm(), [&] {
    if (file_) file_->close();
  });
}

void History::sync() {
  together(simulation_.model().space().comm(), [&] {
    if (file_) file_->sync();
  });
}

void History::transfer(Record& record) {
  const Record::Section section(record, "history");
  if (file_) length_ = file_->length();
  record.number("rows", length_.rows);
  record.number("bytes", length_.bytes);
  record.number("initial energy", initial_energy_);
  record.number("largest energy error", max_energy_error_);
  record.number("largest energy", largest_energy_);
  contacts_.transfer(record);
  // A checkpoint of another scene restores only the reactions that this scene has too.
  auto count = max_forces_.size();
  record.number("reactions", count);
  for (std::size_t k = 0; k < count; ++k) {
    const Record::Section reaction(record, "reaction " + std::to_string(k));
    auto force = k < max_forces_.size() ? max_forces_[k] : std::pair<std::string, double>();
    record.text("name", force.first);
    record.number("largest", force.second);
    if (!record.loading()) continue;
    const bool is_column = std::find(columns_.begin(), columns_.end(), force.first) != columns_.end();
    if (is_column) largest_force(force.first) = force.second;
  }
}

}  // namespace ixos
