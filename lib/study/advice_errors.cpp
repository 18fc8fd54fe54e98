#include "study/advice_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ixos {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();
constexpr double order_of_schemes = 2;

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
    if (!sample.good) failed_.push_back(sample.point);
  }
  exact_ = base_values_;
  for (std::size_t d = 0; d < directions.all.size(); ++d) {
    std::vector<Line>& lines = lines_.emplace_back();
    const bool by_pairs = !directions.all[d].converges;
    for (std::size_t b = 0; b < directions.all[d].branches.size(); ++b)
      lines.push_back(by_pairs ? pairs(d, b, samples) : line(d, b, samples));
    if (by_pairs) continue;
    for (std::size_t q = 0; q < quantities; ++q) judge(d, q);
  }
  for (std::size_t q = 0; q < quantities; ++q)
    if (is_error_[q]) exact_[q] = 0;
  measure_interaction(samples);
}

/// Returns the good runs of a branch with everything else at the base, the coarsest first.
AdviceErrors::Line AdviceErrors::line(std::size_t d, std::size_t b, const std::vector<AdviceSample>& samples) const {
  Line line;
  line.points.resize(is_error_.size());
  const AdviceBranch& branch = directions_.all[d].branches[b];
  for (std::size_t level = 0; level < branch.levels.size(); ++level) {
    AdvicePoint point = base_;
    point[d] = {b, level};
    for (const AdviceSample& sample : samples) {
      if (!sample.good || sample.point != point) continue;
      line.levels.push_back(level);
      for (std::size_t q = 0; q < is_error_.size(); ++q)
        line.points[q].push_back({branch.levels[level].size, sample.values[q]});
      break;
    }
  }
  return line;
}

/// Returns the largest differences of runs that differ in the branch of a direction alone.
AdviceErrors::Line AdviceErrors::pairs(std::size_t d, std::size_t b, const std::vector<AdviceSample>& samples) const {
  Line line;
  line.errors.resize(is_error_.size());
  for (SequenceErrors& errors : line.errors) {
    errors.errors = {0};
    errors.reason = "the scene's own counts as exact";
  }
  if (b == 0) line.levels = {0};
  for (const AdviceSample& sample : samples) {
    if (!sample.good || b == 0 || sample.point[d].branch != b) continue;
    AdvicePoint twin = sample.point;
    twin[d] = {0, 0};
    for (const AdviceSample& other : samples) {
      if (!other.good || other.point != twin) continue;
      line.levels = {0};
      for (std::size_t q = 0; q < is_error_.size(); ++q) {
        double& largest = line.errors[q].errors[0];
        largest = std::max(largest, std::abs(sample.values[q] - other.values[q]));
      }
    }
  }
  return line;
}

/// Judges the branches of a direction for a quantity, and moves the exact value by what the direction adds.
void AdviceErrors::judge(std::size_t d, std::size_t q) {
  std::vector<Line>& lines = lines_[d];
  SequenceErrors own;
  const std::vector<SequencePoint>& points = lines[0].points[q];
  const bool refined = directions_.all[d].converges && directions_.all[d].branches[0].levels.size() > 1;
  if (is_error_[q] && d == time_direction) {
    own.errors = errors_against(points, 0, 0);
    own.reason = "the quantity is an error itself";
  } else if (is_error_[q] || !refined) {
    own.limit = base_values_[q];
    own.errors = errors_against(points, own.limit, 0);
    own.reason = is_error_[q] ? "changes of the base" : "not examined";
  } else if (points.size() > 1) {
    own = sequence_errors(points);
    exact_[q] += own.limit - base_values_[q];
  } else {
    own.limit = base_values_[q];
    own.limit_uncertainty = unknown;
    own.errors.assign(points.size(), unknown);
    own.reason = "one size only";
  }
  lines[0].errors.push_back(own);
  for (std::size_t b = 1; b < lines.size(); ++b) judge_branch(d, b, q);
}

/// Compares another branch with the limit of the scene's own. Its errors count as falling at most with the order of the
/// schemes: a smaller one at its finest point is a coincidence.
void AdviceErrors::judge_branch(std::size_t d, std::size_t b, std::size_t q) {
  const SequenceErrors& own = lines_[d][0].errors[q];
  Line& line = lines_[d][b];
  const std::vector<SequencePoint>& points = line.points[q];
  SequenceErrors errors;
  errors.errors = errors_against(points, own.limit, own.limit_uncertainty);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double least = std::pow(points[i].size / points[i - 1].size, order_of_schemes);
    errors.errors[i] = std::max(errors.errors[i], least * errors.errors[i - 1]);
  }
  line.errors.push_back(errors);
}

double AdviceErrors::part(std::size_t d, std::size_t q, const AdvicePlace& place) const {
  const Line& line = lines_[d][place.branch];
  const AdviceDirection& direction = directions_.all[d];
  if (line.levels.empty()) return unknown;
  if (!direction.converges) return line.errors[q].errors.back();
  // One run of another branch may be near the limit by coincidence, and beyond its runs nothing is known.
  if (place.branch > 0 && (line.levels.size() < 2 || place.level > line.levels.back())) return unknown;
  return error_at(line.points[q], line.errors[q], direction.branches[place.branch].levels[place.level].size);
}

/// Compares the runs off the lines with the sums of the changes in step and mesh.
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
        if (found == line.levels.end() || !directions_.all[d].converges)
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

double AdviceErrors::interaction(const AdvicePoint& point, std::size_t quantity) const {
  if (distance(point, base_) < 2) return 0;
  double largest = 0, smallest_of_coarser = unknown;
  for (const Defect& defect : defects_) {
    const double here = defect.relative[quantity];
    if (defect.point == point) return here;
    largest = std::max(largest, here);
    bool coarser = true;
    for (std::size_t d = 0; d < point.size(); ++d)
      coarser = coarser && defect.point[d].branch == point[d].branch && defect.point[d].level <= point[d].level;
    if (coarser) smallest_of_coarser = std::min(smallest_of_coarser, here);
  }
  return std::isfinite(smallest_of_coarser) ? smallest_of_coarser : largest;
}

AdviceEstimate AdviceErrors::estimate(const AdvicePoint& point) const {
  AdviceEstimate result;
  const bool failed = std::find(failed_.begin(), failed_.end(), point) != failed_.end();
  for (std::size_t q = 0; q < is_error_.size(); ++q) {
    double sum = noise_[q] + interaction(point, q);
    std::vector<double>& parts = result.parts.emplace_back();
    for (std::size_t d = 0; d < point.size(); ++d) {
      parts.push_back(part(d, q, point[d]) / scale(q));
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

double AdviceErrors::finest_error(std::size_t direction, std::size_t branch) const {
  const Line& line = lines_[direction][branch];
  if (line.levels.empty()) return unknown;
  double largest = 0;
  for (std::size_t q = 0; q < is_error_.size(); ++q)
    largest = std::max(largest, line.errors[q].errors.back() / scale(q));
  return largest;
}

std::string AdviceErrors::reason(std::size_t direction, std::size_t quantity) const {
  return lines_[direction][0].errors[quantity].reason;
}

std::size_t AdviceErrors::tested(std::size_t direction, std::size_t branch) const {
  return lines_[direction][branch].levels.size();
}

std::size_t AdviceErrors::finest(std::size_t direction, std::size_t branch) const {
  return lines_[direction][branch].levels.empty() ? 0 : lines_[direction][branch].levels.back();
}

}  // namespace ixos
