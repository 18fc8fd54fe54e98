/// Numbers over time in an HDF5 file that all ranks write together.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "io/hdf5_file.hpp"

namespace ixos {

/// Data sets that grow by a row with each frame. HDF5 keeps the structure in the memory of the first rank; each rank
/// writes its part of a row to the disk itself, at the place that HDF5 allocated.
///
/// Whatever happens while a frame is written, the frames before it can be read: rows are only added behind others, the
/// sets' index of rows only grows at its end (HDF5's extensible array; its older B-tree would divide nodes that are in
/// use), the file is as long as the frame needs before the first byte of it is written, and the structure follows the
/// rows.
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

  /// Opens the file. Throws InputError if it has no such sets, or rows of other widths; FileError if the disk cannot
  /// read it. Collective, as all that follows.
  Hdf5Series(const std::string& path, const Comm& comm, const std::vector<Set>& sets, Mode mode);
  ~Hdf5Series();
  Hdf5Series(const Hdf5Series&) = delete;
  Hdf5Series& operator=(const Hdf5Series&) = delete;

  /// Appends a row to each set; `values[s]` and `slabs[s]` are this rank's part of the row of set s, which may be
  /// empty. Throws FileError on all ranks if any rank could not write, or the file cannot grow.
  void append(const std::vector<std::vector<double>>& values, const std::vector<Slab>& slabs);
  /// Reads a rank's part of a row. Throws InputError, or FileError if a disk cannot read it, on all ranks alike.
  std::vector<double> read(std::size_t set, unsigned long long frame, const Slab& slab) const;
  /// Has the disk keep the frames. Throws FileError on all ranks alike.
  void sync();
  /// Closes the file; a later call does nothing. Throws FileError on all ranks alike.
  void close();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace ixos
