/// Nodal fields of a rank's part and of the whole mesh.
#pragma once
#include <cstddef>
#include <vector>

#include "base/tpetra.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// Returns the field by node of the Mesh, on all ranks. `local`: local nodes x count; valid for owned nodes and those
/// that follow them. Collective.
std::vector<double> whole_field(const LocalMesh& mesh, const Comm& comm, const std::vector<double>& local,
                                std::size_t count, int nodes);

/// Returns the part of a field by node of the Mesh that belongs to the local nodes.
std::vector<double> local_field(const LocalMesh& mesh, const std::vector<double>& whole, std::size_t count);

}  // namespace ixos
