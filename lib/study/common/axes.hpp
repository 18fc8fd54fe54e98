/// Varied settings, and the runs of all their combinations.
#pragma once
#include <string>
#include <vector>

#include "study/common/study_run.hpp"

namespace ixos {

struct AxisValue {
  std::string label;
  Assignments settings;
};

/// A varied quantity: its values exclude each other.
struct Axis {
  std::string name;
  std::vector<AxisValue> values;
};

/// Returns every combination of the axes' values after the common settings, the last axis running fastest. The name of
/// a run is that of its folder. Throws InputError if there are too many runs, or if two, or one and a reserved name,
/// would share a folder.
std::vector<StudyRun> combinations(const std::vector<Axis>& axes, const Assignments& common,
                                   const std::vector<std::string>& reserved = {});

}  // namespace ixos
