/// The rotations and strains that a run measured, and what the strain measure of a law makes of them.
#pragma once
#include <limits>
#include <string>

#include "study/common/history_table.hpp"

namespace ixos {

/// Extremes over a run, see StrainExtent. NaN: the run did not measure them.
struct MeasuredStrains {
  double rotation = std::numeric_limits<double>::quiet_NaN();  ///< [rad]
  double least = std::numeric_limits<double>::quiet_NaN();     ///< principal strain, a stretch less 1 [-]
  double largest = std::numeric_limits<double>::quiet_NaN();   ///< the same [-]

  bool known() const;
  /// Takes the extremes of both, or those that are known.
  void add(const MeasuredStrains& other);
};

/// Returns the extremes of the strain_columns of a table up to a time.
MeasuredStrains measured_strains(const HistoryTable& table, double end);

/// Returns the relative error of a stress that a law's strain measure causes, at most, in a body with these rotations
/// and strains; infinite if they are not known.
///
/// - Linear Elastic: 1 - cos(rotation), the strain that the law sees in a turn, and the largest principal strain.
/// - Saint Venant-Kirchhoff: 1 - s (1 + s)/2 of the least stretch s, what compression takes of the stress of Hooke's
///   law; infinite for s of 1/sqrt(3) and less, where the law has no stiffness.
/// - Other laws: 0.
double measure_error(const std::string& law, const MeasuredStrains& strains);

}  // namespace ixos
