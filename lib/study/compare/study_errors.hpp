/// Errors of runs against a reference.
#pragma once
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "study/compare/study.hpp"

namespace ixos {

/// Relative errors, and the numbers that two of them compare; NaN if the columns are missing or empty, or if the
/// reference is as good as zero.
struct StudyErrors {
  /// summary.json's max_energy_error, which is that of the recorded rows, over the energy scale.
  double energy = std::numeric_limits<double>::quiet_NaN();
  double momentum = std::numeric_limits<double>::quiet_NaN();  ///< of linear momentum, as the force's
  double force = std::numeric_limits<double>::quiet_NaN();     ///< rms in time over the reference's rms
  double position = std::numeric_limits<double>::quiet_NaN();  ///< as the force's
  double peak = std::numeric_limits<double>::quiet_NaN();      ///< |peak force - reference's| over the reference's
  double work = std::numeric_limits<double>::quiet_NaN();      ///< |work - reference's| over the reference's
  /// Largest magnitude, in the rows of the interval, of the vector whose components are the columns of the force [E0
  /// L0^(D-1)].
  double peak_force = std::numeric_limits<double>::quiet_NaN();
  /// Change of external_work in the interval [E0 L0^D].
  double external_work = std::numeric_limits<double>::quiet_NaN();
};

/// An error as a column of study.csv.
struct Measure {
  const char* column;
  const char* quantity;  ///< as in "error of the ..."
  double StudyErrors::*error;
};

/// Returns all measures, in the order of the columns.
const std::vector<Measure>& measures();

/// Returns the measure of a column. Throws std::invalid_argument if there is none.
const Measure& measure(const std::string& column);

/// How well the reference is known.
struct ReferenceQuality {
  /// The distance of a coarser run from the reference. It bounds the error of the reference, if that falls at least in
  /// proportion to a step that the coarser run doubles. NaN if unknown; always for the energy, whose error is none
  /// against the reference.
  StudyErrors own;
  std::string origin;                        ///< of `own`, as in "from ..."; empty if unknown
  std::string unknown;                       ///< why `own` is unknown
  std::map<std::string, std::string> notes;  ///< by column: why the measure is blank in all runs
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

  /// Estimates the reference's own errors by the results in `folder`, of a coarser run that `origin` describes. From
  /// then on, measures of which the reference knows less than half are blank. Throws as errors() does.
  void judge(const std::string& folder, const std::string& origin);

  const ReferenceQuality& quality() const { return quality_; }

 private:
  struct Results;
  double relative_distance(const Results& run, const std::vector<std::string>& columns) const;
  void find_zeros();

  std::unique_ptr<Results> reference_;
  ErrorOptions options_;
  ReferenceQuality quality_;
};

}  // namespace ixos
