#include "scene/output/output_norms.hpp"

#include <algorithm>

#include "base/closest_name.hpp"
#include "base/error.hpp"

namespace ixos {
namespace {

/// Returns whether the field has values in the whole volume, not on a surface only.
bool is_of_volume(const OutputField& field) {
  return field.cell || field.name == "displacement" || field.name == "velocity" || field.name == "acceleration";
}

std::vector<std::string> names_of_volume() {
  std::vector<std::string> names;
  for (const OutputField& field : output_fields())
    if (is_of_volume(field)) names.push_back(field.name);
  return names;
}

}  // namespace

std::string norm_column(const std::string& field) { return "norm_" + field; }

std::string output_norms_documentation() {
  std::string names;
  for (const std::string& name : names_of_volume()) names += (names.empty() ? "" : ", ") + name;
  return "Fields whose norms become columns of history.csv, such as norm_displacement [unit of the field]: the root of "
         "the field's mean square over the reference volume, which is its L2 norm over the root of the volume. Mass "
         "does not count. Fields are " +
         names + "; those of cells enter with the means of cells. None is evaluated unless it is listed.";
}

void check_norm_names(const SceneNode& node, const std::string& entry, const std::vector<std::string>& names) {
  const std::vector<std::string> allowed = names_of_volume();
  for (const std::string& name : names) {
    if (std::find(allowed.begin(), allowed.end(), name) == allowed.end())
      node.refuse(entry, no_such("field", name, allowed, "Norms are there of"));
    if (std::count(names.begin(), names.end(), name) > 1) node.refuse(entry, "\"" + name + "\" is given twice");
  }
}

std::vector<OutputField> norm_fields(const std::vector<std::string>& names, const Model& model) {
  std::vector<OutputField> chosen;
  for (const std::string& name : names) {
    const auto& all = output_fields();
    const auto field = std::find_if(all.begin(), all.end(), [&](const OutputField& own) { return own.name == name; });
    if (field->present && !field->present(model))
      throw InputError("Output/Norms: \"" + name + "\" needs " + field->needs +
                       ", which the scene does not have; remove it from the list");
    chosen.push_back(*field);
  }
  return chosen;
}

}  // namespace ixos
