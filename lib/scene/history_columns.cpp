#include "scene/history_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "io/history_file.hpp"
#include "model/grips.hpp"
#include "model/traits.hpp"
#include "scene/output/output_norms.hpp"
#include "scene/output/strain_columns.hpp"

namespace ixos {
namespace {

/// Collects columns, each of which is new.
class Columns {
 public:
  /// Adds the column that the list at `path` asks for.
  void add(const std::string& path, const std::string& column) {
    check_column_name(path, column);
    if (std::find(names_.begin(), names_.end(), column) != names_.end())
      throw InputError(fmt::format("{}: history.csv has a column \"{}\" already; choose another name", path, column));
    names_.push_back(column);
  }
  void add(const std::string& path, const std::string& stem, const std::string& axes) {
    for (char axis : axes) add(path, stem + axis);
  }
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
};

void add_sums(Columns& columns, const std::string& axes) {
  for (const char* name : {"step", "time", "time_step", "kinetic_energy", "elastic_energy", "contact_energy",
                           "external_work", "dissipated_energy", "total_energy"})
    columns.add("", name);
  columns.add("", "linear_momentum_", axes);
  columns.add("", "angular_momentum_", axes.size() == 3 ? axes : "z");
  columns.add("", "contact_force_", axes);
  for (const char* name : {"contact_measure", "min_gap", "newton_iterations", "linear_iterations", "wall_seconds"})
    columns.add("", name);
}

/// Returns the column of a source: that of "friction of Upper wall" is "dissipated_friction_of_Upper wall".
std::string dissipation_column(const std::string& source) {
  const std::string of = " of ";
  const auto place = source.find(of);
  if (place == std::string::npos) return "dissipated_" + source;
  return "dissipated_" + source.substr(0, place) + "_of_" + source.substr(place + of.size());
}

/// Returns the list that a source of dissipation belongs to.
std::string list_of(const Model& model, const std::string& source) {
  for (const auto& [kind, list] : {std::pair<std::string, std::string>("friction of ", "Interactions/"),
                                   {"damage of ", "Interactions/"},
                                   {"dashpots of ", "Grips/"}}) {
    if (source.rfind(kind, 0) != 0) continue;
    const std::string name = source.substr(kind.size());
    const bool is_grip =
        std::any_of(model.grips().begin(), model.grips().end(), [&](const Grip& grip) { return grip.name == name; });
    return (list == "Grips/" && !is_grip ? "Rigid Bodies/" : list) + name;
  }
  return "Materials";
}

}  // namespace

HistoryColumns history_columns(const Simulation& simulation) {
  const Model& model = simulation.model();
  const LocalMesh& mesh = model.mesh();
  const std::string axes = mesh.dimension == 2 ? "xy" : "xyz", spins = mesh.dimension == 2 ? "z" : "xyz";
  Columns columns;
  add_sums(columns, axes);
  std::vector<std::string> reactions;
  const auto add_reaction = [&](const std::string& path, const std::string& name) {
    columns.add(path, "reaction_" + name + "_", axes);
    reactions.insert(reactions.end(), columns.names().end() - mesh.dimension, columns.names().end());
  };
  for (const std::string& set : simulation.output().reactions) add_reaction("Output/Reactions", set);
  for (const Grip& grip : model.grips()) {
    const std::string path = "Grips/" + grip.name;
    add_reaction(path, grip.name);
    if (!mesh.axisymmetric) columns.add(path, "moment_" + grip.name + "_", spins);
  }
  for (const Probe& probe : simulation.probes())
    for (const char* field : {"_u", "_v"}) columns.add("Output/Probes/" + probe.name, probe.name + field, axes);
  for (const RigidBody& body : model.rigid_bodies()) {
    const std::string path = "Rigid Bodies/" + body.name();
    for (const char* field : {"_u", "_v"}) columns.add(path, body.name() + field, axes);
    for (const char* field : {"_r", "_w"})
      if (!mesh.axisymmetric) columns.add(path, body.name() + field, spins);
  }
  if (has_interaction_columns(simulation.output(), simulation.interactions().size()))
    for (const std::string& name : model.interaction_names()) {
      const std::string path = "Interactions/" + name;
      columns.add(path, "contact_force_" + name + "_", axes);
      if (!mesh.axisymmetric) columns.add(path, "contact_moment_" + name + "_", spins);
      columns.add(path, "contact_measure_" + name);
      columns.add(path, "min_gap_" + name);
    }
  for (const std::string& name : model.interaction_names())
    if (has_friction(model, name)) {
      const std::string path = "Interactions/" + name;
      columns.add(path, "friction_force_" + name + "_", axes);
      for (const char* stem : {"mean_slip_", "sliding_measure_", "sticking_measure_"}) columns.add(path, stem + name);
    }
  for (const std::string& source : model.dissipation_names())
    columns.add(list_of(model, source), dissipation_column(source));
  for (const std::string& field : simulation.output().norms) columns.add("Output/Norms", norm_column(field));
  if (simulation.output().strains)
    for (const char* column : strain_columns) columns.add("Output/Strains", column);
  return {columns.names(), reactions};
}

}  // namespace ixos
