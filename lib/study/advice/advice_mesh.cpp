#include "study/advice/advice_mesh.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Teuchos_Array.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "adapt/options.hpp"
#include "io/drawing.hpp"
#include "io/gmsh_mesh.hpp"
#include "parameters/parameter_entries.hpp"
#include "study/common/tuning.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;

/// A number of cells that a generator takes, and its place.
struct CellCount {
  std::string path;          ///< of the parameter
  std::vector<int> numbers;  ///< along each edge; one for a parameter that is no array
  bool array = false;
  int step = 1;   ///< the numbers must be multiples of it
  int power = 1;  ///< of the refinement in the number: 1 along an edge, 3 in a volume
};

/// Adds the numbers of a list that chooses a generator. Returns why there are none; empty if there are some.
std::string add_counts(const List& mesh, const std::string& path, std::vector<CellCount>& counts, int& dimension) {
  const std::string& type = mesh.get<std::string>("Type");
  if (type == "Parts" || type == "Array") {
    for (const auto& [name, entry] : entries(mesh.sublist(type))) {
      if (!entry.isList()) continue;
      std::string part = path;
      part.append("/").append(type).append("/").append(name);
      std::string why = add_counts(mesh.sublist(type).sublist(name), part, counts, dimension);
      if (!why.empty()) return why;
    }
    return {};
  }
  if (!mesh.isSublist(type)) return "the mesh is not made by a generator";
  const List& made = mesh.sublist(type);
  if (type == "Box") {
    dimension = made.get<int>("Dimension");
    const std::vector<int> divisions = made.get<Teuchos::Array<int>>("Divisions").toVector();
    counts.push_back({path + "/Box/Divisions", divisions, true, 1, 1});
  } else if (type == "Disk") {
    counts.push_back({path + "/Disk/Core Divisions", {made.get<int>("Core Divisions")}, false, 2, 1});
    counts.push_back({path + "/Disk/Rings", {made.get<int>("Rings")}, false, 1, 1});
  } else if (type == "Spatula" && made.get<int>("Stations") == 0) {
    dimension = 3;
    counts.push_back({path + "/Spatula/Target Cells", {made.get<int>("Target Cells")}, false, 1, 3});
  } else {
    return "the mesh " + type + " has no parameter that refines it";
  }
  return {};
}

/// Returns the path of the factor of all sizes of a drawing; empty if the mesh is not made of one.
std::string size_factor(const List& mesh) {
  if (mesh.get<std::string>("Type") != gmsh_mesh_name) return {};
  return is_drawing(mesh.sublist(gmsh_mesh_name).get<std::string>("File")) ? "Mesh/Gmsh/Drawing/Size Factor" : "";
}

/// Returns the levels of a drawing: gmsh makes all cells larger or smaller.
MeshLevels drawing_levels(const List& mesh, const std::string& path) {
  const List& gmsh = mesh.sublist(gmsh_mesh_name);
  const double factor = gmsh.sublist("Drawing").get<double>("Size Factor");
  MeshLevels result;
  const int dimension = gmsh.get<int>("Dimension");
  result.dimension = dimension > 0                                                                ? dimension
                     : std::filesystem::path(gmsh.get<std::string>("File")).extension() == ".geo" ? 2
                                                                                                  : 3;
  for (int k = -tuning::coarser_meshes; k <= tuning::finer_meshes; ++k) {
    const double size = std::pow(2.0, -k);
    result.levels.push_back({fmt::format("sizes x {}", size), size, {fmt::format("{}={}", path, factor * size)}});
  }
  result.scene_level = static_cast<std::size_t>(tuning::coarser_meshes);
  return result;
}

/// Returns the level with 2^k times the numbers along an edge; one without settings if they are no whole numbers.
AdviceLevel level(const std::vector<CellCount>& counts, int k) {
  AdviceLevel result{"", std::pow(2.0, -k), {}};
  for (const CellCount& count : counts) {
    std::vector<int> numbers;
    for (int number : count.numbers) {
      const double scaled = number * std::pow(2.0, k * count.power);
      const bool volume = count.power > 1;
      const double rounded = volume ? std::round(scaled) : scaled;
      const double least = volume ? 200 : std::min(count.step * tuning::fewest_cells, number);
      if (rounded != std::floor(rounded) || rounded < least ||
          rounded > (volume ? 2e7 : tuning::most_cells_along_an_edge) || std::fmod(rounded, count.step) != 0)
        return {"", 0, {}};
      numbers.push_back(static_cast<int>(rounded));
    }
    const std::string text = fmt::format("{}", fmt::join(numbers, ", "));
    result.settings.push_back(count.path + "=" + (count.array ? "{" + text + "}" : text));
    result.label += (result.label.empty() ? "" : ", ") + fmt::format("{}", fmt::join(numbers, " x "));
  }
  return result;
}

/// Scales the bounds of a mesh that follows the front, for its faces and its strain, with the cells of each level. If
/// the mesh has no parameter that refines it, makes levels with fewer and with more halvings.
void add_bounds(const List& adapt, MeshLevels& meshes) {
  const int halvings = adapt.get<int>("Levels");
  if (halvings == 0) return;
  const auto bounds = [&](double size) {
    return Assignments{
        fmt::format("Mesh/Adapt/Part={:.6g}", std::clamp(adapt.get<double>("Part") * size, least_adapt_part, 1.0)),
        fmt::format("Mesh/Adapt/Strain={:.6g}", adapt.get<double>("Strain") * size)};
  };
  if (meshes.levels.size() == 1) {
    meshes.note.clear();
    meshes.levels.clear();
    meshes.scene_level = static_cast<std::size_t>(std::min(tuning::coarser_meshes, halvings - 1));
    for (int k = -static_cast<int>(meshes.scene_level); k <= tuning::finer_meshes; ++k) {
      if (halvings + k > most_adapt_levels) break;
      meshes.levels.push_back({fmt::format("{} halvings", halvings + k),
                               std::pow(2.0, -k),
                               {fmt::format("Mesh/Adapt/Levels={}", halvings + k)}});
    }
  }
  for (AdviceLevel& level : meshes.levels)
    for (const std::string& bound : bounds(level.size)) level.settings.push_back(bound);
}

MeshLevels levels_of_cells(const List& mesh) {
  if (const std::string path = size_factor(mesh); !path.empty()) return drawing_levels(mesh, path);
  MeshLevels result;
  std::vector<CellCount> counts;
  result.note = add_counts(mesh, "Mesh", counts, result.dimension);
  if (!result.note.empty()) {
    result.levels = {{"as given", 1, {}}};
    return result;
  }
  int coarsest = 0;
  while (coarsest > -tuning::coarser_meshes && level(counts, coarsest - 1).size > 0) --coarsest;
  for (int k = coarsest; k <= tuning::finer_meshes; ++k) {
    const AdviceLevel next = level(counts, k);
    if (next.size == 0) break;
    result.levels.push_back(next);
  }
  result.scene_level = static_cast<std::size_t>(-coarsest);
  return result;
}

}  // namespace

MeshLevels mesh_levels(const List& mesh) {
  MeshLevels result = levels_of_cells(mesh);
  add_bounds(mesh.sublist("Adapt"), result);
  return result;
}

}  // namespace ixos
