/// The cost to expect of settings.
#pragma once
#include <vector>

#include "study/advice/advice_point.hpp"
#include "study/advice/cost_model.hpp"

namespace ixos {

/// Costs of points from those of the runs: the time of a start, which all runs have in common; steps and degrees of
/// freedom by the model that is fitted to the rest; and a factor for each choice that is not the scene's own.
class AdviceCosts {
 public:
  AdviceCosts(const AdviceDirections& directions, const std::vector<AdviceSample>& samples);

  /// Returns seconds of processor time: those of the run if there was one.
  double seconds(const AdvicePoint& point) const;

  const CostModel& model() const { return model_; }

 private:
  double steps(const AdvicePoint& point) const;
  double dofs(const AdvicePoint& point) const;
  double factor(const AdvicePoint& point, std::size_t d) const;
  /// Returns the sample whose level in a direction is the nearest to the point's, of the same branch if there is one.
  const AdviceSample* nearest(const AdvicePoint& point, std::size_t d) const;

  const AdviceDirections& directions_;
  std::vector<AdviceSample> samples_;
  double start_ = 0;  ///< seconds of a run without its steps, the median
  CostModel model_;   ///< of the rest
  /// By direction, branch and level; of step and mesh, the first level stands for all.
  std::vector<std::vector<std::vector<double>>> factors_;
};

}  // namespace ixos
