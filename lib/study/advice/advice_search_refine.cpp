#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "study/advice/advice_search.hpp"
#include "study/common/tuning.hpp"

namespace ixos {
namespace {

/// Returns the largest error of a base. Two relative errors interact by about their product, which should be a part of
/// the tolerance.
double largest_base_error(double tolerance) { return std::sqrt(tolerance) / 2; }

}  // namespace

/// Runs the next finer level of a direction at the base. Returns whether it reached its end; if not, obstacle_ says
/// why, unless it has an earlier reason of this round.
bool AdviceSearch::extend(std::size_t d) {
  const std::size_t level = errors().finest(d, own(d)) + 1;
  if (level >= levels(d)) {
    meets(fmt::format("The {} has no finer level.", directions_.all[d].name));
    return false;
  }
  const AdvicePoint next = moved(d, level);
  if (runs_.sample(next) == nullptr) {
    const double seconds = costs().seconds(next);
    if (!(d <= mesh_direction ? runs_.may_afford(seconds) : runs_.affords(seconds))) {
      meets(fmt::format("The next run ({}) should take {:.2g} s, and the budget has {:.2g} s left.",
                        description_of(directions_, next), seconds, std::max(0.0, runs_.budget() - runs_.spent())));
      return false;
    }
    runs_.carry_out({next});
  }
  const AdviceSample* sample = runs_.sample(next);
  if (!sample->good)
    meets(fmt::format("A finer run ({}) failed: {}.", description_of(directions_, next), sample->reason));
  return sample->good;
}

/// Notes what stops a round; its first obstacle is that of the largest error.
void AdviceSearch::meets(const std::string& obstacle) {
  if (obstacle_.empty()) obstacle_ = obstacle;
}

/// Extends the line of step or mesh. If the finer run fails, the base moves in the other direction, twice at most: with
/// a shorter step a finer mesh may reach its end. Returns whether anything changed.
bool AdviceSearch::extend_or_move(std::size_t d) {
  if (extend(d)) return true;
  if (d > mesh_direction) return false;
  const std::size_t level = errors().finest(d, own(d)) + 1,
                    other = d == time_direction ? mesh_direction : time_direction;
  if (level >= levels(d) || runs_.sample(moved(d, level)) == nullptr) return false;
  const std::vector<AdviceSample>& all = runs_.samples();
  const auto failed = [&](const AdviceSample& sample) {
    return !sample.good && sample.point[d].level == level && sample.point[d].branch == own(d) &&
           sample.point[other].branch == own(other);
  };
  if (std::count_if(all.begin(), all.end(), failed) > tuning::most_failures_of_a_level) return false;
  const bool more = finer_base(other).empty() && extend(other);
  if (move_base({other})) {
    last_part_[d] = std::numeric_limits<double>::infinity();  // that of the old base
    return true;
  }
  return more;
}

/// Returns whether the line of a direction has enough points, as far as there are levels. A run tells its own error if
/// all quantities are errors.
bool AdviceSearch::has_line(std::size_t d) const {
  if (std::all_of(is_error_.begin(), is_error_.end(), [](bool is_error) { return is_error; })) return true;
  const std::size_t first = d == mesh_direction ? coarsest_mesh_ : 0;
  const AdviceErrors known = errors();
  // Elements of a higher order are judged by those that were refined before, too.
  const std::size_t least = d == mesh_direction && own(d) != 0 && known.tested(d, 0) >= tuning::least_points_of_a_line
                                ? 2
                                : tuning::least_points_of_a_line;
  return known.tested(d, own(d)) >= std::min(least, levels(d) - first);
}

/// Returns whether the error of a direction at the base is so large that it may change those of other directions.
bool AdviceSearch::is_base_coarse(std::size_t d) const {
  for (const std::vector<double>& parts : errors().estimate(base_).parts)
    if (!(parts[d] <= largest_base_error(question_.tolerance))) return true;
  return false;
}

/// Returns whether the error of a direction at a point is so small that even a coarse base measures it well enough.
bool AdviceSearch::is_negligible(const AdvicePoint& point, std::size_t d) const {
  for (const std::vector<double>& parts : errors().estimate(point).parts)
    if (!(parts[d] <= tuning::negligible_part * question_.tolerance)) return false;
  return true;
}

/// Returns whether the base should be finer in a direction for the sake of the errors of another.
bool AdviceSearch::spoils(std::size_t d, std::size_t other) const {
  return is_base_coarse(d) && !is_negligible(base_, other);
}

/// Returns the runs that the line of a direction through another base needs, and that were not carried out: the base
/// and the finest levels that the present line has.
std::vector<AdvicePoint> AdviceSearch::missing_line(const AdvicePoint& base, std::size_t d) const {
  std::vector<std::size_t> wanted = errors().levels(d, own(d));
  wanted.erase(wanted.begin(),
               wanted.end() - static_cast<long>(std::min(tuning::most_points_of_a_line, wanted.size())));
  wanted.push_back(base[d].level);
  std::vector<AdvicePoint> missing;
  for (std::size_t level : wanted) {
    AdvicePoint point = base;
    point[d].level = level;
    if (runs_.sample(point) == nullptr) missing.push_back(point);
  }
  return missing;
}

/// Returns the next finer base in a direction; none if the line does not reach it.
AdvicePoint AdviceSearch::finer_base(std::size_t d) const {
  const AdvicePoint next = moved(d, base_[d].level + 1);
  if (next[d].level > errors().finest(d, own(d))) return {};
  const AdviceSample* sample = runs_.sample(next);
  return sample != nullptr && sample->good ? next : AdvicePoint();
}

/// Moves the base to the next finer level of one of some directions, whichever needs the cheaper runs. Returns whether
/// it moved.
bool AdviceSearch::move_base(const std::vector<std::size_t>& directions) {
  const AdviceCosts cost = costs();
  std::vector<AdvicePoint> cheapest;
  AdvicePoint best;
  double least = 0;
  for (std::size_t d : directions) {
    const AdvicePoint next = finer_base(d);
    if (next.empty()) continue;
    const std::vector<AdvicePoint> missing = missing_line(next, d == time_direction ? mesh_direction : time_direction);
    double seconds = 0;
    for (const AdvicePoint& point : missing) seconds += cost.seconds(point);
    if (!best.empty() && seconds >= least) continue;
    best = next;
    cheapest = missing;
    least = seconds;
  }
  if (best.empty() || !runs_.affords(least)) return false;
  runs_.carry_out(cheapest);
  base_ = best;
  return true;
}

/// Returns the largest part of the error that a direction has at its finest level.
double AdviceSearch::finest_part(std::size_t d) const {
  const AdviceErrors known = errors();
  double most = 0;
  for (const std::vector<double>& parts : known.estimate(moved(d, known.finest(d, own(d)))).parts)
    most = std::max(most, parts[d]);
  return most;
}

/// Refines a direction once more. If its sequence has no order, or the last refinement did not help, it does not
/// converge at this base: coarse meshes ripple. Then it is measured at a base that is finer in the other direction, if
/// that has an error to speak of.
bool AdviceSearch::refine_line(std::size_t d) {
  const double part = finest_part(d);
  const AdviceErrors known = errors();
  const bool irregular = !known.has_order(d) && known.tested(d, own(d)) >= tuning::least_points_of_a_line,
             futile = part > tuning::helpful * last_part_[d];
  const std::size_t other = d == time_direction ? mesh_direction : time_direction;
  if ((irregular || futile) && d <= mesh_direction && !is_negligible(base_, other) && move_base({other})) {
    last_part_[d] = std::numeric_limits<double>::infinity();
    return true;
  }
  last_part_[d] = part;
  return extend_or_move(d);
}

/// Reduces the largest part of the error that the finest settings of all lines have. Returns whether anything changed.
bool AdviceSearch::sharpen() {
  const AdviceErrors known = errors();
  AdvicePoint corner = base_;
  for (std::size_t d = 0; d < corner.size(); ++d) corner[d].level = known.finest(d, own(d));
  const AdviceEstimate estimate = known.estimate(corner);
  const std::size_t q = estimate.worst_quantity();
  const std::vector<double>& parts = estimate.parts[q];
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return parts[a] > parts[b]; });
  if (known.interaction(corner, q) > parts[order.front()] && move_base({time_direction, mesh_direction})) return true;
  for (std::size_t d : order) {
    if (!directions_.all[d].converges) continue;
    if (d <= mesh_direction && try_before(d)) return true;
    if (refine_line(d)) return true;
    if (parts[d] > question_.tolerance) return false;
  }
  return false;
}

/// Runs the next level of a direction whose error must be measured. Returns whether there was one.
bool AdviceSearch::examine_suspects() {
  const AdviceErrors known = errors();
  for (std::size_t d = mesh_direction + 1; d < directions_.all.size(); ++d)
    if (directions_.all[d].suspect && known.finest(d, own(d)) == directions_.all[d].scene_level && extend(d))
      return true;
  return false;
}

/// Refines until settings keep the tolerance.
AdviceStatus AdviceSearch::refine() {
  for (std::size_t round = 0; round < tuning::most_rounds; ++round) {
    obstacle_.clear();
    // Chaos may show on finer meshes, or with some steps, only.
    if (needs_perturbation(base_) && !is_predictable(base_)) return AdviceStatus::Chaotic;
    if (!has_line(time_direction) || !has_line(mesh_direction)) {
      if (extend_or_move(has_line(time_direction) ? mesh_direction : time_direction)) continue;
      break;
    }
    if (examine_suspects()) continue;
    if (adopt_better_cells()) continue;
    if (spoils(mesh_direction, time_direction) && move_base({mesh_direction})) continue;
    if (spoils(time_direction, mesh_direction) && move_base({time_direction})) continue;
    const std::vector<AdviceCandidate> all = candidates(directions_, errors(), costs(), 0);
    if (cheapest_within(all, question_.tolerance) != nullptr) return AdviceStatus::Advised;
    if (!sharpen()) break;
  }
  problem_ = obstacle_.empty() ? "No refinement reduces the error." : obstacle_;
  return AdviceStatus::Unreachable;
}

}  // namespace ixos
