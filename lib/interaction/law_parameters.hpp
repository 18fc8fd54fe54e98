/// Parameters that interaction laws have in common.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "parameters/scene_node.hpp"

namespace ixos {

/// Defaults: work of adhesion W [E0 L0], largest attraction s0 [E0] and equilibrium gap [L0] of the default Van der
/// Waals law.
inline constexpr double default_work = 0.01549567, default_strength = 0.0624428, default_gap = 0.2547093;

/// Throws InputError if a number that follows from parameters is not positive and finite. `names`: of the parameters;
/// `derived`: what each number is, and its value.
void check_derived(const SceneNode& node, const std::string& names,
                   const std::vector<std::pair<std::string, double>>& derived);

}  // namespace ixos
