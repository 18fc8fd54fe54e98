#include "scene/examine/supports.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/vector3.hpp"
#include "interaction/catalogue.hpp"
#include "interaction/obstacle.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/fitted_normal.hpp"
#include "mesh/free_motions.hpp"
#include "mesh/node_place.hpp"
#include "mesh/selection.hpp"
#include "model/conditions.hpp"
#include "scene/read/grips.hpp"

namespace ixos {
namespace {

using Point = std::array<double, 3>;

/// A connected part, or several that are judged as one.
struct Body {
  std::vector<Point> places;
  std::vector<Restraint> outer;  ///< by conditions, grips and obstacles
  std::vector<Restraint> inner;  ///< by other bodies
  std::set<std::string> blocks;
};

class Supports {
 public:
  Supports(const Mesh& mesh, const std::vector<int>& parts) : mesh_(mesh), parts_(parts), joined_(mesh.nodes()) {
    std::vector<bool> seen(parts.size(), false);
    for (const ElementBlock& block : mesh.blocks)
      for (const int node : block.nodes) {
        if (mesh.is_derivative(node) || seen[static_cast<std::size_t>(node)]) continue;
        seen[static_cast<std::size_t>(node)] = true;
        Body& body = bodies_[part_of(node)];
        body.places.push_back(place(node));
        body.blocks.insert(block.name);
      }
  }

  void add_condition(const SceneNode& node) {
    const NodeSet* set = find_set(mesh_.node_sets, node.text("Node Set"));
    if (set == nullptr) return;
    if (node.text("Type") == "Symmetry") return at(node.path_of("Node Set"), [&] { hold_in_plane(*set); });
    if (node.text("Type") != "Displacement") return;
    hold(*set, components_of(node.text("Components"), mesh_.dimension));
  }

  void add_grip(const SceneNode& node) {
    const GripOptions grip = read_grip(node);
    const NodeSet* set = find_set(mesh_.node_sets, grip.node_set);
    if (set == nullptr) return;
    std::vector<int> axes;
    for (int i = 0; i < mesh_.dimension; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      if (grip.type == GripType::Rigid || (axis < grip.stiffness.size() && grip.stiffness[axis] > 0)) axes.push_back(i);
    }
    hold(*set, axes);
  }

  void add_obstacle(const SceneInteraction& interaction) {
    const SideSet* set = find_set(mesh_.side_sets, interaction.side_set);
    if (set == nullptr) return;
    const auto obstacle = obstacles().make(interaction.node, static_cast<std::size_t>(mesh_.dimension));
    const bool turns = interaction.moves() && interaction.node.text("Obstacle") != "Half-Space";
    for (const int node : nodes_of(*set)) {
      const Point x = place(node);
      const ObstacleGap found = obstacle->at({x[0], x[1], x[2]});
      const Point normal{found.normal[0][0], found.normal[1][0], found.normal[2][0]};
      const bool known = std::isfinite(dot(normal, normal)) && dot(normal, normal) > 0;
      if (has_friction(interaction) || turns || !known)
        hold_all(bodies_[part_of(node)].outer, x);
      else
        bodies_[part_of(node)].outer.push_back({x, normal});
    }
  }

  void add_pair(const SceneInteraction& interaction) {
    const SideSet* first = find_set(mesh_.side_sets, interaction.side_set);
    const SideSet* second = find_set(mesh_.side_sets, interaction.primary);
    if (first == nullptr || second == nullptr || first->sides.empty() || second->sides.empty()) return;
    const std::set<int> first_parts = parts_of(*first), second_parts = parts_of(*second);
    for (const SideSet* set : {first, second})
      for (const Side& side : set->sides) {
        std::vector<Restraint> own;
        add_side(side, has_friction(interaction), own);
        const int part = part_of(nodes_of_side(mesh_, side).front());
        // The side restrains its own body against others, and the bodies of the other surface against its own.
        const std::set<int>& others = set == first ? second_parts : first_parts;
        const bool faces_another = others.size() > 1 || others.count(part) == 0;
        for (const int other : others)
          if (other != part) append(own, bodies_[other].inner);
        if (faces_another) append(own, bodies_[part].inner);
      }
    for (const std::set<int>* all : {&first_parts, &second_parts})
      for (const int part : *all) joined_.join(*first_parts.begin(), part);
  }

  std::vector<Warning> warnings() {
    std::vector<Warning> result;
    std::map<int, Body> groups;
    std::map<int, int> sizes;
    std::set<int> reported;
    for (auto& [part, body] : bodies_) {
      const int group = joined_.of(part);
      Body& whole = groups[group];
      append(body.places, whole.places);
      append(body.outer, whole.outer);
      whole.blocks.insert(body.blocks.begin(), body.blocks.end());
      ++sizes[group];
      append(body.inner, body.outer);
      if (judge(body, false, result)) reported.insert(group);
    }
    for (const auto& [group, body] : groups)
      if (sizes[group] > 1 && reported.count(group) == 0) judge(body, true, result);
    return result;
  }

 private:
  int part_of(int node) const { return parts_[static_cast<std::size_t>(node)]; }

  Point place(int node) const { return node_place(mesh_, node); }

  template <class Values>
  static void append(const Values& values, Values& all) {
    all.insert(all.end(), values.begin(), values.end());
  }

  static bool has_friction(const SceneInteraction& interaction) {
    return interaction.friction.type != FrictionType::None;
  }

  void hold(const NodeSet& set, const std::vector<int>& axes) {
    for (const int node : set.nodes)
      for (const int axis : axes) {
        if (mesh_.is_derivative(node)) continue;
        Point direction{};
        direction[static_cast<std::size_t>(axis)] = 1;
        bodies_[part_of(node)].outer.push_back({place(node), direction});
      }
  }

  void hold_in_plane(const NodeSet& set) {
    const Point normal = fitted_normal(mesh_, set);
    for (const int node : set.nodes)
      if (!mesh_.is_derivative(node)) bodies_[part_of(node)].outer.push_back({place(node), normal});
  }

  void hold_all(std::vector<Restraint>& restraints, const Point& x) const {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(mesh_.dimension); ++axis) {
      Point direction{};
      direction[axis] = 1;
      restraints.push_back({x, direction});
    }
  }

  /// Adds the side's normal at its nodes, or all directions.
  void add_side(const Side& side, bool sticks, std::vector<Restraint>& restraints) const {
    Point normal = outward_normal(mesh_, side);
    const double length = std::sqrt(dot(normal, normal));
    for (double& component : normal) component /= length > 0 ? length : 1;
    for (const int node : nodes_of_side(mesh_, side)) {
      if (mesh_.is_derivative(node)) continue;
      if (sticks)
        hold_all(restraints, place(node));
      else
        restraints.push_back({place(node), normal});
    }
  }

  std::set<int> nodes_of(const SideSet& set) const {
    std::set<int> nodes;
    for (const Side& side : set.sides)
      for (const int node : nodes_of_side(mesh_, side))
        if (!mesh_.is_derivative(node)) nodes.insert(node);
    return nodes;
  }

  std::set<int> parts_of(const SideSet& set) const {
    std::set<int> parts;
    for (const Side& side : set.sides) parts.insert(part_of(nodes_of_side(mesh_, side).front()));
    return parts;
  }

  /// Adds a warning if the body has a free motion; returns whether it has one. `several`: bodies that move as one.
  bool judge(const Body& body, bool several, std::vector<Warning>& result) const {
    constexpr std::size_t most = 5;
    const MotionSpace space = mesh_.axisymmetric     ? MotionSpace::Revolved
                              : mesh_.dimension == 2 ? MotionSpace::Plane
                                                     : MotionSpace::Space;
    const FreeMotions motions = free_motions(body.places, body.outer, space);
    if (motions.empty()) return false;
    if (result.size() == most) return true;
    std::vector<double> centre(static_cast<std::size_t>(mesh_.dimension), 0.0);
    for (const Point& x : body.places)
      for (std::size_t i = 0; i < centre.size(); ++i) centre[i] += x[i] / static_cast<double>(body.places.size());
    result.push_back(
        {support_warning,
         fmt::format("nothing holds {} of {} \"{}\" around ({:.4g}){}; Static needs supports against every rigid "
                     "motion: prescribe displacements (a plane of symmetry holds its normal direction), add springs "
                     "(Grips), or use a scheme with inertia",
                     in_words(motions), several ? "the bodies" : "the body", fmt::join(body.blocks, "\", \""),
                     fmt::join(centre, ", "), several ? ", which move as one" : "")});
    return true;
  }

  const Mesh& mesh_;
  const std::vector<int>& parts_;
  DisjointSets joined_;         ///< of parts, by interactions of bodies
  std::map<int, Body> bodies_;  ///< by part
};

}  // namespace

std::vector<Warning> missing_supports(const SceneNode& scene, const std::vector<SceneInteraction>& interactions,
                                      const Mesh& mesh, const std::vector<int>& parts) {
  Supports supports(mesh, parts);
  for (const SceneNode& node : scene.sublist("Boundary Conditions").sublists()) supports.add_condition(node);
  for (const SceneNode& node : scene.sublist("Grips").sublists()) supports.add_grip(node);
  for (const SceneInteraction& interaction : interactions)
    if (interaction.is_pair())
      supports.add_pair(interaction);
    else
      supports.add_obstacle(interaction);
  return supports.warnings();
}

}  // namespace ixos
