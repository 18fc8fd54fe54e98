/// The results of a study's runs, and the files that hold them.
#pragma once
#include <string>
#include <vector>

#include "study/common/run_record.hpp"
#include "study/compare/study.hpp"
#include "study/compare/study_errors.hpp"

namespace ixos {

struct StudyResult : RunRecord {
  StudyErrors errors;

  /// Returns the value of a column by its name. Throws std::invalid_argument for any other name.
  double error(const std::string& measure) const;
  double cost(const std::string& name) const;
};

/// Writes study.csv and study.json. `command` repeats the study. Throws FileError.
void write_study(const Study& study, const std::vector<StudyResult>& results, const ReferenceQuality& reference,
                 const std::string& folder, const std::string& command, const std::string& version);

}  // namespace ixos
