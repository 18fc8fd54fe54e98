/// The output meshes of all ranks as one.
#pragma once
#include "base/tpetra.hpp"
#include "io/output_mesh.hpp"

namespace ixos {

/// A mesh and its description, as define_exodus_mesh() takes them.
struct GatheredMesh {
  Mesh mesh;
  ExodusShare description;
};

/// Returns, on the first rank, the whole mesh: nodes, cells and sets in the order of their numbers, and thus the same
/// for any number of ranks. Collective.
GatheredMesh gathered(const OutputMesh& share, const Comm& comm);

}  // namespace ixos
