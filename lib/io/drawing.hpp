/// Drawings that gmsh, a program beside this one, makes meshes of.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "parameters/options.hpp"

namespace ixos {

/// The size of cells at a part of a drawing: at the points of a physical group, or at those in a box.
struct LocalSize {
  std::string name;
  double size = 0;                   ///< [L0]
  std::string group;                 ///< "": `name`
  std::vector<double> lower, upper;  ///< of the box [L0]; empty: there is none
};

/// How gmsh makes the mesh. A size of 0 is the drawing's own.
struct DrawingOptions {
  double size = 0;    ///< of the largest cells [L0]
  double factor = 1;  ///< of all sizes
  int order = 1;      ///< 2: quadratic cells whose sides follow the drawing
  Teuchos::ParameterList constants;
  std::vector<LocalSize> local;
  int dimension = 0;       ///< 0: that of the drawing
  double length_unit = 1;  ///< of the drawing [L0]
};

/// A mesh in a file, and what gmsh warned of.
struct DrawnMesh {
  std::string path;
  std::vector<std::string> warnings;
};

/// Returns whether a path is that of a drawing: .geo, .step, .stp, .brep, .iges or .igs, or in capitals but .geo.
bool is_drawing(const std::string& path);

/// Declares the list of a drawing's options; reads it.
void declare_drawing(Teuchos::ParameterList& list);
DrawingOptions read_drawing(const SceneNode& node);

/// Lets gmsh make the mesh of a drawing, unless the same drawing was meshed so before: the mesh stays in the user's
/// cache (XDG_CACHE_HOME, ~/.cache), by a checksum of drawing_files(), of the options and of the program. Throws
/// InputError, with gmsh's words, if there is no program gmsh on the PATH, or if it makes no mesh, and as
/// drawing_files() does; FileError if the cache cannot be written.
DrawnMesh drawn_mesh(const std::string& path, const DrawingOptions& options);

/// From now on scripts may start programs and write files, here and in programs that this one starts.
void trust_geometry();

}  // namespace ixos
