/// Fingerprints, by which a checkpoint knows its mesh.
#pragma once
#include <string>

#include "mesh/mesh.hpp"

namespace ixos {

/// XXH3 (128 bits) of everything that a mesh consists of, as 32 hexadecimal digits: the same for the same mesh on any
/// number of ranks.
std::string fingerprint(const Mesh& mesh);

}  // namespace ixos
