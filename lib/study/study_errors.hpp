/// Errors of a run against a reference.
#pragma once
#include <limits>
#include <string>

#include "study/study.hpp"

namespace ixos {

/// Relative errors; NaN where the columns are not there, or empty.
struct StudyErrors {
  double energy = std::numeric_limits<double>::quiet_NaN();    ///< largest |E - E_0 - W + D| over the energy scale
  double momentum = std::numeric_limits<double>::quiet_NaN();  ///< of linear momentum, as the force's
  double force = std::numeric_limits<double>::quiet_NaN();     ///< rms in time over the reference's rms
  double position = std::numeric_limits<double>::quiet_NaN();  ///< as the force's
};

/// Of the results in `folder` against those in `reference`, at the times of the run's own rows in the interval (those
/// of the reference are interpolated, so it should have more). Reactions of schemes in momentum form are means of the
/// step and belong to its middle. Throws InputError where a named column is not there, or the interval holds no two
/// rows, and FileError where results cannot be read.
StudyErrors study_errors(const std::string& folder, const std::string& reference, const ErrorOptions& options);

}  // namespace ixos
