#include "study/advice/advice_costs.hpp"

#include <algorithm>
#include <cmath>

#include "study/common/tuning.hpp"

namespace ixos {
namespace {

/// Returns whether a place has the scene's own cost but for its steps and degrees of freedom.
bool is_own(const AdviceDirections& directions, const AdvicePoint& point, std::size_t d) {
  return point[d].branch == 0 && (d <= mesh_direction || point[d].level == directions.all[d].scene_level);
}

/// Returns the degrees of freedom of a branch over those of the first one on the same mesh.
double dofs_of_cells(const AdviceDirections& directions, std::size_t branch) {
  return directions.all[mesh_direction].branches[branch].higher_order ? std::pow(2.0, directions.dimension) : 1;
}

/// Returns the seconds of a run's steps, without its start; all seconds if they are not known apart.
double loop_seconds(const AdviceSample& sample) {
  const double loop = sample.seconds_per_step * sample.steps;
  return loop > 0 ? std::min(loop, sample.seconds) : sample.seconds;
}

/// Returns in how many directions a point is not the scene's own; the last of them is `direction`.
std::size_t others(const AdviceDirections& directions, const AdvicePoint& point, std::size_t& direction) {
  std::size_t count = 0;
  for (std::size_t d = 0; d < point.size(); ++d) {
    if (is_own(directions, point, d)) continue;
    direction = d;
    ++count;
  }
  return count;
}

}  // namespace

AdviceCosts::AdviceCosts(const AdviceDirections& directions, const std::vector<AdviceSample>& samples)
    : directions_(directions) {
  std::vector<double> starts;
  for (const AdviceSample& sample : samples) {
    // A run that was ended tells nothing of the whole.
    if (!((sample.good || sample.reached_end) && sample.steps > 0 && sample.dofs > 0 && sample.seconds > 0)) continue;
    samples_.push_back(sample);
    starts.push_back(sample.seconds - loop_seconds(sample));
  }
  if (!starts.empty()) {
    const auto middle = starts.begin() + static_cast<std::ptrdiff_t>(starts.size() / 2);
    std::nth_element(starts.begin(), middle, starts.end());
    start_ = *middle;
  }
  std::vector<CostSample> own;
  for (const AdviceSample& sample : samples_) {
    std::size_t direction = 0;
    if (others(directions, sample.point, direction) == 0)
      own.push_back({sample.steps, sample.dofs, loop_seconds(sample)});
  }
  model_ = fit_costs(own);
  // Geometric means of the runs that differ from the scene's own in one choice.
  std::vector<std::vector<std::vector<double>>> counts;
  for (const AdviceDirection& direction : directions.all) {
    factors_.emplace_back();
    for (const AdviceBranch& branch : direction.branches) factors_.back().emplace_back(branch.levels.size(), 0);
  }
  counts = factors_;
  for (const AdviceSample& sample : samples_) {
    std::size_t d = 0;
    if (others(directions, sample.point, d) != 1) continue;
    const std::size_t level = d <= mesh_direction ? 0 : sample.point[d].level, branch = sample.point[d].branch;
    factors_[d][branch][level] += std::log(loop_seconds(sample) / model_.seconds(sample.steps, sample.dofs));
    ++counts[d][branch][level];
  }
  for (std::size_t d = 0; d < factors_.size(); ++d)
    for (std::size_t b = 0; b < factors_[d].size(); ++b)
      for (std::size_t level = 0; level < factors_[d][b].size(); ++level)
        factors_[d][b][level] = std::exp(factors_[d][b][level] / std::max(1.0, counts[d][b][level]));
}

double AdviceCosts::factor(const AdvicePoint& point, std::size_t d) const {
  return factors_[d][point[d].branch][d <= mesh_direction ? 0 : point[d].level];
}

const AdviceSample* AdviceCosts::nearest(const AdvicePoint& point, std::size_t d) const {
  const AdviceSample* best = nullptr;
  double least = 0;
  for (const AdviceSample& sample : samples_) {
    const AdvicePlace &here = sample.point[d], &wanted = point[d];
    const double levels = std::abs(static_cast<double>(here.level) - static_cast<double>(wanted.level));
    const double far = levels + (here.branch == wanted.branch ? 0 : tuning::other_branch);
    if (best != nullptr && far >= least) continue;
    best = &sample;
    least = far;
  }
  return best;
}

double AdviceCosts::steps(const AdvicePoint& point) const {
  const AdviceSample* sample = nearest(point, time_direction);
  if (sample == nullptr) return 0;
  const double ratio =
      level_at(directions_, sample->point, time_direction).size / level_at(directions_, point, time_direction).size;
  return sample->steps * (directions_.adaptive ? std::pow(ratio, tuning::adaptive_power) : ratio);
}

double AdviceCosts::dofs(const AdvicePoint& point) const {
  const AdviceSample* sample = nearest(point, mesh_direction);
  if (sample == nullptr) return 0;
  const double ratio =
      level_at(directions_, sample->point, mesh_direction).size / level_at(directions_, point, mesh_direction).size;
  const double cells = dofs_of_cells(directions_, point[mesh_direction].branch) /
                       dofs_of_cells(directions_, sample->point[mesh_direction].branch);
  return sample->dofs * cells * std::pow(ratio, directions_.dimension);
}

double AdviceCosts::seconds(const AdvicePoint& point) const {
  for (const AdviceSample& sample : samples_)
    if (sample.good && sample.point == point) return sample.seconds;
  double seconds = model_.seconds(steps(point), dofs(point));
  for (std::size_t d = 0; d < point.size(); ++d) seconds *= factor(point, d);
  return start_ + seconds;
}

}  // namespace ixos
