/// Fingerprints, by which a checkpoint identifies its mesh, and ranks compare theirs.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// Returns XXH3 (128 bits) of the data that give a mesh's degrees of freedom their meaning, as 32 hexadecimal digits:
/// coordinates, cells and their blocks, derivative nodes; and of `values`: numbers that a file has at nodes, and
/// checksums of other files. The sets do not count.
std::string fingerprint(const Mesh& mesh, const std::vector<double>& values = {});

}  // namespace ixos
