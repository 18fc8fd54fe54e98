/// Carrying a study out.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "study/study.hpp"
#include "study/study_result.hpp"

namespace ixos {

struct RunnerOptions {
  std::string folder;   ///< results go here: runs/<name>/ for each run, and for the reference
  std::string driver;   ///< path of the program ixos
  std::string version;  ///< results of another version are not reused
  /// Called after each run: its result, how many are done, and whether it was there already. May be empty.
  std::function<void(const StudyResult&, std::size_t, bool)> watch;
  std::function<bool()> interrupted;  ///< asked between polls
};

enum class StudyStatus { Done, ReferenceFailed, Interrupted };

/// Runs what has not been run with these settings before, each in a process of its own, and compares all results with
/// the reference. A run is done when its record stands in its folder, runs/<name>/run.json, which is written last; so a
/// study may be killed at any time and goes on where it was. `results` holds the finished runs in the study's order; of
/// a failed reference, it alone. Throws FileError, also where another process works in that
/// folder, and InputError.
StudyStatus run_study(const Study& study, const RunnerOptions& options, std::vector<StudyResult>& results);

}  // namespace ixos
