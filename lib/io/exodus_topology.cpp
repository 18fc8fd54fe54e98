#include "io/exodus_topology.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/mesh_file.hpp"

namespace ixos {
namespace {

bool begins(const std::string& text, const char* beginning) { return text.rfind(beginning, 0) == 0; }

}  // namespace

int dimension_of(const ExodusBlock& block, int file_dimension) {
  for (const char* point : {"SPHERE", "CIRCLE", "POINT"})
    if (begins(block.topology, point)) return 0;
  for (const char* line : {"BAR", "BEAM", "TRUSS", "EDGE", "LINE"})
    if (begins(block.topology, line)) return 1;
  for (const char* face : {"QUAD", "TRI"})
    if (begins(block.topology, face)) return 2;
  return file_dimension;
}

CellType cell_type_of(const ExodusBlock& block, int file_dimension) {
  const bool solid = begins(block.topology, "HEX") && file_dimension == 3;
  if (begins(block.topology, "QUAD") && block.nodes_per_cell == 4) return CellType::Quad4;
  if (begins(block.topology, "QUAD") && block.nodes_per_cell == 9) return CellType::Quad9;
  if (solid && block.nodes_per_cell == 8) return CellType::Hex8;
  if (solid && block.nodes_per_cell == 27) return CellType::Hex27;
  const int dimension = dimension_of(block, file_dimension);
  throw InputError(
      fmt::format("block \"{}\" has elements of type {} with {} nodes in {} dimensions; QUAD4 and QUAD9 in 2, "
                  "HEX8 and HEX27 in 3 are allowed. {}",
                  block.name, block.topology, block.nodes_per_cell, file_dimension,
                  recombining_recipe(dimension < 2 ? file_dimension : dimension)));
}

}  // namespace ixos
