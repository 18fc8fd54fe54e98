#include "mesh/selection.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "mesh/cell_sides.hpp"

namespace ixos {
namespace {

template <class Set>
const Set& set_named(const std::vector<Set>& sets, const std::string& name, const char* what) {
  std::vector<std::string> names;
  for (const Set& set : sets) {
    if (set.name == name) return set;
    names.push_back(set.name);
  }
  throw InputError(no_such_set(what, name, names));
}

template <class Set>
void refuse_known(const std::vector<Set>& sets, const std::string& name, const char* what) {
  if (std::any_of(sets.begin(), sets.end(), [&](const Set& set) { return set.name == name; }))
    throw InputError(std::string(what) + " \"" + name + "\" already exists; choose another name");
}

}  // namespace

const SideSet& side_set_named(const Mesh& mesh, const std::string& name) {
  return set_named(mesh.side_sets, name, "side set");
}

std::string no_such_set(const std::string& what, const std::string& name, const std::vector<std::string>& names) {
  return no_such(what, name, names, "The mesh has") + (names.empty() ? "; Mesh/Sets can select one" : "");
}

void add_side_set(Mesh& mesh, const std::string& name, const std::string& from, const Region& region) {
  refuse_known(mesh.side_sets, name, "side set");
  const Inside inside(mesh, region);
  const std::vector<Side> candidates = from.empty() ? boundary_sides(mesh) : side_set_named(mesh, from).sides;
  SideSet chosen{name, {}};
  std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(chosen.sides),
               [&](const Side& side) { return inside.side(side); });
  if (chosen.sides.empty())
    throw InputError("no side of " + (from.empty() ? "the boundary" : "\"" + from + "\"") +
                     " lies in the region; the mesh spans " + inside.span());
  mesh.side_sets.push_back(std::move(chosen));
}

void add_node_set(Mesh& mesh, const std::string& name, const std::string& from, const Region& region) {
  refuse_known(mesh.node_sets, name, "node set");
  if (!region.normal.empty()) throw InputError("Normal selects sides; a node has none");
  std::vector<int> candidates(static_cast<std::size_t>(mesh.nodes()));
  std::iota(candidates.begin(), candidates.end(), 0);
  if (!from.empty()) candidates = set_named(mesh.node_sets, from, "node set").nodes;
  const Inside inside(mesh, region);
  NodeSet chosen{name, {}};
  std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(chosen.nodes),
               [&](int node) { return inside.node(node); });
  if (chosen.nodes.empty()) throw InputError("no node lies in the region; the mesh spans " + inside.span());
  mesh.node_sets.push_back(std::move(chosen));
}

}  // namespace ixos
