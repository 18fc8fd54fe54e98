#include "mesh/cell_place.hpp"
#include "mesh/node_place.hpp"

#include <fmt/format.h>

namespace ixos {

CellPlace place_of(const Mesh& mesh, const ElementBlock& block, int cell) {
  CellPlace place{block.name, cell + 1, cell_centre(mesh, block, cell), {}};
  if (const auto number = static_cast<std::size_t>(cell); number < block.file_numbers.size())
    place.in_file = block.file_numbers[number];
  return place;
}

std::string point_in_words(const std::array<double, 3>& point, int dimension) {
  return dimension == 2 ? fmt::format("({:.6g}, {:.6g})", point[0], point[1])
                        : fmt::format("({:.6g}, {:.6g}, {:.6g})", point[0], point[1], point[2]);
}

std::string node_in_words(const Mesh& mesh, int node) {
  return fmt::format("node {} of the mesh at {}", node + 1, point_in_words(node_place(mesh, node), mesh.dimension));
}

std::string in_words(const CellPlace& place, int dimension) {
  return fmt::format("block \"{}\", cell {}{} at {}", place.block, place.cell,
                     place.in_file ? fmt::format(" (number {} in the file)", *place.in_file) : "",
                     point_in_words(place.centre, dimension));
}

}  // namespace ixos
