#include "study/study_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "io/disk_file.hpp"
#include "parameters/validation.hpp"
#include "scene/scene_file.hpp"
#include "study/history_table.hpp"
#include "time/catalogue.hpp"

namespace ixos {

/// A results folder, as far as errors need it.
struct StudyReference::Results {
  explicit Results(const std::string& folder) : history(folder + "/history.csv") {
    const std::string path = folder + "/effective.xml";
    const Teuchos::ParameterList scene = read_scene_file(path);
    try {
      const Teuchos::ParameterList& integrator = scene.sublist("Time Integrator");
      const Scheme& chosen = scheme(integrator.get<std::string>("Type"));
      // Parameters that an older version did not know take their defaults.
      const Teuchos::ParameterList given =
          integrator.isSublist(chosen.name) ? integrator.sublist(chosen.name) : Teuchos::ParameterList();
      step_means = chosen.table(validated(given, chosen.parameters)).closing == Closing::Collocate;
    } catch (const std::exception& error) {  // of Teuchos, of the validation, of the table
      throw InputError(path + ": Time Integrator: " + last_paragraph(error.what()));
    }
  }
  /// Returns the times to which a column's values belong.
  std::vector<double> times(const std::string& column) const {
    std::vector<double> result = history.column("time");
    if (!step_means || column.rfind("reaction_", 0) != 0) return result;
    const std::vector<double>& step = history.column("time_step");
    for (std::size_t i = 1; i < result.size(); ++i) result[i] -= step[i] / 2;
    return result;
  }
  bool filled(const std::string& name) const {
    return history.has(name) && history.rows() > 0 && !std::isnan(history.column(name).back());
  }

  HistoryTable history;
  bool step_means;
};

namespace {

std::vector<std::string> probe_displacements(const HistoryTable& history) {
  std::vector<std::string> result;
  bool after_counts = false;  // probes and reactions are the last columns
  for (const std::string& name : history.names()) {
    const auto underscore = name.rfind("_u");
    if (after_counts && underscore != std::string::npos && underscore + 3 == name.size()) result.push_back(name);
    after_counts = after_counts || name == "wall_seconds";
  }
  return result;
}

double energy_error(const std::string& folder) {
  std::ifstream file = open_text(folder + "/summary.json");
  const nlohmann::json summary = nlohmann::json::parse(file, nullptr, false);
  if (!summary.is_object() || !summary.contains("max_energy_error"))
    throw FileError(folder + "/summary.json: cannot be read");
  const auto& error = summary["max_energy_error"];
  return error.is_number() ? error.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

StudyReference::StudyReference(const std::string& folder, const ErrorOptions& options)
    : reference_(std::make_unique<Results>(folder)), options_(options) {
  for (const auto* named : {&options.force, &options.position})
    for (const std::string& name : *named) reference_->history.column(name);  // throws if there is none
  if (options_.energy_scale > 0) return;
  for (double energy : reference_->history.column("kinetic_energy"))
    if (energy > options_.energy_scale) options_.energy_scale = energy;
}

StudyReference::~StudyReference() = default;

/// Returns the rms in time of the columns' distance from the reference, over the reference's own rms there.
double StudyReference::relative_distance(const Results& run, const std::vector<std::string>& columns) const {
  if (columns.empty()) return std::numeric_limits<double>::quiet_NaN();
  double error = 0, scale = 0;
  std::size_t rows = 0;
  for (const std::string& name : columns) {
    const std::vector<double> times = run.times(name), reference_times = reference_->times(name);
    const std::vector<double>&values = run.history.column(name), &wanted = reference_->history.column(name);
    rows = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (times[i] < options_.from || times[i] > options_.to) continue;
      const double expected = interpolated(reference_times, wanted, times[i]);
      if (std::isnan(expected) && times[i] > reference_times.back()) continue;
      // Rows stand for the time up to their neighbours.
      const double width = times[std::min(i + 1, times.size() - 1)] - times[i > 0 ? i - 1 : 0];
      error += width * (values[i] - expected) * (values[i] - expected);
      scale += width * expected * expected;
      ++rows;
    }
  }
  if (rows < 2) throw InputError("no errors: history.csv has fewer than two rows in Errors/Interval");
  return std::sqrt(error / scale);
}

StudyErrors StudyReference::errors(const std::string& folder) const {
  const Results run(folder);
  // The part that a run misses by ending early is not a small error.
  const std::vector<double>& times = reference_->history.column("time");
  const double from = std::max(options_.from, times.front()), to = std::min(options_.to, times.back());
  const double end = run.history.column("time").back();
  if (end < to - 0.05 * (to - from))
    throw InputError(
        fmt::format("no errors: the run ended at {:.6g} T0, before the end of the comparison at {:.6g} T0", end, to));
  const auto either = [&](const std::vector<std::string>& named, const std::vector<std::string>& usual) {
    if (!named.empty()) return relative_distance(run, named);
    std::vector<std::string> both;
    for (const std::string& name : usual)
      if (run.filled(name) && reference_->filled(name)) both.push_back(name);
    return relative_distance(run, both);
  };
  StudyErrors errors;
  if (options_.energy_scale > 0) errors.energy = energy_error(folder) / options_.energy_scale;
  errors.momentum = either({}, {"linear_momentum_x", "linear_momentum_y", "linear_momentum_z"});
  errors.force = either(options_.force, {"contact_force_x", "contact_force_y", "contact_force_z"});
  errors.position = either(options_.position, probe_displacements(run.history));
  return errors;
}

}  // namespace ixos
