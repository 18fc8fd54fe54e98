/// Checks of the blocks and sets of a mesh that a program provides, whole or distributed.
#pragma once
#include <fmt/format.h>

#include <array>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "mesh/mesh.hpp"

namespace ixos {

/// Throws InputError if a name is empty or given twice. `what`: "block", "node set" or "side set".
template <class Named>
void check_names(const std::vector<Named>& all, const char* what) {
  std::set<std::string> names;
  for (const Named& one : all) {
    if (one.name.empty()) throw InputError(fmt::format("a {} has an empty name", what));
    if (!names.insert(one.name).second) throw InputError(fmt::format("two {}s have the name \"{}\"", what, one.name));
  }
}

/// The limits of the numbers in a Side of one block.
struct SideLimits {
  std::size_t cells = 0;
  int sides = 0;  ///< of a cell
};

/// Throws InputError if a side of the set does not exist, or is given twice. `blocks`: by block; `where`: "", or " on
/// this rank".
inline void check_sides(const SideSet& set, const std::vector<SideLimits>& blocks, const char* where = "") {
  std::set<std::array<int, 3>> seen;
  for (const Side& side : set.sides) {
    const bool has_block = side.block >= 0 && static_cast<std::size_t>(side.block) < blocks.size();
    const SideLimits limits = has_block ? blocks[static_cast<std::size_t>(side.block)] : SideLimits{};
    if (side.cell < 0 || static_cast<std::size_t>(side.cell) >= limits.cells || side.side < 0 ||
        side.side >= limits.sides)
      throw InputError(fmt::format("side set \"{}\" has side {} of cell {} of block {}, which does not exist{}",
                                   set.name, side.side, side.cell, side.block, where));
    if (!seen.insert({side.block, side.cell, side.side}).second)
      throw InputError(fmt::format("side set \"{}\" has side {} of cell {} of block {} twice", set.name, side.side,
                                   side.cell, side.block));
  }
}

}  // namespace ixos
