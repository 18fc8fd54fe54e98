/// Settings that a model refuses.
#pragma once
#include <string>

namespace ixos {

/// A setting that is not allowed, by its name in scenes ("Friction/Type"), and why: words that follow the setting or
/// its value. Programs and scenes say the same of it, each with its own place.
struct Refusal {
  std::string setting;
  std::string value;  ///< a number; empty for a choice, which a scene knows by its word, and for a list
  std::string why;

  /// Returns the refusal without a place: "Cutoff 2 is not ...".
  std::string in_words() const { return setting + (value.empty() ? " " : " " + value + " ") + why; }
};

}  // namespace ixos
