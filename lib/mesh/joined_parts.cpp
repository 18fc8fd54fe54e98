#include "mesh/joined_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/error.hpp"
#include "mesh/normalize.hpp"

namespace ixos {
namespace {

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

void check_part_names(const std::vector<MeshPart>& parts) {
  if (parts.empty()) throw InputError("there is no part; give at least one, a list of a name of your choice");
  for (const MeshPart& part : parts) {
    if (part.name.empty()) throw InputError("a part has an empty name");
    if (!std::all_of(part.name.begin(), part.name.end(), is_plain))
      throw InputError(
          fmt::format("part \"{}\": a name of a part has letters, digits, \"_\" and \"-\" only, since it "
                      "begins the names of its blocks and sets",
                      part.name));
    const auto same = [&part](const MeshPart& other) { return other.name == part.name; };
    if (std::count_if(parts.begin(), parts.end(), same) > 1)
      throw InputError(fmt::format("two parts have the name \"{}\"", part.name));
    for (const MeshPart& other : parts)
      if (is_in_part(other.name, part.name))
        throw InputError(
            fmt::format("the name of the part \"{}\" begins with \"{}\", as the names of the blocks and "
                        "sets of the part \"{}\" do; give one of them another name",
                        part.name, name_in_part(other.name, ""), other.name));
  }
}

void check_meshes(const std::vector<MeshPart>& parts) {
  const MeshPart& first = parts.front();
  for (const MeshPart& part : parts) {
    if (part.mesh.dimension != first.mesh.dimension)
      throw InputError(fmt::format("the part \"{}\" has {} dimensions, but the part \"{}\" has {}", first.name,
                                   first.mesh.dimension, part.name, part.mesh.dimension));
    if (part.mesh.axisymmetric != first.mesh.axisymmetric)
      throw InputError(
          fmt::format("of the parts \"{}\" and \"{}\", one is axisymmetric, the other is not", first.name, part.name));
    if (part.mesh.plain_nodes >= 0)
      throw InputError(
          fmt::format("the part \"{}\" has enriched sides; join parts before they are enriched", part.name));
  }
}

/// The numbers that nodes of a part have in the joined mesh.
struct Numbers {
  int linear_nodes;  ///< of the part
  int first, first_added;
  int of(int node) const { return node < linear_nodes ? first + node : first_added + node - linear_nodes; }
};

int linear_nodes(const Mesh& mesh) { return mesh.linear_nodes < 0 ? mesh.nodes() : mesh.linear_nodes; }

std::vector<int> renumbered(const std::vector<int>& nodes, const Numbers& numbers) {
  std::vector<int> result;
  result.reserve(nodes.size());
  for (int node : nodes) result.push_back(numbers.of(node));
  return result;
}

void append(const MeshPart& part, const Numbers& numbers, Mesh& all) {
  const auto d = static_cast<std::size_t>(all.dimension);
  for (int node = 0; node < part.mesh.nodes(); ++node)
    std::copy_n(&part.mesh.coordinates[static_cast<std::size_t>(node) * d], d,
                &all.coordinates[static_cast<std::size_t>(numbers.of(node)) * d]);
  const int first_block = static_cast<int>(all.blocks.size());
  for (ElementBlock block : part.mesh.blocks) {
    block.name = name_in_part(part.name, block.name);
    block.nodes = renumbered(block.nodes, numbers);
    all.blocks.push_back(std::move(block));
  }
  for (SideSet set : part.mesh.side_sets) {
    set.name = name_in_part(part.name, set.name);
    for (Side& side : set.sides) side.block += first_block;
    all.side_sets.push_back(std::move(set));
  }
  for (const Side& side : part.mesh.hanging_sides)
    all.hanging_sides.push_back({side.block + first_block, side.cell, side.side});
  for (const auto& [a, b, middle] : part.mesh.hanging_edges)
    all.hanging_edges.push_back({numbers.of(a), numbers.of(b), numbers.of(middle)});
  for (const Tie& tie : part.mesh.ties)
    all.ties.push_back({numbers.of(tie.node), renumbered(tie.masters, numbers), tie.weights, tie.in_place});
  for (const int node : part.mesh.nodes_of_tied_sides) all.nodes_of_tied_sides.push_back(numbers.of(node));
  for (const NodeSet& set : part.mesh.node_sets)
    all.node_sets.push_back({name_in_part(part.name, set.name), renumbered(set.nodes, numbers)});
  for (const std::string& note : part.mesh.notes) all.notes.push_back(fmt::format("part \"{}\": {}", part.name, note));
}

}  // namespace

std::string name_in_part(const std::string& part, const std::string& own) { return part + "_" + own; }

bool is_in_part(const std::string& part, const std::string& name) { return name.rfind(name_in_part(part, ""), 0) == 0; }

Mesh joined_parts(const std::vector<MeshPart>& parts) {
  check_part_names(parts);
  check_meshes(parts);
  Mesh all;
  all.dimension = parts.front().mesh.dimension;
  all.axisymmetric = parts.front().mesh.axisymmetric;
  double count = 0;
  for (const MeshPart& part : parts) count += part.mesh.nodes();
  if (count > 1e9)
    throw InputError(fmt::format("the parts have {:.3g} nodes together; at most 1e9 are allowed", count));
  int linear = 0, nodes = 0;
  for (const MeshPart& part : parts) {
    linear += linear_nodes(part.mesh);
    nodes += part.mesh.nodes();
  }
  if (linear < nodes) all.linear_nodes = linear;
  all.coordinates.resize(static_cast<std::size_t>(nodes) * static_cast<std::size_t>(all.dimension));
  Numbers numbers{0, 0, linear};
  for (const MeshPart& part : parts) {
    numbers.linear_nodes = linear_nodes(part.mesh);
    append(part, numbers, all);
    numbers.first += numbers.linear_nodes;
    numbers.first_added += part.mesh.nodes() - numbers.linear_nodes;
  }
  return all;
}

Mesh part_of_joined(const Mesh& joined, const std::string& part, std::vector<int>& old) {
  const auto is_own = [&part](const auto& named) { return is_in_part(part, named.name); };
  Mesh own;
  own.dimension = joined.dimension;
  own.axisymmetric = joined.axisymmetric;
  own.coordinates = joined.coordinates;
  own.linear_nodes = joined.linear_nodes;
  std::copy_if(joined.blocks.begin(), joined.blocks.end(), std::back_inserter(own.blocks), is_own);
  std::copy_if(joined.side_sets.begin(), joined.side_sets.end(), std::back_inserter(own.side_sets), is_own);
  std::copy_if(joined.node_sets.begin(), joined.node_sets.end(), std::back_inserter(own.node_sets), is_own);
  // The blocks of a part are next to each other.
  const auto first = std::find_if(joined.blocks.begin(), joined.blocks.end(), is_own);
  for (SideSet& set : own.side_sets)
    for (Side& side : set.sides) side.block -= static_cast<int>(first - joined.blocks.begin());
  old = drop_unused_nodes(own);
  own.notes.clear();  // the other nodes are those of other parts
  return own;
}

}  // namespace ixos
