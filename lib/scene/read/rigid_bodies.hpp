/// Rigid bodies of a scene.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "parameters/scene_node.hpp"
#include "rigid/rigid_bodies.hpp"
#include "scene/read/histories.hpp"
#include "scene/read/motions.hpp"

namespace ixos {

enum class BodyShape { Given, Sphere, Box, Cylinder };

/// One list of "Rigid Bodies".
struct RigidBodySettings : MotionOptions {
  BodyShape shape = BodyShape::Given;
  double mass = 0;
  std::vector<double> inertia{};
  double density = 0, radius = 0, height = 0;
  std::vector<double> sides{}, direction{};
  std::vector<double> centre{};
  std::vector<std::string> held{};
  std::vector<double> velocity{}, spin{};
  std::vector<double> gravity{}, force{}, moment{};
  std::string force_history{}, moment_history{};
  std::vector<double> stiffness{}, damping{};
  std::vector<std::string> base{};

  /// Returns whether histories, and what is held, leave nothing free: the body is prescribed as a whole.
  bool is_prescribed(int dimension, bool axisymmetric) const;
  /// Returns the names of all its histories, each once.
  std::vector<std::string> all_histories() const;
};

/// Adds the parameters of a rigid body to a valid list.
void declare_rigid_body(Teuchos::ParameterList& list);

RigidBodySettings read_rigid_body(const SceneNode& node);

/// Returns the bodies of the list "Rigid Bodies", without those that are prescribed as a whole. `has_inertia`: the run
/// needs their masses. Throws InputError with the list path.
RigidBodies read_rigid_bodies(const SceneNode& bodies, int dimension, bool axisymmetric, bool has_inertia);

/// Returns the motion of a body that is prescribed as a whole; nothing if it is not.
std::optional<RigidMotion> prescribed_motion(const SceneNode& bodies, const std::string& name,
                                             const Histories& histories, int dimension, bool axisymmetric);

/// Adds the loads on them, their springs and dashpots, and what histories move, to the model. Throws InputError with
/// the list path, on all ranks alike.
void add_rigid_body_loads(const SceneNode& bodies, const Histories& histories, Model& model);

/// Sets the bodies' numbers in the initial velocities, a local array. Throws InputError with the list path.
void set_rigid_body_velocities(const SceneNode& bodies, const Model& model, std::vector<double>& velocities);

/// Returns a line for each body.
std::string rigid_bodies_in_words(const RigidBodies& bodies, int dimension);

}  // namespace ixos
