#include "study/advice_costs.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {
namespace {

/// The steps of an adaptive run grow as its tolerance falls, with this power: that of a scheme of second order.
constexpr double adaptive_power = 1.0 / 3;

bool is_the_scenes_own(const AdvicePoint& point) {
  return std::all_of(point.begin(), point.end(), [](const AdvicePlace& place) { return place.branch == 0; });
}

}  // namespace

AdviceCosts::AdviceCosts(const AdviceDirections& directions, const std::vector<AdviceSample>& samples)
    : directions_(directions) {
  std::vector<CostSample> own;
  for (const AdviceSample& sample : samples) {
    if (!(sample.steps > 0 && sample.dofs > 0 && sample.seconds > 0)) continue;
    samples_.push_back(sample);
    if (is_the_scenes_own(sample.point)) own.push_back({sample.steps, sample.dofs, sample.seconds});
  }
  model_ = fit_costs(own);
  for (std::size_t d = 0; d < directions.all.size(); ++d) {
    std::vector<double>& factors = factors_.emplace_back(directions.all[d].branches.size(), 1);
    for (std::size_t b = 1; b < factors.size(); ++b) {
      double sum = 0, count = 0;
      for (const AdviceSample& sample : samples_) {
        AdvicePoint without = sample.point;
        without[d].branch = 0;
        if (sample.point[d].branch != b || !is_the_scenes_own(without)) continue;
        sum += std::log(sample.seconds / model_.seconds(sample.steps, sample.dofs));
        ++count;
      }
      if (count > 0) factors[b] = std::exp(sum / count);
    }
  }
}

const AdviceSample* AdviceCosts::nearest(const AdvicePoint& point, std::size_t d) const {
  const AdviceSample* best = nullptr;
  double least = 0;
  for (const AdviceSample& sample : samples_) {
    const AdvicePlace &here = sample.point[d], &wanted = point[d];
    const double levels = std::abs(static_cast<double>(here.level) - static_cast<double>(wanted.level));
    const double far = levels + (here.branch == wanted.branch ? 0 : 0.5);
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
  return sample->steps * (directions_.adaptive ? std::pow(ratio, adaptive_power) : ratio);
}

double AdviceCosts::dofs(const AdvicePoint& point) const {
  const AdviceSample* sample = nearest(point, mesh_direction);
  if (sample == nullptr) return 0;
  const double ratio =
      level_at(directions_, sample->point, mesh_direction).size / level_at(directions_, point, mesh_direction).size;
  return sample->dofs * std::pow(ratio, directions_.dimension);
}

double AdviceCosts::seconds(const AdvicePoint& point) const {
  for (const AdviceSample& sample : samples_)
    if (sample.good && sample.point == point) return sample.seconds;
  double seconds = model_.seconds(steps(point), dofs(point));
  for (std::size_t d = 0; d < point.size(); ++d) seconds *= factors_[d][point[d].branch];
  return seconds;
}

}  // namespace ixos
