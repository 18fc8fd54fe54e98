/// Contact elements of every kind for tests.
#pragma once
#include <string>

#include "mesh/cell_order.hpp"
#include "mesh/enrichment/enrich.hpp"

namespace ixos::test {

inline bool is_of_quadratic_cells(ContactElement element) {
  return element == ContactElement::Q2C2 || element == ContactElement::Q2C4;
}

/// Gives the sides of the set that contact element. Q2C2 and Q2C4 make all cells of the mesh quadratic.
inline void give_contact_element(Mesh& mesh, const std::string& side_set, ContactElement element, int points = 0) {
  if (is_of_quadratic_cells(element)) raise_order(mesh);
  enrich(mesh, side_set, element, points);
}

}  // namespace ixos::test
