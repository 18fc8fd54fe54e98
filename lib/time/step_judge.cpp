#include "time/step_judge.hpp"

namespace ixos {

bool judge_step(Integrator& integrator, const AdaptiveOptions& asked, double dt, StepControl& control) {
  StepJudgement judgement;
  if (asked.tolerance > 0) judgement.error = integrator.error();
  if (asked.gap_ratio > 0 || asked.time_points) judgement.gap_ratio = integrator.gap_ratio();
  const int used = integrator.table().interaction_points;
  if (asked.time_points && used > 0) {
    const int needed = time_points(judgement.gap_ratio);
    integrator.set_interaction_points(needed);
    if (needed > used) return false;  // the same step again
  }
  return control.accepts(dt, judgement);
}

}  // namespace ixos
