#include "io/gmsh_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <vector>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "fem/cell_info.hpp"
#include "io/disk_file.hpp"
#include "io/file_cells.hpp"
#include "mesh/bounds.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/node_place.hpp"
#include "mesh/side_set_nodes.hpp"

namespace ixos {
namespace {

/// Elements by gmsh's type: nodes from 1, one element after the other, in gmsh's order.
using Elements = std::map<int, std::vector<int>>;

constexpr int point_type = 15;

/// A physical group, and its one entity of the same number.
struct Group {
  int dimension;
  int tag;
  std::string name;
  Vec<3> first{};  ///< place of a point
  Elements elements;
};

/// Returns gmsh's type of a side of so many corners and nodes.
int type_of_side(std::size_t corners, std::size_t nodes) {
  if (corners == 2) return nodes == 2 ? 1 : 8;
  if (corners == 3) return nodes == 3 ? 2 : 9;
  return nodes == 4 ? 3 : 10;
}

int nodes_of_type(int type) {
  if (type == point_type) return 1;
  if (type == 1 || type == 8) return type == 1 ? 2 : 3;
  return static_cast<int>(gmsh_cells(type)->order.size());
}

class Writer {
 public:
  explicit Writer(const Mesh& mesh) : mesh_(mesh) {
    add_blocks();
    add_side_sets();
    add_node_sets();
  }

  std::string text() {
    line("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n{}", groups_.size());
    for (const Group& group : groups_) line("{} {} \"{}\"", group.dimension, group.tag, group.name);
    line("$EndPhysicalNames");
    write_entities();
    write_nodes();
    write_elements();
    return std::move(text_);
  }

 private:
  template <class... Values>
  void line(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
    text_ += '\n';
  }

  Group& add_group(int dimension, const std::string& name, const char* kind) {
    if (name.find_first_of("\"\n\r") != std::string::npos)
      throw InputError(
          fmt::format("the name of the {} {} has a quote or a line break; gmsh's files allow all other characters",
                      kind, printable(name)));
    groups_.push_back({dimension, ++tags_[dimension], name, {}, {}});
    return groups_.back();
  }

  void add_blocks() {
    std::map<std::string, std::size_t> place;
    for (const ElementBlock& block : mesh_.blocks) {
      const int type = cell_info(block.type).gmsh;
      if (type == 0 || mesh_.plain_nodes >= 0)
        throw InputError("the mesh has enriched cells, which gmsh does not have; write it without a Contact Element");
      const auto [found, is_new] = place.try_emplace(block.name, groups_.size());
      if (is_new) add_group(mesh_.dimension, block.name, "block");
      if (block.nodes.empty()) continue;
      std::vector<int>& nodes = groups_[found->second].elements[type];
      const std::vector<int>& order = gmsh_cells(type)->order;
      for (int cell = 0; cell < block.cells(); ++cell) {
        const std::size_t first = nodes.size();
        nodes.resize(first + order.size());
        for (std::size_t a = 0; a < order.size(); ++a)
          nodes[first + static_cast<std::size_t>(order[a])] =
              block.nodes[cell_entry(cell, static_cast<int>(order.size()), static_cast<int>(a))] + 1;
      }
    }
  }

  void add_side_sets() {
    for (const SideSet& set : mesh_.side_sets) {
      Group& group = add_group(mesh_.dimension - 1, set.name, "side set");
      for (const Side& side : set.sides) {
        const CellType type = mesh_.blocks[static_cast<std::size_t>(side.block)].type;
        const std::vector<int> nodes = nodes_of_side(mesh_, side);
        const std::size_t corners = side_nodes(corner_type(type), side.side).size();
        std::vector<int>& own = group.elements[type_of_side(corners, nodes.size())];
        for (const int node : nodes) own.push_back(node + 1);
      }
    }
  }

  void add_node_sets() {
    for (const NodeSet& set : mesh_.node_sets) {
      const auto same = std::find_if(mesh_.side_sets.begin(), mesh_.side_sets.end(),
                                     [&](const SideSet& sides) { return sides.name == set.name; });
      if (same != mesh_.side_sets.end()) {
        if (nodes_of(mesh_, *same) == std::set<int>(set.nodes.begin(), set.nodes.end())) continue;
      }
      Group& group =
          add_group(0, same == mesh_.side_sets.end() ? set.name : unused_name(set.name + "_nodes"), "node set");
      if (!set.nodes.empty()) group.first = node_place(mesh_, set.nodes.front());
      for (const int node : set.nodes) group.elements[point_type].push_back(node + 1);
    }
  }

  /// Returns the name, or one with a number that no side set and no node set has.
  std::string unused_name(const std::string& name) const {
    const auto has_name = [](const auto& sets, const std::string& own) {
      return std::any_of(sets.begin(), sets.end(), [&own](const auto& set) { return set.name == own; });
    };
    std::string result = name;
    for (int k = 2; has_name(mesh_.side_sets, result) || has_name(mesh_.node_sets, result); ++k)
      result = fmt::format("{}_{}", name, k);
    return result;
  }

  void write_entities() {
    line("$Entities\n{} {} {} {}", tags_[0], tags_[1], tags_[2], tags_[3]);
    const auto [low, high] = bounds_of(mesh_);
    for (int dimension = 0; dimension <= 3; ++dimension)
      for (const Group& group : groups_) {
        if (group.dimension != dimension) continue;
        const Vec<3>& x = group.first;
        if (dimension == 0)
          line("{} {} {} {} 1 {}", group.tag, x[0], x[1], x[2], group.tag);
        else
          line("{} {} {} {} {} {} {} 1 {} 0", group.tag, low[0], low[1], low[2], high[0], high[1], high[2], group.tag);
      }
    line("$EndEntities");
  }

  void write_nodes() {
    line("$Nodes\n1 {0} 1 {0}\n{1} 1 0 {0}", mesh_.nodes(), mesh_.dimension);
    for (int node = 1; node <= mesh_.nodes(); ++node) line("{}", node);
    for (int node = 0; node < mesh_.nodes(); ++node) {
      const Vec<3> x = node_place(mesh_, node);
      line("{} {} {}", x[0], x[1], x[2]);
    }
    line("$EndNodes");
  }

  void write_elements() {
    std::size_t blocks = 0, count = 0;
    for (const Group& group : groups_)
      for (const auto& [type, nodes] : group.elements) {
        ++blocks;
        count += nodes.size() / static_cast<std::size_t>(nodes_of_type(type));
      }
    line("$Elements\n{} {} 1 {}", blocks, count, count);
    std::size_t tag = 0;
    for (const Group& group : groups_)
      for (const auto& [type, nodes] : group.elements) {
        const auto n = static_cast<std::size_t>(nodes_of_type(type));
        line("{} {} {} {}", group.dimension, group.tag, type, nodes.size() / n);
        for (std::size_t first = 0; first < nodes.size(); first += n) {
          fmt::format_to(std::back_inserter(text_), "{}", ++tag);
          for (std::size_t a = 0; a < n; ++a) fmt::format_to(std::back_inserter(text_), " {}", nodes[first + a]);
          text_ += '\n';
        }
      }
    line("$EndElements");
  }

  const Mesh& mesh_;
  std::vector<Group> groups_;
  std::map<int, int> tags_;  ///< by dimension: the last one
  std::string text_;
};

}  // namespace

void write_gmsh_mesh(const Mesh& mesh, const std::string& path) {
  write_whole_file(path, Writer(without_bubbles(mesh)).text());
}

}  // namespace ixos
