#include "mesh/mesh.hpp"

namespace ixos {

int Mesh::cells() const {
  int sum = 0;
  for (const ElementBlock& block : blocks) sum += block.cells();
  return sum;
}

}  // namespace ixos
