/// Scans: numbers that the runs of a scene yield, over varied parameters.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "study/common/asked_quantity.hpp"
#include "study/common/run_record.hpp"
#include "study/scan/varied_parameter.hpp"

namespace ixos {

struct Scan {
  std::string scene;   ///< path of the scene's file
  Assignments common;  ///< changes of the scene in all runs
  std::vector<VariedParameter> varied;
  std::vector<AskedQuantity> quantities;
  bool collects = false;       ///< the quantities are the user's, not those of the scene
  std::vector<StudyRun> runs;  ///< all combinations of the values, the last parameter running fastest
};

/// A run, with a value for each quantity: NaN if it has none, and the record's reason then says why.
struct ScanRow : RunRecord {
  std::vector<double> values;
};

struct ScanOptions {
  std::string folder;   ///< results go here: runs/<name>/ for each run. Created if missing
  std::string driver;   ///< path of the program ixos
  std::string command;  ///< repeats the scan, for scan.json
  std::string version;  ///< results of another version are not reused
  int jobs = 1;         ///< runs at the same time
  bool overwrite = false;
  /// Called after each run: its row, how many are done, and whether it was finished already. May be empty.
  std::function<void(const ScanRow&, std::size_t, bool)> watch;
  std::function<bool()> interrupted;  ///< called between polls; may be empty
};

struct ScanOutcome {
  bool complete = false;      ///< or it was interrupted
  std::vector<ScanRow> rows;  ///< of the finished runs, in the scan's order
};

/// Returns the scan of a scene's file with ranges as read_varied() takes them, and quantities: Output/Quantities of the
/// scene if there are none. All runs are checked against what the scene may say. Throws InputError.
Scan read_scan(const std::string& scene, const Assignments& common, const std::vector<std::string>& varied,
               const std::vector<std::string>& quantities);

/// Carries out the runs that have no result yet, each as a process, and writes scan.csv and scan.json. A
/// scan may be killed at any time, and resumes from the runs that are done. Throws FileError, and InputError if the
/// folder holds the results of another scan, or if a quantity needs a column which history.csv lacks: the program
/// checks that before the first run, and leaves no new folder then.
ScanOutcome run_scan(const Scan& scan, const ScanOptions& options);

}  // namespace ixos
