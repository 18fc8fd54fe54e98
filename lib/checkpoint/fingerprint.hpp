/// Fingerprints, by which a checkpoint identifies its mesh.
#pragma once
#include <string>

#include "mesh/mesh.hpp"

namespace ixos {

/// Returns XXH3 (128 bits) of the data that give a mesh's degrees of freedom their meaning, as 32 hexadecimal digits:
/// coordinates, cells and their blocks, derivative nodes. The sets do not count.
std::string fingerprint(const Mesh& mesh);

}  // namespace ixos
