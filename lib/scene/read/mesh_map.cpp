#include "scene/read/mesh_map.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>

#include "base/error.hpp"
#include "parameters/expression.hpp"

namespace ixos {
namespace {

constexpr std::array<const char*, 3> names{"X", "Y", "Z"};

}  // namespace

void declare_map(Teuchos::ParameterList& map) {
  for (const char* name : names)
    map.set(name, std::string(),
            fmt::format("Expression in x, y and z, the place of a node of the generator or the file in L0: the node's "
                        "new {} coordinate. If empty, it stays.",
                        name));
}

void map_nodes(const SceneNode& map, Mesh& mesh) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::array<std::unique_ptr<Expression>, 3> expressions;
  bool any = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string& text = map.text(names[i]);
    if (text.empty()) continue;
    if (i >= d) map.refuse(names[i], "a mesh of two dimensions has no third coordinate");
    at(map.path_of(names[i]), [&] {
      expressions[i] = std::make_unique<Expression>("map", text, std::vector<std::string>{"x", "y", "z"});
    });
    any = true;
  }
  for (std::size_t node = 0; any && node * d < mesh.coordinates.size(); ++node) {
    double* place = &mesh.coordinates[node * d];
    const std::array<double, 3> old{place[0], place[1], d == 3 ? place[2] : 0.0};
    for (std::size_t i = 0; i < d; ++i) {
      if (!expressions[i]) continue;
      place[i] = expressions[i]->at({old[0], old[1], old[2]});
      if (!std::isfinite(place[i]))
        throw InputError(fmt::format("{}: the node at ({:.6g}, {:.6g}, {:.6g}) has no finite place",
                                     map.path_of(names[i]), old[0], old[1], old[2]));
    }
  }
}

}  // namespace ixos
