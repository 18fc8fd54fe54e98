/// How slender a mesh is, as a sparse factorisation sees it.
#pragma once
#include "mesh/mesh.hpp"

namespace ixos {

/// Returns the number of nodes over the number of levels of a breadth-first numbering that starts at a node far away
/// from others (George and Liu 1979): the mean size of the cuts that separate the mesh into two. A factorisation takes
/// about nodes times its square operations. Returns 0 for a mesh without nodes.
double mean_level_width(const Mesh& mesh);

}  // namespace ixos
