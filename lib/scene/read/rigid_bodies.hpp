/// Rigid bodies of a scene.
#pragma once
#include <optional>
#include <string>

#include "histories/rigid_motion.hpp"
#include "parameters/scene_node.hpp"
#include "rigid/rigid_bodies.hpp"
#include "scene/read/histories.hpp"

namespace ixos {

/// Returns the bodies of the list "Rigid Bodies", without those that are prescribed as a whole. `has_inertia`: the run
/// needs their masses. Throws InputError with the list path.
RigidBodies read_rigid_bodies(const SceneNode& bodies, int dimension, bool axisymmetric, bool has_inertia);

/// Returns the motion of a body that is prescribed as a whole; nothing if it is not.
std::optional<RigidMotion> prescribed_motion(const SceneNode& bodies, const std::string& name,
                                             const Histories& histories, int dimension, bool axisymmetric);

/// Returns a line for each body.
std::string rigid_bodies_in_words(const RigidBodies& bodies, int dimension);

}  // namespace ixos
