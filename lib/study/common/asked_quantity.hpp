/// Numbers that a user asks of a run: "peak reaction_right_y", "mean contact_force_y [20, 50]".
#pragma once
#include <limits>
#include <string>
#include <vector>

#include "study/common/column_history.hpp"
#include "study/common/run_history.hpp"

namespace ixos {

/// The forms that AskedQuantity reads, one line each, for messages and help.
std::string quantity_forms();

/// A number that the rows of a run yield.
///
/// | form | value |
/// |---|---|
/// | peak COLUMN | the value of largest magnitude, without its sign |
/// | maximum COLUMN, minimum COLUMN | the largest and the smallest value |
/// | mean COLUMN, rms COLUMN | the mean in time, and the root of the mean square |
/// | final COLUMN | the value of the last row |
/// | value COLUMN at TIME | the value at a time, between rows by linear interpolation |
/// | work | the change of external_work |
/// | energy error | the largest energy error, over the largest kinetic energy |
/// | restitution COLUMN | the ratio of the peaks after and before the column's first change of sign |
/// | time of peak COLUMN | the time of the value of largest magnitude |
/// | time of COLUMN above LIMIT, time of COLUMN below LIMIT | the first time at which the column passes the limit |
/// | time of first contact, time of detachment | when contact_measure first becomes positive, and last becomes zero |
/// | time of arrest | after which the kinetic energy stays below 1 % of its largest value |
///
/// A window "[from, to]" [T0] may end each form but those of one time; it chooses the rows.
class AskedQuantity {
 public:
  enum class Kind {
    Peak,
    Maximum,
    Minimum,
    Mean,
    Rms,
    Final,
    Value,
    Work,
    EnergyError,
    Restitution,
    PeakTime,
    TimeAbove,
    TimeBelow,
    FirstContact,
    Detachment,
    Arrest
  };

  /// Throws InputError, which quotes the text and lists the forms, if the text has none of them.
  explicit AskedQuantity(const std::string& text);

  const std::string& text() const { return text_; }

  /// Throws InputError, with the nearest name, if the quantity needs a column that is not among the names.
  void check_columns(const std::vector<std::string>& names) const;

  /// Throws InputError if the window, or the time, is not within a run from one time to another.
  void check_times(double from, double to) const;

  /// Returns the value. Throws InputError if a column is missing or empty, the window holds too few rows, the run ended
  /// before it, or the event did not happen. A first event counts even if the run ended before its window.
  double value(const RunHistory& run) const;

  /// Returns the whole column, with the time that decides the value. Throws as value().
  ColumnHistory history(const RunHistory& run) const;

  /// Returns whether a failed run has the value: its time or its window has passed, its first event has happened, or it
  /// is a peak of a force that the run reached before the contact was released. That no later contact is stronger is
  /// then an assumption; a window replaces it.
  bool is_decided(const RunHistory& run) const;

  /// Returns whether the number of a chaotic run may be predictable: means and errors of conserved quantities.
  bool is_statistic() const { return kind_ == Kind::Mean || kind_ == Kind::Rms || kind_ == Kind::EnergyError; }

  /// Returns the column that it is taken from.
  const std::string& column() const { return column_; }
  /// Returns the same of another column.
  AskedQuantity of_column(const std::string& column) const;
  /// Returns whether the number grows in proportion to its column; others are times and ratios.
  bool is_proportional() const;
  /// Returns the column that has the unit of the number: "time" for times; empty for ratios.
  std::string column_of_unit() const;
  /// Returns whether it has a limit for its column.
  bool has_limit() const { return kind_ == Kind::TimeAbove || kind_ == Kind::TimeBelow; }

  /// Returns whether the number is itself an error, so that its exact value is 0.
  bool is_error() const { return kind_ == Kind::EnergyError; }

 private:
  struct Rows;
  Rows rows(const RunHistory& run) const;
  Rows rows_so_far(const RunHistory& run) const;
  double event(const RunHistory& run) const;
  double deciding_time(const RunHistory& run) const;
  bool is_decided_by_release(const RunHistory& run) const;
  [[noreturn]] void refuse(const std::string& why) const;

  std::string text_;
  Kind kind_;
  std::string column_;
  double number_ = 0;  ///< a time or a limit
  double from_ = -std::numeric_limits<double>::infinity(), to_ = std::numeric_limits<double>::infinity();
};

/// Returns whether all quantities of a failed run are decided.
bool are_decided(const std::vector<AskedQuantity>& quantities, const RunHistory& run);

}  // namespace ixos
