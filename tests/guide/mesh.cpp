#include "mesh/generators/entry.hpp"
#include "mesh/generators/shapes.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {
namespace {

struct Parameters {
  double length = 1;
  int cells = 4;
};

}  // namespace

MeshEntry sheared_mesh() {
  Options<Parameters> options;
  options.add("Length", &Parameters::length, "Edge length [L0].", greater_than(0))
      .add("Cells", &Parameters::cells, "Number of cells along an edge.", between(1, 1000));
  return {"Sheared",
          "A square, sheared by 45 degrees.",
          "",
          options.list(),
          [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            BoxShape shape;
            shape.lengths = {p.length, p.length, 0};
            shape.divisions = {p.cells, p.cells, 1};
            Mesh mesh = box(shape);
            for (std::size_t k = 0; k < mesh.coordinates.size(); k += 2) mesh.coordinates[k] += mesh.coordinates[k + 1];
            return mesh;
          },
          false,
          2};
}

}  // namespace ixos
