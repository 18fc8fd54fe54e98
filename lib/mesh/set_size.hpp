/// Sizes of the sets of a mesh.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace ixos {

/// How many sides or nodes a set has, and how large its sides are.
struct SetSize {
  std::string name;
  bool of_sides = true;
  std::size_t count = 0;
  double measure = 0;  ///< of the sides: length [L0]; in 3D, and of a body of revolution, area [L0^2]; 0 of nodes
};

/// Returns the length of a side [L0], in 3D its area, and in an axisymmetric mesh that of the ring [L0^2]. Integrates
/// along the curve or the face of the cell without enrichment.
double side_measure(const Mesh& mesh, const Side& side);

/// Returns the sizes of all side sets, then of all node sets.
std::vector<SetSize> set_sizes(const Mesh& mesh);

/// Returns a line such as "side set foot: 8 sides, 2 L0" or "node set head: 9 nodes". `body_dimension`: see Mesh.
std::string in_words(const SetSize& size, int body_dimension);

}  // namespace ixos
