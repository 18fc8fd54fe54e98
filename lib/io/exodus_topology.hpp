/// Types of elements in Exodus files.
#pragma once
#include <cstdint>
#include <string>

#include "fem/cell_type.hpp"

namespace ixos {

/// A block as the file describes it.
struct ExodusBlock {
  int id;
  std::string name;
  std::string topology;  ///< type of its elements, in capitals: "QUAD4", "BAR2", ...
  std::int64_t cells, nodes_per_cell;
};

/// Returns the dimension of the block's elements: 0 for points, 1 for lines, 2 for quadrilaterals and triangles; that
/// of the file for all other types.
int dimension_of(const ExodusBlock& block, int file_dimension);

/// Returns the type of the block's elements. Throws InputError, with gmsh's recipe for other ones, if Ixos does not
/// compute with them.
CellType cell_type_of(const ExodusBlock& block, int file_dimension);

}  // namespace ixos
