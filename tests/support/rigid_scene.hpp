/// Scenes with a rigid body before an elastic block.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>

namespace ixos::test {

/// The options in which the scenes differ.
struct RigidScene {
  int dimension = 2;
  std::string scheme = "Energy-Momentum";
  double step = 0.02;
  double mass = 30;
  std::string body{};      ///< more entries of the rigid body
  std::string more{};      ///< more lists
  bool held = false;       ///< the underside of the block is held
  double gap = 0.5;        ///< of the ball at the start
  std::string settings{};  ///< of the scheme
  bool ball_rests = false;
  double plate = 0;  ///< mass of a free plate to which the underside of the block is glued; 0: none
};

/// Returns all lists of the scene below but the integrator's.
std::string ball_on_block_lists(const RigidScene& options);

/// Returns a ball, a disk in the plane, that flies obliquely and spins towards the top of a free block. Its inertia has
/// three different moments.
Teuchos::ParameterList ball_on_block(const RigidScene& options);

}  // namespace ixos::test
