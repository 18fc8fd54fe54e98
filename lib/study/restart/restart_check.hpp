/// Verification that killed runs of a scene resume bit for bit.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "study/common/study_run.hpp"

namespace ixos {

struct RestartCheck {
  /// The program ixos, after the words that start it on several ranks if there are any. It must take --kill-after-step.
  std::vector<std::string> driver;
  std::string scene;  ///< path of the scene's file
  Assignments settings;
  std::string folder;       ///< results go to its subfolders undisturbed and killed
  bool overwrite = false;   ///< passed to the runs: replace results of another scene there
  std::vector<long> steps;  ///< the steps to resume from, ascending, at least 1; empty: `kills` of them
  int kills = 3;            ///< spread evenly over the run
  std::function<void(const std::string&)> log;  ///< called with one line for each part of the check; may be empty
  std::function<bool()> interrupted;            ///< called between polls; may be empty
};

/// Unrepeatable: the second run differs before its first kill, so that restarts cannot be judged.
enum class RestartCheckStatus { Same, Different, Unrepeatable, Refused, RunFailed, Interrupted };

struct RestartCheckResult {
  RestartCheckStatus status = RestartCheckStatus::Same;
  std::string message;  ///< the first difference, or the last message of a run that was refused or failed; else empty
  int exit_status =
      0;  ///< of a run that was refused or failed; 4 if that is none of ixos, as for a run that was killed
};

/// Runs the scene once undisturbed, then once more with kills: for each chosen step s in turn, a process writes a
/// checkpoint at s, ends by SIGKILL after step s + 1, and the next process resumes from that checkpoint. The rows of
/// history.csv are compared before each resumption, all results at the end. Ends with the first difference: all that
/// follows has the same cause. A scene whose run diverges is verified up to there. A scene that ixos
/// refuses leaves nothing in the folder. Throws InputError if a chosen step is beyond the run, or if the run is too
/// short, and FileError.
RestartCheckResult check_restarts(const RestartCheck& check);

}  // namespace ixos
