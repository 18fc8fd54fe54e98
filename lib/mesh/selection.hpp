/// Sets of sides and nodes chosen by their place.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/region.hpp"

namespace ixos {

/// Returns the set of that name; null if there is none. `Set`: SideSet or NodeSet.
template <class Set>
const Set* find_set(const std::vector<Set>& sets, const std::string& name) {
  const auto found = std::find_if(sets.begin(), sets.end(), [&](const Set& set) { return set.name == name; });
  return found == sets.end() ? nullptr : &*found;
}

/// Returns the side set of that name. Throws InputError that names the nearest one.
const SideSet& side_set_named(const Mesh& mesh, const std::string& name);

/// Returns a message: no set of a mesh that has sets of these names has that name. `what`: "side set" or "node set".
std::string no_such_set(const std::string& what, const std::string& name, const std::vector<std::string>& names);

/// Adds the side set `name`: the sides of the set `from`, or of the whole boundary if `from` is empty, that lie in the
/// region. Throws InputError if `from` does not exist, `name` exists already, the region holds no side, or it leaves
/// out sides of which it is in doubt: Inside::is_doubtful().
void add_side_set(Mesh& mesh, const std::string& name, const std::string& from, const Region& region);

/// Adds the node set `name`: the nodes of the set `from` in the region, or of the whole mesh if `from` is empty. Throws
/// InputError likewise, and if the region has a `normal`.
void add_node_set(Mesh& mesh, const std::string& name, const std::string& from, const Region& region);

}  // namespace ixos
