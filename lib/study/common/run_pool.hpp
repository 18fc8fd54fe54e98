/// Runs of one scene, each a process, whose records let them be reused.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "io/child_process.hpp"
#include "study/common/run_record.hpp"

namespace ixos {

/// Options that all runs of a pool share.
struct PoolOptions {
  std::string folder;  ///< results go to its subfolders of the runs' names
  std::string scene;   ///< path of the scene's file
  std::string driver;  ///< path of the program ixos
  std::string version;
  double time_limit = 0;               ///< of one run [s]; 0: none
  std::function<bool()> interrupted;   ///< called between polls; may be empty
  bool limits_processor_time = false;  ///< whether the limit is one of processor time; else of the wall clock
};

/// Carries out runs. A run is done when its record, run.json, stands in its folder; that is written last. A run whose
/// record has the same complete scene, version and program is not repeated.
class RunPool {
 public:
  /// Called after each run with its place in the list, and whether it was done before.
  using Finished = std::function<void(std::size_t, bool)>;

  /// Throws FileError if the program cannot be read.
  explicit RunPool(PoolOptions options);

  std::string folder(const StudyRun& run) const { return options_.folder + "/" + run.name; }

  /// Limits the time of the runs that start from now on.
  void limit_time(double seconds) { options_.time_limit = seconds; }

  /// Carries out those runs that are not done, `jobs` at a time. Returns false if interrupted. Throws InputError if a
  /// setting is none of the scene's, and FileError.
  bool carry_out(const std::vector<StudyRun>& runs, int jobs, const Finished& finished) const;

  /// Returns the path of what the program says of a run.
  std::string log(const StudyRun& run) const { return folder(run) + "/log.txt"; }

  /// Lets the program check a run with one more setting (`--check`). Returns its exit status. Throws FileError.
  int check(const StudyRun& run, const std::string& setting) const;

  /// Returns whether this version has a result of the run. A result cut off by a time limit counts if the present limit
  /// is not longer.
  bool is_done(const StudyRun& run) const;

  RunRecord record(const StudyRun& run) const;

 private:
  struct Active;
  void make_folder(const StudyRun& run) const;
  ChildProcess begin(const StudyRun& run, std::vector<std::string> options) const;
  bool is_done(const StudyRun& run, const std::string& scene) const;
  Active start(const StudyRun& run, std::size_t number, std::string scene) const;
  bool ended(Active& child, const StudyRun& run) const;

  PoolOptions options_;
  std::string driver_;  ///< results of another build are not reused
};

}  // namespace ixos
