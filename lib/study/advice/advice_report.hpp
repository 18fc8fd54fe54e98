/// An advice for its reader.
#pragma once
#include <string>

#include "study/advice/advice.hpp"

namespace ixos {

/// Returns the answer as text: the recommended settings, the error of each quantity and its parts, what limits the
/// accuracy, and what other tolerances cost; or why there is no answer.
std::string advice_text(const AdviceQuestion& question, const Advice& advice);

/// Writes advice.json, and, if settings are recommended, advised.xml: the user's scene with these settings, or that in
/// two dimensions, ready to run from any folder. `command` repeats the advice. Throws FileError.
void write_advice(const AdviceQuestion& question, const Advice& advice, const std::string& folder,
                  const std::string& command, const std::string& version);

}  // namespace ixos
