/// Nodal fields of a split mesh at points of its unsplit cells.
#pragma once
#include <cstddef>
#include <vector>

#include "adapt/split_mesh.hpp"

namespace ixos {

/// Sets `value` to the field at a point, as the cell there has it. `field`: nodes x count.
void evaluate(const SplitMesh& mesh, const std::vector<double>& field, std::size_t count, const RootPoint& point,
              double* value);

/// Returns a field of one mesh at the nodes of another one with the same unsplit cells: the same function wherever
/// cells have only been split, and plain ones. Zero at nodes without a place.
std::vector<double> interpolated(const SplitMesh& from, const std::vector<double>& field, std::size_t count,
                                 const SplitMesh& to);

}  // namespace ixos
