/// Rigid motions of a body that nothing restrains.
#pragma once
#include <array>
#include <string>
#include <vector>

namespace ixos {

/// A place of a body [L0] at which its displacement along a direction, a unit vector, is restrained. The first
/// component of a body of revolution is radial.
struct Restraint {
  std::array<double, 3> place;
  std::array<double, 3> direction;
};

/// The motions that a body can have: translations and a rotation about z in the plane, all six in space; a body of
/// revolution has the translation along y.
enum class MotionSpace { Plane, Space, Revolved };

/// A basis of the rigid motions that change no restrained displacement to first order.
struct FreeMotions {
  /// An axis of a rotation: its direction, a unit vector, and its point nearest to the body's centre [L0].
  struct Axis {
    std::array<double, 3> direction;
    std::array<double, 3> point;
  };
  MotionSpace space = MotionSpace::Plane;
  std::vector<std::array<double, 3>> translations;  ///< orthogonal unit vectors
  std::vector<Axis> rotations;                      ///< about orthogonal axes, besides the translations
  bool empty() const { return translations.empty() && rotations.empty(); }
};

/// Returns the rigid motions of a body with nodes at these places that no restraint hinders. The values of the motions
/// at the restraints are the rows of a matrix, rotations about the body's centre and scaled by its size: a motion is
/// free if its singular value is below 1e-6 of the largest one. Such a motion changes neither strains nor gaps to first
/// order, so that the tangent of a static balance is singular.
FreeMotions free_motions(const std::vector<std::array<double, 3>>& places, const std::vector<Restraint>& restraints,
                         MotionSpace space);

/// Returns the motions in words: "the translation along (1, 0) and the rotation about (0, 2)"; empty if there are none.
std::string in_words(const FreeMotions& motions);

}  // namespace ixos
