/// Fields of single interactions, which a run can write to fields.e.
#pragma once
#include <string>
#include <vector>

#include "scene/output/output_fields.hpp"

namespace ixos {

/// Returns the fields of the interaction of that name, on nodes: gap_<name>, normal_<name>, traction_<name>,
/// pressure_<name>, damage_<name>, friction_<name> and slip_<name>; the last three are present if the law or the
/// friction of the interaction has them. Their functions throw InputError if the model has no such interaction.
std::vector<OutputField> interaction_fields(const std::string& name);

}  // namespace ixos
