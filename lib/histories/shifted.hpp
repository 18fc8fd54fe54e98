/// A function of time that is moved.
#pragma once
#include <memory>

#include "histories/time_function.hpp"

namespace ixos {

/// Returns f(t - time) + value; `time` in T0, `value` in the unit of the function.
std::shared_ptr<const TimeFunction> shifted(std::shared_ptr<const TimeFunction> function, double time, double value);

}  // namespace ixos
