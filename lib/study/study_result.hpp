/// The results of a study's runs, and the files that hold them.
#pragma once
#include <string>
#include <vector>

#include "study/study.hpp"
#include "study/study_errors.hpp"

namespace ixos {

struct StudyResult {
  StudyRun run;
  std::string status;  ///< completed, stopped, diverged, interrupted or failed
  std::string reason;
  StudyErrors errors;
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
  /// Returns the value of a column by its name. Throws std::invalid_argument for any other name.
  double error(const std::string& measure) const;
  double cost(const std::string& name) const;
};

/// Writes study.csv and study.json. `command` repeats the study. Throws FileError.
void write_study(const Study& study, const std::vector<StudyResult>& results, const ReferenceQuality& reference,
                 const std::string& folder, const std::string& command, const std::string& version);

}  // namespace ixos
