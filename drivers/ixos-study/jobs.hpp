/// Runs at the same time.
#pragma once
#include <thread>

#include "console.hpp"

namespace ixos {

/// Notes that there are more jobs than processors, which is allowed.
inline void note_jobs(int jobs) {
  const auto processors = static_cast<int>(std::thread::hardware_concurrency());
  if (processors > 0 && jobs > processors)
    console::say("Note: {} jobs share {} processors: each run takes longer\n", jobs, processors);
}

}  // namespace ixos
