/// Checks of a mesh before computation, and figures of its quality.
#pragma once
#include <string>

#include "mesh/cell_place.hpp"
#include "mesh/local_mesh.hpp"
#include "mesh/mesh.hpp"

namespace ixos {

/// Throws InputError, naming the place of the cell, if a cell's reference Jacobian is not positive at some point of its
/// element's own quadrature: the cell is inverted, degenerate or wrongly numbered. Throws also if check_meridian()
/// does.
void check_cells(const Mesh& mesh);

/// Does the same with the cells of a rank's part, and names a cell by its nodes' program_id() and its centre.
void check_cells(const LocalMesh& mesh);

/// Figures of the whole mesh. They use the corners of linear cells only: the further nodes of enriched ones do not
/// change their shape.
struct MeshQuality {
  int cells = 0, nodes = 0;
  /// The least scaled Jacobian of all cells. That of a cell is the least Jacobian determinant of edges scaled to length
  /// 1, at its corners and, in 3D, its centre, of a quadratic cell at its Gauss points, too; of a triangle over that
  /// of an equilateral one. 1: a rectangle, a brick, an equilateral triangle; 0 or less: degenerate or inverted. Knupp
  /// (2000), as computed by Verdict.
  double least_scaled_jacobian = 0;
  CellPlace most_distorted{};      ///< the cell with the least scaled Jacobian
  double low_scaled_jacobian = 0;  ///< 5 % of the cells have this or less
  double mean_scaled_jacobian = 0;
  double largest_aspect_ratio = 0;  ///< of a cell: its longest edge over its shortest, corner to corner
  CellPlace longest{};              ///< the cell with the largest aspect ratio
  int dimension = 2;
  double volume = 0;  ///< area [L0^2]; in three dimensions and of a body of revolution volume [L0^3]
};

MeshQuality mesh_quality(const Mesh& mesh);

/// Returns the least scaled Jacobian of cells of one type whose nodes stand at `coordinates`, row by row; 1 if there
/// are none. `nodes`: cells x nodes per cell.
double least_scaled_jacobian(CellType type, const std::vector<int>& nodes, const std::vector<double>& coordinates);

/// Returns the figures in three lines.
std::string to_string(const MeshQuality& quality);

/// Returns a warning if a cell is so bad that results there are not to be trusted and iterative solvers suffer: a
/// scaled Jacobian below 0.1 (Verdict calls 0.3 of quadrilaterals, 0.5 of hexahedra acceptable), or an aspect ratio
/// beyond 100. Returns an empty string otherwise.
std::string quality_warning(const MeshQuality& quality);

}  // namespace ixos
