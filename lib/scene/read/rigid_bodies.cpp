#include "scene/read/rigid_bodies.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "model/body_supports.hpp"
#include "parameters/options.hpp"
#include "parameters/range_validator.hpp"
#include "scene/read/motions.hpp"

namespace ixos {
namespace {

using Triple = std::array<double, 3>;

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
           "empty, "
           "all are free.")
      .add(
          "Rotation", &MotionOptions::rotation,
          "Name of a history, whose value is the angle of the body's rotation about the Centre. Then each direction is "
          "held, or has a history. If empty, the body turns by its own dynamics.")
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

/// Returns the array as a vector of space; throws unless it is empty or has an element for each dimension.
Triple vector_of(const SceneNode& node, const char* entry, const std::vector<double>& values, int dimension) {
  check_length(node, entry, values.size(), dimension);
  Triple result{};
  std::copy(values.begin(), values.end(), result.begin());
  return result;
}

/// Returns what turns: one number in 2D is that about z.
Triple turning_of(const SceneNode& node, const char* entry, const std::vector<double>& values, int dimension) {
  if (dimension == 3) return vector_of(node, entry, values, dimension);
  if (values.size() > 1)
    throw InputError(
        fmt::format("{} has {} elements, not 1: a body in 2D turns about z", node.path_of(entry), values.size()));
  return {0, 0, values.empty() ? 0 : values[0]};
}

void set_held(const SceneNode& node, const std::vector<std::string>& held, int dimension, RigidBodyOptions& body) {
  const std::vector<std::string> names = dimension == 2 ? std::vector<std::string>{"x", "y", "rz"}
                                                        : std::vector<std::string>{"x", "y", "z", "rx", "ry", "rz"};
  for (const std::string& name : held) {
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw InputError(fmt::format("{}: there is no direction \"{}\" here; allowed: {}", node.path_of("Held"), name,
                                   quoted_list(names)));
    const auto axis = static_cast<std::size_t>(name.back() - 'x');
    (name.size() == 1 ? body.translates : body.turns)[axis] = false;
  }
}

/// Refuses what a body that is prescribed as a whole cannot have.
void refuse_without_effect(const SceneNode& node, const RigidBodySettings& own) {
  for (const auto& [entry, values] : {std::pair{"Velocity", &own.velocity},
                                      {"Spin", &own.spin},
                                      {"Gravity", &own.gravity},
                                      {"Force", &own.force},
                                      {"Moment", &own.moment},
                                      {"Stiffness", &own.stiffness},
                                      {"Damping", &own.damping}})
    if (!values->empty()) node.refuse(entry, "has no effect: histories and Held prescribe the whole motion; remove it");
}

void set_given(const SceneNode& node, const RigidBodySettings& own, int dimension, RigidBodyOptions& body) {
  body.mass = own.mass;
  const std::size_t count = own.inertia.size();
  Small<double, 3>& j = body.inertia;
  if (dimension == 2) {
    j[2][2] = turning_of(node, "Inertia", own.inertia, 2)[2];
    return;
  }
  if (count != 0 && count != 3 && count != 6)
    throw InputError(fmt::format("{} has {} elements, not 3 or 6", node.path_of("Inertia"), count));
  for (std::size_t i = 0; i < 3 && count > 0; ++i) j[i][i] = own.inertia[i];
  for (std::size_t i = 0; i < 3 && count == 6; ++i) j[i][(i + 1) % 3] = j[(i + 1) % 3][i] = own.inertia[3 + i];
}

/// `solid`: the dimension of the body, 3 on an axisymmetric mesh.
void set_shape(const SceneNode& node, const RigidBodySettings& own, int dimension, bool solid, RigidBodyOptions& body) {
  const auto given = [&](const char* entry, bool is) {
    if (!is) throw InputError(node.path_of(entry) + " is missing: the Shape needs it");
  };
  given("Density", own.density > 0);
  const double r = own.radius;
  Small<double, 3>& j = body.inertia;
  if (own.shape == BodyShape::Sphere) {
    given("Radius", r > 0);
    body.mass = own.density * (solid ? 4 * M_PI / 3 * r * r * r : M_PI * r * r);
    for (std::size_t i = 0; i < 3; ++i) j[i][i] = body.mass * r * r * (solid ? 0.4 : 0.5);
  } else if (own.shape == BodyShape::Box) {
    given("Sides", !own.sides.empty());
    if (solid && dimension == 2) node.refuse_value("Shape", "", "is no body of revolution; choose Sphere or Cylinder");
    const Triple sides = vector_of(node, "Sides", own.sides, dimension);
    body.mass = own.density;
    for (const double side : own.sides) body.mass *= side;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        if (k != i) j[i][i] += body.mass * sides[k] * sides[k] / 12;
  } else {
    given("Radius", r > 0);
    given("Height", own.height > 0 || !solid);
    if (dimension == 2 && !own.direction.empty())
      node.refuse("Direction",
                  "a Cylinder has its axis along z in the plane, along y on an axisymmetric mesh; remove it");
    Triple axis = vector_of(node, "Direction", own.direction, dimension);
    if (own.direction.empty()) axis = {0, 0, 1};
    const double length = std::sqrt(dot(axis, axis));
    if (!(length > 0)) node.refuse("Direction", "it must have a direction");
    const double height = solid ? own.height : 1;
    body.mass = own.density * M_PI * r * r * height;
    const double along = body.mass * r * r / 2, across = body.mass * (r * r / 4 + height * height / 12);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        j[i][k] = (along - across) * axis[i] * axis[k] / (length * length) + (i == k ? across : 0);
  }
}

void add_load(Model& model, const RigidBody& body, std::size_t first, const double* values, std::size_t at,
              std::size_t count, const std::shared_ptr<const TimeFunction>& history) {
  std::vector<double> forces(static_cast<std::size_t>(model.space().local()), 0.0);
  const bool mine = model.space().comm()->getRank() == 0;  // forces on globals are shares of ranks
  for (std::size_t i = 0; i < count && mine; ++i)
    if (std::find(body.free().begin(), body.free().end(), at + i) != body.free().end())
      forces[first + at + i] = values[i];
  model.loads().add(std::move(forces), history);
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

RigidBodies read_rigid_bodies(const SceneNode& bodies, int dimension, bool axisymmetric, bool has_inertia) {
  std::vector<RigidBody> all;
  for (const SceneNode& node : bodies.sublists()) {
    const RigidBodySettings own = read_rigid_body(node);
    RigidBodyOptions body;
    body.name = node.name();
    body.centre = vector_of(node, "Centre", own.centre, dimension);
    set_held(node, own.held, dimension, body);
    check_length(node, "Translation", own.translation.size(), dimension);
    for (std::size_t i = 0; i < own.translation.size(); ++i) {
      if (own.along(i).empty()) continue;
      if (axisymmetric && i == 0) node.refuse("Translation", "it moves the body off the axis of an axisymmetric mesh");
      if (!body.translates[i]) node.refuse("Translation", "it moves the body along a direction in which it is Held");
      body.translates[i] = false;
    }
    if (!own.rotation.empty()) {
      if (!own.is_prescribed(dimension, axisymmetric))
        node.refuse("Rotation", "with it each direction must be Held or have a history in Translation");
      body.turns = {false, false, false};
    }
    if (own.shape == BodyShape::Given)
      set_given(node, own, dimension, body);
    else
      set_shape(node, own, dimension, dimension == 3 || axisymmetric, body);
    if (own.is_prescribed(dimension, axisymmetric)) {
      refuse_without_effect(node, own);
      continue;
    }
    if (has_inertia && body.mass == 0)
      throw InputError(node.path_of("Mass") + " is missing: a body that moves in time needs it");
    at(node.path(), [&] { all.emplace_back(body, dimension, axisymmetric); });
  }
  return RigidBodies(std::move(all));
}

std::optional<RigidMotion> prescribed_motion(const SceneNode& bodies, const std::string& name,
                                             const Histories& histories, int dimension, bool axisymmetric) {
  for (const SceneNode& node : bodies.sublists()) {
    if (node.name() != name) continue;
    RigidBodySettings own = read_rigid_body(node);
    if (!own.is_prescribed(dimension, axisymmetric)) return std::nullopt;
    own.point = own.centre;
    return rigid_motion(node, own, histories, dimension);
  }
  return std::nullopt;
}

void add_rigid_body_loads(const SceneNode& bodies, const Histories& histories, Model& model) {
  const int d = model.mesh().dimension;
  for (const SceneNode& node : bodies.sublists()) {
    const RigidBodySettings own = read_rigid_body(node);
    if (own.is_prescribed(d, model.mesh().axisymmetric)) continue;
    const std::size_t number = model.rigid_bodies().find(node.name());
    const RigidBody& body = model.rigid_bodies()[number];
    const std::size_t first = model.first_number(number);
    for (std::size_t i = 0; i < own.translation.size(); ++i)
      if (const std::string name = own.along(i); !name.empty())
        model.drive_body(number, i,
                         at(node.path_of("Translation"), [&] { return histories.get(name, HistoryUse::Motion); }));
    const auto history = [&](const char* entry, const std::string& name) {
      return name.empty() ? constant(1.0)
                          : at(node.path_of(entry), [&] { return histories.get(name, HistoryUse::Load); });
    };
    if (!own.gravity.empty()) {
      const Triple force = scaled(body.mass(), vector_of(node, "Gravity", own.gravity, d));
      add_load(model, body, first, force.data(), 0, 3, constant(1.0));
    }
    if (!own.force.empty()) {
      const Triple force = vector_of(node, "Force", own.force, d);
      add_load(model, body, first, force.data(), 0, 3, history("Force History", own.force_history));
    }
    MotionOptions base;
    base.translation = own.base;
    check_length(node, "Base", own.base.size(), d);
    check_length(node, "Stiffness", own.stiffness.size(), d);
    check_length(node, "Damping", own.damping.size(), d);
    RigidMotionOptions motion;
    for (std::size_t i = 0; i < own.base.size(); ++i) {
      const std::string name = base.along(i);
      motion.translation.push_back(
          name.empty() ? nullptr : at(node.path_of("Base"), [&] { return histories.get(name, HistoryUse::Motion); }));
    }
    at(node.path(), [&] { support_body(model, node.name(), RigidMotion(d, motion), {own.stiffness, own.damping}); });
    if (!own.moment.empty()) {
      const std::size_t axes = static_cast<std::size_t>(
          std::count_if(body.free().begin(), body.free().end(), [](std::size_t i) { return i >= RigidBody::turning; }));
      if (axes != 1)
        node.refuse("Moment", "a moment acts on a body that turns about one axis; this one turns about " +
                                  std::string(axes == 0 ? "none" : "all"));
      if (own.moment.size() != 1)
        throw InputError(fmt::format("{} has {} elements, not 1", node.path_of("Moment"), own.moment.size()));
      const double force = own.moment[0] / body.length();
      add_load(model, body, first, &force, body.free().back(), 1, history("Moment History", own.moment_history));
    }
  }
}

void set_rigid_body_velocities(const SceneNode& bodies, const Model& model, std::vector<double>& velocities) {
  const int d = model.mesh().dimension;
  for (const SceneNode& node : bodies.sublists()) {
    const RigidBodySettings own = read_rigid_body(node);
    if (own.is_prescribed(d, model.mesh().axisymmetric)) continue;
    const std::size_t number = model.rigid_bodies().find(node.name());
    const RigidBody& body = model.rigid_bodies()[number];
    const std::size_t first = model.first_number(number);
    const Triple velocity = vector_of(node, "Velocity", own.velocity, d);
    const Triple spin = scaled(body.length(), turning_of(node, "Spin", own.spin, d));
    for (const std::size_t i : body.free())
      velocities[first + i] = i < RigidBody::turning ? velocity[i] : spin[i - RigidBody::turning];
    for (std::size_t i = 0; i < 3; ++i) {
      if (velocity[i] != velocities[first + i]) node.refuse("Velocity", "the body is held along that direction");
      if (spin[i] != velocities[first + RigidBody::turning + i])
        node.refuse("Spin", "the body is held about that axis");
    }
  }
}

std::string rigid_bodies_in_words(const RigidBodies& bodies, int dimension) {
  const char* const names[] = {"x", "y", "z", "rx", "ry", "rz"};
  std::string text;
  for (const RigidBody& body : bodies) {
    std::vector<std::string> free;
    for (const std::size_t i : body.free()) free.emplace_back(names[i]);
    text += fmt::format("Rigid body {}: mass {:.6g}, centre ({:.6g}), moves along or about {}\n", body.name(),
                        body.mass(), fmt::join(body.centre().begin(), body.centre().begin() + dimension, ", "),
                        free.empty() ? "nothing" : fmt::format("{}", fmt::join(free, ", ")));
  }
  return text;
}

}  // namespace ixos
