/// The cost of a run that was not carried out.
#pragma once
#include <vector>

namespace ixos {

/// The size and the cost of a run.
struct CostSample {
  double steps = 0;
  double dofs = 0;
  double seconds = 0;
};

/// The model seconds = c steps^b dofs^a.
struct CostModel {
  double scale = 0;        ///< c; 0 if nothing is known
  double step_power = 1;   ///< b
  double dof_power = 1.2;  ///< a

  double seconds(double steps, double dofs) const;
};

/// Fits the model to samples by least squares of the logarithms. A run of half a second weighs half as much as a long
/// one, shorter ones less: equal runs differ by about 0.05 s, so that the times of short ones tell little of how costs
/// grow. Powers that the samples do not determine, because they all have nearly the same steps or degrees of freedom,
/// keep their defaults; so do powers out of the range that runs have. Ignores samples that are not positive. Without a
/// sample, the scale is 0.
CostModel fit_costs(const std::vector<CostSample>& samples);

}  // namespace ixos
