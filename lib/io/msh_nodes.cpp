#include "io/msh_nodes.hpp"

#include <algorithm>

namespace ixos {

void MshNodes::finish(const MshSource& source) {
  std::sort(places_.begin(), places_.end());
  const auto twice = std::adjacent_find(places_.begin(), places_.end(),
                                        [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice != places_.end()) source.refuse("the node {} is given twice", twice->first);
}

int MshNodes::of_element(std::uint64_t tag, const MshSource& source) const {
  const auto found = std::lower_bound(places_.begin(), places_.end(), std::pair(tag, 0));
  if (found == places_.end() || found->first != tag)
    source.refuse("an element has the node {}, which does not exist", tag);
  return found->second;
}

}  // namespace ixos
