/// Places and directions that a scene states as vectors.
#pragma once
#include <array>
#include <cstddef>
#include <string>

#include "parameters/scene_node.hpp"

namespace ixos {

/// Returns the unit vector along the entry of that name, which has `dimension` numbers, or `fallback` if it is empty.
/// Throws InputError if all numbers are zero. `meaning` ends the message: "it must point out of the wall".
std::array<double, 3> unit_vector(const SceneNode& node, const std::string& entry, std::size_t dimension,
                                  const std::array<double, 3>& fallback,
                                  const std::string& meaning = "it must have a direction");

/// Returns the place in the entry of that name, which has `dimension` numbers, or the origin if it is empty.
std::array<double, 3> place_of(const SceneNode& node, const std::string& entry, std::size_t dimension);

/// Returns the unit vector of the last coordinate.
std::array<double, 3> last_axis(std::size_t dimension);

}  // namespace ixos
