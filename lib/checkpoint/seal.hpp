/// The seal of a checkpoint: its length and checksum, in the user block before the HDF5 data.
#pragma once
#include <string>

namespace ixos {

/// Bytes that an HDF5 file leaves free at its beginning for the seal (H5Pset_userblock).
inline constexpr int seal_bytes = 512;

/// Writes the seal into a closed file whose first seal_bytes are free, and has the disk keep it all (fsync). The
/// checksum is XXH3 (128 bits, Collet) of every other byte of the file. Not collective. Throws FileError.
void seal(const std::string& path);

/// Why the file is not a sound checkpoint, in words that follow its name; empty where it is. Any changed, missing or
/// added byte is noticed, before any other library reads the file. Not collective.
std::string seal_problem(const std::string& path);

}  // namespace ixos
