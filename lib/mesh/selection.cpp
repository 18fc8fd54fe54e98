#include "mesh/selection.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "base/closest_name.hpp"
#include "base/error.hpp"

namespace ixos {
namespace {

template <class Set>
const Set& set_named(const std::vector<Set>& sets, const std::string& name, const char* what) {
  std::vector<std::string> names;
  for (const Set& set : sets) {
    if (set.name == name) return set;
    names.push_back(set.name);
  }
  throw InputError(no_such(what, name, names, "The mesh has"));
}

template <class Set>
void refuse_known(const std::vector<Set>& sets, const std::string& name, const char* what) {
  if (std::any_of(sets.begin(), sets.end(), [&](const Set& set) { return set.name == name; }))
    throw InputError(std::string(what) + " \"" + name + "\" already exists; choose another name");
}

class Inside {
 public:
  Inside(const Mesh& mesh, const Region& region) : mesh_(mesh), region_(region) {
    for (const std::vector<double>* bound : {&region.lower, &region.upper})
      if (!bound->empty() && bound->size() != static_cast<std::size_t>(mesh.dimension))
        throw InputError("a bound has " + std::to_string(bound->size()) + " coordinates, but the mesh has " +
                         std::to_string(mesh.dimension) + " dimensions");
    if (mesh.coordinates.empty()) return;
    const auto [low, high] = std::minmax_element(mesh.coordinates.begin(), mesh.coordinates.end());
    slack_ = 1e-9 * (*high - *low);
  }
  bool operator()(int node) const {
    const auto d = static_cast<std::size_t>(mesh_.dimension);
    for (std::size_t i = 0; i < d; ++i) {
      const double x = mesh_.coordinates[static_cast<std::size_t>(node) * d + i];
      if (!region_.lower.empty() && x < region_.lower[i] - slack_) return false;
      if (!region_.upper.empty() && x > region_.upper[i] + slack_) return false;
    }
    return true;
  }

  /// Returns the mesh's bounding box, for a message.
  std::string span() const {
    const auto d = static_cast<std::size_t>(mesh_.dimension);
    std::vector<double> low(mesh_.coordinates.begin(), mesh_.coordinates.begin() + mesh_.dimension), high(low);
    for (std::size_t k = 0; k < mesh_.coordinates.size(); ++k) {
      low[k % d] = std::min(low[k % d], mesh_.coordinates[k]);
      high[k % d] = std::max(high[k % d], mesh_.coordinates[k]);
    }
    return fmt::format("({}) to ({})", fmt::join(low, ", "), fmt::join(high, ", "));
  }

 private:
  const Mesh& mesh_;
  const Region& region_;
  double slack_ = 0;
};

}  // namespace

const SideSet& side_set_named(const Mesh& mesh, const std::string& name) {
  return set_named(mesh.side_sets, name, "side set");
}

void add_side_set(Mesh& mesh, const std::string& name, const std::string& from, const Region& region) {
  refuse_known(mesh.side_sets, name, "side set");
  const Inside inside(mesh, region);
  SideSet chosen{name, {}};
  for (const Side& side : side_set_named(mesh, from).sides) {
    const ElementBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
    const int n = nodes_per_cell(block.type);
    const auto& numbers = side_nodes(block.type, side.side);
    if (std::all_of(numbers.begin(), numbers.end(),
                    [&](int a) { return inside(block.nodes[cell_entry(side.cell, n, a)]); }))
      chosen.sides.push_back(side);
  }
  if (chosen.sides.empty())
    throw InputError("no side of \"" + from + "\" lies in the region; the mesh spans " + inside.span());
  mesh.side_sets.push_back(std::move(chosen));
}

void add_node_set(Mesh& mesh, const std::string& name, const std::string& from, const Region& region) {
  refuse_known(mesh.node_sets, name, "node set");
  std::vector<int> candidates(static_cast<std::size_t>(mesh.nodes()));
  std::iota(candidates.begin(), candidates.end(), 0);
  if (!from.empty()) candidates = set_named(mesh.node_sets, from, "node set").nodes;
  const Inside inside(mesh, region);
  NodeSet chosen{name, {}};
  std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(chosen.nodes), inside);
  if (chosen.nodes.empty()) throw InputError("no node lies in the region; the mesh spans " + inside.span());
  mesh.node_sets.push_back(std::move(chosen));
}

}  // namespace ixos
