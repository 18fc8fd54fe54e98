/// The results of a study's runs, and the conclusions from them.
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
  double peak_memory_bytes = 0;
  double end_time = 0;

  bool reached_its_end() const { return status == "completed" || status == "stopped"; }
  /// Returns the value of a column by its name. Throws std::invalid_argument for any other name.
  double error(const std::string& measure) const;
  double cost(const std::string& name) const;
};

/// Returns the runs that no other beats in both cost and error, the cheapest first.
std::vector<const StudyResult*> pareto(const std::vector<StudyResult>& results, const std::string& cost,
                                       const std::string& measure);

struct Recommendation {
  const StudyResult* run = nullptr;  ///< null if no run is good enough
  std::string sentence;
};

/// Returns the cheapest run within the tolerance; without a tolerance the most accurate run within the budget.
Recommendation recommend(const Study& study, const std::vector<StudyResult>& results);

/// Writes study.csv and study.json. `command` repeats the study. Throws FileError.
void write_study(const Study& study, const std::vector<StudyResult>& results, const std::string& folder,
                 const std::string& command, const std::string& version);

}  // namespace ixos
