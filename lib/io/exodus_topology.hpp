/// Types of elements in Exodus files.
#pragma once
#include <cstdint>
#include <string>

#include "io/file_cells.hpp"

namespace ixos {

/// A block as the file describes it.
struct ExodusBlock {
  std::int64_t id;
  std::string name;
  std::string topology;  ///< type of its elements, in capitals: "QUAD4", "BAR2", ...
  std::int64_t cells, nodes_per_cell;
};

/// Returns whether the elements are shells, as Cubit names the quadrilaterals of a surface by default.
bool is_shell(const ExodusBlock& block);

/// Returns how many sides of an element come before its edges: a shell or a triangle of a file with three coordinates
/// has its two faces as sides 1 and 2.
int first_edge(const ExodusBlock& block, int file_dimension);

/// Returns the dimension of the block's elements: 0 for points, 1 for lines, 2 for quadrilaterals, shells and
/// triangles; that of the file for all other types.
int dimension_of(const ExodusBlock& block, int file_dimension);

/// Returns the block's cells. Throws InputError, with what is allowed, if Ixos does not compute with them.
const FileCells& cells_of(const ExodusBlock& block, int file_dimension);

}  // namespace ixos
