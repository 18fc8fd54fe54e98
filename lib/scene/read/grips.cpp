#include "scene/read/grips.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/grips.hpp"
#include "scene/read/rigid_bodies.hpp"

namespace ixos {
namespace {

Options<GripOptions> make_options() {
  Options<GripOptions> all;
  all.choose_one("Type", &GripOptions::type, {{"Rigid", GripType::Rigid}, {"Springs", GripType::Springs}},
                 {{"Rigid", {}}, {"Springs", {"Stiffness", "Damping"}}},
                 "Kind of grip. Rigid: the nodes follow a rigid body. Springs: springs and dashpots hold the nodes "
                 "to the places to which the rigid body would carry them, as a testing machine does.")
      .add("Node Set", &GripOptions::node_set, "Node set that the grip holds.")
      .add("Rigid Body", &GripOptions::rigid_body,
           "Name of a list of Rigid Bodies, whose body the nodes follow; their forces act on it. Its Centre is the "
           "Point of the moment. Empty: the entries of this list move the nodes.");
  add_motion_options(all, "rigid body", "The moment of the grip refers to it. ");
  all.add("Stiffness", &GripOptions::stiffness,
          "Stiffness of all springs together, by direction [E0 for a grip in 2D, E0 L0 for a grip in 3D]. The "
          "nodes of the set share it equally. Bodies of revolution have the unit of 3D, and springs along y only. If "
          "empty, there are no springs.",
          at_least(0))
      .add("Damping", &GripOptions::damping,
           "Damping of all dashpots together, by direction [E0 T0 for a grip in 2D, E0 L0 T0 for a grip in 3D]. The "
           "nodes of the set share it equally. Bodies of revolution have the unit of 3D, and dashpots along y only. If "
           "empty, there are no dashpots.",
           at_least(0));
  return all;
}

const Options<GripOptions>& options() {
  static const Options<GripOptions> all = make_options();
  return all;
}

}  // namespace

void declare_grip(Teuchos::ParameterList& list) { options().declare(list); }

GripOptions read_grip(const SceneNode& node) { return options().read(node); }

void add_grips(const SceneNode& grips, const SceneNode& bodies, const Histories& histories, Model& model) {
  const int d = model.mesh().dimension;
  for (const SceneNode& node : grips.sublists()) {
    const GripOptions grip = read_grip(node);
    if (grip.node_set.empty()) throw InputError(node.path_of("Node Set") + " is missing: a grip needs it");
    at(node.path_of("Node Set"), [&] { return model.mesh().node_set(grip.node_set); });
    if (!grip.rigid_body.empty()) {
      if (grip.type != GripType::Rigid)
        node.refuse("Rigid Body", "carries the nodes of a Rigid grip, not springs; leave it empty");
      if (!grip.histories().empty() || !grip.point.empty())
        node.refuse("Rigid Body", "moves the grip; leave it, or Translation, Rotation and Point, empty");
    }
    const auto whole = prescribed_motion(bodies, grip.rigid_body, histories, d, model.mesh().axisymmetric);
    const RigidMotion motion = whole ? *whole : rigid_motion(node, grip, histories, d);
    if (!grip.rigid_body.empty() && !whole) {
      at(node.path_of("Rigid Body"), [&] { model.rigid_bodies().find(grip.rigid_body); });
      at(node.path(), [&] { grip_by_body(model, node.name(), grip.node_set, grip.rigid_body); });
      continue;
    }
    if (grip.type == GripType::Rigid) {
      at(node.path(), [&] { grip_rigidly(model, node.name(), grip.node_set, motion); });
      continue;
    }
    check_length(node, "Stiffness", grip.stiffness.size(), d);
    check_length(node, "Damping", grip.damping.size(), d);
    at(node.path(), [&] {
      grip_elastically(model, node.name(), grip.node_set, motion, {grip.stiffness, grip.damping});
    });
  }
}

std::string grips_in_words(const SceneNode& grips) {
  std::string text;
  for (const SceneNode& node : grips.sublists()) {
    const GripOptions grip = read_grip(node);
    text += fmt::format("Grip {}: node set \"{}\", {}, {}", node.name(), grip.node_set,
                        grip.type == GripType::Rigid ? "rigid" : "springs and dashpots",
                        grip.rigid_body.empty() ? grip.in_words() : "carried by the rigid body " + grip.rigid_body);
    if (grip.type == GripType::Springs)
      text += fmt::format(", stiffness {{{}}}, damping {{{}}}", fmt::join(grip.stiffness, ", "),
                          fmt::join(grip.damping, ", "));
    text += "; its reactions are columns of history.csv\n";
  }
  return text;
}

}  // namespace ixos
