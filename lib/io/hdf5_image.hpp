/// HDF5 files whose structure is made in memory. Included by lib/io only.
#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "io/disk_file.hpp"
#include "io/hdf5_handle.hpp"

namespace ixos::hdf5 {

/// The contents of a file, as pieces in memory. The HDF5 library reads and writes them through a driver of ours (HDF5's
/// virtual file layer). The library never writes to a disk, because a disk that fails would leave a file open inside
/// the library, and its exit would then crash. The owner writes the pieces to the disk and checks each write.
///
/// Data sets that the owner writes himself have room in the file (early allocation) but no piece.
class Image {
 public:
  using Pieces = std::map<std::uint64_t, std::vector<char>>;  ///< by position; they do not overlap

  /// Creates the image of a new file or, with `base`, of an existing one: bytes that were not written are read from
  /// `base`, which must outlive the image
  /// and all identifiers of its file.
  explicit Image(const DiskFile* base = nullptr);

  /// Makes a list for H5Fcreate and H5Fopen, which ignore their path then.
  Handle access() const;

  const Pieces& pieces() const;
  /// Returns the end of what HDF5 has allocated: the least length of the file.
  std::uint64_t end() const;
  /// Returns position and bytes of the raw data allocated since the last call.
  std::vector<std::pair<std::uint64_t, std::uint64_t>> new_raw_data();
  /// Writes the pieces to the file: first those beyond `old_end`, then those that change what was there, so that a
  /// reader of the old structure never meets half of the new one. Then forgets the pieces; the file must be the base.
  /// Throws FileError; the pieces stay.
  void commit(DiskFile& file, std::uint64_t old_end);

  /// Throws FileError if the file could not be read since the beginning, whatever HDF5 made of that; std::bad_alloc if
  /// memory ran out.
  void check() const;

  struct Contents;

 private:
  std::shared_ptr<Contents> contents_;
};

}  // namespace ixos::hdf5
