/// history.csv: the recorded rows of a run.
#pragma once
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/record.hpp"
#include "io/history_file.hpp"
#include "run/contact_events.hpp"
#include "run/history_row.hpp"
#include "run/jump_watch.hpp"
#include "scene/simulation.hpp"

namespace ixos {

/// The writer of the rows, which it evaluates; the file is written on rank 0. Columns that the list "Output" leaves out
/// are not evaluated and stay empty. Collective.
class History {
 public:
  explicit History(Simulation& simulation);

  /// Creates the file. Throws FileError.
  void create(const std::string& path);
  /// Throws InputError unless the file is the one that existed when the loaded checkpoint was written. Rows then have
  /// the column of released energy if the file has it: a run may go on with another scheme.
  void verify(const std::string& path);
  /// Continues the verified file; drops later rows.
  void resume(const std::string& path);

  /// Records the present state. `is_first`: a file begins with it, and no jump leads to it; of a quasi-static run it
  /// need not be an equilibrium, since constant loads and motions act at once.
  void record(const RowCounts& counts, bool is_first = false);
  /// Skips the row of a step: its reactions still count for max_forces().
  void pass();
  /// Sets the energy that changes of the mesh have added so far [E0 L0^D], for the rows from here on.
  void set_adapted(double energy) { adapted_ = energy; }
  /// Returns the largest |E_n - E_0 - external work + dissipation + released energy - that of adaptations| of the rows
  /// [E0 L0^D]; NaN without energies. A scheme makes no error where a body jumps to another equilibrium, or its mesh
  /// changes.
  double max_energy_error() const { return max_energy_error_; }
  /// Returns the largest kinetic, elastic or interaction energy of the recorded rows [E0 L0^D], the scale of that
  /// error.
  double largest_energy() const { return largest_energy_; }
  /// Returns, by reaction column, the value of largest magnitude over all steps.
  const std::vector<std::pair<std::string, double>>& max_forces() const { return max_forces_; }
  /// Returns the last row's energy less external work plus dissipation, less what changes of the mesh have added
  /// [E0 L0^D]; NaN without energies.
  double balance() const { return balance_; }
  /// Returns the jump of a quasi-static run before the last row, and all jumps so far.
  const Jump& jump() const { return jump_; }
  const JumpSums& jumps() const { return jumps_.jumps(); }
  /// Returns the times of each interaction's contact; of none if rows do not have the contact measure of each.
  const ContactEvents& contacts() const { return contacts_; }
  /// Returns the last row's contact measure; NaN if rows have none.
  double contact_measure() const { return contact_measure_; }
  /// Returns the last row's reports of the interactions with friction.
  const std::vector<FrictionReport>& friction_reports() const { return friction_reports_; }
  /// Returns the last step's reactions by column.
  const std::vector<std::pair<std::string, double>>& forces() const { return forces_; }
  void sync();   ///< has the disk keep the rows; throws FileError
  void close();  ///< after the last row; throws FileError

  /// Takes the file and the sums of the history of another simulation, which ends. Throws InputError, on all ranks, if
  /// its columns are others, but for that of released energy.
  void go_on_from(History& before);

  /// Writes or reads the sums and the length of the file for checkpoints.
  void transfer(Record& record);
  /// Writes or reads the jumps, which checkpoints have among the measures of a run.
  void transfer_jumps(Record& record);

 private:
  void take_columns(const std::vector<std::string>& columns);
  void keep_forces(const std::vector<double>& forces);
  double& largest_force(const std::string& column);

  Simulation& simulation_;
  HistoryRow row_;
  std::vector<std::string> columns_;   ///< of the file
  std::vector<std::size_t> places_;    ///< among them, of the numbers of a row
  std::size_t released_place_ = 0;     ///< among them, of the energy that jumps released; their number if there is none
  std::size_t adapted_place_ = 0;      ///< likewise of the energy that changes of the mesh added
  double adapted_ = 0;                 ///< that energy
  TableLength length_;                 ///< of the file, as loaded
  std::unique_ptr<HistoryFile> file_;  ///< on rank 0
  /// Energy at the first row, less external work, plus dissipation; NaN if no energies were recorded yet.
  double initial_energy_ = std::numeric_limits<double>::quiet_NaN();
  double balance_ = std::numeric_limits<double>::quiet_NaN();  ///< of the last row
  double max_energy_error_ = 0;
  double largest_energy_ = 0;
  JumpWatch jumps_;  ///< takes part in quasi-static runs
  Jump jump_;        ///< before the last row
  ContactEvents contacts_;
  std::vector<FrictionReport> friction_reports_;
  std::vector<std::pair<std::string, double>> max_forces_;
  double contact_measure_ = std::numeric_limits<double>::quiet_NaN();  ///< of the last row
  std::vector<std::pair<std::string, double>> forces_;                 ///< of the last step
};

}  // namespace ixos
