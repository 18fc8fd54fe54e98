#include "study/compare/study_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "base/error.hpp"
#include "study/common/run_history.hpp"
#include "study/common/tuning.hpp"

namespace ixos {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

const std::vector<std::string> force_columns{"contact_force_x", "contact_force_y", "contact_force_z"};
const std::vector<std::string> momentum_columns{"linear_momentum_x", "linear_momentum_y", "linear_momentum_z"};
const std::vector<std::string> energy_columns{"kinetic_energy", "elastic_energy", "contact_energy", "external_work"};

}  // namespace

/// A results folder, as far as errors need it.
struct StudyReference::Results {
  explicit Results(const std::string& folder) : source(folder), history(source.table()) {}
  std::vector<double> times(const std::string& column) const { return source.times(column); }
  bool filled(const std::string& name) const {
    return history.has(name) && history.rows() > 0 && !std::isnan(history.column(name).back());
  }
  std::vector<std::string> filled(const std::vector<std::string>& names) const {
    std::vector<std::string> result;
    std::copy_if(names.begin(), names.end(), std::back_inserter(result),
                 [&](const std::string& name) { return filled(name); });
    return result;
  }
  /// Returns the largest magnitude, in the rows from one time to another, of the vector with these components; NaN
  /// without rows. The times of the first component are those of the vector.
  double largest(const std::vector<std::string>& components, double from, double to) const {
    double square = nothing;
    if (components.empty()) return square;
    const std::vector<double> at = times(components.front());
    const double slack = tuning::same_time * (at.back() - at.front());
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (at[i] < from - slack || at[i] > to + slack) continue;
      double sum = 0;
      for (const std::string& name : components) sum += std::pow(history.column(name)[i], 2);
      if (!(sum <= square)) square = std::isnan(sum) ? square : sum;
    }
    return std::sqrt(square);
  }
  /// Returns the change of external_work from one time to another; NaN without that column.
  double work(double from, double to) const {
    if (!history.has("external_work")) return nothing;
    const std::vector<double>&at = history.column("time"), &values = history.column("external_work");
    return interpolated(at, values, to) - interpolated(at, values, from);
  }
  /// Returns the largest magnitude of a value in all columns with these names. A word that ends in an underscore stands
  /// for all names that begin with it.
  double largest_of(const std::vector<std::string>& words) const {
    double result = 0;
    for (const std::string& name : history.names())
      for (const std::string& word : words)
        if (word.back() == '_' ? name.rfind(word, 0) == 0 : name == word)
          for (double value : history.column(name)) result = std::max(result, std::abs(value));
    return result;
  }

  RunHistory source;
  const HistoryTable& history;
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

double relative_difference(double value, double expected) { return std::abs(value - expected) / std::abs(expected); }

}  // namespace

const std::vector<Measure>& measures() {
  static const std::vector<Measure> all{
      {"error_energy", "energy", &StudyErrors::energy}, {"error_momentum", "momentum", &StudyErrors::momentum},
      {"error_force", "force", &StudyErrors::force},    {"error_position", "position", &StudyErrors::position},
      {"peak_error", "peak force", &StudyErrors::peak}, {"work_error", "work", &StudyErrors::work}};
  return all;
}

const Measure& measure(const std::string& column) {
  for (const Measure& known : measures())
    if (column == known.column) return known;
  throw std::invalid_argument("no such error: " + column);
}

StudyReference::StudyReference(const std::string& folder, const ErrorOptions& options)
    : reference_(std::make_unique<Results>(folder)), options_(options) {
  for (const auto* named : {&options.force, &options.position})
    for (const std::string& name : *named) reference_->history.column(name);  // throws if there is none
  find_zeros();
}

StudyReference::~StudyReference() = default;

/// Finds the energy scale, and the measures whose reference is as good as zero.
void StudyReference::find_zeros() {
  const std::vector<double>& times = reference_->history.column("time");
  const double from = std::max(options_.from, times.front()), to = std::min(options_.to, times.back());
  // Not the columns of single interactions, whose forces may cancel.
  const double force = std::max(reference_->largest_of(force_columns), reference_->largest_of({"reaction_"}));
  const double energy = reference_->largest_of(energy_columns);
  const auto judge = [&](const char* column, const char* what, double size, double scale, const char* scale_name) {
    if (!(size <= tuning::negligible * scale)) return;
    const std::string much = size == 0 ? "zero"
                                       : fmt::format("at most {:.2g}, as good as zero beside the largest {}, {:.2g}",
                                                     size, scale_name, scale);
    quality_.notes[column] = fmt::format("{} is blank: the {} of the reference is {}.", column, what, much);
  };
  const auto largest = [&](const std::vector<std::string>& named, const std::vector<std::string>& usual) {
    return reference_->largest(named.empty() ? reference_->filled(usual) : named, from, to);
  };
  const std::vector<std::string> probes = probe_displacements(reference_->history);
  double displacement = 0;
  for (const std::string& name : probes)
    for (double value : reference_->history.column(name)) displacement = std::max(displacement, std::abs(value));
  const double peak = largest(options_.force, force_columns);
  judge("error_force", "force", peak, force, "force");
  judge("peak_error", "force", peak, force, "force");
  judge("error_momentum", "momentum", largest({}, momentum_columns), force * (to - from), "force times the duration");
  judge("error_position", "displacement", largest(options_.position, probes), displacement, "displacement of a probe");
  judge("work_error", "work", std::abs(reference_->work(from, to)), energy, "energy");
  if (options_.energy_scale > 0) return;
  options_.energy_scale = reference_->largest_of({"kinetic_energy"});
  judge("error_energy", "kinetic energy", options_.energy_scale, energy, "energy");
}

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
  if (end < to - tuning::near_end * (to - from))
    throw InputError(
        fmt::format("no errors: the run ended at {:.6g} T0, before the end of the comparison at {:.6g} T0", end, to));
  const auto either = [&](const std::vector<std::string>& named, const std::vector<std::string>& usual) {
    return relative_distance(run, named.empty() ? reference_->filled(run.filled(usual)) : named);
  };
  StudyErrors errors;
  if (options_.energy_scale > 0) errors.energy = run.source.energy_error() / options_.energy_scale;
  errors.momentum = either({}, momentum_columns);
  errors.force = either(options_.force, force_columns);
  errors.position = either(options_.position, probe_displacements(run.history));
  const double last = std::min(to, end);
  const std::vector<std::string> force =
      options_.force.empty() ? reference_->filled(run.filled(force_columns)) : options_.force;
  errors.peak_force = run.largest(force, from, last);
  errors.external_work = run.work(from, last);
  errors.peak = relative_difference(errors.peak_force, reference_->largest(force, from, last));
  errors.work = relative_difference(errors.external_work, reference_->work(from, last));
  for (const Measure& blank : measures())
    if (quality_.notes.count(blank.column) > 0) errors.*blank.error = nothing;
  return errors;
}

void StudyReference::judge(const std::string& folder, const std::string& origin) {
  StudyErrors own = errors(folder);
  own.energy = nothing;
  bool equal = true;
  for (const Measure& compared : measures()) equal = equal && !(own.*compared.error > 0);
  if (equal) {
    quality_.unknown = fmt::format("{} gives exactly the results of the reference", origin);
    return;
  }
  quality_.origin = origin;
  quality_.own = own;
  for (const Measure& compared : measures())
    if (own.*compared.error > tuning::too_uncertain)
      quality_.notes[compared.column] =
          fmt::format("{} is blank: {} differs from the reference by {:.2g} of the reference's {}.", compared.column,
                      origin, own.*compared.error, compared.quantity);
}

}  // namespace ixos
