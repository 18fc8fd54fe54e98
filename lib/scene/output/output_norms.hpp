/// Fields whose norms history.csv can have: the list "Output/Norms".
#pragma once
#include <string>
#include <vector>

#include "scene/output/output_fields.hpp"

namespace ixos {

/// Returns the column of a field: that of "displacement" is "norm_displacement".
std::string norm_column(const std::string& field);

/// Returns the documentation of the parameter that lists the fields.
std::string output_norms_documentation();

/// Throws InputError, with the place `entry` of the list, if a name is given twice or is no field of the volume.
void check_norm_names(const SceneNode& node, const std::string& entry, const std::vector<std::string>& names);

/// Returns the fields of a checked list, in its order. Throws InputError if the model lacks what one of them needs.
/// Collective.
std::vector<OutputField> norm_fields(const std::vector<std::string>& names, const Model& model);

}  // namespace ixos
