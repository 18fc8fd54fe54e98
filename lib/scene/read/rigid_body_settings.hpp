/// The parameters of a rigid body of a scene.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <array>
#include <string>
#include <vector>

#include "parameters/scene_node.hpp"
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

/// Returns the array of an entry as a vector of space. Throws InputError unless it is empty or has an element for each
/// dimension.
std::array<double, 3> vector_of(const SceneNode& node, const char* entry, const std::vector<double>& values,
                                int dimension);

/// Returns a spin or a moment: in 2D the array has one number, about z, or none. Throws InputError.
std::array<double, 3> turning_of(const SceneNode& node, const char* entry, const std::vector<double>& values,
                                 int dimension);

}  // namespace ixos
