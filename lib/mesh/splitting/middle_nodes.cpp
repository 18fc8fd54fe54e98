#include "mesh/splitting/middle_nodes.hpp"

#include <algorithm>

namespace ixos {

std::uint64_t MiddleNodes::key(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  return static_cast<std::uint64_t>(low) << 32U | static_cast<std::uint64_t>(high);
}

int MiddleNodes::named(int a, int b) const {
  const auto found = nodes_.find(key(a, b));
  return found == nodes_.end() ? -1 : found->second;
}

MiddleNodes::Pair MiddleNodes::origin(int node) const {
  const auto& pairs = origins_[static_cast<std::size_t>(node)];
  return pairs.empty() ? Pair{-1, -1} : pairs.front();
}

/// If a is between p and q, and b between r and s, the middle is also that of the middles of p and r, and of q and s.
std::vector<MiddleNodes::Pair> MiddleNodes::crossing(int a, int b) const {
  std::vector<Pair> found;
  for (const auto& [p, q] : origins_[static_cast<std::size_t>(a)])
    for (const auto& [r, s] : origins_[static_cast<std::size_t>(b)])
      for (const Pair& pair : {Pair{named(p, r), named(q, s)}, Pair{named(p, s), named(q, r)}})
        if (pair[0] >= 0 && pair[1] >= 0 && pair[0] != a && pair[0] != b)  // halves of one edge are no face
          found.push_back(pair);
  return found;
}

int MiddleNodes::find(int a, int b) {
  int same = named(a, b);
  if (same >= 0) return same;
  for (const auto& [left, right] : crossing(a, b)) same = std::max(same, named(left, right));
  if (same >= 0) set(a, b, same);
  return same;
}

void MiddleNodes::set(int a, int b, int node) {
  if (nodes_.emplace(key(a, b), node).second) origins_[static_cast<std::size_t>(node)].push_back({a, b});
}

int MiddleNodes::add(int a, int b) {
  const int node = static_cast<int>(origins_.size());
  origins_.emplace_back();
  set(a, b, node);
  return node;
}

}  // namespace ixos
