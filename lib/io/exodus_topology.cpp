#include "io/exodus_topology.hpp"

#include <fmt/format.h>

#include <optional>

#include "base/error.hpp"
#include "fem/cell_info.hpp"

namespace ixos {
namespace {

bool begins(const std::string& text, const char* beginning) { return text.rfind(beginning, 0) == 0; }

}  // namespace

bool is_shell(const ExodusBlock& block) {
  return begins(block.topology, "SHELL") || begins(block.topology, "TRISHELL");
}

int first_edge(const ExodusBlock& block, int file_dimension) {
  return file_dimension == 3 && (is_shell(block) || begins(block.topology, "TRI")) ? 2 : 0;
}

int dimension_of(const ExodusBlock& block, int file_dimension) {
  for (const char* point : {"SPHERE", "CIRCLE", "POINT"})
    if (begins(block.topology, point)) return 0;
  for (const char* line : {"BAR", "BEAM", "TRUSS", "EDGE", "LINE"})
    if (begins(block.topology, line)) return 1;
  for (const char* face : {"QUAD", "TRI"})
    if (begins(block.topology, face)) return 2;
  // A shell of two nodes, or of three in the plane, is a line.
  if (is_shell(block)) return block.nodes_per_cell < (file_dimension == 2 ? 4 : 3) ? 1 : 2;
  return file_dimension;
}

namespace {

/// Returns the shape of the block's elements; nothing if it is unknown or has not the file's dimension.
std::optional<ReferenceShape> shape_of(const ExodusBlock& block, int file_dimension) {
  if (begins(block.topology, "TRI")) return ReferenceShape::Triangle;
  if (begins(block.topology, "QUAD")) return ReferenceShape::Quadrilateral;
  const bool triangular = block.nodes_per_cell == 3 || block.nodes_per_cell == 6 || block.nodes_per_cell == 7;
  if (is_shell(block)) return triangular ? ReferenceShape::Triangle : ReferenceShape::Quadrilateral;
  if (file_dimension != 3) return std::nullopt;
  if (begins(block.topology, "TET")) return ReferenceShape::Tetrahedron;
  if (begins(block.topology, "WEDGE") || begins(block.topology, "PRISM")) return ReferenceShape::Prism;
  if (begins(block.topology, "PYR")) return ReferenceShape::Pyramid;
  if (begins(block.topology, "HEX")) return ReferenceShape::Hexahedron;
  return std::nullopt;
}

}  // namespace

const FileCells& cells_of(const ExodusBlock& block, int file_dimension) {
  const auto shape = shape_of(block, file_dimension);
  const FileCells* const cells =
      shape && block.nodes_per_cell < 100 ? exodus_cells(*shape, static_cast<int>(block.nodes_per_cell)) : nullptr;
  if (cells != nullptr) return *cells;
  throw InputError(fmt::format(
      "block \"{}\" has elements of type {} with {} nodes in {} dimensions; triangles of 3, 6 and 7 nodes and "
      "quadrilaterals and shells of 4, 8 and 9 are allowed in a plane, tetrahedra of 4 and 10, prisms of 6, 15 and 18, "
      "pyramids of 5, 13 and 14, hexahedra of 8, 20 and 27 nodes in 3 dimensions",
      block.name, block.topology, block.nodes_per_cell, file_dimension));
}

}  // namespace ixos
