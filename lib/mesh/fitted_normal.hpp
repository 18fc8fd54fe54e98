/// The plane of a set of nodes.
#pragma once
#include <functional>
#include <vector>

#include "base/vec.hpp"
#include "mesh/mesh.hpp"

namespace ixos {

/// Returns the normal, of length 1 and without components below 1e-6, of the plane through places [L0], in two
/// dimensions of the line in the plane z = 0. `sum` adds numbers over all ranks that have places; without it these are
/// all. Throws InputError if the places leave their plane (root of the mean square) by more than 1e-6 of their extent,
/// or have no plane: they are on one line, in two dimensions at one point.
Vec<3> fitted_normal(int dimension, const std::vector<Vec<3>>& places,
                     const std::function<void(double*, int)>& sum = {});

/// Returns that of the nodes of a set, without derivative nodes.
Vec<3> fitted_normal(const Mesh& mesh, const NodeSet& set);

}  // namespace ixos
