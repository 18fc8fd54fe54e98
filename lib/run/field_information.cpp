#include "run/field_information.hpp"

#include <fmt/format.h>

#include "base/printable.hpp"
#include "scene/scene_changes.hpp"

namespace ixos {

const std::vector<std::string>& frame_energies() {
  static const std::vector<std::string> names{"kinetic_energy", "elastic_energy",    "contact_energy",
                                              "external_work",  "dissipated_energy", "total_energy"};
  return names;
}

std::vector<std::string> field_information(const Simulation& simulation, const std::string& scene_file,
                                           const std::vector<OutputField>& fields) {
  const LocalMesh& mesh = simulation.model().mesh();
  const int dimension = mesh.body_dimension();
  const Teuchos::ParameterList& scene = simulation.parameters();
  std::vector<std::string> lines{"written by: Ixos " IXOS_VERSION, "scene: " + printable(scene.name())};
  if (!scene_file.empty()) lines.push_back("scene file: " + printable(scene_file));
  lines.push_back("digest of the scene: " + scene_digest(scene, simulation.mesh_fingerprint()));
  lines.push_back("fingerprint of the mesh: " + simulation.mesh_fingerprint());
  const Teuchos::ParameterList& units = scene.sublist("Units");
  for (const auto& [symbol, entry] : {std::pair{"L0", "Length"}, {"E0", "Energy Density"}, {"T0", "Time"}})
    lines.push_back(fmt::format("{}: {}", symbol, printable(units.get<std::string>(entry))));
  for (const OutputField& field : fields)
    lines.push_back(fmt::format("unit of {}: {}", field.name, unit_in(dimension, field.unit)));
  for (const std::string& energy : frame_energies())
    lines.push_back(fmt::format("unit of {}: {}", energy, unit_in(dimension, "E0 L0^D")));
  if (dimension == 2) lines.emplace_back("plane strain: forces and energies are per depth");
  if (mesh.axisymmetric)
    lines.emplace_back("axisymmetric about y, x is the radius: forces and energies are those of the whole body");
  return lines;
}

}  // namespace ixos
