/// The judgement of a step in an adaptive run.
#pragma once
#include "time/integrator.hpp"
#include "time/step_control.hpp"

namespace ixos {

/// Returns whether the step of length dt that the integrator has attempted keeps what the options ask for. Measures
/// only that, tells the control, and sets the number of points in time; a step that needs more of them is to be done
/// again. Collective.
bool judge_step(Integrator& integrator, const AdaptiveOptions& asked, double dt, StepControl& control);

}  // namespace ixos
