/// Names in files of meshes.
#pragma once
#include "mesh/mesh.hpp"

namespace ixos {

/// Gives each block, side set and node set a name that no other of them has, because readers on IOSS refuse files in
/// which two of them have one name. As there, small and capital letters are the same, and so are blanks, dots and
/// underscores. The first one keeps its name: a block before a side set before a node set. Another
/// side set gets "_sides" after its name, a node set "_nodes"; where that name is taken, too, and for blocks, a number
/// from 2 follows. Names that are distinct stay.
void make_names_distinct(Mesh& mesh);

}  // namespace ixos
