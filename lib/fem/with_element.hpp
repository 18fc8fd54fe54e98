/// From a mesh's cell type to the element's C++ type.
#pragma once
#include <stdexcept>

#include "fem/cell_type.hpp"
#include "fem/contact_elements.hpp"
#include "fem/contact_hexahedra.hpp"
#include "fem/quadratic_contact_elements.hpp"
#include "fem/quadratic_elements.hpp"
#include "fem/reference_elements.hpp"

namespace ixos {

/// A type as a value.
template <class T>
struct TypeTag {
  using type = T;
};

/// Calls function(TypeTag<Element>) for the element of that type of quadrilateral.
template <class Function>
decltype(auto) with_plane_element(CellType type, const Function& function) {
  switch (type) {
    case CellType::Quad4:
      return function(TypeTag<Quad4>{});
    case CellType::Quad4C2:
      return function(TypeTag<Quad4C2>{});
    case CellType::Quad4C3:
      return function(TypeTag<Quad4C3>{});
    case CellType::Quad4C4:
      return function(TypeTag<Quad4C4>{});
    case CellType::Quad4CH:
      return function(TypeTag<Quad4CH>{});
    case CellType::Quad9:
      return function(TypeTag<Quad9>{});
    case CellType::Quad9C4:
      return function(TypeTag<Quad9C4>{});
    default:
      throw std::logic_error("not a quadrilateral");
  }
}

/// Calls function(TypeTag<Element>) for the element of that cell type.
template <class Function>
decltype(auto) with_element(CellType type, const Function& function) {
  switch (type) {
    case CellType::Hex8:
      return function(TypeTag<Hex8>{});
    case CellType::Hex8C2:
      return function(TypeTag<Hex8C2>{});
    case CellType::Hex8C3:
      return function(TypeTag<Hex8C3>{});
    case CellType::Hex8C4:
      return function(TypeTag<Hex8C4>{});
    case CellType::Hex8CH:
      return function(TypeTag<Hex8CH>{});
    case CellType::Hex27:
      return function(TypeTag<Hex27>{});
    case CellType::Hex27C4:
      return function(TypeTag<Hex27C4>{});
    default:
      return with_plane_element(type, function);
  }
}

/// Calls function(TypeTag<Element>) for the element of a side of that cell type. The sides of an enriched hexahedron
/// beside the contact face are enriched along the edge that they share with it.
template <class Function>
decltype(auto) with_side_element(CellType type, int side, const Function& function) {
  const bool contact = side == contact_side(type);
  if (type == CellType::Hex27C4 && contact) return function(TypeTag<QuarticFace>{});
  if (type == CellType::Hex27C4 && side < 4) return function(TypeTag<Quad9C4>{});
  if (type == CellType::Quad9C4 && contact) return function(TypeTag<LagrangeEdge<4>>{});
  if (plain_type(type) == CellType::Hex27) return function(TypeTag<LagrangeFace<2>>{});
  if (plain_type(type) == CellType::Quad9) return function(TypeTag<LagrangeEdge<2>>{});
  if (corner_type(type) == CellType::Hex8) {
    if (contact) {
      if (type == CellType::Hex8C2) return function(TypeTag<LagrangeFace<2>>{});
      if (type == CellType::Hex8C3) return function(TypeTag<LagrangeFace<3>>{});
      if (type == CellType::Hex8C4) return function(TypeTag<LagrangeFace<4>>{});
      if (type == CellType::Hex8CH) return function(TypeTag<HermiteFace>{});
    } else if (side < 4) {
      if (type == CellType::Hex8C2) return function(TypeTag<Quad4C2>{});
      if (type == CellType::Hex8C3) return function(TypeTag<Quad4C3>{});
      if (type == CellType::Hex8C4) return function(TypeTag<Quad4C4>{});
      if (type == CellType::Hex8CH) return function(TypeTag<Quad4CH>{});
    }
    return function(TypeTag<Quad4>{});
  }
  if (contact) {
    if (type == CellType::Quad4C2) return function(TypeTag<LagrangeEdge<2>>{});
    if (type == CellType::Quad4C3) return function(TypeTag<LagrangeEdge<3>>{});
    if (type == CellType::Quad4C4) return function(TypeTag<LagrangeEdge<4>>{});
    if (type == CellType::Quad4CH) return function(TypeTag<HermiteEdge>{});
  }
  return function(TypeTag<Line2>{});
}

}  // namespace ixos
