#include "model/grips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "model/supports.hpp"

namespace ixos {
namespace {

std::size_t checked_set(const Model& model, const std::string& name, const std::string& node_set,
                        const RigidMotion& motion) {
  model.check_open();
  if (motion.dimension() != model.mesh().dimension)
    throw InputError(fmt::format("the motion of the grip \"{}\" has {} dimensions, the mesh {}", name,
                                 motion.dimension(), model.mesh().dimension));
  if (model.mesh().axisymmetric && (motion.turns() || motion.translates(0)))
    throw InputError(
        fmt::format("the grip \"{}\" moves off the axis of an axisymmetric mesh: it may translate along y only", name));
  for (const Grip& grip : model.grips())
    if (grip.name == name) throw InputError("there are two grips of the name \"" + name + "\"");
  return model.mesh().node_set(node_set);
}

std::vector<MotionShare> shares_of(const LocalMesh& mesh, const RigidMotion& motion, int node, int i) {
  const auto n = static_cast<std::size_t>(node);
  const double* place = &mesh.coordinates[n * static_cast<std::size_t>(mesh.dimension)];
  // The coordinates of a derivative node are dX/ds.
  return mesh.is_derivative(n) ? motion.displacement_derivative(place, i) : motion.displacement(place, i);
}

/// Nodes of the mesh that carry springs, ghosts included, and the number of them on all ranks.
struct Carriers {
  std::vector<int> nodes;
  double count = 0;
};

Carriers carriers(const Model& model, std::size_t set) {
  Carriers result;
  for (const int node : model.mesh().node_sets[set]) {
    if (model.mesh().is_added(static_cast<std::size_t>(node)) || model.mesh().is_tied(node)) continue;
    result.nodes.push_back(node);
    if (node < model.mesh().owned_nodes) ++result.count;
  }
  model.space().sum(&result.count, 1);
  return result;
}

DrivenEnds driven_ends(const Model& model, const Carriers& carriers, const RigidMotion& motion,
                       const std::vector<double>& whole) {
  DrivenEnds ends;
  const auto to = std::make_shared<Constraints>();
  const int d = model.mesh().dimension;
  for (const int node : carriers.nodes)
    for (int i = 0; i < d; ++i) {
      if (whole[static_cast<std::size_t>(i)] == 0) continue;
      ends.dofs.push_back(node * d + i);
      ends.coefficients.push_back(whole[static_cast<std::size_t>(i)] / carriers.count);
      to->add(node * d + i, shares_of(model.mesh(), motion, node, i));
    }
  ends.to = to;
  return ends;
}

}  // namespace

void grip_rigidly(Model& model, const std::string& name, const std::string& node_set, const RigidMotion& motion) {
  const std::size_t set = checked_set(model, name, node_set, motion);
  const LocalMesh& mesh = model.mesh();
  together<InputError>(model.space().comm(), [&] {
    for (const int node : mesh.node_sets[set])
      for (int i = 0; i < mesh.dimension && !mesh.is_tied(node); ++i) try {
          model.constraints().check(node * mesh.dimension + i, shares_of(mesh, motion, node, i));
        } catch (const InputError& error) {
          throw InputError(fmt::format("{}: component {} of node {} of the mesh", error.what(), "xyz"[i],
                                       mesh.message_number(static_cast<std::size_t>(node))));
        }
  });
  for (const int node : mesh.node_sets[set])
    if (mesh.is_tied(node))
      model.tied_conditions().add(node_set, node, [&model, motion](int master) {
        bool held = true;
        for (int i = 0; i < model.mesh().dimension; ++i)
          held = held && model.constraints().holds_by(master * model.mesh().dimension + i,
                                                      shares_of(model.mesh(), motion, master, i));
        return held;
      });
    else
      for (int i = 0; i < mesh.dimension; ++i)
        model.constraints().add(node * mesh.dimension + i, shares_of(mesh, motion, node, i));
  model.add_grip({name, set, motion}, nullptr, nullptr);
}

void grip_by_body(Model& model, const std::string& name, const std::string& node_set, const std::string& body) {
  const RigidMotion none(model.mesh().dimension, {});
  const std::size_t set = checked_set(model, name, node_set, none), carrier = model.rigid_bodies().find(body);
  together<InputError>(model.space().comm(), [&] {
    try {
      model.carry_nodes(carrier, model.mesh().node_sets[set]);
    } catch (const InputError& error) {
      throw InputError(fmt::format("the grip \"{}\": {}", name, error.what()));
    }
  });
  Grip grip{name, set, none};
  grip.carrier = static_cast<int>(carrier);
  model.add_grip(std::move(grip), nullptr, nullptr);
}

void grip_elastically(Model& model, const std::string& name, const std::string& node_set, const RigidMotion& motion,
                      const GripSupport& support) {
  const std::size_t set = checked_set(model, name, node_set, motion);
  const Carriers nodes = carriers(model, set);
  if (nodes.count == 0) throw InputError("the node set \"" + node_set + "\" has no nodes");
  Supports supports = make_supports(
      model, "the grip", support.stiffness, support.damping, motion,
      [&](const std::vector<double>& coefficients) { return driven_ends(model, nodes, motion, coefficients); });
  if (!supports.springs && !supports.dashpots)
    throw InputError("the grip has neither a stiffness nor a damping greater than 0");
  model.add_grip({name, set, motion, false}, std::move(supports.springs), std::move(supports.dashpots));
}

}  // namespace ixos
