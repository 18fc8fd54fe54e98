/// Carrying a study out.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "study/compare/study.hpp"
#include "study/compare/study_result.hpp"

namespace ixos {

struct RunnerOptions {
  std::string folder;      ///< results go here: runs/<name>/ for each run, and for the reference. Created if missing
  std::string driver;      ///< path of the program ixos
  std::string command;     ///< repeats the study, for study.json
  std::string version;     ///< results of another version are not reused
  bool overwrite = false;  ///< replaces the results of another study
  /// Called after each run: its result, how many are done, and whether it was finished already. May be empty.
  std::function<void(const StudyResult&, std::size_t, bool)> watch;
  std::function<bool()> interrupted;  ///< called between polls
};

enum class StudyStatus { Done, ReferenceFailed, Interrupted };

struct StudyOutcome {
  StudyStatus status = StudyStatus::Done;
  std::vector<StudyResult> results;  ///< of the finished runs in the study's order, or of the failed reference alone
  std::string recommendation;        ///< a sentence; empty unless the study is done
};

/// Runs the settings that have no result yet, each in a separate process, compares all results with the reference, and
/// writes study.csv and study.json. A run is done when its record stands in its folder, runs/<name>/run.json, which is
/// written last. A study may therefore be killed at any time, and resumes from the runs that are done. Throws
/// InputError, also if the folder holds the results of another study, and FileError, also if another process works in
/// that folder.
StudyOutcome run_study(const Study& study, const RunnerOptions& options);

}  // namespace ixos
