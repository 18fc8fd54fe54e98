#include "study/study_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "scene/scene_file.hpp"
#include "study/history_table.hpp"
#include "time/catalogue.hpp"

namespace ixos {
namespace {

/// A results folder, as far as errors need it.
struct Results {
  explicit Results(const std::string& folder) : history(folder + "/history.csv") {
    const Teuchos::ParameterList scene = read_scene_file(folder + "/effective.xml");
    const Teuchos::ParameterList& integrator = scene.sublist("Time Integrator");
    const Scheme& chosen = scheme(integrator.get<std::string>("Type"));
    step_means = chosen.table(integrator.sublist(chosen.name)).closing == Closing::Collocate;
  }
  /// The times that a column's values belong to.
  std::vector<double> times(const std::string& column) const {
    std::vector<double> result = history.column("time");
    if (!step_means || column.rfind("reaction_", 0) != 0) return result;
    const std::vector<double>& step = history.column("time_step");
    for (std::size_t i = 1; i < result.size(); ++i) result[i] -= step[i] / 2;
    return result;
  }

  HistoryTable history;
  bool step_means;
};

/// rms in time of the columns' distance from the reference, over the reference's own rms there.
double relative_distance(const Results& run, const Results& reference, const std::vector<std::string>& columns,
                         const ErrorOptions& options) {
  double error = 0, scale = 0;
  std::size_t rows = 0;
  for (const std::string& name : columns) {
    const std::vector<double> times = run.times(name), reference_times = reference.times(name);
    const std::vector<double>&values = run.history.column(name), &wanted = reference.history.column(name);
    rows = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (times[i] < options.from || times[i] > options.to) continue;
      const double expected = interpolated(reference_times, wanted, times[i]);
      if (std::isnan(expected) && times[i] > reference_times.back()) continue;
      // Rows stand for the time up to their neighbours.
      const double width = times[std::min(i + 1, times.size() - 1)] - times[i > 0 ? i - 1 : 0];
      error += width * (values[i] - expected) * (values[i] - expected);
      scale += width * expected * expected;
      ++rows;
    }
  }
  if (columns.empty()) return std::numeric_limits<double>::quiet_NaN();
  if (rows < 2) throw InputError("Errors/Interval: a run has fewer than two rows there");
  return std::sqrt(error / scale);
}

std::vector<std::string> present(const HistoryTable& history, const std::vector<std::string>& names) {
  std::vector<std::string> result;
  for (const std::string& name : names)
    if (history.has(name) && history.rows() > 0 && !std::isnan(history.column(name).back())) result.push_back(name);
  return result;
}

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
  std::ifstream file(folder + "/summary.json");
  const nlohmann::json summary = nlohmann::json::parse(file, nullptr, false);
  if (summary.is_discarded() || !summary.contains("max_energy_error"))
    throw FileError(folder + "/summary.json: cannot be read");
  const auto& error = summary["max_energy_error"];
  return error.is_number() ? error.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

StudyErrors study_errors(const std::string& folder, const std::string& reference_folder, const ErrorOptions& options) {
  const Results run(folder), reference(reference_folder);
  const auto distance = [&](const std::vector<std::string>& columns) {
    return relative_distance(run, reference, columns, options);
  };
  StudyErrors errors;
  double scale = options.energy_scale;
  if (scale == 0)
    for (double energy : reference.history.column("kinetic_energy"))
      if (energy > scale) scale = energy;
  if (scale > 0) errors.energy = energy_error(folder) / scale;
  errors.momentum = distance(present(run.history, {"linear_momentum_x", "linear_momentum_y", "linear_momentum_z"}));
  errors.force =
      distance(options.force.empty() ? present(run.history, {"contact_force_x", "contact_force_y", "contact_force_z"})
                                     : options.force);
  errors.position = distance(options.position.empty() ? probe_displacements(run.history) : options.position);
  return errors;
}

}  // namespace ixos
