/// Cubes of cells of a type, for benchmarks.
#pragma once
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

#include "mesh/cell_order.hpp"
#include "mesh/generators/shapes.hpp"
#include "support/simplices.hpp"

namespace ixos::test {

/// A type of cell by its name, and the order of its functions.
struct BlockCells {
  std::string_view name;
  int order;
};
inline constexpr std::array<BlockCells, 5> block_cells{
    {{"Hex8", 1}, {"Hex27", 2}, {"Tet4", 1}, {"Tet10", 2}, {"Tet15", 2}}};

/// Returns the cells of that name. Throws std::invalid_argument if there are none.
inline BlockCells block_cells_named(std::string_view name) {
  for (const BlockCells& cells : block_cells)
    if (cells.name == name) return cells;
  throw std::invalid_argument("no cells are called " + std::string(name));
}

/// Returns a cube of edge `length` with so many steps from node to node along each edge. All quadratic cells have the
/// nodes of linear hexahedra, but for those inside Tet15 and its sides. Corners are moved by up to `distortion`; edges
/// stay straight.
inline Mesh block_of(const BlockCells& cells, int divisions, double length, double distortion = 0) {
  BoxShape shape;
  shape.dimension = 3;
  shape.lengths = {length, length, length};
  shape.divisions.fill(divisions / cells.order);
  Mesh mesh = box(shape);
  if (cells.name.substr(0, 3) == "Tet") mesh = split_cells(mesh, "tetrahedra");
  for (std::size_t i = 0; i < mesh.coordinates.size(); ++i)
    mesh.coordinates[i] += distortion * std::sin(1.7 * static_cast<double>(i));
  if (cells.order == 2) raise_order(mesh, cells.name == "Tet15");
  return mesh;
}

}  // namespace ixos::test
