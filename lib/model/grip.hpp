/// A grip: a node set that a rigid body holds.
#pragma once
#include <string>
#include <vector>

#include "histories/rigid_motion.hpp"

namespace ixos {

class Springs;
class Dashpots;

/// The nodes follow the body, or springs and dashpots hold them to it.
struct Grip {
  std::string name;
  std::size_t node_set = 0;            ///< number in the mesh
  RigidMotion motion;                  ///< of the body
  bool rigid = true;                   ///< the nodes follow it
  const Springs* springs = nullptr;    ///< may be null
  const Dashpots* dashpots = nullptr;  ///< may be null
  int carrier = -1;  ///< the rigid body that carries the nodes, whose centre is the grip's point; -1: none
};

/// The force and the moment of a grip on the bodies of the scene.
struct GripReaction {
  std::vector<double> force;   ///< D components [E0 L0^(D-1)]; of bodies of revolution the first is summed over rings
  std::vector<double> moment;  ///< about the present place of the grip's point: z in 2D, x, y, z in 3D [E0 L0^D];
                               ///< empty for bodies of revolution
};

}  // namespace ixos
