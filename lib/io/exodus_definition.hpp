/// Writing a mesh into an open Exodus file. Included by lib/io only.
#pragma once
#include <string>
#include <vector>

#include "io/exodus_handle.hpp"
#include "io/output_mesh.hpp"
#include "mesh/mesh.hpp"

namespace ixos {

/// The format below Exodus: netCDF's own, or HDF5.
enum class ExodusFormat { Classic, Hdf5 };

/// Bytes that the names of blocks, sets and variables may have in a file.
constexpr int most_name_length = 80;

/// Makes a file, or empties one that exists. Returns a negative number, as ex_create does, if that fails.
int create_exodus(const std::string& path, ExodusFormat format = ExodusFormat::Classic);

/// Returns the lines as information records of Exodus, which have at most 80 bytes: a longer line continues in records
/// that begin with two spaces.
std::vector<std::string> exodus_records(const std::vector<std::string>& lines);

/// Writes coordinates, blocks (ids from 1), sets, id maps, and the lines as information records. Throws FileError.
void define_exodus_mesh(const ExodusHandle& file, const Mesh& mesh, const ExodusShare& share, const std::string& title,
                        const std::vector<std::string>& information = {});

/// Throws FileError if `status` is an error of the Exodus library, with the system's word for it if there is one.
void require_written(int status, const ExodusHandle& file, const char* what);
void require_created(int status, const std::string& path);

}  // namespace ixos
