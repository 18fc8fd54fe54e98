/// Errors of runs against a reference.
#pragma once
#include <limits>
#include <memory>
#include <string>

#include "study/study.hpp"

namespace ixos {

/// Relative errors; NaN if the columns are missing or empty.
struct StudyErrors {
  /// summary.json's max_energy_error, which is that of the recorded rows, over the energy scale.
  double energy = std::numeric_limits<double>::quiet_NaN();
  double momentum = std::numeric_limits<double>::quiet_NaN();  ///< of linear momentum, as the force's
  double force = std::numeric_limits<double>::quiet_NaN();     ///< rms in time over the reference's rms
  double position = std::numeric_limits<double>::quiet_NaN();  ///< as the force's
};

/// The results that others are compared with, read once.
class StudyReference {
 public:
  /// Throws FileError if the results in `folder` cannot be read, and InputError, with the nearest name, if they lack a
  /// column that `options` name.
  StudyReference(const std::string& folder, const ErrorOptions& options);
  ~StudyReference();
  StudyReference(const StudyReference&) = delete;
  StudyReference& operator=(const StudyReference&) = delete;

  /// Returns the errors of the results in `folder`, at the times of their own rows in the interval (the reference's
  /// rows are interpolated, so it should have more). Reactions of schemes in momentum form are means of the step and
  /// belong to its middle. Throws InputError if a named column is missing, the interval holds fewer than two rows, or
  /// the run ended before it; FileError if results cannot be read.
  StudyErrors errors(const std::string& folder) const;

 private:
  struct Results;
  double relative_distance(const Results& run, const std::vector<std::string>& columns) const;

  std::unique_ptr<Results> reference_;
  ErrorOptions options_;
};

}  // namespace ixos
