/// The numbers of a row of history.csv.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "run/field_norms.hpp"
#include "scene/simulation.hpp"

namespace ixos {

/// The counts that the driver adds to a row.
struct RowCounts {
  long step = 0;
  double time_step = 0;
  long newton_iterations = 0;  ///< since the row before
  long linear_iterations = 0;
  double wall_seconds = 0;  ///< cumulative
};

/// The numbers of one state. Groups of columns that the list "Output" leaves out are NaN.
struct RowValues {
  std::vector<double> row;  ///< parallel to HistoryRow::columns()
  double kinetic = 0, elastic = 0, contact = 0;
  double balance = 0;                              ///< energy less external work plus dissipation [E0 L0^D]
  double contact_measure = 0;                      ///< of all interactions
  std::vector<double> forces{};                    ///< parallel to HistoryRow::force_columns()
  std::vector<double> measures{};                  ///< parallel to HistoryRow::contact_names()
  std::vector<FrictionReport> friction_reports{};  ///< of the interactions with friction
};

/// Evaluates the present state of a simulation, which must outlive it. Collective.
class HistoryRow {
 public:
  explicit HistoryRow(Simulation& simulation);

  const std::vector<std::string>& columns() const { return columns_; }
  /// Returns the columns of the forces on node sets, then on grips.
  const std::vector<std::string>& force_columns() const { return force_columns_; }
  /// Returns the names of the interactions whose contact measure a row has.
  const std::vector<std::string>& contact_names() const { return contact_names_; }

  RowValues values(const RowCounts& counts) const;
  /// Returns RowValues::forces alone.
  std::vector<double> forces() const;

 private:
  std::vector<double> set_forces() const;
  std::vector<double> grip_columns(std::vector<double>& forces) const;
  std::vector<double> body_columns() const;
  std::vector<double> interaction_columns(RowValues& values) const;
  std::vector<double> friction_columns(RowValues& values) const;

  Simulation& simulation_;
  std::vector<std::string> columns_, force_columns_, contact_names_;
  std::vector<std::size_t> reaction_sets_;  ///< node set numbers
  std::vector<std::string> interactions_;   ///< those with columns of their own
  std::vector<std::string> frictions_;      ///< those with friction
  FieldNorms norms_;
};

}  // namespace ixos
