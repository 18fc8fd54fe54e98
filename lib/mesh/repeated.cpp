#include "mesh/repeated.hpp"

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

}  // namespace

Mesh repeated(std::vector<Mesh> copies) {
  std::vector<MeshPart> parts;
  for (Mesh& copy : copies) parts.push_back({std::to_string(parts.size() + 1), std::move(copy)});
  Mesh all = joined_parts(parts);
  const Mesh& first = parts.front().mesh;
  const std::size_t count = first.blocks.size();
  for (const MeshPart& part : parts) {
    bool alike = part.mesh.blocks.size() == count && part.mesh.side_sets.size() == first.side_sets.size() &&
                 part.mesh.node_sets.size() == first.node_sets.size();
    for (std::size_t b = 0; b < count && alike; ++b) alike = part.mesh.blocks[b].type == first.blocks[b].type;
    if (!alike) throw InputError("copy " + part.name + " has other blocks or sets than copy 1");
  }
  // Cells pass into the blocks of the first copy; sides and hanging sides follow them.
  std::vector<ElementBlock> blocks;
  for (std::size_t b = 0; b < count; ++b) {
    blocks.push_back(all.blocks[b]);
    blocks.back().name = first.blocks[b].name;
    blocks.back().file_numbers.clear();  // of one copy
  }
  std::vector<int> shift(all.blocks.size(), 0);
  for (std::size_t b = count; b < all.blocks.size(); ++b) {
    ElementBlock& target = blocks[b % count];
    shift[b] = target.cells();
    target.nodes.insert(target.nodes.end(), all.blocks[b].nodes.begin(), all.blocks[b].nodes.end());
  }
  const auto move = [&](Side& side) {
    side.cell += shift[static_cast<std::size_t>(side.block)];
    side.block %= static_cast<int>(count);
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
