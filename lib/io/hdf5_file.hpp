/// HDF5 as checkpoints use it: numbers as attributes of groups, texts and arrays as data sets. Once used, HDF5 prints
/// no errors of its own in this process any more: they are exceptions here.
#pragma once
#include <string>
#include <vector>

#include "base/tpetra.hpp"

namespace ixos {

/// A rank's part of a data set of one dimension.
struct Slab {
  unsigned long long offset = 0;
  unsigned long long count = 0;
  unsigned long long total = 0;  ///< length of the data set
};

/// A file that is written by all ranks together (MPI-IO, collective transfers; on a single rank plainly). Names are of
/// the present group.
class Hdf5Output {
 public:
  /// `user_block` bytes, a power of two of at least 512, stay free at the beginning. Throws FileError where the disk
  /// has no room for `size` bytes: what HDF5 and MPI-IO do on a full disk is not for the faint-hearted.
  Hdf5Output(const std::string& path, const Comm& comm, int user_block, unsigned long long size);
  ~Hdf5Output();
  Hdf5Output(const Hdf5Output&) = delete;
  Hdf5Output& operator=(const Hdf5Output&) = delete;

  void enter(const std::string& group);
  void leave();
  void put(const char* name, double value);  ///< the same on all ranks
  void put(const char* name, const std::string& value);
  void put(const char* name, const double* values, const Slab& slab);
  void put(const char* name, const long long* values, const Slab& slab);

  /// Closes the file. A failure on any rank since the beginning throws FileError here, on all ranks alike: until then
  /// all go on, for none may leave the others alone in a collective call.
  void close();

  /// Did some file fail to close on this rank? HDF5 1.10 then crashes in MPI_Finalize: a program should not get there.
  static bool left_open();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// A file that each rank reads for itself. What is not there, or of another kind, throws InputError.
class Hdf5Input {
 public:
  explicit Hdf5Input(const std::string& path);
  ~Hdf5Input();
  Hdf5Input(const Hdf5Input&) = delete;
  Hdf5Input& operator=(const Hdf5Input&) = delete;

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
