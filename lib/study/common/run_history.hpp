/// The rows of a run, and the times to which they belong.
#pragma once
#include <string>
#include <vector>

#include "study/common/history_table.hpp"

namespace ixos {

/// history.csv of a results folder, with what effective.xml tells of its times.
class RunHistory {
 public:
  /// Throws FileError if the results cannot be read, and InputError if effective.xml is none of a scene.
  explicit RunHistory(const std::string& folder);

  const std::string& folder() const { return folder_; }
  const HistoryTable& table() const { return table_; }

  /// Returns the times to which a column's values belong. Reactions of schemes in momentum form are means of the step
  /// and belong to its middle.
  std::vector<double> times(const std::string& column) const;

  /// Returns max_energy_error of summary.json; NaN if the run has no energies. Throws FileError.
  double energy_error() const;

 private:
  std::string folder_;
  HistoryTable table_;
  bool step_means_;
};

}  // namespace ixos
