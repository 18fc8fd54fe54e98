#include "scene/read/parameters.hpp"

#include <Teuchos_Array.hpp>

#include "parameters/one_of.hpp"
#include "parameters/range_validator.hpp"
#include "parameters/validation.hpp"
#include "scene/output/output_options.hpp"
#include "scene/read/grips.hpp"
#include "scene/read/histories.hpp"
#include "scene/read/initial_conditions.hpp"
#include "scene/read/interactions.hpp"
#include "scene/read/materials.hpp"
#include "scene/read/mesh_adaptation.hpp"
#include "scene/read/mesh_map.hpp"
#include "scene/read/mesh_refinement.hpp"
#include "scene/read/mesh_sets.hpp"
#include "scene/read/newton_options.hpp"
#include "scene/read/rigid_body_settings.hpp"
#include "scene/read/scene_mesh.hpp"
#include "scene/read/stages.hpp"
#include "scene/read/stop.hpp"
#include "scene/read/time_integrator_options.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;
using Numbers = Teuchos::Array<double>;

void add_units(List& list) {
  list.set("Length", "1 nm", "Unit of length, L0.");
  list.set("Energy Density", "2 GPa", "Unit of energy density and stress, E0.");
  list.set("Time", "1 ns", "Unit of time, T0.");
}

/// Declares a side set that follows another one.
void declare_pair(List& list, const char* follower, const char* primary, const char* tolerance) {
  list.set("Side Set", "", follower);
  list.set("Primary Side Set", "", primary);
  list.set("Tolerance", 0.0, tolerance, at_least(0));
}

void add_mesh(List& list) {
  meshes().declare(list);
  list.set(geometry_choice, "Plane Strain",
           "Meaning of a mesh of two dimensions. Plane Strain: a body of unit depth. Axisymmetric: a body of "
           "revolution about the y axis, x is the radius; forces, energies and masses are those of the whole body. "
           "Nodes on the axis stay on it. A mesh of three dimensions ignores Plane Strain.",
           one_of({"Plane Strain", axisymmetric_geometry}));
  list.set(cell_order, 1,
           "Order of the cells. 1: linear cells, and those of a file as they are. 2: quadratic cells; linear "
           "quadrilaterals and hexahedra get nodes in the middle of their edges, faces and insides (9 and 27), other "
           "cells in the middle of their edges and, for Mean Dilatation and Central Difference, of triangles and "
           "insides. In the Disk they follow the circle, other meshes keep their shape; the Map moves the new nodes, "
           "too.",
           between(1, 2));
  declare_refinement(
      list.sublist("Refine", false,
                   "Places where cells are split before Map moves the nodes. The scene chooses the names "
                   "of these lists. A cell is split that meets all that a list names; at least one of "
                   "Lower, Upper, Sphere Radius and Side Set is needed. Neighbours differ by one level "
                   "at most: further cells are split around the regions. Nodes of fine cells on edges "
                   "and faces of coarse ones follow the nodes of these.")
          .sublist(any_name));
  declare_adaptation(list);
  declare_map(list.sublist("Map", false,
                           "Formulas that move the nodes, for graded meshes and for shapes that no generator has. Sets "
                           "refer to the new places."));
  declare_set(list.sublist("Sets", false, "Additional sets, selected by region. The scene chooses their names.")
                  .sublist(any_name));
  declare_pair(
      list.sublist("Ties", false,
                   "Pairs of surfaces that move as one though their meshes differ. The scene chooses the "
                   "names of these lists.")
          .sublist(any_name),
      "Side set whose nodes follow the other one. That must cover it.", "Side set that it follows.",
      "Distance up to which the surfaces may be apart [L0]: the nodes of the Side Set are moved onto the other "
      "one. With 0, it is a twentieth of the size of a side.");
  declare_pair(list.sublist("Periodic", false,
                            "Pairs of sides that are one: a wave that leaves through the one comes in through the "
                            "other. Both have the same mesh, and one is the other moved by a translation. The "
                            "scene chooses the names of these lists.")
                   .sublist(any_name),
               "Side set whose nodes follow those of the other one.", "Side set that they follow.",
               "Distance up to which a node may be off its partner's place [L0]. With 0, it is a thousandth of the "
               "shortest edge of the mesh.");
}

void add_condition(List& list) {
  list.set("Type", "Displacement",
           "Kind of condition. Displacement prescribes a displacement; Symmetry keeps nodes in their plane, of any "
           "direction; Traction is a force per reference length (2D) "
           "or area (3D), Body Force a force per reference volume, Gravity an acceleration that the density "
           "multiplies, Point Force a force on each node of a set. In plane strain all forces are per depth; on an "
           "axisymmetric mesh a Point Force is the force on the whole ring of a node, and Gravity acts along y.",
           one_of({"Displacement", "Symmetry", "Traction", "Body Force", "Gravity", "Point Force"}));
  list.set("Node Set", "", "Node set of a Displacement, a Symmetry or a Point Force.");
  list.set("Side Set", "", "Side set of a Traction.");
  list.set("Block", "", "Block of a Body Force or of Gravity. If empty, the load acts on all blocks.");
  list.set("Components", "all", "Directions of a Displacement.",
           one_of({"x", "y", "z", "xy", "xz", "yz", "xyz", "all"}));
  list.set("Vector", Numbers(),
           "Load for a history value of 1 [E0 for a Traction, E0/L0 for a Body Force, L0/T0^2 for Gravity, E0 L0 for a "
           "Point Force in 2D, E0 L0^2 for a Point Force in 3D]. On an axisymmetric mesh a Point Force has the unit of "
           "3D.",
           any_number());
  list.set("History", "",
           "Name of a list of Histories that gives the value over time. If empty, a Displacement is held at 0 and a "
           "load is constant.");
}

void add_time_integrator(List& list) {
  declare_time_integrator(list);
  declare_stop(list.sublist("Stop", false, "Criteria that end the run before Final Time; the first one met ends it.")
                   .sublist(any_name));
}

void add_output(List& list) {
  declare_output(list);
  List& probe =
      list.sublist("Probes", false, "Named points whose displacements and velocities become columns of history.csv.")
          .sublist(any_name);
  probe.set("Point", Numbers(), "Position of the probe in the reference configuration [L0].", any_number());
}

List make_scene_parameters() {
  List scene("Scene");
  add_units(scene.sublist("Units", false,
                          "Units that plain numbers refer to. Defaults of other parameters are plain numbers: they "
                          "change with these units. A number with a unit, such as \"10 nm\", is "
                          "converted."));
  add_mesh(scene.sublist("Mesh", false, "Mesh of the bodies."));
  declare_material(scene.sublist("Materials", false, "One list for each block of the mesh.").sublist(any_name));
  declare_interaction(scene.sublist("Interactions", false, "One list for each adhesive surface.").sublist(any_name));
  declare_history(
      scene.sublist("Histories", false, "Named functions of time for motions and loads.").sublist(any_name));
  add_condition(scene.sublist("Boundary Conditions", false, "One list for each prescribed motion and each load.")
                    .sublist(any_name));
  declare_grip(scene
                   .sublist("Grips", false,
                            "One list for each grip: a node set that moves as a rigid body, or that springs and "
                            "dashpots hold to one. Its name heads the columns of its force and moment.")
                   .sublist(any_name));
  declare_rigid_body(scene
                         .sublist("Rigid Bodies", false,
                                  "One list for each rigid body that moves by its own dynamics. Obstacles belong to it "
                                  "by the entry Rigid Body of their interactions.")
                         .sublist(any_name));
  declare_initial_conditions(scene.sublist("Initial Conditions", false, "Velocities at the initial time."));
  add_time_integrator(scene.sublist("Time Integrator", false, "Time integration scheme and its steps."));
  declare_newton(scene.sublist("Nonlinear Solver", false, "Newton's method (NOX)."));
  mark_free_form(scene.sublist(
      "Linear Solver", false,
      "A Stratimikos list. Linear Solver Type is Automatic (the default: chosen by size, shape and step size), Direct, "
      "Belos or Amesos2. Preconditioner Type is None, Direct, MueLu, Ifpack2, Chebyshev or Two-Level. Two entries are "
      "Ixos' own: "
      "Operator is Automatic, Assembled or Matrix-Free, and Reuse/Setup Cost is the cost of a new preconditioner in "
      "iterations of the linear solver."));
  add_output(scene.sublist("Output", false, "Results that a run writes."));
  declare_stages(scene);
  return scene;
}

}  // namespace

const List& scene_parameters() {
  static const List parameters = make_scene_parameters();
  return parameters;
}

}  // namespace ixos
