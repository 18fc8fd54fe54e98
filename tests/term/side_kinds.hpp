/// Kinds of sides for tests of templates.
#pragma once
#include <vector>

#include "fem/with_element.hpp"
#include "term/wall/wall_sides.hpp"

namespace ixos::test {

/// Calls make(TypeTag<SideElement>, sides) for each element type and choice of tied edges among the sides.
template <class Make>
void for_each_kind_of_side(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Make& make) {
  for (const SideGroup& group : grouped(mesh, sides))
    with_side_element(group.type, group.side, [&](auto side) { make(side, group.sides); });
}

}  // namespace ixos::test
