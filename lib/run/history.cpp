#include "run/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "base/phase_timer.hpp"
#include "scene/history_columns.hpp"

namespace ixos {
namespace {

constexpr double empty = std::numeric_limits<double>::quiet_NaN();

std::size_t place_of(const std::vector<std::string>& columns, const std::string& name) {
  return static_cast<std::size_t>(std::find(columns.begin(), columns.end(), name) - columns.begin());
}

}  // namespace

History::History(Simulation& simulation)
    : simulation_(simulation),
      row_(simulation),
      max_energy_error_(simulation.output().energies ? 0.0 : empty),
      contacts_(row_.contact_names()) {
  take_columns(simulation.run_columns());
  for (const std::string& column : row_.force_columns()) max_forces_.emplace_back(column, 0.0);
  forces_ = max_forces_;
}

/// Sets the columns of the file.
void History::take_columns(const std::vector<std::string>& columns) {
  columns_ = columns;
  places_.clear();
  for (const std::string& name : row_.columns()) places_.push_back(place_of(columns_, name));
  released_place_ = place_of(columns_, released_column);
  adapted_place_ = place_of(columns_, adapted_column);
}

void History::create(const std::string& path) {
  on_first_rank(simulation_.model().space().comm(), [&] { file_ = std::make_unique<HistoryFile>(path, columns_); });
}

void History::verify(const std::string& path) {
  const Comm& comm = simulation_.model().space().comm();
  std::string header;
  on_first_rank(comm, [&] { header = HistoryFile::verify(path, columns_, released_column, length_); });
  take_columns(csv_cells(from_first_rank(comm, header)));
}

void History::resume(const std::string& path) {
  on_first_rank(simulation_.model().space().comm(), [&] {
    file_.reset();  // it writes its last rows, which go then
    file_ = std::make_unique<HistoryFile>(path, length_);
  });
}

void History::go_on_from(History& before) {
  if (!are_alike(columns_, before.columns_, released_column)) {
    const auto has = [](const std::vector<std::string>& all, const std::string& name) {
      return name == released_column || std::find(all.begin(), all.end(), name) != all.end();
    };
    std::string words = "their order is another one";
    for (const std::string& name : columns_)
      if (!has(before.columns_, name)) words = "it has no " + name;
    for (const std::string& name : before.columns_)
      if (!has(columns_, name)) words = "it has " + name;
    throw InputError("history.csv cannot go on with the columns of another simulation: " + words);
  }
  take_columns(before.columns_);
  file_ = std::move(before.file_);
  adapted_ = before.adapted_;
  initial_energy_ = before.initial_energy_;
  balance_ = before.balance_;
  max_energy_error_ = before.max_energy_error_;
  largest_energy_ = before.largest_energy_;
  jumps_.go_on_from(before.jumps());
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

void History::keep_forces(const std::vector<double>& forces) {
  for (std::size_t column = 0; column < forces.size(); ++column) {
    const double force = forces[column];
    forces_[column].second = force;
    double& largest = max_forces_[column].second;
    if (!(std::abs(force) <= std::abs(largest))) largest = force;
  }
}

void History::pass() { keep_forces(row_.forces()); }

void History::record(const RowCounts& counts, bool is_first) {
  const TimedScope timed(Phase::Output);
  RowValues values = row_.values(counts);
  if (simulation_.output().energies) {
    balance_ = values.balance - adapted_;
    if (std::isnan(initial_energy_)) initial_energy_ = balance_;
    if (std::isnan(max_energy_error_)) max_energy_error_ = 0;  // a checkpoint of a run without energies
    largest_energy_ = std::max({largest_energy_, values.kinetic, std::abs(values.elastic), std::abs(values.contact)});
  }
  const double time = simulation_.integrator().time();
  const bool may_jump = !is_first && is_static(simulation_.integrator().table());
  jump_ = may_jump ? jumps_.row(time, balance_, simulation_.integrator().external_work(), largest_energy_) : Jump();
  if (simulation_.output().energies) {
    const double error = std::abs(balance_ - initial_energy_ + jumps().released);
    if (!(error <= max_energy_error_)) max_energy_error_ = error;  // not std::max: a NaN must remain visible
  }
  contact_measure_ = values.contact_measure;
  keep_forces(values.forces);
  contacts_.row(time, values.measures);
  friction_reports_ = std::move(values.friction_reports);
  std::vector<double> line(columns_.size(), empty);
  for (std::size_t i = 0; i < values.row.size(); ++i) line[places_[i]] = values.row[i];
  if (released_place_ < line.size() && simulation_.output().energies) line[released_place_] = jumps().released;
  if (adapted_place_ < line.size() && simulation_.output().energies) line[adapted_place_] = adapted_;
  together(simulation_.model().space().comm(), [&] {
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

void History::transfer_jumps(Record& record) {
  const bool has_jumps = is_static(simulation_.integrator().table()) || jumps().count > 0;
  if (record.loading() ? record.has_section("jump watch") : has_jumps) jumps_.transfer(record);
}

}  // namespace ixos
