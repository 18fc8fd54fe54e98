/// Fingerprints, by which a checkpoint knows its mesh.
#pragma once
#include <string>

#include "mesh/mesh.hpp"

namespace ixos {

/// XXH3 (128 bits) of what gives a mesh's degrees of freedom their meaning, as 32 hexadecimal digits: coordinates,
/// cells and their blocks, derivative nodes. Not of its sets.
std::string fingerprint(const Mesh& mesh);

}  // namespace ixos
