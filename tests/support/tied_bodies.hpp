/// Checks of bodies with tied nodes.
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "model/material.hpp"
#include "time/table.hpp"

namespace ixos::test {

/// Two boxes of 3 (by 3) by 1 L0, one upon the other, with meshes that do not match and inner nodes off their grids,
/// also those where the boxes meet, which stay in that plane. Side sets "lower_top", "upper_bottom" and those of the
/// boxes' other sides; node set "outer": all nodes at the outside of both. The cells are of that order.
Mesh stacked_boxes(int dimension, int order);

/// The cells of two boxes in space: kinds of split_cells(), or "" for hexahedra; with nodes in triangles and insides.
struct StackedCells {
  std::string lower, upper;
  int order = 1;
  bool bubbles = false;
};
Mesh stacked_boxes(const StackedCells& cells);
/// Those with triangles on one or both of the surfaces that meet, which the upper one can follow.
std::vector<StackedCells> stacked_triangles();

/// Expects that a body moves by an affine motion, uniform in time, if the nodes of that set do; those of the set that
/// are tied are left to their ties. Tolerance 1e-10, matrix-free 1e-8.
void expect_affine_motion(const Mesh& mesh, const Material& material, const std::string& node_set, const Table& table,
                          bool matrix_free);

/// Expects that a free body, which spins and vibrates, keeps its energy, its momentum and, if `angular`, its angular
/// momentum, over steps of 0.1 T0. `tolerance`: of the energy its share, of momenta a tenth [F T0, F L0 T0].
void expect_conserved(const Mesh& mesh, const Table& table, int steps, double tolerance, bool angular);

/// A component of a displacement at a place.
using Displacement = std::function<double(const double* x, std::size_t i)>;

/// A harmonic displacement, u = grad(exp(kx) cos y [cos z]), which solves the equations of any linear material.
Displacement harmonic(int dimension);

/// The integral of the squared error of a displacement of a linear body, the unit square or cube, over that of the
/// displacement. Conditions prescribe it on the outside, but for tied nodes. The second one has another linear
/// material.
double squared_error(const Mesh& mesh, const Displacement& exact);
double squared_error(const Mesh& mesh, const Displacement& exact, const Material& material);

}  // namespace ixos::test
