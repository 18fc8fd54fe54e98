/// From a mesh's cell type to the element's C++ type.
#pragma once
#include <cstddef>
#include <stdexcept>
#include <tuple>
#include <type_traits>

#include "fem/cell_type.hpp"
#include "fem/cells/hexahedra.hpp"
#include "fem/cells/prisms.hpp"
#include "fem/cells/pyramids.hpp"
#include "fem/cells/quadrilaterals.hpp"
#include "fem/cells/tetrahedra.hpp"
#include "fem/cells/triangles.hpp"

namespace ixos {

/// Calls function(TypeTag<Element>) for the element of that type, which must have that dimension.
template <int Dimension, class Function>
decltype(auto) with_element_of(CellType type, const Function& function) {
  switch (type) {
#define IXOS_CELL(Element)                         \
  case CellType::Element:                          \
    if constexpr (Element::dimension == Dimension) \
      return function(TypeTag<Element>{});         \
    else                                           \
      break;
#include "fem/cells.def"
  }
  throw std::logic_error("a cell of another dimension");
}

/// Calls function(TypeTag<Element>) for the element of that type in the plane.
template <class Function>
decltype(auto) with_plane_element(CellType type, const Function& function) {
  return with_element_of<2>(type, function);
}

/// Calls function(TypeTag<Element>) for the element of that type in space.
template <class Function>
decltype(auto) with_solid_element(CellType type, const Function& function) {
  return with_element_of<3>(type, function);
}

/// Calls function(TypeTag<Element>) for the element of that cell type.
template <class Function>
decltype(auto) with_element(CellType type, const Function& function) {
  switch (type) {
#define IXOS_CELL(Element) \
  case CellType::Element:  \
    return function(TypeTag<Element>{});
#include "fem/cells.def"
  }
  throw std::logic_error("no type of cell");
}

/// Calls function(TypeTag<Element>) for the element of a side of that cell type. The sides of an enriched hexahedron
/// beside the contact face are enriched along the edge that they share with it.
template <class Function>
decltype(auto) with_side_element(CellType type, int side, const Function& function) {
  return with_element(type, [&](auto tag) -> decltype(auto) {
    using Sides = typename CellTraits<typename decltype(tag)::type>::Sides;
    const auto visit = [&](auto self, auto place) -> decltype(auto) {
      constexpr std::size_t k = decltype(place)::value;
      if constexpr (k + 1 < std::tuple_size_v<Sides>)
        if (static_cast<int>(k) != side) return self(self, std::integral_constant<std::size_t, k + 1>{});
      if (static_cast<int>(k) != side) throw std::out_of_range("a cell has no such side");
      return function(std::tuple_element_t<k, Sides>{});
    };
    return visit(visit, std::integral_constant<std::size_t, 0>{});
  });
}

}  // namespace ixos
