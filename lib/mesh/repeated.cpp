#include "mesh/repeated.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "mesh/joined_parts.hpp"

namespace ixos {
namespace {

/// Adds the sets of all copies together, in front: of `count` sets of a copy, number k is at k, k + count, ... of
/// `sets`.
template <class Set, class Entries>
void add_unions(const std::vector<Set>& own, std::vector<Set>& sets, Entries Set::*entries) {
  std::vector<Set> all;
  for (std::size_t k = 0; k < own.size(); ++k) {
    Set together{own[k].name, {}};
    for (std::size_t i = k; i < sets.size(); i += own.size())
      (together.*entries).insert((together.*entries).end(), (sets[i].*entries).begin(), (sets[i].*entries).end());
    all.push_back(std::move(together));
  }
  sets.insert(sets.begin(), all.begin(), all.end());
}

/// `Named`: a block or a set.
template <class Named>
void require_alike(const std::vector<Named>& own, const std::vector<Named>& first, const std::string& copy) {
  for (std::size_t k = 0; k < std::max(own.size(), first.size()); ++k)
    if (k >= own.size() || k >= first.size() || own[k].name != first[k].name)
      throw InputError(fmt::format("copy {} has other blocks or sets than copy 1: \"{}\"", copy,
                                   k < own.size() ? own[k].name : first[k].name));
}

}  // namespace

Mesh repeated(std::vector<Mesh> copies) {
  std::vector<MeshPart> parts;
  parts.reserve(copies.size());
  for (Mesh& copy : copies) parts.push_back({std::to_string(parts.size() + 1), std::move(copy)});
  Mesh all = joined_parts(parts);  // refuses none
  const Mesh& first = parts.front().mesh;
  const std::size_t count = first.blocks.size();
  for (const MeshPart& part : parts) {
    require_alike(part.mesh.blocks, first.blocks, part.name);
    require_alike(part.mesh.side_sets, first.side_sets, part.name);
    require_alike(part.mesh.node_sets, first.node_sets, part.name);
    for (std::size_t b = 0; b < count; ++b)
      if (part.mesh.blocks[b].type != first.blocks[b].type)
        throw InputError(fmt::format("the block \"{}\" of copy {} has other cells than that of copy 1",
                                     first.blocks[b].name, part.name));
  }
  // Cells pass into the blocks of the first copy; sides and hanging sides follow them.
  std::vector<ElementBlock> blocks = first.blocks;
  for (ElementBlock& block : blocks) {
    block.nodes.clear();
    block.file_numbers.clear();  // of one copy
  }
  std::vector<Side> starts;  // where the first cell of each block of the joined mesh goes
  for (std::size_t copy = 0; copy < parts.size(); ++copy)
    for (std::size_t own = 0; own < count; ++own) {
      const std::vector<int>& nodes = all.blocks[starts.size()].nodes;
      starts.push_back({static_cast<int>(own), blocks[own].cells(), 0});
      blocks[own].nodes.insert(blocks[own].nodes.end(), nodes.begin(), nodes.end());
    }
  const auto move = [&](Side& side) {
    const Side& start = starts[static_cast<std::size_t>(side.block)];
    side.block = start.block;
    side.cell += start.cell;
  };
  for (SideSet& set : all.side_sets)
    for (Side& side : set.sides) move(side);
  for (Side& side : all.hanging_sides) move(side);
  all.blocks = std::move(blocks);
  add_unions(first.side_sets, all.side_sets, &SideSet::sides);
  add_unions(first.node_sets, all.node_sets, &NodeSet::nodes);
  all.notes = first.notes;
  return all;
}

}  // namespace ixos
