/// Fields over time in files.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/tpetra.hpp"
#include "io/output_mesh.hpp"

namespace ixos {

/// Names of the variables, in the order in which their values come.
struct FieldNames {
  std::vector<std::string> nodal;
  std::vector<std::string> cell;
  std::vector<std::string> global;
};

/// The length of a file in frames and bytes.
struct FieldLength {
  int frames = 0;
  double bytes = 0;  ///< 0: not known, as another number of ranks wrote it
};

/// A file that grows by a frame at a time. All ranks call each function. If there is a file for each rank, an exception
/// may reach some ranks only.
class FieldFile {
 public:
  virtual ~FieldFile() = default;

  /// Throws FileError.
  virtual void create() = 0;
  /// Throws InputError if the existing file is not of this mesh and these names, or has fewer frames or bytes.
  virtual void verify(const FieldLength& keep) const = 0;
  /// Continues the file that verify() accepted after the frames to keep, and drops later ones. Throws FileError.
  virtual void resume(const FieldLength& keep) = 0;

  /// Appends a frame: `nodal[v]` by local node; `cell[v][b]` by cell of local block b; `global[v]` (the same on every
  /// rank). Throws FileError.
  virtual void write(double time, const std::vector<std::vector<double>>& nodal,
                     const std::vector<std::vector<std::vector<double>>>& cell, const std::vector<double>& global) = 0;
  virtual FieldLength length() const = 0;
  virtual void sync() = 0;   ///< has the disk keep the frames; throws FileError
  virtual void close() = 0;  ///< after the last frame; throws FileError
};

/// The mesh, the names and the title of a file of fields, and lines for whoever reads it. Title and lines are written
/// when a file is made; a file that is resumed keeps those that it has.
struct FieldContents {
  OutputMesh output;
  FieldNames names;
  std::string title;
  std::vector<std::string> information{};  ///< see exodus_records()
};

/// Makes a file in Exodus, in the classic format of netCDF. On a single rank, `path` holds everything. On several
/// ranks, each writes a file of its cells and their nodes, with the numbers of the whole mesh, in the series path.N.r
/// that ParaView opens.
std::unique_ptr<FieldFile> exodus_fields(const std::string& path, FieldContents contents, const Comm& comm);

/// Makes one HDF5 file that all ranks write together: Exodus as netCDF 4 lays it out, for the readers of Exodus and of
/// HDF5. Nodes and cells stand in the order of the mesh, on any number of ranks.
std::unique_ptr<FieldFile> hdf5_fields(const std::string& path, FieldContents contents, const Comm& comm);

}  // namespace ixos
