/// Fields over time in Exodus files: one file, or one a rank in the series fields.e.N.r that ParaView opens.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "mesh/local_mesh.hpp"

namespace ixos {

/// Names of the variables, in the order in which their values come.
struct FieldNames {
  std::vector<std::string> nodal;
  std::vector<std::string> cell;
  std::vector<std::string> global;
};

/// How far a file goes.
struct FieldLength {
  int frames = 0;
  double bytes = 0;
};

/// One rank's file. It holds the rank's own cells and their nodes, with the numbers of the whole mesh.
class FieldFile {
 public:
  /// `path` without the rank's ending. Makes the file with create(), or goes on with the one that is there with
  /// resume().
  FieldFile(const std::string& path, const LocalMesh& mesh, int rank, int ranks, const FieldNames& names,
            const std::string& title);
  ~FieldFile();
  FieldFile(const FieldFile&) = delete;
  FieldFile& operator=(const FieldFile&) = delete;

  /// Throws FileError.
  void create();
  /// Throws InputError where the file there is not of this mesh and these names, or has fewer frames or bytes.
  void verify(const FieldLength& keep) const;
  /// Goes on after the frames to keep in the file that verify() found to fit; later ones are dropped. Throws FileError.
  void resume(const FieldLength& keep);

  /// Appends a frame: `nodal[v]` by local node; `cell[v][b]` by cell of local block b; `global[v]` (the same on every
  /// rank). Throws FileError.
  void write(double time, const std::vector<std::vector<double>>& nodal,
             const std::vector<std::vector<std::vector<double>>>& cell, const std::vector<double>& global);
  FieldLength length() const;
  void sync();  ///< has the disk keep them; throws FileError

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace ixos
