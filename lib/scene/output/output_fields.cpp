#include "scene/output/output_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "scene/output/interaction_fields.hpp"

namespace ixos {
namespace {

const char* const usual_word = "default";
constexpr std::size_t longest_name = 78;  ///< two letters for the component follow, up to 80 bytes in Exodus files

/// Returns the components of a local array.
NodalValues vector_field(const Model& model, const std::vector<double>& local) {
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  NodalValues values(d, std::vector<double>(static_cast<std::size_t>(model.mesh().nodes())));
  for (std::size_t i = 0; i < d; ++i)
    for (std::size_t node = 0; node < values[i].size(); ++node) values[i][node] = local[node * d + i];
  return values;
}

/// A running simulation does not end because of an acceleration that only the output needs.
std::vector<double> acceleration_or_nan(Integrator& integrator) {
  try {
    return integrator.acceleration();
  } catch (const InputError&) {
    return std::vector<double>(integrator.state().u.size(), std::numeric_limits<double>::quiet_NaN());
  }
}

/// Returns one member of the cells' fields.
std::function<CellValues(FieldFrame&)> member(std::vector<double> CellFields::*field) {
  return [field](FieldFrame& frame) {
    CellValues values(1);
    for (const CellFields& block : frame.cells()) {
      values[0].push_back(block.*field);
      values[0].back().resize(block.jacobian.size());  // blocks that do not dissipate have no numbers
    }
    return values;
  };
}

/// Returns the first `count` numbers of function(stress), an array, for each cell.
template <class Function>
CellValues of_stress(FieldFrame& frame, std::size_t count, const Function& function) {
  CellValues values(count);
  for (const std::vector<SymmetricTensor>& block : frame.stress()) {
    for (auto& component : values) component.emplace_back();
    for (const SymmetricTensor& stress : block) {
      const auto numbers = function(stress);
      for (std::size_t i = 0; i < count; ++i) values[i].back().push_back(numbers[i]);
    }
  }
  return values;
}

bool has_interactions(const Model& model) { return model.has_interactions(); }
bool dissipates_in_cells(const Model& model) { return has_viscosity(model) || has_viscoelasticity(model); }
/// Asks all ranks: some may see no constrained node.
bool has_prescribed(const Model& model) { return model.space().maximum(model.constraints().empty() ? 0 : 1) > 0; }

std::vector<OutputField> nodal_fields() {
  std::vector<OutputField> fields;
  fields.push_back({"displacement", "Displacement.", "L0", FieldShape::Axes, true});
  fields.back().nodal = [](FieldFrame& frame) { return vector_field(frame.model(), frame.state().u); };
  fields.push_back({"velocity", "Velocity.", "L0/T0", FieldShape::Axes, true});
  fields.back().nodal = [](FieldFrame& frame) { return vector_field(frame.model(), frame.state().v); };
  fields.push_back({"acceleration", "Acceleration.", "L0/T0^2", FieldShape::Axes, true});
  fields.back().nodal = [](FieldFrame& frame) {
    return vector_field(frame.model(), acceleration_or_nan(frame.integrator()));
  };
  fields.push_back({"interaction_traction",
                    "Traction of all interactions on the body, nodal force over nodal reference area.", "E0",
                    FieldShape::Axes, true, "an interaction", has_interactions});
  fields.back().nodal = [](FieldFrame& frame) {
    return vector_of_owned(frame.model(), frame.report().interaction_traction());
  };
  fields.push_back({"gap", "Distance of a surface node from the nearest obstacle; NaN away from interacting surfaces.",
                    "L0", FieldShape::Scalar, false, "an interaction", has_interactions});
  fields.back().nodal = [](FieldFrame& frame) { return scalar_of_owned(frame.model(), frame.report().nodal_gap()); };
  fields.push_back({"contact_pressure",
                    "Part of the interaction traction along the obstacle's normal; positive: the obstacle pushes.",
                    "E0", FieldShape::Scalar, false, "an interaction", has_interactions});
  fields.back().nodal = [](FieldFrame& frame) {
    return scalar_of_owned(frame.model(), frame.report().contact_pressure());
  };
  fields.push_back({"reaction",
                    "Force that holds or drives a node whose displacement is prescribed. Its sum over a node set is "
                    "the reaction in history.csv.",
                    "E0 L0^(D-1)", FieldShape::Axes, false, "a prescribed displacement", has_prescribed});
  fields.back().nodal = [](FieldFrame& frame) {
    const LocalMesh& mesh = frame.model().mesh();
    std::vector<double> forces = frame.state().reaction;
    for (std::size_t dof = 0; dof < forces.size(); ++dof)  // those of derivative nodes are moments
      if (mesh.is_derivative(dof / static_cast<std::size_t>(mesh.dimension))) forces[dof] = 0;
    return vector_of_owned(frame.model(), std::move(forces));
  };
  return fields;
}

std::vector<OutputField> cell_fields() {
  std::vector<OutputField> fields;
  fields.push_back({"first_stress_invariant", "tr(sigma) over Young's modulus.", "-", FieldShape::Scalar, true});
  fields.back().cell = member(&CellFields::stress_invariant);
  fields.push_back({"jacobian", "J, present over reference volume.", "-", FieldShape::Scalar, true});
  fields.back().cell = member(&CellFields::jacobian);
  fields.push_back({"energy_density", "Energy that the elastic law and Maxwell branches store per reference volume.",
                    "E0", FieldShape::Scalar, true});
  fields.back().cell = member(&CellFields::energy_density);
  fields.push_back({"dissipated_energy_density",
                    "Energy that viscosity and Maxwell branches have dissipated per reference volume.", "E0",
                    FieldShape::Scalar, true, "a viscosity or Maxwell branches", dissipates_in_cells});
  fields.back().cell = member(&CellFields::dissipated);
  fields.push_back(
      {"stress",
       "Cauchy stress of the elastic law, of viscosity and of Maxwell branches, without Rayleigh damping; in 2D with "
       "ZZ.",
       "E0", FieldShape::Symmetric});
  fields.back().cell = [](FieldFrame& frame) {
    return of_stress(frame, frame.model().mesh().dimension == 2 ? 4 : 6, [](const SymmetricTensor& s) { return s; });
  };
  fields.push_back({"von_mises_stress", "Von Mises' equivalent of stress.", "E0", FieldShape::Scalar});
  fields.back().cell = [](FieldFrame& frame) {
    return of_stress(frame, 1, [](const SymmetricTensor& s) { return std::array<double, 1>{von_mises(s)}; });
  };
  fields.push_back({"principal_stress", "Principal values of stress, the largest first.", "E0", FieldShape::Principal});
  fields.back().cell = [](FieldFrame& frame) {
    return of_stress(frame, 3, [](const SymmetricTensor& s) { return principal_values(s); });
  };
  return fields;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_present(const OutputField& field, const Model& model) { return !field.present || field.present(model); }

/// Throws InputError if the model lacks what a named field needs.
void need(const OutputField& field, const Model& model) {
  if (!is_present(field, model))
    throw InputError(
        fmt::format("Output/Fields: \"{}\" needs {}, which the scene does not have; remove it from the list",
                    field.name, field.needs));
}

/// Returns the fields of all interactions of these names.
std::vector<OutputField> fields_of_interactions(const std::vector<std::string>& interactions) {
  std::vector<OutputField> all;
  for (const std::string& name : interactions)
    for (OutputField& field : interaction_fields(name)) all.push_back(std::move(field));
  return all;
}

}  // namespace

NodalValues vector_of_owned(const Model& model, std::vector<double> local) {
  local.resize(static_cast<std::size_t>(model.space().local()), 0.0);
  model.space().update_ghosts(local.data());
  return vector_field(model, local);
}

// The exchange knows degrees of freedom, so numbers by node stand in for a component.
NodalValues scalar_of_owned(const Model& model, const std::vector<double>& by_node) {
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  std::vector<double> local(static_cast<std::size_t>(model.space().local()), 0.0);
  for (std::size_t node = 0; node < by_node.size(); ++node) local[node * d] = by_node[node];
  NodalValues values = vector_of_owned(model, std::move(local));
  values.resize(1);
  return values;
}

const std::vector<CellFields>& FieldFrame::cells() {
  if (!cells_) cells_ = report().cell_fields();
  return *cells_;
}

const std::vector<std::vector<SymmetricTensor>>& FieldFrame::stress() {
  if (!stress_) stress_ = report().cell_stress();
  return *stress_;
}

std::vector<std::string> OutputField::components(int dimension) const {
  std::vector<std::string> endings{""};
  if (shape == FieldShape::Axes) endings = {"X", "Y", "Z"};
  if (shape == FieldShape::Axes && dimension == 2) endings.pop_back();
  if (shape == FieldShape::Principal) endings = {"1", "2", "3"};
  if (shape == FieldShape::Symmetric) endings = {"XX", "YY", "ZZ", "XY", "YZ", "ZX"};
  if (shape == FieldShape::Symmetric && dimension == 2) endings.resize(4);
  for (std::string& ending : endings) ending.insert(0, name);
  return endings;
}

const std::vector<OutputField>& output_fields() {
  static const std::vector<OutputField> fields = [] {
    std::vector<OutputField> all = nodal_fields();
    for (OutputField& field : cell_fields()) all.push_back(std::move(field));
    return all;
  }();
  return fields;
}

std::string output_fields_documentation() {
  const auto described = [](const OutputField& field) {
    return fmt::format(" {} [{}]: {}", field.name, field.unit, field.sentence);
  };
  std::string usual, others, single;
  for (const OutputField& field : output_fields()) {
    if (field.usual)
      usual += (usual.empty() ? "" : ", ") + field.name;
    else
      others += described(field);
  }
  for (const OutputField& field : interaction_fields("NAME")) single += described(field);
  return fmt::format(
      "Fields of fields.e. If empty, or with the name default: {}, as far as the scene has them. Others:{} Values of "
      "cells are means over the reference volume. Fields of the interaction NAME alone:{}",
      usual, others, single);
}

void check_field_names(const SceneNode& node, const std::string& entry, const std::vector<std::string>& names,
                       const std::vector<std::string>& interactions) {
  std::vector<std::string> allowed{usual_word};
  for (const OutputField& field : output_fields()) allowed.push_back(field.name);
  for (const OutputField& field : fields_of_interactions(interactions)) allowed.push_back(field.name);
  for (const std::string& name : names) {
    if (std::count(allowed.begin(), allowed.end(), name) > 1)
      node.refuse(entry,
                  "\"" + name + "\" names a field of the body and one of an interaction; rename the interaction");
    if (!contains(allowed, name)) node.refuse(entry, no_such("field", name, allowed, "There are"));
    if (name.size() > longest_name)
      node.refuse(entry,
                  fmt::format("\"{}\" has {} bytes; names of fields may have {}", name, name.size(), longest_name));
    if (std::count(names.begin(), names.end(), name) > 1) node.refuse(entry, "\"" + name + "\" is given twice");
  }
}

std::vector<OutputField> chosen_fields(const std::vector<std::string>& names, const Model& model) {
  const bool usual = names.empty() || contains(names, usual_word);
  std::vector<OutputField> chosen;
  for (const OutputField& field : output_fields()) {
    const bool named = contains(names, field.name);
    if (!named && !(usual && field.usual)) continue;
    if (named) need(field, model);
    if (is_present(field, model)) chosen.push_back(field);
  }
  for (OutputField& field : fields_of_interactions(model.interaction_names())) {
    if (!contains(names, field.name)) continue;
    need(field, model);
    chosen.push_back(std::move(field));
  }
  return chosen;
}

std::string unit_in(int dimension, const std::string& unit) {
  const auto power = [](int exponent) { return exponent == 1 ? std::string() : fmt::format("^{}", exponent); };
  std::string result = unit;
  for (const auto& [text, exponent] : {std::pair<std::string, int>{"^(D-1)", dimension - 1}, {"^D", dimension}})
    if (const auto place = result.find(text); place != std::string::npos)
      result.replace(place, text.size(), power(exponent));
  return result;
}

}  // namespace ixos
