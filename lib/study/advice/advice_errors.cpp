#include "study/advice/advice_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "study/common/tuning.hpp"

namespace ixos {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

template <class Range>
std::size_t place_of_largest(const Range& values) {
  return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
}

}  // namespace

double AdviceEstimate::largest() const { return *std::max_element(errors.begin(), errors.end()); }
std::size_t AdviceEstimate::worst_quantity() const { return place_of_largest(errors); }
std::size_t AdviceEstimate::worst_direction() const { return place_of_largest(parts[worst_quantity()]); }

AdviceErrors::AdviceErrors(const AdviceDirections& directions, AdvicePoint base,
                           const std::vector<AdviceSample>& samples, std::vector<bool> is_error,
                           std::vector<double> noise)
    : directions_(directions), base_(std::move(base)), is_error_(std::move(is_error)), noise_(std::move(noise)) {
  const std::size_t quantities = is_error_.size();
  base_values_.assign(quantities, std::numeric_limits<double>::quiet_NaN());
  for (const AdviceSample& sample : samples) {
    if (sample.good && sample.point == base_) base_values_ = sample.values;
    if (sample.good)
      good_.push_back(sample);
    else
      failed_.push_back(sample.point);
  }
  exact_ = base_values_;
  for (std::size_t d = 0; d < directions.all.size(); ++d) {
    std::vector<Line>& lines = lines_.emplace_back();
    examined_.emplace_back(quantities, true);
    const Line direct = line(d, own(d), {}, samples);  // there is nothing to compare with elsewhere
    const Line leading = line(d, own(d), direct, samples);
    for (std::size_t b = 0; b < directions.all[d].branches.size(); ++b)
      lines.push_back(b == own(d) ? leading : line(d, b, leading, samples));
    for (std::size_t q = 0; q < quantities; ++q) judge(d, q);
  }
  for (std::size_t q = 0; q < quantities; ++q)
    if (is_error_[q]) exact_[q] = 0;
  measure_interaction(samples);
}

/// Judges the branches of a direction for a quantity, and moves the exact value by what the direction adds.
void AdviceErrors::judge(std::size_t d, std::size_t q) {
  std::vector<Line>& lines = lines_[d];
  SequenceErrors own;
  const std::size_t leading = this->own(d);
  const std::vector<SequencePoint>& points = lines[leading].points[q];
  const AdviceDirection& direction = directions_.all[d];
  const bool refined = direction.converges && direction.branches[leading].levels.size() > 1;
  const bool unexamined = d > mesh_direction && finest(d, leading) <= direction.scene_level;
  if (is_error_[q] && d == time_direction) {
    own.errors = errors_against(points, 0, 0);
    own.reason = "the quantity is an error itself";
  } else if (is_error_[q] || !refined || unexamined) {
    own.limit = base_values_[q];
    own.errors = errors_against(points, own.limit, 0);
    const bool is_choice = !direction.converges || (d > mesh_direction && points.size() > 1);
    const bool changes = is_error_[q] && !unexamined && points.size() > 1;
    own.reason = is_choice ? "the scene's own counts as exact" : changes ? "changes of the base" : not_examined;
    examined_[d][q] = !direction.converges || changes;
  } else if (points.size() > 1) {
    own = sequence_errors(points, true);
    if (points.size() == 2) doubt_two_sizes(d, q, own);
    share_limit(d, q, own);
    exact_[q] += own.limit - base_values_[q];
  } else {
    own.limit = base_values_[q];
    own.limit_uncertainty = unknown;
    own.errors.assign(points.size(), unknown);
    own.reason = "one size only";
  }
  lines[leading].errors.push_back(own);
  for (std::size_t b = 0; b < lines.size(); ++b)
    if (b != leading) judge_branch(d, b, q);
}

/// Raises the uncertainty of a limit that two sizes give to a part of the distance of another branch with the same
/// exact solution: two coarse runs may agree by coincidence.
void AdviceErrors::doubt_two_sizes(std::size_t d, std::size_t q, SequenceErrors& own) const {
  for (std::size_t b = 0; b < lines_[d].size(); ++b) {
    const Line& other = lines_[d][b];
    if (b == this->own(d) || !directions_.all[d].branches[b].same_limit || other.levels.size() < 3) continue;
    const double limit = sequence_errors(other.points[q], true).limit;  // or the finest value
    for (double value : {other.points[q].back().value, limit})
      own.limit_uncertainty = std::max(own.limit_uncertainty, tuning::doubted_part * std::abs(value - own.limit));
  }
  own.errors = errors_against(lines_[d][this->own(d)].points[q], own.limit, own.limit_uncertainty);
}

/// Replaces the limit of the base's own branch by that of another branch with the same exact solution that knows it
/// better. If limits differ by more than their uncertainties, the uncertainty grows by the rest.
void AdviceErrors::share_limit(std::size_t d, std::size_t q, SequenceErrors& own) const {
  const std::vector<Line>& lines = lines_[d];
  std::vector<std::pair<double, double>> limits{{own.limit_uncertainty, own.limit}};
  const std::size_t leading = this->own(d);
  std::size_t best = leading;
  for (std::size_t b = 0; b < lines.size(); ++b) {
    if (b == leading || !directions_.all[d].branches[b].same_limit || lines[b].levels.size() < 3) continue;
    const SequenceErrors other = sequence_errors(lines[b].points[q], true);
    if (other.order == 0) continue;
    limits.emplace_back(other.limit_uncertainty, other.limit);
    if (other.limit_uncertainty < own.limit_uncertainty) best = b;
    own.limit_uncertainty = std::min(own.limit_uncertainty, other.limit_uncertainty);
  }
  if (best == leading) return;
  const auto [least, limit] = *std::min_element(limits.begin(), limits.end());
  double uncertainty = least;
  for (const auto& [other_uncertainty, other_limit] : limits)
    uncertainty = std::max(uncertainty, std::abs(other_limit - limit) - other_uncertainty);
  own.limit = limit;
  own.limit_uncertainty = uncertainty;
  own.errors = errors_against(lines[leading].points[q], limit, uncertainty);
  own.reason += "; the limit is that of " + directions_.all[d].branches[best].label;
}

/// Compares another branch with the limit of the base's own. Its errors count as falling at most with the order of the
/// schemes: a smaller one at its finest point is a coincidence.
void AdviceErrors::judge_branch(std::size_t d, std::size_t b, std::size_t q) {
  const SequenceErrors& own = lines_[d][this->own(d)].errors[q];
  Line& line = lines_[d][b];
  const std::vector<SequencePoint>& points = line.points[q];
  SequenceErrors errors;
  errors.errors = errors_against(points, own.limit, own.limit_uncertainty);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double least = std::pow(points[i].size / points[i - 1].size, tuning::order_of_schemes);
    errors.errors[i] = std::max(errors.errors[i], least * errors.errors[i - 1]);
  }
  line.errors.push_back(errors);
}

double AdviceErrors::part(std::size_t d, std::size_t q, const AdvicePlace& place) const {
  const Line& line = lines_[d][place.branch];
  const AdviceDirection& direction = directions_.all[d];
  if (line.levels.empty()) return unknown;
  if (!direction.converges) return with_model(d, q, place, line.errors[q].errors.back());
  // One run of another branch may be near the limit by coincidence, and beyond its runs nothing is known.
  if (place.branch != own(d) && (line.levels.size() < 2 || place.level > line.levels.back())) return unknown;
  return with_model(
      d, q, place, error_at(line.points[q], line.errors[q], direction.branches[place.branch].levels[place.level].size));
}

/// Compares the runs off the lines with the sums of the changes along the lines.
void AdviceErrors::measure_interaction(const std::vector<AdviceSample>& samples) {
  for (const AdviceSample& sample : samples) {
    if (!sample.good || distance(sample.point, base_) < 2) continue;
    Defect defect{sample.point, {}};
    for (std::size_t q = 0; q < is_error_.size(); ++q) {
      double sum = base_values_[q];
      for (std::size_t d = 0; d < base_.size(); ++d) {
        if (sample.point[d] == base_[d]) continue;
        const Line& line = lines_[d][sample.point[d].branch];
        const auto found = std::find(line.levels.begin(), line.levels.end(), sample.point[d].level);
        if (found == line.levels.end())
          sum = std::numeric_limits<double>::quiet_NaN();
        else
          sum += line.points[q][static_cast<std::size_t>(found - line.levels.begin())].value - base_values_[q];
      }
      defect.relative.push_back(std::abs(sample.values[q] - sum) / scale(q));
    }
    const auto unknown_one = [](double value) { return std::isnan(value); };
    if (std::none_of(defect.relative.begin(), defect.relative.end(), unknown_one))
      defects_.push_back(std::move(defect));
  }
}

/// Returns whether a point is in every direction on the same branch as another, on the same side of the base, and at
/// least as far from it.
bool AdviceErrors::is_farther(const AdvicePoint& far, const AdvicePoint& near) const {
  for (std::size_t d = 0; d < base_.size(); ++d) {
    const auto offset = [&](const AdvicePoint& point) {
      return static_cast<int>(point[d].level) - static_cast<int>(base_[d].level);
    };
    const int a = offset(far), b = offset(near);
    if (far[d].branch != near[d].branch || (b < 0 && a > b) || (b > 0 && a < b)) return false;
  }
  return true;
}

double AdviceErrors::interaction(const AdvicePoint& point, std::size_t quantity) const {
  if (distance(point, base_) < 2) return 0;
  double largest = 0, smallest_of_farther = unknown;
  for (const Defect& defect : defects_) {
    const double here = defect.relative[quantity];
    if (defect.point == point) return here;
    largest = std::max(largest, here);
    if (is_farther(defect.point, point)) smallest_of_farther = std::min(smallest_of_farther, here);
  }
  return std::isfinite(smallest_of_farther) ? smallest_of_farther : largest;
}

/// Returns the change of a quantity by twice the step with everything else as at a point; 0 if a run is missing.
double AdviceErrors::change_by_step(const AdvicePoint& point, std::size_t q) const {
  if (point[time_direction].level == 0 || is_error_[q]) return 0;
  AdvicePoint twin = point;
  --twin[time_direction].level;
  const AdviceSample *here = nullptr, *there = nullptr;
  for (const AdviceSample& sample : good_) {
    if (sample.point == point) here = &sample;
    if (sample.point == twin) there = &sample;
  }
  return here == nullptr || there == nullptr ? 0 : std::abs(here->values[q] - there->values[q]);
}

AdviceErrors AdviceErrors::hopeful(std::size_t direction) const {
  AdviceErrors result = *this;
  Line& line = result.lines_[direction][own(direction)];
  for (std::size_t q = 0; q < line.errors.size(); ++q) {
    SequenceErrors& own = line.errors[q];
    own.limit_uncertainty *= tuning::hoped_part;
    own.errors = errors_against(line.points[q], own.limit, own.limit_uncertainty);
  }
  return result;
}

AdviceEstimate AdviceErrors::estimate(const AdvicePoint& point) const {
  AdviceEstimate result;
  const bool failed = std::find(failed_.begin(), failed_.end(), point) != failed_.end();
  for (std::size_t q = 0; q < is_error_.size(); ++q) {
    double sum = noise_[q] + interaction(point, q);
    std::vector<double>& parts = result.parts.emplace_back();
    for (std::size_t d = 0; d < point.size(); ++d) {
      const double here = d == time_direction ? tuning::part_of_change * change_by_step(point, q) : 0;
      parts.push_back(std::max(part(d, q, point[d]), here) / scale(q));
      sum += parts.back();
    }
    result.errors.push_back(failed || std::isnan(sum) ? unknown : sum);
  }
  for (std::size_t d = 0; d < point.size(); ++d) {
    const Line& line = lines_[d][point[d].branch];
    if (!line.levels.empty() && point[d].level > line.levels.back())
      result.beyond = std::max(result.beyond, point[d].level - line.levels.back());
  }
  return result;
}

double AdviceErrors::scale(std::size_t q) const { return is_error_[q] ? 1 : std::abs(exact_[q]); }

double AdviceErrors::finest_error(std::size_t direction, std::size_t branch, std::size_t quantity) const {
  const Line& line = lines_[direction][branch];
  if (line.levels.empty()) return unknown;
  const double error = line.errors[quantity].errors.back();
  return with_model(direction, quantity, {branch, line.levels.back()}, error) / scale(quantity);
}

double AdviceErrors::limit_uncertainty(std::size_t direction, std::size_t quantity) const {
  return lines_[direction][own(direction)].errors[quantity].limit_uncertainty / scale(quantity);
}

std::string AdviceErrors::reason(std::size_t direction, std::size_t quantity) const {
  return lines_[direction][own(direction)].errors[quantity].reason;
}

bool AdviceErrors::has_order(std::size_t direction) const {
  const std::vector<SequenceErrors>& errors = lines_[direction][own(direction)].errors;
  for (std::size_t q = 0; q < errors.size(); ++q)
    if (!is_error_[q] && errors[q].order == 0 && errors[q].limit_uncertainty > 0) return false;
  return true;
}

std::size_t AdviceErrors::tested(std::size_t direction, std::size_t branch) const {
  return lines_[direction][branch].levels.size();
}

const std::vector<std::size_t>& AdviceErrors::levels(std::size_t direction, std::size_t branch) const {
  return lines_[direction][branch].levels;
}

std::size_t AdviceErrors::finest(std::size_t direction, std::size_t branch) const {
  return lines_[direction][branch].levels.empty() ? 0 : lines_[direction][branch].levels.back();
}

}  // namespace ixos
