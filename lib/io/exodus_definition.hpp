/// Writing a mesh into an open Exodus file. Included by lib/io only.
#pragma once
#include <vector>

#include "io/exodus_handle.hpp"
#include "mesh/mesh.hpp"

namespace ixos {

/// What a file of one rank says of the whole.
struct ExodusShare {
  int ranks = 1;
  long long global_nodes = 0;
  long long global_cells = 0;
  std::vector<int> global_block_cells;  ///< by block
  std::vector<int> node_ids;            ///< from 1, by node
  std::vector<int> cell_ids;            ///< from 1, by cell, block after block
};

/// Makes a file, or empties one that is there. Negative, as ex_create's, where that fails.
int create_exodus(const std::string& path);

/// Writes coordinates, blocks (ids from 1), sets and id maps. Throws FileError.
void define_exodus_mesh(const ExodusHandle& file, const Mesh& mesh, const ExodusShare& share, const std::string& title);

/// Throws FileError where `status` is an error of the Exodus library, with the system's word for it if there is one.
void require_written(int status, const ExodusHandle& file, const char* what);
void require_created(int status, const std::string& path);

}  // namespace ixos
