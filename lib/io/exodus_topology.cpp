#include "io/exodus_topology.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "fem/cell_info.hpp"
#include "io/mesh_file.hpp"

namespace ixos {
namespace {

bool begins(const std::string& text, const char* beginning) { return text.rfind(beginning, 0) == 0; }

}  // namespace

bool is_shell(const ExodusBlock& block) { return begins(block.topology, "SHELL"); }

int first_edge(const ExodusBlock& block, int file_dimension) { return is_shell(block) && file_dimension == 3 ? 2 : 0; }

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

CellType cell_type_of(const ExodusBlock& block, int file_dimension) {
  const bool solid = begins(block.topology, "HEX") && file_dimension == 3;
  const bool face = begins(block.topology, "QUAD") || is_shell(block);
  const CellInfo* info = find_cell([&](const CellInfo& candidate) {
    return candidate.shape == (face ? ReferenceShape::Quadrilateral : ReferenceShape::Hexahedron) &&
           candidate.nodes == block.nodes_per_cell && !candidate.exodus.empty();
  });
  if ((solid || face) && info != nullptr) return info->type;
  const int dimension = dimension_of(block, file_dimension);
  throw InputError(
      fmt::format("block \"{}\" has elements of type {} with {} nodes in {} dimensions; QUAD4, QUAD9, SHELL4 and "
                  "SHELL9 in a plane, HEX8 and HEX27 in 3 dimensions are allowed. {}",
                  block.name, block.topology, block.nodes_per_cell, file_dimension,
                  recombining_recipe(dimension < 2 ? file_dimension : dimension)));
}

}  // namespace ixos
