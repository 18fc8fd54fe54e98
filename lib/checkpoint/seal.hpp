/// The seal of a checkpoint: its length and checksums.
#pragma once
#include <string>
#include <vector>

#include "io/hdf5_file.hpp"

namespace ixos {

/// Bytes that an HDF5 file leaves free at its beginning for the seal (H5Pset_userblock).
inline constexpr int seal_bytes = 512;

/// Seals a closed file: appends a table of its pieces (position, length, checksum), writes the seal, which holds the
/// file's length and the table's checksum, into the first seal_bytes, and has the disk keep it all (fsync).
///
/// `pieces` cover the file behind the seal without gaps. Their checksums (XXH3, 128 bits, Collet) are those of what was
/// meant: taken from memory when it was written, they expose a write that failed or was lost. Not collective. Throws
/// FileError.
void seal(const std::string& path, std::vector<FilePiece> pieces);

/// Returns why the file is not a sound checkpoint, in words that follow its name; empty for a sound one. Finds any
/// changed, missing or added byte before another library reads the file. Not collective.
std::string seal_problem(const std::string& path);

}  // namespace ixos
