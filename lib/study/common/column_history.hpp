/// A column of a run over time, and how far it is from that of another model.
#pragma once
#include <vector>

namespace ixos {

/// The column that a quantity is taken from, from the beginning of the run.
struct ColumnHistory {
  std::vector<double> times, values;  ///< rows with a value
  double decided = 0;                 ///< time that decides the quantity: that of the peak, the end of a window [T0]
};

/// Returns the column times a factor.
ColumnHistory scaled(ColumnHistory column, double factor);

/// Returns the largest difference of the column of another model up to the time that decides the quantity, over the
/// largest value of the own column up to there. Numbers of two models may be equal by coincidence; columns may not.
///
/// Times that differ count as follows. The columns are compared up to the later of both times, or else up to the
/// earlier one, and the shift of that time counts as a part of the later one: a jump that comes a little later is no
/// large difference. The smaller of both counts. Rows are those of the column with fewer rows; between the other's rows
/// the column is linear. Infinite if a column has no value there, or if the own one is 0 and the other is not.
double column_difference(const ColumnHistory& own, const ColumnHistory& other);

}  // namespace ixos
