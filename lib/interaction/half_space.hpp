/// A rigid flat wall.
#pragma once
#include <array>
#include <memory>

namespace ixos {

class Obstacle;

/// The rigid half-space { x : (x - point) . normal <= 0 }. The gap of a point is its distance (x - point) . normal.
struct HalfSpace {
  std::array<double, 3> point{};                ///< on the wall [L0]
  std::array<double, 3> normal{0.0, 1.0, 0.0};  ///< unit vector out of the wall
};

/// Returns the half-space as an obstacle.
std::shared_ptr<const Obstacle> flat_wall(const HalfSpace& wall);

}  // namespace ixos
