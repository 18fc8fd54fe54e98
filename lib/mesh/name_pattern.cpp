#include "mesh/name_pattern.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <tuple>
#include <utility>

#include "mesh/selection.hpp"

namespace ixos {
namespace {

template <class Set, class Entries, class Less>
void add_union(const std::string& pattern, Entries Set::*entries, const Less& less, std::vector<Set>& sets) {
  if (find_set(sets, pattern) != nullptr) return;
  Set all{pattern, {}};
  bool any = false;
  for (const Set& set : sets)
    if (matches(pattern, set.name)) {
      any = true;
      (all.*entries).insert((all.*entries).end(), (set.*entries).begin(), (set.*entries).end());
    }
  if (!any) return;
  std::sort((all.*entries).begin(), (all.*entries).end(), less);
  const auto same = [&](const auto& a, const auto& b) { return !less(a, b) && !less(b, a); };
  (all.*entries).erase(std::unique((all.*entries).begin(), (all.*entries).end(), same), (all.*entries).end());
  sets.push_back(std::move(all));
}

}  // namespace

bool is_pattern(const std::string& name) { return name.find('*') != std::string::npos; }

bool matches(const std::string& pattern, const std::string& name) {
  // Text between two stars is found as early as possible; text behind the last one must end the name.
  std::size_t p = pattern.find('*');
  if (p == std::string::npos) return pattern == name;
  if (name.compare(0, p, pattern, 0, p) != 0) return false;
  std::size_t at = p;
  for (std::size_t next = pattern.find('*', p + 1); next != std::string::npos; next = pattern.find('*', p + 1)) {
    const std::string part = pattern.substr(p + 1, next - p - 1);
    const std::size_t found = name.find(part, at);
    if (found == std::string::npos) return false;
    at = found + part.size();
    p = next;
  }
  const std::size_t rest = pattern.size() - p - 1;
  return name.size() >= at + rest && name.compare(name.size() - rest, rest, pattern, p + 1, rest) == 0;
}

std::vector<std::string> expanded(const std::vector<std::string>& names, const std::vector<std::string>& known) {
  std::vector<std::string> result;
  std::set<std::string> from_patterns;
  for (const std::string& name : names) {
    bool any = false;
    for (const std::string& other : known)
      if (is_pattern(name) && !is_pattern(other) && matches(name, other)) {
        any = true;
        if (from_patterns.insert(other).second) result.push_back(other);
      }
    if (!any && from_patterns.count(name) == 0) result.push_back(name);
  }
  return result;
}

void add_pattern_sets(const std::vector<std::string>& names, Mesh& mesh) {
  const auto before = [](const Side& a, const Side& b) {
    return std::tie(a.block, a.cell, a.side) < std::tie(b.block, b.cell, b.side);
  };
  for (const std::string& name : names) {
    if (!is_pattern(name)) continue;
    add_union(name, &SideSet::sides, before, mesh.side_sets);
    add_union(name, &NodeSet::nodes, std::less<>(), mesh.node_sets);
  }
}

}  // namespace ixos
