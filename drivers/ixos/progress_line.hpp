/// Lines that tell how far a run is.
#pragma once
#include <string>

#include "run/run.hpp"

namespace ixos {

/// Shows time, steps, Newton iterations and the time left on standard error: on a terminal one line that changes at
/// most five times a second, elsewhere a new line every minute.
class ProgressLine {
 public:
  explicit ProgressLine(bool is_terminal) : is_terminal_(is_terminal), interval_(is_terminal ? 0.2 : 60) {}

  /// Takes the progress after a step, or within one.
  void show(const Progress& progress);
  /// Removes the line from the terminal.
  void clear();

 private:
  bool is_terminal_;
  double interval_;         ///< between two lines [s]
  double last_shown_ = -1;  ///< by the clock of the run [s]; -1: nothing is shown yet
  bool stands_ = false;     ///< whether a line stands on the terminal
};

/// Returns the line without its end.
std::string in_words(const Progress& progress);

/// "2 h 05 min", "3 min 20 s" or "12 s".
std::string duration(double seconds);

}  // namespace ixos
