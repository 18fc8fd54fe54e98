/// One line on the terminal that tells how far a run is.
#pragma once
#include <string>

#include "run/run.hpp"

namespace ixos {

/// Shows time, steps, Newton iterations a step and the time left, at most five times a second, on standard error.
class ProgressLine {
 public:
  void show(const Progress& progress);
  /// Removes the line.
  void clear();

 private:
  double first_time_ = 0;
  double last_shown_ = -1;
};

/// "2 h 05 min", "3 min 20 s" or "12 s".
std::string duration(double seconds);

}  // namespace ixos
