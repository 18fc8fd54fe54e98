/// The record and the summary of a run.
#pragma once
#include <string>

#include "study/common/study_run.hpp"

namespace ixos {

struct RunRecord {
  StudyRun run;
  std::string status;  ///< completed, stopped, diverged, interrupted or failed
  std::string reason;
  double wall_seconds = 0;  ///< of the time loop
  double cpu_seconds = 0;   ///< of the process
  long steps = 0, rejected_steps = 0, newton_iterations = 0, linear_iterations = 0;
  long dofs = 0;  ///< 0 if unknown
  double peak_memory_bytes = 0;
  double end_time = 0;
  bool refused = false;  ///< whether ixos took the scene for bad input

  bool reached_its_end() const { return status == "completed" || status == "stopped"; }
  /// Returns whether the run failed, with all its rows on the disk.
  bool failed_with_rows() const { return status == "diverged"; }
};

}  // namespace ixos
