#include "scene/read/mesh_sets.hpp"

#include "mesh/name_pattern.hpp"
#include "mesh/selection.hpp"
#include "parameters/options.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {
namespace {

struct Selection : Region {
  bool of_sides = true;
  std::string from;
};

const Options<Selection>& options() {
  static const Options<Selection> all =
      Options<Selection>()
          .choose("Kind", &Selection::of_sides, {{"Sides", true}, {"Nodes", false}},
                  "Kind of set: sides of elements, or nodes. A side is selected if all its corners lie in the region. "
                  "The region is what all conditions given below have in common.")
          .add("From", &Selection::from,
               "Set to select from. If it is empty, sides are selected from the whole boundary of the mesh, nodes from "
               "the whole mesh.")
          .add("Lower", &Selection::lower, "A box: its smallest coordinates [L0]. If empty, there is no bound.",
               any_number())
          .add("Upper", &Selection::upper, "A box: its largest coordinates [L0]. If empty, there is no bound.",
               any_number())
          .add("Plane Normal", &Selection::plane_normal,
               "A plane (a line in 2D): its normal, of any length [-]. If empty, there is no plane.", any_number())
          .add("Plane Point", &Selection::plane_point, "A point of the plane [L0]. If empty, it is the origin.",
               any_number())
          .add("Sphere Radius", &Selection::sphere_radius,
               "The inside and the surface of a sphere (a circle in 2D): its radius [L0]. With 0, there is no sphere.",
               at_least(0))
          .add("Sphere Center", &Selection::sphere_center, "Centre of the sphere [L0]. If empty, it is the origin.",
               any_number())
          .add("Normal", &Selection::normal,
               "Sides only: a direction, of any length [-]. Selects the sides whose outward normal is at most Normal "
               "Angle away from it. If empty, sides may look in any direction.",
               any_number())
          .add("Normal Angle", &Selection::normal_angle,
               "Largest angle between Normal and the outward normal of a side [degrees].", between(0, 180))
          .add("Tolerance", &Selection::tolerance,
               "Distance from the region up to which a node counts as inside [L0]. With 0, it is a thousandth of the "
               "shortest edge of the mesh, and a set that leaves out sides or nodes within ten times that is refused.",
               at_least(0));
  return all;
}

}  // namespace

void declare_set(Teuchos::ParameterList& list) { options().declare(list); }

void add_sets(const SceneNode& sets, Mesh& mesh) {
  for (const SceneNode& own : sets.sublists()) {
    const Selection selection = options().read(own);
    at(own.path(), [&] {
      if (selection.of_sides)
        add_side_set(mesh, own.name(), selection.from, selection);
      else
        add_node_set(mesh, own.name(), selection.from, selection);
    });
  }
}

std::vector<std::string> set_patterns(const Teuchos::ParameterList& list) {
  std::vector<std::string> result;
  for (const auto& [name, entry] : entries(list)) {
    if (entry.isList()) {
      const std::vector<std::string> inner = set_patterns(Teuchos::getValue<Teuchos::ParameterList>(entry));
      result.insert(result.end(), inner.begin(), inner.end());
    } else if (entry.isType<std::string>() &&
               (name == "Node Set" || name == "Side Set" || name == "Primary Side Set")) {
      const auto& set = Teuchos::getValue<std::string>(entry);
      if (is_pattern(set)) result.push_back(set);
    }
  }
  return result;
}

}  // namespace ixos
