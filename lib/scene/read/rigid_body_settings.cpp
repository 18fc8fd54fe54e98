#include "scene/read/rigid_body_settings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "parameters/options.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {
namespace {

Options<RigidBodySettings> make_options() {
  Options<RigidBodySettings> all;
  all.choose_one(
         "Shape", &RigidBodySettings::shape,
         {{"Given", BodyShape::Given},
          {"Sphere", BodyShape::Sphere},
          {"Box", BodyShape::Box},
          {"Cylinder", BodyShape::Cylinder}},
         {{"Given", {"Mass", "Inertia"}},
          {"Sphere", {"Density", "Radius"}},
          {"Box", {"Density", "Sides"}},
          {"Cylinder", {"Density", "Radius", "Height", "Direction"}}},
         "From what mass and inertia follow. Given: from the numbers in the list; Sphere, Box and Cylinder: from "
         "a homogeneous body. In plane strain Sphere is a disk and Box a rectangle, of unit depth.")
      .add("Mass", &RigidBodySettings::mass,
           "Mass [E0 T0^2 for a body in 2D, E0 L0 T0^2 for a body in 3D]. On an axisymmetric mesh it is that of the "
           "whole body, with the unit of 3D. A run in time needs it.",
           at_least(0))
      .add("Inertia", &RigidBodySettings::inertia,
           "Moments of inertia about the Centre [E0 L0^2 T0^2 for a body in 2D, E0 L0^3 T0^2 for a body in 3D]: in 2D "
           "one number; in 3D three, about x, y and z, or six, xx, yy, zz, xy, yz and zx of the tensor. A body that "
           "turns in time needs it.",
           any_number())
      .add("Density", &RigidBodySettings::density, "Mass per volume [E0 T0^2/L0^2].", greater_than(0))
      .add("Radius", &RigidBodySettings::radius, "Radius of a Sphere or a Cylinder [L0].", greater_than(0))
      .add("Sides", &RigidBodySettings::sides, "Lengths of a Box along x, y and, in 3D, z [L0].", greater_than(0))
      .add("Height", &RigidBodySettings::height, "Length of a Cylinder along its axis [L0].", greater_than(0))
      .add("Direction", &RigidBodySettings::direction,
           "Direction of a Cylinder's axis [-], of any length. If empty, it is the last axis of coordinates; in the "
           "plane and on an axisymmetric mesh it is given: z, and y.",
           any_number())
      .add("Centre", &RigidBodySettings::centre,
           "Centre of mass in the reference configuration [L0]. If empty, it is the origin of coordinates.",
           any_number())
      .add("Held", &RigidBodySettings::held,
           "Directions in which the body cannot move: x, y and z for translations, rx, ry and rz for rotations about "
           "the axes; in 2D x, y and rz. A body in 3D turns about all axes, one, or none. On an axisymmetric mesh it "
           "moves along y alone.")
      .add("Translation", &MotionOptions::translation,
           "Names of histories, one for each direction, that move the Centre; \"-\" leaves the direction free. If "
           "empty, all are free.")
      .add("Rotation", &MotionOptions::rotation,
           "Name of a history, whose value is the angle of the body's rotation about the Centre. Then each direction "
           "is held, or has a history. If empty, the body turns by its own dynamics.")
      .add("Axis", &MotionOptions::axis,
           "Direction of the axis of that Rotation in 3D [-], of any length. In 2D the body turns about z.",
           any_number())
      .add("Velocity", &RigidBodySettings::velocity,
           "Velocity of the Centre at the initial time, by direction [L0/T0]. If empty, it is 0.", any_number())
      .add("Spin", &RigidBodySettings::spin,
           "Angular velocity at the initial time [1/T0]: in 2D one number, in 3D three. If empty, it is 0.",
           any_number())
      .add("Gravity", &RigidBodySettings::gravity, "Acceleration that the mass multiplies [L0/T0^2]. If empty, none.",
           any_number())
      .add("Force", &RigidBodySettings::force,
           "Force at the Centre for a history value of 1 [E0 L0 for a body in 2D, E0 L0^2 for a body in 3D]. If empty, "
           "none.",
           any_number())
      .add("Force History", &RigidBodySettings::force_history,
           "Name of a history that multiplies the Force. If empty, it is constant.")
      .add("Moment", &RigidBodySettings::moment,
           "Moment for a history value of 1, for a body that turns about one axis [E0 L0^2 for a body in 2D, E0 L0^3 "
           "for a body in 3D]: one number. If empty, none.",
           any_number())
      .add("Moment History", &RigidBodySettings::moment_history,
           "Name of a history that multiplies the Moment. If empty, it is constant.")
      .add("Stiffness", &RigidBodySettings::stiffness,
           "Stiffness of springs between the Centre and a base, by direction [E0 for a body in 2D, E0 L0 for a body in "
           "3D]. Bodies of revolution have the unit of 3D, and springs along y only. If empty, there are none.",
           at_least(0))
      .add("Damping", &RigidBodySettings::damping,
           "Damping of dashpots between the Centre and the base, by direction [E0 T0 for a body in 2D, E0 L0 T0 for a "
           "body in 3D], likewise.",
           at_least(0))
      .add("Base", &RigidBodySettings::base,
           "Names of histories, one for each direction, that move the base; \"-\" stands still. If empty, it stands "
           "still.");
  return all;
}

const Options<RigidBodySettings>& options() {
  static const Options<RigidBodySettings> all = make_options();
  return all;
}

}  // namespace

std::vector<std::string> RigidBodySettings::all_histories() const {
  std::vector<std::string> names = MotionOptions::histories();
  std::vector<std::string> all{force_history, moment_history};
  for (const std::string& name : base)
    if (name != "-") all.push_back(name);
  for (const std::string& name : all)
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

bool RigidBodySettings::is_prescribed(int dimension, bool axisymmetric) const {
  const auto is_held = [&](const std::string& name) { return std::find(held.begin(), held.end(), name) != held.end(); };
  bool all = true;
  for (std::size_t i = axisymmetric ? 1 : 0; i < static_cast<std::size_t>(dimension); ++i)
    all = all && (!along(i).empty() || is_held(std::string(1, "xyz"[i])));
  if (axisymmetric || !rotation.empty()) return all;
  const bool still = dimension == 2 ? is_held("rz") : is_held("rx") && is_held("ry") && is_held("rz");
  return all && still;
}

void declare_rigid_body(Teuchos::ParameterList& list) { options().declare(list); }

RigidBodySettings read_rigid_body(const SceneNode& node) { return options().read(node); }

std::array<double, 3> vector_of(const SceneNode& node, const char* entry, const std::vector<double>& values,
                                int dimension) {
  check_length(node, entry, values.size(), dimension);
  std::array<double, 3> result{};
  std::copy(values.begin(), values.end(), result.begin());
  return result;
}

std::array<double, 3> turning_of(const SceneNode& node, const char* entry, const std::vector<double>& values,
                                 int dimension) {
  if (dimension == 3) return vector_of(node, entry, values, dimension);
  if (values.size() > 1)
    throw InputError(
        fmt::format("{} has {} elements, not 1: a body in 2D turns about z", node.path_of(entry), values.size()));
  return {0, 0, values.empty() ? 0 : values[0]};
}

}  // namespace ixos
