#include "io/gmsh_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "base/error.hpp"
#include "fem/cell_info.hpp"
#include "io/mesh_file.hpp"
#include "io/msh_file.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/normalize.hpp"
#include "mesh/turned_cells.hpp"

namespace ixos {
namespace {

/// gmsh's numbers of the types that Ixos computes with, by dimension; those of one dimension less are their sides.
constexpr std::array<int, 4> cell_types{15, 1, 3, 5};

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
          fmt::format("has no cells: a mesh needs quadrilaterals (2D) or hexahedra (3D){}", missing_group()));
    mesh_.dimension = 3;
    mesh_.coordinates = file_.coordinates;
    check_cells();
    add_blocks();
    add_side_sets();
    add_node_sets();
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

  /// Quadrilaterals in space may be the sides of cells that are missing.
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

  /// Throws InputError if an element that is to be a cell is of another type, or belongs to several groups.
  void check_cells() const {
    for (const MshElements& elements : file_.elements) {
      if (elements.dimension != dimension_) continue;
      const MshType type = msh_type(elements.type);
      if (elements.type != cell_info(cube_type(dimension_)).gmsh)
        throw InputError(
            fmt::format("has {} with {} nodes; quadrilaterals with 4 nodes (2D) and hexahedra with 8 (3D) "
                        "are allowed; Mesh/Cell Order 2 makes quadratic cells of them. {}",
                        type.name, type.nodes, recombining_recipe(dimension_)));
      const std::vector<int>& groups = groups_of(elements);
      if (groups.size() > 1)
        throw InputError(
            fmt::format("the {} of entity {} belong to the physical groups \"{}\" and \"{}\"; one is "
                        "allowed, because a cell belongs to one block",
                        type.name, elements.entity, name_of({dimension_, groups[0]}, "block"),
                        name_of({dimension_, groups[1]}, "block")));
    }
  }

  /// Physical groups first, in the order of their tags.
  void add_blocks() {
    std::set<std::string> taken;
    std::map<std::string, std::size_t> places;
    const auto add = [&](const std::string& name, const MshElements& elements) {
      const auto place = places.emplace(name, mesh_.blocks.size()).first->second;
      if (place == mesh_.blocks.size()) mesh_.blocks.push_back({name, cube_type(dimension_), {}});
      std::vector<int>& nodes = mesh_.blocks[place].nodes;
      nodes.insert(nodes.end(), elements.nodes.begin(), elements.nodes.end());
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
    if (elements.type != cell_types[static_cast<std::size_t>(dimension_ - 1)])
      throw InputError(fmt::format("the physical group \"{}\" has {} with {} nodes, which are no sides of {}", set.name,
                                   type.name, type.nodes, dimension_ == 2 ? "quadrilaterals" : "hexahedra"));
    const auto nodes = static_cast<std::size_t>(type.nodes);
    for (auto first = elements.nodes.begin(); first != elements.nodes.end(); first += type.nodes) {
      const SideCorners corners = sorted_corners({first, first + type.nodes});
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
};

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
  return mesh_file_entry("Gmsh",
                         "A mesh of quadrilaterals (2D) or hexahedra (3D), read from a file of gmsh (MSH 4.1, ASCII or "
                         "binary). Physical groups become blocks, side sets and node sets of their names.",
                         read_gmsh_mesh);
}

}  // namespace ixos
