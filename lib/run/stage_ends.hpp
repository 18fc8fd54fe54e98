/// The ends of the stages of a scene.
#pragma once
#include <string>
#include <vector>

#include "base/record.hpp"

namespace ixos {

struct StageEnd {
  std::string name;
  double time = 0;     ///< [T0]
  long steps = 0;      ///< since the beginning of the run
  std::string reason;  ///< the criterion that ended it; empty if it came to its Final Time
  double begin = 0;    ///< of the next stage [T0]: `time` without its rounding
};

/// Writes or reads them, for checkpoints. A run without stages leaves no trace.
void transfer(Record& record, std::vector<StageEnd>& ends);

}  // namespace ixos
