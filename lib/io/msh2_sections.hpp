/// The sections of files of gmsh's format MSH 2.2 that other versions have otherwise.
#pragma once
#include "io/msh_file.hpp"
#include "io/msh_nodes.hpp"

namespace ixos {

/// Read the section and add what it holds to the file. An element's entity is its physical group; 0: it has none.
/// Numbers of lists are compared with the length of the file. Throw InputError, see MshSource.
void read_msh2_nodes(MshSource& source, bool binary, MshFile& file, MshNodes& nodes);
void read_msh2_elements(MshSource& source, bool binary, const MshNodes& nodes, MshFile& file);

}  // namespace ixos
