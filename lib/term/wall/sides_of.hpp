/// From a group of sides to the class of its type of side.
#pragma once
#include <cstddef>
#include <memory>
#include <stdexcept>

#include "fem/with_element.hpp"
#include "term/wall/wall_sides.hpp"

namespace ixos {

/// Returns Sides<the group's side element>(arguments...). Throws std::logic_error if the group is not of D dimensions.
template <std::size_t D, template <class> class Sides, class Interface, class... Arguments>
std::unique_ptr<Interface> sides_of(const SideGroup& group, const Arguments&... arguments) {
  return with_side_element(group.type, group.side, [&](auto tag) -> std::unique_ptr<Interface> {
    using SideElement = typename decltype(tag)::type;
    if constexpr (SideElement::dimension + 1 == D)
      return std::make_unique<Sides<SideElement>>(arguments...);
    else
      throw std::logic_error("a side of another dimension");
  });
}

}  // namespace ixos
