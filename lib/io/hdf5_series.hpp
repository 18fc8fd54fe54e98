/// Numbers over time in an HDF5 file that all ranks write together.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "io/hdf5_file.hpp"

namespace ixos {

/// Data sets that grow by a row with each frame. Written by parallel HDF5, with collective transfers through MPI-IO.
///
/// Whatever happens while a frame is written, the frames before it can be read: rows are only added behind others, the
/// sets' index of rows only grows at its end (HDF5's extensible array; its older B-tree would divide nodes that are in
/// use), and the file is as long as the frame needs before the first byte of it is written.
class Hdf5Series {
 public:
  /// Rows of `width` numbers. `scale` is the data set whose length that is; without one a row is a single number.
  struct Set {
    std::string name;
    unsigned long long width;
    std::string scale;
  };
  enum class Mode { Read, Write };

  /// Adds sets without rows to a file, in the place of what has their names. Its data set `frames`, and those that
  /// `sets` name as scales, become their dimension scales. Throws FileError. Not collective.
  static void add(const std::string& path, const std::string& frames, const std::vector<Set>& sets);

  /// Throws InputError unless the file has these sets as add() makes them, and rows for that many frames in each:
  /// numbers as they are, without filters, so that nothing of these rows is decoded. Not collective.
  static void check(const std::string& path, const std::vector<Set>& sets, unsigned long long frames);

  /// Throws InputError where the file has no such sets, or rows of other widths. Collective, as all that follows.
  Hdf5Series(const std::string& path, const Comm& comm, const std::vector<Set>& sets, Mode mode);
  ~Hdf5Series();
  Hdf5Series(const Hdf5Series&) = delete;
  Hdf5Series& operator=(const Hdf5Series&) = delete;

  /// Makes room for so many frames, on the disk too; throws FileError where it has none.
  void grow(unsigned long long frames);
  /// A rank's part of a row, of the set of that number; a rank's slab may be empty.
  void write(std::size_t set, unsigned long long frame, const double* values, const Slab& slab);
  std::vector<double> read(std::size_t set, unsigned long long frame, const Slab& slab) const;
  /// Brings to the file what was written; throws FileError, on all ranks, where any rank could not write since last.
  void flush();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace ixos
