/// Warnings to a user about something that is allowed, but may be a mistake.
#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/record.hpp"

namespace ixos {

struct Warning {
  std::string name;     ///< of the kind, a few words: "cohesive zone"
  std::string message;  ///< one line: the number, its limit, the remedy
};

/// For checkpoints.
void transfer(Record& record, std::vector<Warning>& warnings);

/// A kind of warning about facts.
template <class Facts>
struct WarningKind {
  const char* name;                    ///< see Warning
  std::string (*judge)(const Facts&);  ///< returns the message; empty if there is nothing to warn of
};

/// Returns the warnings of these kinds that the facts draw, in that order.
template <class Facts, std::size_t N>
std::vector<Warning> warnings_of(const Facts& facts, const WarningKind<Facts> (&kinds)[N]) {
  std::vector<Warning> warnings;
  for (const WarningKind<Facts>& kind : kinds)
    if (std::string message = kind.judge(facts); !message.empty()) warnings.push_back({kind.name, std::move(message)});
  return warnings;
}

}  // namespace ixos
