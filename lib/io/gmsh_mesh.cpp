#include "io/gmsh_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "base/error.hpp"
#include "fem/cell_info.hpp"
#include "io/drawing.hpp"
#include "io/file_cells.hpp"
#include "io/mesh_file.hpp"
#include "io/msh_file.hpp"
#include "mesh/bounds.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/normalize.hpp"
#include "mesh/turned_cells.hpp"
#include "parameters/validation.hpp"

namespace ixos {
namespace {

/// Returns the number of corners of elements of gmsh's type; 0 if they can be no side of a cell.
int corners_of_side(int type) {
  if (msh_type(type).dimension == 1) return msh_type(type).nodes > 0 ? 2 : 0;
  const FileCells* const cells = gmsh_cells(type);
  return cells == nullptr ? 0 : nodes_per_cell(corner_type(cells->type));
}

class Builder {
 public:
  explicit Builder(const MshFile& file) : file_(file) {
    for (const MshElements& elements : file.elements) dimension_ = std::max(dimension_, elements.dimension);
    for (const auto& group : file.names) members_[group.first];
    for (const MshElements& elements : file.elements)
      for (int tag : groups_of(elements)) add_member({elements.dimension, tag}, elements);
  }

  Mesh build() {
    if (dimension_ < 2)
      throw InputError(
          fmt::format("has no cells: a mesh needs surface elements (2D) or volume elements (3D){}", missing_group()));
    mesh_.dimension = 3;
    mesh_.coordinates = file_.coordinates;
    check_cells();
    add_blocks();
    add_side_sets();
    add_node_sets();
    reader_.finish();
    drop_unused_nodes(mesh_);
    if (dimension_ == 2) flatten_surfaces();
    turn_cells(mesh_);
    return std::move(mesh_);
  }

 private:
  using Members = std::vector<const MshElements*>;

  /// Throws InputError if copies of the groups' elements would be far larger than the file.
  void add_member(const MshTag& group, const MshElements& elements) {
    constexpr std::size_t most = 10;  // times the file's length, as for Exodus
    entries_ += elements.nodes.size();
    if (entries_ / most > file_.length)
      throw InputError(fmt::format("is damaged: its physical groups up to \"{}\" claim {} entries",
                                   name_of(group, "group"), entries_));
    members_[group].push_back(&elements);
  }

  /// Returns why the file may lack the cells beside its sides: nothing if no element is in a group.
  std::string missing_group() const {
    const bool grouped = std::any_of(members_.begin(), members_.end(), [](const auto& m) { return !m.second.empty(); });
    return grouped
               ? ". gmsh saves only elements in physical groups: add Physical Surface (2D) or Physical Volume (3D), "
                 "or Mesh.SaveAll = 1"
               : "";
  }

  /// Surface elements in space may be the sides of cells that are missing.
  void flatten_surfaces() {
    const bool solid = std::any_of(file_.groups.begin(), file_.groups.end(),
                                   [](const auto& entity) { return entity.first.first == 3; });
    try {
      flatten(mesh_);
    } catch (const InputError& error) {
      throw InputError(error.what() + (solid ? missing_group() : ""));
    }
  }

  const std::vector<int>& groups_of(const MshElements& elements) const {
    static const std::vector<int> none;
    const auto found = file_.groups.find({elements.dimension, elements.entity});
    return found == file_.groups.end() ? none : found->second;
  }

  /// Returns the name of a physical group, or prefix_tag.
  std::string name_of(const MshTag& group, const char* prefix) const {
    const auto found = file_.names.find(group);
    return found == file_.names.end() || found->second.empty() ? fmt::format("{}_{}", prefix, group.second)
                                                               : found->second;
  }

  static std::string new_name(std::string name, const char* kind, std::set<std::string>& taken) {
    if (!taken.insert(name).second)
      throw InputError(
          fmt::format("two physical groups make the {} \"{}\"; each group needs its own name", kind, name));
    return name;
  }

  /// Throws InputError if an element that is to be a cell belongs to several groups.
  void check_cells() const {
    for (const MshElements& elements : file_.elements) {
      if (elements.dimension != dimension_) continue;
      const MshType type = msh_type(elements.type);
      if (gmsh_cells(elements.type) == nullptr)
        throw std::logic_error(fmt::format("no cells are known for {} with {} nodes", type.name, type.nodes));
      const std::vector<int>& groups = groups_of(elements);
      if (groups.size() > 1)
        throw InputError(
            fmt::format("the {} of entity {} belong to the physical groups \"{}\" and \"{}\"; one is "
                        "allowed, because a cell belongs to one block",
                        type.name, elements.entity, name_of({dimension_, groups[0]}, "block"),
                        name_of({dimension_, groups[1]}, "block")));
    }
  }

  /// Physical groups first, in the order of their tags; each makes a block for each type of its cells.
  void add_blocks() {
    std::set<std::string> taken;
    std::map<std::pair<std::string, CellType>, std::size_t> places;
    const auto add = [&](const std::string& name, const MshElements& elements) {
      const FileCells& cells = *gmsh_cells(elements.type);
      const auto place = places.emplace(std::pair(name, cells.type), mesh_.blocks.size()).first->second;
      if (place == mesh_.blocks.size()) mesh_.blocks.push_back({name, cells.type, {}});
      reader_.add(cells, elements.nodes, mesh_.blocks[place]);
      std::vector<long long>& tags = mesh_.blocks[place].file_numbers;
      tags.insert(tags.end(), elements.tags.begin(), elements.tags.end());
    };
    for (const auto& [group, members] : members_) {
      if (group.first != dimension_) continue;
      const std::string name = new_name(name_of(group, "block"), "block", taken);
      for (const MshElements* elements : members) add(name, *elements);
    }
    for (const MshElements& elements : file_.elements)
      if (elements.dimension == dimension_ && groups_of(elements).empty()) add("body", elements);
  }

  void add_side_sets() {
    std::set<std::string> taken;
    std::vector<CellSide> sides;
    for (const auto& [group, members] : members_) {
      if (group.first != dimension_ - 1) continue;
      if (sides.empty()) sides = sorted_sides(mesh_);
      SideSet set{new_name(name_of(group, "surface"), "side set", taken), {}};
      std::set<SideCorners> distinct;
      for (const MshElements* elements : members) add_sides(*elements, sides, distinct, set);
      mesh_.side_sets.push_back(std::move(set));
    }
  }

  void add_sides(const MshElements& elements, const std::vector<CellSide>& sides, std::set<SideCorners>& distinct,
                 SideSet& set) const {
    const MshType type = msh_type(elements.type);
    const int corner_count = corners_of_side(elements.type);
    if (corner_count == 0)
      throw InputError(fmt::format("the physical group \"{}\" has {} with {} nodes, which are no sides of cells",
                                   set.name, type.name, type.nodes));
    const auto nodes = static_cast<std::size_t>(type.nodes);
    for (auto first = elements.nodes.begin(); first != elements.nodes.end(); first += type.nodes) {
      const SideCorners corners = sorted_corners({first, first + corner_count});
      const auto [begin, end] = sides_with(sides, corners);
      const double* place = &mesh_.coordinates[3 * static_cast<std::size_t>(*first)];
      const std::string where = fmt::format("({:.6g}, {:.6g}, {:.6g})", place[0], place[1], place[2]);
      if (begin == end)
        throw InputError(
            fmt::format("the physical group \"{}\" has an element of {} nodes at {} that is no side of a "
                        "cell; is the {} beside it in a physical group, too?",
                        set.name, nodes, where, dimension_ == 2 ? "surface" : "volume"));
      if (!distinct.insert(corners).second)
        throw InputError(fmt::format("the physical group \"{}\" holds the side at {} twice", set.name, where));
      set.sides.push_back(begin->side);
    }
  }

  void add_node_sets() {
    std::set<std::string> taken;
    for (const auto& [group, members] : members_) {
      if (group.first >= dimension_) continue;
      const char* prefix = group.first == dimension_ - 1 ? "surface" : "nodelist";
      NodeSet set{new_name(name_of(group, prefix), "node set", taken), {}};
      for (const MshElements* elements : members)
        set.nodes.insert(set.nodes.end(), elements->nodes.begin(), elements->nodes.end());
      std::sort(set.nodes.begin(), set.nodes.end());
      set.nodes.erase(std::unique(set.nodes.begin(), set.nodes.end()), set.nodes.end());
      mesh_.node_sets.push_back(std::move(set));
    }
  }

  const MshFile& file_;
  int dimension_ = 0;
  std::map<MshTag, Members> members_;  ///< the elements of each physical group
  std::size_t entries_ = 0;            ///< nodes of the elements of all groups, together
  Mesh mesh_;
  FileCellReader reader_{mesh_};
};

const char* const drawing = "Drawing";

/// `node`: a list of the entry.
DrawingOptions options_of(const SceneNode& node) {
  DrawingOptions options = read_drawing(node.sublist(drawing));
  options.dimension = node.count("Dimension");
  options.length_unit = node.number("Length Unit");
  return options;
}

/// Throws InputError if a box of Size At does not meet the box around the nodes, and so has no effect.
void refuse_boxes_outside(const SceneNode& node, const DrawingOptions& options, const Mesh& mesh) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const Bounds bounds = bounds_of(mesh);
  for (const LocalSize& own : options.local)
    for (std::size_t i = 0; i < std::min(d, own.lower.size()); ++i) {
      const double low = options.length_unit * bounds.lower[i], high = options.length_unit * bounds.upper[i];
      if (own.lower[i] > high || own.upper[i] < low)
        throw InputError(fmt::format(
            "{}/Size At/{}: the box from {:.6g} to {:.6g} L0 in direction {} lies beside the drawing, which is from "
            "{:.6g} to {:.6g} L0 there",
            node.path_of(drawing), own.name, own.lower[i], own.upper[i], "xyz"[i], low, high));
    }
}

}  // namespace

Mesh read_gmsh_mesh(const std::string& path) {
  const MshFile file = read_msh_file(MshSource(path));
  try {
    return Builder(file).build();
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

MeshEntry gmsh_mesh() {
  return mesh_file_entry(
      gmsh_mesh_name,
      "A mesh read from a file of gmsh (MSH 4.1 or 2.2, ASCII or binary), of first or second order: triangles "
      "and quadrilaterals (2D), tetrahedra, prisms, pyramids and hexahedra (3D). Physical groups become "
      "blocks, side sets and node sets of their names. The file may be a drawing (.geo, .step, .brep, .iges): gmsh, "
      "which has to be installed, makes the mesh then.",
      [](const SceneNode& node, const std::string& path) {
        if (!is_drawing(path)) return read_gmsh_mesh(path);
        const DrawingOptions own = options_of(node);
        const DrawnMesh drawn = drawn_mesh(path, own);
        Mesh mesh;
        at(path, [&] { mesh = read_gmsh_mesh(drawn.path); });
        refuse_boxes_outside(node, own, mesh);
        for (const std::string& warning : drawn.warnings)
          mesh.notes.push_back(fmt::format("{}: gmsh warns: {}", path, warning));
        return mesh;
      },
      [](Teuchos::ParameterList& list) {
        declare_drawing(list.sublist(drawing, false, "What gmsh makes of a drawing; of no effect for a mesh."));
      });
}

void prepare_drawing(const SceneNode& node) {
  if (const std::string path = node.text("File"); is_drawing(path)) drawn_mesh(path, options_of(node));
}

}  // namespace ixos
