#include "interaction/frame.hpp"

#include <cmath>

#include "base/vector3.hpp"
#include "interaction/direction.hpp"

namespace ixos {
namespace {

using Vector = std::array<double, 3>;

}  // namespace

Frame read_frame(const SceneNode& node, std::size_t dimension) {
  Frame frame;
  frame.origin = place_of(node, "Point", dimension);
  const Vector normal = unit_vector(node, "Normal", dimension, last_axis(dimension), "it must point out of the wall");
  frame.axes[2] = normal;
  if (dimension == 2) {
    if (!node.numbers("Direction").empty())
      node.refuse("Direction", "not allowed in two dimensions: there the normal determines it");
    frame.axes[0] = {normal[1], -normal[0], 0.0};
    return frame;
  }
  const Vector usual = std::abs(normal[0]) < 0.9 ? Vector{1.0, 0.0, 0.0} : Vector{0.0, 1.0, 0.0};
  Vector along = unit_vector(node, "Direction", dimension, usual);
  const double part = dot(along, normal);
  for (std::size_t i = 0; i < 3; ++i) along[i] -= part * normal[i];
  const double length = std::sqrt(dot(along, along));
  if (length < 1e-6) node.refuse("Direction", "is parallel to the normal; it must have a part along the wall");
  for (double& component : along) component /= length;
  frame.axes[0] = along;
  frame.axes[1] = cross(normal, along);
  return frame;
}

}  // namespace ixos
