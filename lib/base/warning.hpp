/// Warnings to a user about something that is allowed, but may be a mistake.
#pragma once
#include <string>

namespace ixos {

struct Warning {
  std::string name;     ///< of the kind, a few words: "cohesive zone"
  std::string message;  ///< one line: the number, its limit, the remedy
};

}  // namespace ixos
