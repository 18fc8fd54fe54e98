/// Meshes of many bodies of one kind.
#pragma once
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// Returns one mesh of copies, which have the same blocks and sets, and may differ in all else. Each block holds the
/// cells of all copies, one copy after the other. Each set is there for all copies together, under its name, and for
/// each of them, counted from 1: the copies of a set "pad" are "1_pad", "2_pad". Throws InputError if there is no copy,
/// or as joined_parts().
Mesh repeated(std::vector<Mesh> copies);

}  // namespace ixos
