#include <algorithm>
#include <cmath>
#include <limits>

#include "study/advice/advice_errors.hpp"

namespace ixos {

/// Returns the runs of a branch with everything else at the base, the coarsest first. Where a run at the base is
/// missing, its difference from a run of the base's own branch is taken from elsewhere, as near to the base as
/// possible.
AdviceErrors::Line AdviceErrors::line(std::size_t d, std::size_t b, const Line& own,
                                      const std::vector<AdviceSample>& samples) const {
  Line line;
  line.points.resize(is_error_.size());
  const AdviceBranch& branch = directions_.all[d].branches[b];
  for (std::size_t level = 0; level < branch.levels.size(); ++level) {
    std::vector<double> values = at_base(d, {b, level}, samples);
    if (values.empty()) values = from_elsewhere(d, {b, level}, own, samples);
    if (values.empty()) continue;
    line.levels.push_back(level);
    for (std::size_t q = 0; q < is_error_.size(); ++q) line.points[q].push_back({branch.levels[level].size, values[q]});
  }
  return line;
}

std::vector<double> AdviceErrors::at_base(std::size_t d, const AdvicePlace& place,
                                          const std::vector<AdviceSample>& samples) const {
  AdvicePoint point = base_;
  point[d] = place;
  for (const AdviceSample& sample : samples)
    if (sample.good && sample.point == point) return sample.values;
  return {};
}

std::vector<double> AdviceErrors::from_elsewhere(std::size_t d, const AdvicePlace& place, const Line& own,
                                                 const std::vector<AdviceSample>& samples) const {
  std::vector<double> values;
  double least = std::numeric_limits<double>::infinity();
  for (const AdviceSample& sample : samples) {
    if (!sample.good || !(sample.point[d] == place)) continue;
    for (const AdviceSample& twin : samples) {
      if (!twin.good || twin.point[d].branch != this->own(d)) continue;
      AdvicePoint same = twin.point;
      same[d] = place;
      const auto found = std::find(own.levels.begin(), own.levels.end(), twin.point[d].level);
      if (same != sample.point || found == own.levels.end()) continue;
      const double far = levels_between(d, sample.point, base_) + std::abs(levels_of(twin.point[d], place)) / 100;
      if (far >= least) continue;
      least = far;
      const auto i = static_cast<std::size_t>(found - own.levels.begin());
      values.clear();
      for (std::size_t q = 0; q < is_error_.size(); ++q)
        values.push_back(own.points[q][i].value + sample.values[q] - twin.values[q]);
    }
  }
  return values;
}

/// Returns how many levels two points of the same branches are apart in all directions but d; infinite if the branches
/// differ.
double AdviceErrors::levels_between(std::size_t d, const AdvicePoint& a, const AdvicePoint& b) {
  double sum = 0;
  for (std::size_t e = 0; e < a.size(); ++e) {
    if (e == d) continue;
    if (a[e].branch != b[e].branch) return std::numeric_limits<double>::infinity();
    sum += std::abs(levels_of(a[e], b[e]));
  }
  return sum;
}

double AdviceErrors::levels_of(const AdvicePlace& a, const AdvicePlace& b) {
  return static_cast<double>(a.level) - static_cast<double>(b.level);
}

}  // namespace ixos
