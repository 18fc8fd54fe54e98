#include "mesh/enrichment/bricks.hpp"

#include <cmath>

#include "mesh/generators/shapes.hpp"
#include "mesh/selection.hpp"

namespace ixos::test {

Mesh brick(const std::array<int, 3>& divisions) {
  BoxShape shape;
  shape.dimension = 3;
  shape.divisions = divisions;
  for (std::size_t d = 0; d < 3; ++d) shape.lengths[d] = divisions[d];
  Mesh mesh = box(shape);
  for (std::size_t n = 0; n < mesh.coordinates.size() / 3; ++n)
    for (std::size_t d = 0; d < 3; ++d) {
      double& x = mesh.coordinates[3 * n + d];
      if (x > 0 && x < divisions[d]) x += 0.15 * std::sin(7.0 * static_cast<double>(n) + 2.0 * static_cast<double>(d));
    }
  return mesh;
}

void choose(Mesh& mesh, const std::string& name, const std::string& from, const std::vector<std::size_t>& sides) {
  SideSet chosen{name, {}};
  for (std::size_t k : sides) chosen.sides.push_back(side_set_named(mesh, from).sides.at(k));
  mesh.side_sets.push_back(chosen);
}

}  // namespace ixos::test
