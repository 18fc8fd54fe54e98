/// Sums of work over a step.
#pragma once
#include <vector>

namespace ixos {

/// How the work of external forces g (loads and reactions) and of forces C v that depend on rates is summed over a
/// step.
struct WorkSum {
  enum class Form {
    Increment,  ///< du . g of the step mean; du . C v, v the damping row over dt
    EndMean,    ///< du . (g_n + g)/2; du . C (v_n + v)/2
    Stages      ///< dt sum_i weights_i v_i . g_i over the known states and the end; dt sum_i weights_i v_i . C v_i
  };
  Form form = Form::Increment;
  std::vector<double> weights;
};

}  // namespace ixos
