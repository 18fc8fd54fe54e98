/// Contents of files of gmsh's formats MSH 4.1 and 2.2.
#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "io/msh_source.hpp"

namespace ixos {

/// Cells of one entity (a point, curve, surface or volume of the geometry) and of one type.
struct MshElements {
  int dimension;
  int entity;
  int type;                     ///< gmsh's number
  std::vector<int> nodes;       ///< cells x nodes of the type: indices into the file's nodes
  std::vector<long long> tags;  ///< of the cells
};

/// A physical group or an entity: dimension and tag.
using MshTag = std::pair<int, int>;

struct MshFile {
  std::size_t length = 0;                     ///< of the file [bytes]
  std::vector<double> coordinates;            ///< nodes x 3
  std::map<MshTag, std::string> names;        ///< of physical groups; not every group has a name
  std::map<MshTag, std::vector<int>> groups;  ///< by entity: the tags of its physical groups, each once
  std::vector<MshElements> elements;          ///< in the order of the file
};

/// A type of element: its name, nodes and dimension.
struct MshType {
  const char* name;
  int nodes;  ///< 0: the type is unknown
  int dimension;
};

/// Returns the type of gmsh's number: elements of first and second order.
MshType msh_type(int type);

/// Reads ASCII and binary files of versions 4.1 and 2.2. Other versions, other byte orders and partitioned meshes are
/// refused. Sections that hold no mesh are skipped; comments may come first. The number of every list is compared with
/// the length of the file before memory is allocated, and every node that an element names exists. Throws InputError,
/// see MshSource.
MshFile read_msh_file(MshSource source);

}  // namespace ixos
