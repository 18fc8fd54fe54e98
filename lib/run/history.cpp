#include "run/history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/agreement.hpp"
#include "base/phase_timer.hpp"
#include "model/set_reactions.hpp"

namespace ixos {
namespace {

constexpr double empty = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> columns(int dimension) {
  std::vector<std::string> names{"step",
                                 "time",
                                 "time_step",
                                 "kinetic_energy",
                                 "elastic_energy",
                                 "contact_energy",
                                 "external_work",
                                 "dissipated_energy",
                                 "total_energy",
                                 "linear_momentum_x",
                                 "linear_momentum_y"};
  if (dimension == 3) names.emplace_back("linear_momentum_z");
  if (dimension == 3)
    for (const char* axis : {"x", "y", "z"}) names.push_back(std::string("angular_momentum_") + axis);
  else
    names.emplace_back("angular_momentum_z");
  names.insert(names.end(), {"contact_force_x", "contact_force_y"});
  if (dimension == 3) names.emplace_back("contact_force_z");
  for (const char* name : {"contact_measure", "min_gap", "newton_iterations", "linear_iterations", "wall_seconds"})
    names.emplace_back(name);
  return names;
}

}  // namespace

History::History(Simulation& simulation)
    : simulation_(simulation),
      columns_(columns(simulation.model().mesh().dimension)),
      max_energy_error_(simulation.output().energies ? 0.0 : empty) {
  const Model& model = simulation.model();
  const std::string axes = model.mesh().dimension == 2 ? "xy" : "xyz";
  for (const std::string& set : simulation.output().reactions) {
    reaction_sets_.push_back(model.mesh().node_set(set));
    for (char axis : axes) {
      columns_.push_back("reaction_" + set + "_" + axis);
      max_forces_.emplace_back(columns_.back(), 0.0);
    }
  }
  forces_ = max_forces_;
  for (const Probe& probe : simulation.probes())
    for (char field : {'u', 'v'})
      for (char axis : axes) columns_.push_back(probe.name + "_" + field + axis);
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

std::vector<double> History::reactions() {
  if (reaction_sets_.empty()) return {};
  std::vector<double> sums =
      set_reactions(simulation_.model(), simulation_.integrator().state().reaction, reaction_sets_);
  for (std::size_t k = 0; k < sums.size(); ++k) {
    forces_[k].second = sums[k];
    if (!(std::abs(sums[k]) <= std::abs(max_forces_[k].second))) max_forces_[k].second = sums[k];
  }
  return sums;
}

void History::pass() { reactions(); }

void History::record(const RowCounts& counts) {
  const TimedScope timed(Phase::Output);
  const Model& model = simulation_.model();
  const Integrator& integrator = simulation_.integrator();
  const State& state = integrator.state();
  const OutputOptions& output = simulation_.output();
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  const std::size_t spins = d == 2 ? 1 : 3;
  std::vector<double> row{static_cast<double>(counts.step), integrator.time(), counts.time_step};

  Momenta momenta{empty, std::vector<double>(d, empty), std::vector<double>(spins, empty)};
  if (output.energies || output.momenta) momenta = model.momenta(state.u.data(), state.v.data());
  if (output.energies) {
    const double elastic = model.energy(Part::Elastic, state.u.data());
    const double contact = model.has_interactions() ? model.energy(Part::Interaction, state.u.data()) : 0.0;
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
    const InteractionReport report = model.interaction_report(state.u.data());
    row.insert(row.end(), report.force.begin(), report.force.end());
    row.insert(row.end(), {report.measure, report.least_gap});
    contact_measure_ = report.measure;
  } else {
    row.insert(row.end(), d + 2, empty);
  }
  row.insert(row.end(), {static_cast<double>(counts.newton_iterations), static_cast<double>(counts.linear_iterations),
                         counts.wall_seconds});
  const std::vector<double> forces = reactions();
  row.insert(row.end(), forces.begin(), forces.end());
  for (const Probe& probe : simulation_.probes())
    for (const std::vector<double>* field : {&state.u, &state.v}) {
      const std::vector<double> value = probe.point.value(model.space(), *field);
      row.insert(row.end(), value.begin(), value.end());
    }
  together(model.space().comm(), [&] {
    if (file_) file_->write(row);
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
  // A checkpoint of another scene restores only the reactions that this scene has too.
  auto count = max_forces_.size();
  record.number("reactions", count);
  for (std::size_t k = 0; k < count; ++k) {
    const Record::Section reaction(record, "reaction " + std::to_string(k));
    auto force = k < max_forces_.size() ? max_forces_[k] : std::pair<std::string, double>();
    record.text("name", force.first);
    record.number("largest", force.second);
    if (!record.loading()) continue;
    for (auto& [name, largest] : max_forces_)
      if (name == force.first) largest = force.second;
  }
}

}  // namespace ixos
