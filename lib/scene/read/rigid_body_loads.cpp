#include "scene/read/rigid_body_loads.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "model/body_supports.hpp"
#include "scene/read/rigid_body_settings.hpp"

namespace ixos {
namespace {

using Triple = std::array<double, 3>;

/// Calls visit(list, settings, number of the body) for each body that is not prescribed as a whole.
template <class Visit>
void for_each_body(const SceneNode& bodies, const Model& model, const Visit& visit) {
  for (const SceneNode& node : bodies.sublists()) {
    const RigidBodySettings own = read_rigid_body(node);
    if (own.is_prescribed(model.mesh().dimension, model.mesh().axisymmetric)) continue;
    visit(node, own, model.rigid_bodies().find(node.name()));
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

void add_rigid_body_loads(const SceneNode& bodies, const Histories& histories, Model& model) {
  const int d = model.mesh().dimension;
  for_each_body(bodies, model, [&](const SceneNode& node, const RigidBodySettings& own, std::size_t number) {
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
      if (body.axes() != 1)
        node.refuse("Moment", "a moment acts on a body that turns about one axis; this one turns about " +
                                  std::string(body.turns() ? "all" : "none"));
      if (own.moment.size() != 1)
        throw InputError(fmt::format("{} has {} elements, not 1", node.path_of("Moment"), own.moment.size()));
      const double force = own.moment[0] / body.length();
      add_load(model, body, first, &force, body.free().back(), 1, history("Moment History", own.moment_history));
    }
  });
}

void set_rigid_body_velocities(const SceneNode& bodies, const Model& model, std::vector<double>& velocities) {
  const int d = model.mesh().dimension;
  for_each_body(bodies, model, [&](const SceneNode& node, const RigidBodySettings& own, std::size_t number) {
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
  });
}

}  // namespace ixos
