/// Coordinates along a wall.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "interaction/obstacle.hpp"
#include "parameters/options.hpp"
#include "parameters/range_validator.hpp"
#include "parameters/scene_node.hpp"

namespace ixos {

/// An origin and three unit vectors at right angles: the first two along the wall, the last out of it. In two
/// dimensions the second is zero.
struct Frame {
  std::array<double, 3> origin{};
  std::array<std::array<double, 3>, 3> axes{};

  /// Returns the coordinates of a point.
  PackPoint to_local(const PackPoint& x) const {
    PackPoint result;
    for (std::size_t k = 0; k < 3; ++k)
      result[k] = (x[0] - origin[0]) * axes[k][0] + (x[1] - origin[1]) * axes[k][1] + (x[2] - origin[2]) * axes[k][2];
    return result;
  }
  /// Returns the vector with these coordinates.
  PackPoint to_space(const PackPoint& local) const {
    PackPoint result;
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = local[0] * axes[0][i] + local[1] * axes[1][i] + local[2] * axes[2][i];
    return result;
  }
};

/// Reads "Point", "Normal" and, in three dimensions, "Direction", of which the part along the wall counts. If they are
/// empty, the wall is through the origin, its normal is the last axis, and the direction is the first one, or the
/// second one if the normal is nearly the first. Throws InputError.
Frame read_frame(const SceneNode& node, std::size_t dimension);

/// The parameters that read_frame() reads.
struct FrameParameters {
  std::vector<double> point, normal, direction;
};

/// Adds them to the options of a struct that derives from FrameParameters, with the documentation of two of them.
template <class Parameters>
void add_frame(Options<Parameters>& options, const std::string& point, const std::string& direction) {
  options.add("Point", &Parameters::point, point, any_number())
      .add("Normal", &Parameters::normal,
           "Vector that points out of the wall [-]. If empty, it points along the last axis.", any_number())
      .add("Direction", &Parameters::direction, direction, any_number());
}

}  // namespace ixos
