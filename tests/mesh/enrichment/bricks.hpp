/// Boxes of hexahedra, and parts of their surfaces, to be enriched.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos::test {

/// A box of unit cells, none of whose inner edges is parallel to an axis.
Mesh brick(const std::array<int, 3>& divisions);

/// Adds the set `name` of those sides of the set `from` that are listed.
void choose(Mesh& mesh, const std::string& name, const std::string& from, const std::vector<std::size_t>& sides);

}  // namespace ixos::test
