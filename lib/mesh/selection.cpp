#include "mesh/selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
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

/// Returns the candidates in the region. Throws InputError, with the set's name, if the region leaves out some of which
/// it is in doubt. `what`: "side" or "node".
template <class Item>
std::vector<Item> chosen(const std::vector<Item>& candidates, const Inside& inside, const std::string& set,
                         const char* what) {
  std::vector<Item> result;
  std::size_t near = 0;
  const double infinity = std::numeric_limits<double>::infinity();
  double nearest = infinity, farthest = 0, next = infinity;
  for (const Item& item : candidates) {
    const double excess = inside.excess(item);
    if (excess <= inside.tolerance()) {
      result.push_back(item);
    } else if (inside.is_doubtful(excess)) {
      ++near;
      nearest = std::min(nearest, excess);
      farthest = std::max(farthest, excess);
    } else {
      next = std::min(next, excess);
    }
  }
  // Rounding leaves a gap behind it. On a smooth curve that touches the region the distances grow as squares.
  constexpr double gap = 5;
  if (near == 0 || next < gap * farthest) return result;
  throw InputError(fmt::format(
      "the set \"{}\" takes {} {}(s) and leaves out {} that are {:.3g} to {:.3g} L0 outside of its region, within ten "
      "times the tolerance, {:.3g} L0 (a thousandth of the mesh's shortest edge): its coordinates may have too few "
      "digits. Give the set a Tolerance: {:.3g} takes them too, {:.3g} leaves them out",
      set, result.size(), what, near, nearest, farthest, inside.tolerance(), 1.1 * farthest,
      std::max(inside.tolerance(), 0.5 * nearest)));
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
  SideSet set{name, chosen(candidates, inside, name, "side")};
  if (set.sides.empty())
    throw InputError("no side of " + (from.empty() ? "the boundary" : "\"" + from + "\"") +
                     " lies in the region; the mesh spans " + inside.span());
  mesh.side_sets.push_back(std::move(set));
}

void add_node_set(Mesh& mesh, const std::string& name, const std::string& from, const Region& region) {
  refuse_known(mesh.node_sets, name, "node set");
  if (!region.normal.empty()) throw InputError("Normal selects sides; a node has none");
  std::vector<int> candidates(static_cast<std::size_t>(mesh.nodes()));
  std::iota(candidates.begin(), candidates.end(), 0);
  if (!from.empty()) candidates = set_named(mesh.node_sets, from, "node set").nodes;
  const Inside inside(mesh, region);
  NodeSet set{name, chosen(candidates, inside, name, "node")};
  if (set.nodes.empty()) throw InputError("no node lies in the region; the mesh spans " + inside.span());
  mesh.node_sets.push_back(std::move(set));
}

}  // namespace ixos
