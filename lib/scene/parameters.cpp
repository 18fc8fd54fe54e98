#include "scene/parameters.hpp"

#include <Teuchos_Array.hpp>
#include <limits>

#include "base/one_of.hpp"
#include "base/range_validator.hpp"
#include "mesh/spatula.hpp"
#include "scene/validation.hpp"
#include "time/catalogue.hpp"

namespace ixos {
namespace {

using List = Teuchos::ParameterList;
using Numbers = Teuchos::Array<double>;
using Counts = Teuchos::Array<int>;

/// A number without a default. The validator comes after the value: NaN marks it as missing and is not in its range.
void require(List& list, const char* name, const std::string& documentation,
             const Teuchos::RCP<const RangeValidator>& range) {
  list.set(name, std::numeric_limits<double>::quiet_NaN(), documentation);
  list.getEntry(name).setValidator(range);
}

/// Documentation of a history's values, whose unit depends on its use.
std::string history_value(const std::string& what) {
  return what + " A motion is in L0; a load is its Vector times this number.";
}

void add_units(List& list) {
  list.set("Length", "1 nm", "Name of the unit of length, L0. It is a label only: nothing is converted.");
  list.set("Energy Density", "2 GPa", "Name of the unit of energy density and stress, E0.");
  list.set("Time", "1 ns", "Name of the unit of time, T0.");
}

void add_spatula_lengths(List& list) {
  const SpatulaShape shape;
  list.set("Pad Length", shape.pad_length, "Length of the pad from its rear end to its tip [L0].", greater_than(0));
  list.set("Neck Width", shape.neck_width, "Width of the pad at its rear end [L0].", greater_than(0));
  list.set("Tip Width", shape.tip_width, "Largest width of the pad [L0]. It must be at least Neck Width.",
           greater_than(0));
  list.set("Widening Length", shape.widening_length,
           "Length over which the pad widens, from its rear end [L0]. The half-width grows as s^2 (3 - 2 s), with s "
           "from 0 to 1.",
           greater_than(0));
  list.set("Tip Length", shape.tip_length,
           "Length of the half ellipse that ends the outline [L0]. It must be at most Pad Length minus Widening "
           "Length.",
           greater_than(0));
  list.set("Rear Thickness", shape.rear_thickness,
           "Thickness of the pad at its rear end [L0]. It varies linearly from there to the tip.", greater_than(0));
  list.set("Tip Thickness", shape.tip_thickness, "Thickness of the pad at its tip [L0].", greater_than(0));
  list.set("Transition Length", shape.transition_length,
           "Length, along the centreline, of the transition from the pad's rectangular section to the shaft's disk "
           "[L0]. It must be at least the arc length of the fillet.",
           greater_than(0));
  list.set("Fillet Radius", shape.fillet_radius,
           "Radius of the arc of the centreline that is tangent to pad and shaft [L0]. It must be greater than half "
           "of Shaft Diameter and half of Rear Thickness.",
           greater_than(0));
  list.set("Shaft Diameter", shape.shaft_diameter, "Diameter of the shaft [L0].", greater_than(0));
  list.set("Shaft Length", shape.shaft_length, "Length of the shaft beyond the transition [L0].", greater_than(0));
  list.set("Inclination", shape.inclination, "Angle between shaft and pad [degrees].", greater_than_and_at_most(0, 90));
  list.set("Gap", shape.gap,
           "Distance from the wall z = 0 to the flat underside of the pad [L0]. The default is the equilibrium gap of "
           "the default interaction.",
           greater_than(0));
}

void add_spatula_divisions(List& list) {
  const SpatulaShape shape;
  list.set("Core Cells", shape.core_cells, "Number of cells across the core of a cross-section. It must be even.",
           between(4, 1000));
  list.set("Core Layers", shape.core_layers, "Number of layers of cells through the core.", between(1, 100));
  list.set("Rings", shape.rings, "Number of layers of cells around the core.", between(1, 100));
  list.set("Tip Rows", shape.tip_rows,
           "Number of rows of cells that turn around the tip. It must be less than half of Core Cells.",
           between(1, 499));
  list.set("Stations", shape.stations,
           "Number of cells along the centreline, at least 3. With 0, Target Cells determines it.", between(0, 100000));
  list.set("Target Cells", shape.target_cells,
           "Approximate number of cells of the mesh, used if Stations is 0. Below 50,000 the cross-sections get fewer "
           "cells than given above.",
           between(200, 20000000));
  list.set("Growth", shape.growth, "Ratio of the cell length in the shaft to that in the pad [-].", between(1, 100));
  list.set("Layer Ratio", shape.layer_ratio,
           "Ratio of the thickness of the pad's uppermost layer of cells to that of its lowest [-].", between(1, 100));
}

void add_mesh(List& list) {
  list.set("Type", "Disk", "Selects a mesh generator, or a mesh file (Exodus).",
           one_of({"Disk", "Box", "Spatula", "Exodus"}));
  List& exodus = list.sublist("Exodus", false, "A mesh of QUAD4 (2D) or HEX8 (3D) elements, read from an Exodus file.");
  exodus.set("File", required, "Path of the mesh file, relative to the scene's folder or to the working folder.");
  exodus.set("Dimension", 0, "Dimension that the mesh must have: 2 or 3. With 0, both are accepted.", between(0, 3));
  List& disk = list.sublist("Disk", false,
                            "A disk of quadrilaterals, meshed as an O-grid. It has the block \"body\", the side and "
                            "node set \"surface\", and the node set \"center\".");
  disk.set("Diameter", 10.0, "Diameter of the disk [L0].", greater_than(0));
  disk.set("Center", Numbers(2, 0.0), "Coordinates x and y of the centre [L0].", any_number());
  disk.set("Core Divisions", 4, "Number of cells along a side of the square core. It must be even.", between(2, 10000));
  disk.set("Rings", 2, "Number of layers of cells around the core.", between(1, 10000));
  disk.set("Core Half Side", 0.4, "Half the side length of the core, divided by the radius of the disk [-].",
           greater_and_less_than(0, 0.7));
  List& box = list.sublist("Box", false,
                           "A box. It has the block \"body\" and the side and node sets \"left\", \"right\", "
                           "\"bottom\", \"top\" and \"surface\"; in 3D also \"front\" and \"back\".");
  box.set("Dimension", 2, "Dimension of the box. 2: quadrilaterals in plane strain; 3: hexahedra.", between(2, 3));
  box.set("Lower", Numbers(), "Corner with the smallest coordinates [L0]. If empty, it is the origin.", any_number());
  box.set("Lengths", Numbers(2, 1.0), "Edge lengths [L0].", greater_than(0));
  box.set("Divisions", Counts(2, 1), "Number of cells along each edge.", between(1, 100000));
  List& spatula = list.sublist("Spatula", false,
                               "A gecko's spatula of hexahedra. It has the block \"body\", the side and node sets "
                               "\"pad\" (its underside), \"shaft end\" and \"surface\", and the node set \"tip\".");
  add_spatula_lengths(spatula);
  add_spatula_divisions(spatula);
  List& set = list.sublist("Sets", false, "Additional sets, selected by region. The scene chooses their names.")
                  .sublist(any_name);
  set.set("Kind", "Sides", "Kind of set: sides of elements, or nodes.", one_of({"Sides", "Nodes"}));
  set.set("From", "", "Set to select from. Sides need one; if it is empty, nodes are selected from the whole mesh.");
  set.set("Lower", Numbers(), "Smallest coordinates of the region [L0]. If empty, there is no bound.", any_number());
  set.set("Upper", Numbers(), "Largest coordinates of the region [L0]. If empty, there is no bound.", any_number());
}

void add_material(List& list) {
  list.set("Block", "body", "Name of the block of cells that consists of this material.");
  list.set("Model", "Neo-Hooke", "Elastic law.", one_of({"Neo-Hooke", "Linear Elastic"}));
  list.set("Young's Modulus", 1.0, "Young's modulus E [E0].", greater_than(0));
  list.set("Poisson's Ratio", 0.2, "Poisson's ratio nu [-].", greater_and_less_than(-1, 0.5));
  list.set("Density", 5e-7, "Mass density rho [E0 T0^2/L0^2]. In the default units, 5e-7 corresponds to 1000 kg/m^3.",
           greater_than(0));
  list.set("Mass Damping", 0.0, "Rayleigh damping: the coefficient alpha_1 of the mass matrix [1/T0].", at_least(0));
  list.set("Stiffness Damping", 0.0,
           "Rayleigh damping: the coefficient alpha_2 of the stiffness matrix [T0]. It also damps finite rigid "
           "rotations.",
           at_least(0));
  list.set("Quadrature Points", 2, "Number of Gauss points per direction in elements that are not enriched.",
           between(1, 10));
  list.set("Element Formulation", "Standard",
           "Element type. Mean Dilatation avoids volumetric locking; its forces and tangents cost 2 to 4 times as much "
           "as those of Standard. Enhanced also avoids locking in bending; its forces cost 5 to 40 times and its "
           "tangents 3 to 10 times as much. Enhanced is not suitable for strong compression, and enriched contact "
           "elements stay Standard.",
           one_of({"Standard", "Mean Dilatation", "Enhanced"}));
}

void add_interaction(List& list) {
  list.set("Law", "Van der Waals",
           "Interaction law. Van der Waals integrates the Lennard-Jones potential over the half-space: at a gap r the "
           "traction is T(r) = c1/r^9 - c2/r^3.",
           one_of({"Van der Waals"}));
  list.set("Side Set", required, "Side set of the surface that interacts.");
  list.set("Gamma L", 2.5, "Ratio L0/r0, where r0 is the length scale of the law [-].", greater_than(0));
  list.set("Gamma W", 25.0, "Ratio E0/W0, where W0 is the energy density scale of the law [-].", greater_than(0));
  list.set("Contact Element", "Q1C1",
           "Interpolation of the displacement along the contact side, in 3D in both directions of the face. Q1C1 is "
           "linear; Q1C2, Q1C3 and Q1C4 have order 2, 3 and 4; Q1CH is cubic Hermite with continuous slope. In 3D, "
           "Q1CH needs faces in a regular grid.",
           one_of({"Q1C1", "Q1C2", "Q1C3", "Q1C4", "Q1CH"}));
  list.set("Bulk Points", 0,
           "Number of Gauss points along the contact side in the enriched elements, in 3D in both directions of the "
           "face. With 0 it is the order + 1, or 5 for Q1CH in 3D.",
           between(0, 64));
  list.set("Surface Points", 0,
           "Number of Gauss points per direction on each side of the surface. With 0 it is 5, or 8 for Q1C3, Q1C4 and "
           "Q1CH.",
           between(0, 64));
  list.set("Obstacle", "Half-Space", "Obstacle that the surface interacts with. Half-Space is a rigid flat wall.",
           one_of({"Half-Space"}));
  list.set("Point", Numbers(), "A point on the surface of the wall [L0]. If empty, it is the origin.", any_number());
  list.set("Normal", Numbers(), "Vector that points out of the wall. If empty, it points along the last axis.",
           any_number());
  list.set("Cutoff", 0.0,
           "Gap beyond which the interaction is neglected [L0]. The error of the traction is at most the traction at "
           "this gap. 0: no cutoff.",
           at_least(0));
  list.set("Step Margin", 0.8,
           "Factor kappa that limits a Newton step: it keeps every gap r at least kappa min(r, equilibrium gap) [-].",
           greater_and_less_than(0, 1));
}

Teuchos::RCP<const Teuchos::ParameterEntryValidator> ramp_shapes() { return one_of({"Linear", "Cosine", "Quintic"}); }

void add_ramps(List& list) {
  List& ramp = list.sublist("Ramp", false, "Rises from 0 to Value, then stays constant.");
  require(ramp, "Value", history_value("Value reached at Start + Length."), any_number());
  ramp.set("Start", 0.0, "Time at which the ramp starts [T0].", any_number());
  require(ramp, "Length", "Duration of the ramp [T0]. For a motion it must be greater than 0.", at_least(0));
  ramp.set("Shape", "Quintic",
           "Shape of the ramp. Cosine has a continuous rate, Quintic also a continuous acceleration.", ramp_shapes());
  List& rate = list.sublist("Rate Ramp", false,
                            "The rate rises from 0 to Rate, then stays constant. The value is the integral of the "
                            "rate, 0 until Start.");
  require(rate, "Rate", "Rate reached at Start + Length [1/T0; L0/T0 for a motion].", any_number());
  rate.set("Start", 0.0, "Time at which the ramp of the rate starts [T0].", any_number());
  require(rate, "Length", "Duration of the ramp of the rate [T0]. For a motion it must be greater than 0.",
          at_least(0));
  rate.set("Shape", "Cosine", "Shape of the ramp of the rate.", ramp_shapes());
}

void add_history(List& list) {
  list.set("Type", "Constant", "Kind of function.",
           one_of({"Constant", "Ramp", "Rate Ramp", "Sine", "Table", "Expression"}));
  list.sublist("Constant", false, "The same value at all times.")
      .set("Value", 1.0, history_value("Value of the function."), any_number());
  add_ramps(list);
  List& sine = list.sublist("Sine", false, "Offset + Amplitude sin(2 pi Frequency t + Phase).");
  sine.set("Offset", 0.0, history_value("Mean value."), any_number());
  sine.set("Amplitude", 1.0, history_value("Amplitude."), any_number());
  require(sine, "Frequency", "Number of cycles per T0.", greater_than(0));
  sine.set("Phase", 0.0, "Phase [rad].", any_number());
  List& table = list.sublist("Table", false, "Quintic interpolation of a table, twice continuously differentiable.");
  table.set("Times", Numbers(), "Times of the table [T0]. They must increase strictly and cover the whole run.",
            any_number());
  table.set("Values", Numbers(), history_value("Values of the table, one for each of Times."), any_number());
  List& formula = list.sublist("Expression", false, "muParser expressions in the time t.");
  formula.set("Value", required, history_value("Expression of the value."));
  formula.set("Velocity", "",
              "Expression of the first derivative of Value. A motion needs it; Ixos verifies it by quadrature.");
  formula.set("Acceleration", "",
              "Expression of the first derivative of Velocity. A motion needs it; Ixos verifies it by quadrature.");
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
              one_of({"Fixed", "Adaptive"}));
  control.set("Initial Time", 0.0, "Time at which the run starts [T0].", any_number());
  require(control, "Final Time", "Time at which the run ends [T0]. It must be later than Initial Time.", any_number());
  require(control, "Time Step",
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
               "Largest ratio between the gaps that a point of the surface has at the two ends of a step [-]. It must "
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
           one_of({"Probe", "Detached"}));
  List& probe = stop.sublist("Probe", false, "A limit on a probe.");
  probe.set("Name", required, "Name of a probe in Output/Probes.");
  probe.set("Quantity", "y", "Coordinate (x), displacement (ux) or velocity (vx) of the probe.",
            one_of({"x", "y", "z", "ux", "uy", "uz", "vx", "vy", "vz"}));
  probe.set("Side", "Above", "Side of the limit on which the run ends.", one_of({"Above", "Below"}));
  require(probe, "Limit", "Limit of the quantity, in its unit [L0 or L0/T0].", any_number());
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
           one_of(names));
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
  add_material(scene.sublist("Materials", false, "One list for each block of the mesh.").sublist(any_name));
  add_interaction(scene.sublist("Interactions", false, "One list for each adhesive surface.").sublist(any_name));
  add_history(scene.sublist("Histories", false, "Named functions of time for motions and loads.").sublist(any_name));
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
