#include "mesh/placement.hpp"

#include <cmath>

#include "base/vector3.hpp"

namespace ixos {
namespace {

using Vector = std::array<double, 3>;

struct Turn {
  double cosine, sine;
};

Turn turn(double degrees) {
  const double quarters = degrees / 90;
  if (quarters != std::round(quarters)) return {std::cos(degrees * M_PI / 180), std::sin(degrees * M_PI / 180)};
  const int quarter = static_cast<int>(std::fmod(quarters, 4)) & 3;  // also of negative angles
  constexpr std::array<Turn, 4> exact{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  return exact[static_cast<std::size_t>(quarter)];
}

}  // namespace

void move_nodes(const Placement& placement, Mesh& mesh) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const auto [cosine, sine] = turn(placement.angle);
  const bool turns = cosine != 1;
  const Vector& axis = placement.axis;
  for (std::size_t first = 0; first < mesh.coordinates.size(); first += d) {
    double* place = &mesh.coordinates[first];
    Vector arm{};
    for (std::size_t i = 0; i < d; ++i) arm[i] = place[i] - placement.point[i];
    const Vector across = cross(axis, arm);
    const double along = dot(axis, arm);
    for (std::size_t i = 0; i < d; ++i) {
      if (turns) place[i] = placement.point[i] + cosine * arm[i] + sine * across[i] + (1 - cosine) * along * axis[i];
      place[i] += placement.translation[i];
    }
  }
}

}  // namespace ixos
