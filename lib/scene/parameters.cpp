#include "scene/parameters.hpp"

#include <Teuchos_Array.hpp>

#include "histories/catalogue.hpp"
#include "parameters/one_of.hpp"
#include "parameters/range_validator.hpp"
#include "parameters/validation.hpp"
#include "scene/interactions.hpp"
#include "scene/materials.hpp"
#include "scene/scene_mesh.hpp"
#include "time/catalogue.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;
using Numbers = Teuchos::Array<double>;
using Counts = Teuchos::Array<int>;

void add_units(List& list) {
  list.set("Length", "1 nm", "Name of the unit of length, L0. It is a label only: nothing is converted.");
  list.set("Energy Density", "2 GPa", "Name of the unit of energy density and stress, E0.");
  list.set("Time", "1 ns", "Name of the unit of time, T0.");
}

void add_mesh(List& list) {
  meshes().declare(list);
  List& set = list.sublist("Sets", false, "Additional sets, selected by region. The scene chooses their names.")
                  .sublist(any_name);
  set.set("Kind", "Sides", "Kind of set: sides of elements, or nodes.", one_of({"Sides", "Nodes"}));
  set.set("From", "", "Set to select from. Sides need one; if it is empty, nodes are selected from the whole mesh.");
  set.set("Lower", Numbers(), "Smallest coordinates of the region [L0]. If empty, there is no bound.", any_number());
  set.set("Upper", Numbers(), "Largest coordinates of the region [L0]. If empty, there is no bound.", any_number());
}

void add_condition(List& list) {
  list.set("Type", "Displacement",
           "Kind of condition. Displacement prescribes a displacement; Traction is a force per reference length (2D) "
           "or area (3D), Body Force a force per reference volume, Point Force a force on each node of a set.",
           one_of({"Displacement", "Traction", "Body Force", "Point Force"}));
  list.set("Node Set", "", "Node set of a Displacement or of a Point Force.");
  list.set("Side Set", "", "Side set of a Traction.");
  list.set("Block", "", "Block of a Body Force. If empty, the force acts on all blocks.");
  list.set("Components", "all", "Directions of a Displacement.",
           one_of({"x", "y", "z", "xy", "xz", "yz", "xyz", "all"}));
  list.set("Vector", Numbers(),
           "Load for a history value of 1 [E0 for a Traction, E0/L0 for a Body Force, E0 L0^(D-1) for a Point Force "
           "in D dimensions].",
           any_number());
  list.set("History", "",
           "Name of a list of Histories that gives the value over time. If empty, a Displacement is held at 0 and a "
           "load is constant.");
}

void add_initial_conditions(List& list) {
  list.set("Velocity", Numbers(), "Uniform velocity [L0/T0]. If empty, it is zero.", any_number());
  list.set("Velocity Gradient", Numbers(),
           "Velocity gradient L, row by row [1/T0]: v = Velocity + L (X - Origin). A skew-symmetric L is a rotation. "
           "If empty, it is zero.",
           any_number());
  list.set("Origin", Numbers(),
           "Point at which Velocity Gradient contributes nothing [L0]. If empty, it is the origin of coordinates.",
           any_number());
}

void add_time_step_control(List& list) {
  List& control = list.sublist("Time Step Control", false, "Times of the run, and size of its steps.");
  control.set("Type", "Fixed",
              "How the step size is chosen. Fixed keeps it; Adaptive checks each step and adapts the size.",
              choice_of({"Fixed", "Adaptive"}));
  control.set("Initial Time", 0.0, "Time at which the run starts [T0].", any_number());
  set_required(control, "Final Time", "Time at which the run ends [T0]. It must be later than Initial Time.",
               any_number());
  set_required(
      control, "Time Step",
      "Step size [T0]; with Adaptive, the size of the first step. Steps are shortened where needed, so that one "
      "ends at Final Time and at each multiple of the time intervals of Output.",
      greater_than(0));
  control.set("Maximum Cuts", 0,
              "How many times Time Step may be halved after failed steps. With 0, a failed step ends the run. Adaptive "
              "runs ignore it.",
              between(0, 60));
  control.set("Minimum Time Step", 0.0, "Smallest step size that halving or adapting may choose [T0].", at_least(0));
  List& adaptive = control.sublist("Adaptive", false,
                                   "Limits of an adaptive step. A step that exceeds one of them is repeated with a "
                                   "smaller size.");
  adaptive.set("Tolerance", 0.0, "Largest local error of a displacement in a step [L0]. 0: no limit.", at_least(0));
  adaptive.set("Maximum Gap Ratio", 0.0,
               "Largest ratio between the gaps that a point of the surface has in a step [-]. It must "
               "be greater than 1. 0: no limit.",
               at_least(0));
  adaptive.set("Choose Time Points", false,
               "Chooses 5, 8 or 16 Gauss points in time for the interaction, by the gap ratio of the step.");
  adaptive.set("Safety", 0.9, "Safety factor: the next step takes this fraction of the predicted size [-].",
               greater_and_less_than(0, 1));
  adaptive.set("Largest Growth", 2.0, "Largest ratio of a step size to the one before [-].", greater_than(1));
  adaptive.set("Maximum Time Step", 0.0, "Largest step size [T0]. 0: no limit.", at_least(0));
}

void add_stop(List& list) {
  List& stop = list.sublist("Stop", false, "Criteria that end the run before Final Time; the first one met ends it.")
                   .sublist(any_name);
  stop.set("Type", "Probe",
           "Kind of criterion. Probe is met when a probe passes a limit; Detached when the contact of a surface that "
           "was in contact is lost.",
           choice_of({"Probe", "Detached"}));
  List& probe = stop.sublist("Probe", false, "A limit on a probe.");
  probe.set("Name", required, "Name of a probe in Output/Probes.");
  probe.set("Quantity", "y", "Coordinate (x), displacement (ux) or velocity (vx) of the probe.",
            one_of({"x", "y", "z", "ux", "uy", "uz", "vx", "vy", "vz"}));
  probe.set("Side", "Above", "Side of the limit on which the run ends.", one_of({"Above", "Below"}));
  set_required(probe, "Limit", "Limit of the quantity, in its unit [L0 or L0/T0].", any_number());
}

void add_time_integrator(List& list) {
  std::vector<std::string> names;
  const auto add = [&](const Scheme& scheme) {
    names.push_back(scheme.name);
    list.sublist(scheme.name, false, scheme.citation) = scheme.parameters;
    list.sublist(scheme.name).setName(scheme.name);
  };
  for (const Scheme& scheme : schemes()) add(scheme);
  add(custom_scheme());
  list.set("Type", default_scheme(),
           "Name of the time integration scheme. The option list-schemes of ixos prints the properties of each.",
           choice_of(names));
  list.set("Predictor", "Automatic", "Initial guess of Newton's method. Automatic is the guess that suits the scheme.",
           one_of({"Automatic", "Last Displacement", "Constant Velocity", "Constant Acceleration", "Newmark",
                   "Extrapolation"}));
  add_time_step_control(list);
  add_stop(list);
}

void add_nonlinear_solver(List& list) {
  list.set("Tolerance", 1e-11,
           "Convergence tolerance: the norm of the residual over the largest of the norms of inertia, elastic, "
           "interaction and external forces [-].",
           greater_and_less_than(0, 1));
  list.set("Linear Tolerance", 0.0,
           "Relative residual of iterative linear solves [-]. With 0, Eisenstat and Walker's forcing terms choose it, "
           "at most 1e-3.",
           at_least(0));
  list.set("Maximum Iterations", 100, "Largest number of Newton iterations. A step that needs more fails.",
           between(1, 10000));
  List& nox = list.sublist(
      "NOX", false,
      "Overrides lists of NOX: Printing, Direction, Line Search, ... Another Line Search replaces the one that keeps "
      "gaps positive; another Direction replaces the one that corrects tangents that are not positive definite.");
  mark_free_form(nox);
}

void add_output(List& list) {
  list.set("History Interval", 1, "Number of steps between rows of history.csv. The last state is always a row.",
           between(1, 1000000000));
  list.set("Fields Interval", 0, "Number of steps between frames of fields.e. 0: no frames.", between(0, 1000000000));
  list.set("Fields Format", "Exodus",
           "Format of fields.e. Exodus writes one file per rank; HDF5 writes one file that all ranks share (Exodus on "
           "HDF5).",
           one_of({"Exodus", "HDF5"}));
  list.set("History Time Interval", 0.0,
           "Time between rows of history.csv [T0]. It replaces History Interval unless it is 0.", at_least(0));
  list.set("Fields Time Interval", 0.0,
           "Time between frames of fields.e [T0]. It replaces Fields Interval unless it is 0.", at_least(0));
  List& checkpoint = list.sublist("Checkpoint", false,
                                  "Checkpoints, from which a run can be resumed. A run also writes one at its end and "
                                  "on SIGINT or SIGTERM.");
  checkpoint.set("Interval", 0, "Number of steps between checkpoints. 0: only Wall-Clock Interval counts.",
                 between(0, 1000000000));
  checkpoint.set("Wall-Clock Interval", 600.0, "Seconds between checkpoints. 0: only Interval counts.", at_least(0));
  checkpoint.set("Keep", 2, "Number of latest checkpoints that are kept. 0: the run writes none.", between(0, 1000));
  List& watch =
      list.sublist("Watch", false,
                   "Watch on the energy balance, row by row of history.csv. It needs Energies. It finds steps "
                   "that are too long for the scheme's points in time, and damaged memory.");
  watch.set(
      "Action", "Warn",
      "What a row does that breaks the bound. Warn prints one warning; Stop ends the run; Resume goes back to the "
      "last checkpoint, and ends the run if that does not help.",
      one_of({"Off", "Warn", "Stop", "Resume"}));
  watch.set("Tolerance", 0.0,
            "Largest change of the energy balance in a step, as a share of the largest energy so far [-]. 0: what the "
            "scheme, its points in time and the tolerance of Newton's method promise; then only schemes that conserve "
            "energy are watched, in scenes without damping.",
            at_least(0));
  list.set("Energies", true, "Whether history.csv has the energies.");
  list.set("Momenta", true, "Whether history.csv has the momenta.");
  list.set("Interaction", true, "Whether history.csv has contact force, contact measure and least gap.");
  list.set("Reactions", Teuchos::Array<std::string>(), "Node sets whose reactions become columns of history.csv.");
  List& probe =
      list.sublist("Probes", false, "Named points whose displacements and velocities become columns of history.csv.")
          .sublist(any_name);
  probe.set("Point", Numbers(), "Position of the probe in the reference configuration [L0].", any_number());
}

List make_scene_parameters() {
  List scene("Scene");
  add_units(scene.sublist("Units", false, "Names of the units. Every value of a scene is in L0, E0 and T0."));
  add_mesh(scene.sublist("Mesh", false, "Mesh of the bodies."));
  declare_material(scene.sublist("Materials", false, "One list for each block of the mesh.").sublist(any_name));
  declare_interaction(scene.sublist("Interactions", false, "One list for each adhesive surface.").sublist(any_name));
  histories().declare(
      scene.sublist("Histories", false, "Named functions of time for motions and loads.").sublist(any_name));
  add_condition(scene.sublist("Boundary Conditions", false, "One list for each prescribed motion and each load.")
                    .sublist(any_name));
  add_initial_conditions(scene.sublist("Initial Conditions", false, "Velocities at the initial time."));
  add_time_integrator(scene.sublist("Time Integrator", false, "Time integration scheme and its steps."));
  add_nonlinear_solver(scene.sublist("Nonlinear Solver", false, "Newton's method (NOX)."));
  mark_free_form(scene.sublist(
      "Linear Solver", false,
      "A Stratimikos list. Linear Solver Type is Automatic (the default: chosen by size, shape and step size), Direct, "
      "Belos or Amesos2. Preconditioner Type is None, Direct, MueLu, Ifpack2 or Chebyshev. Two entries are Ixos' own: "
      "Operator is Automatic, Assembled or Matrix-Free, and Reuse/Setup Cost is the cost of a new preconditioner in "
      "iterations of the linear solver."));
  add_output(scene.sublist("Output", false, "Results that a run writes."));
  return scene;
}

}  // namespace

const List& scene_parameters() {
  static const List parameters = make_scene_parameters();
  return parameters;
}

}  // namespace ixos
