/// HDF5 as checkpoints use it: numbers as attributes of groups, texts and arrays as data sets. Once used, HDF5 no
/// longer prints errors in this process: they are exceptions here.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/digest.hpp"
#include "base/tpetra.hpp"

namespace ixos {

/// A rank's part of a data set of one dimension.
struct Slab {
  unsigned long long offset = 0;
  unsigned long long count = 0;
  unsigned long long total = 0;  ///< length of the data set
};

/// A part of a file that was written, and what it should hold.
struct FilePiece {
  std::uint64_t position;
  std::uint64_t length;
  Checksum checksum;  ///< of the bytes in memory, not of those on the disk
};

/// A file that all ranks write together. HDF5 makes its structure in the memory of the first rank; each rank writes
/// its own slabs to the disk. Names are of the present group.
class Hdf5Output {
 public:
  /// Leaves `user_block` bytes, a power of two of at least 512, free at the beginning. Throws FileError if the disk has
  /// no room for `size` bytes.
  Hdf5Output(const std::string& path, const Comm& comm, int user_block, unsigned long long size);
  ~Hdf5Output();
  Hdf5Output(const Hdf5Output&) = delete;
  Hdf5Output& operator=(const Hdf5Output&) = delete;

  void enter(const std::string& group);
  void leave();
  void put(const char* name, double value);  ///< the first rank's
  void put(const char* name, const std::string& value);
  void put(const char* name, const double* values, const Slab& slab);
  void put(const char* name, const long long* values, const Slab& slab);

  /// Writes the structure, has the disk keep what the other ranks wrote, and closes the file. Returns, on the first
  /// rank, the pieces of the file behind the user block, in order and without gaps. Throws FileError on all ranks if
  /// any rank failed to write since the beginning: until then all continue, for none may leave the others alone in a
  /// collective call.
  std::vector<FilePiece> close();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Starts the HDF5 library so that its end is no part of MPI_Finalize or exit(): HDF5 1.10 may crash there after a
/// failure. Programs call it before MPI_Init.
void start_hdf5();

/// A file that each rank reads for itself. A name that is missing, or of another kind, throws InputError.
class Hdf5Input {
 public:
  explicit Hdf5Input(const std::string& path);
  ~Hdf5Input();
  Hdf5Input(const Hdf5Input&) = delete;
  Hdf5Input& operator=(const Hdf5Input&) = delete;

  bool has_group(const std::string& name) const;
  void enter(const std::string& group);
  void leave();
  double number(const char* name) const;
  std::string text(const char* name) const;
  unsigned long long length(const char* name) const;  ///< of a data set
  /// The slab's part; its `total` is not used.
  std::vector<double> numbers(const char* name, const Slab& slab) const;
  std::vector<long long> integers(const char* name, const Slab& slab) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace ixos
