/// Friction of a scene's interactions.
#pragma once
#include <memory>
#include <string>

#include "interaction/friction.hpp"
#include "parameters/options.hpp"

namespace ixos {

class GapLaw;

/// Returns the parameters of a list "Friction".
const Options<Friction>& friction_options();

/// Returns the threshold, the elastic slip and the accounts of friction under that law as one line for --explain. Empty
/// if there is none.
std::string friction_in_words(const Friction& friction, const std::shared_ptr<const GapLaw>& law);

}  // namespace ixos
