#include "scene/read/rigid_bodies.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/closest_name.hpp"
#include "base/error.hpp"
#include "scene/read/rigid_body_settings.hpp"

namespace ixos {
namespace {

using Triple = std::array<double, 3>;

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

}  // namespace

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
