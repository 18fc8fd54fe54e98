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
void require(List& list, const char* name, const char* documentation, const Teuchos::RCP<const RangeValidator>& range) {
  list.set(name, std::numeric_limits<double>::quiet_NaN(), documentation);
  list.getEntry(name).setValidator(range);
}

void add_units(List& list) {
  list.set("Length", "1 nm", "what L0 stands for; a name only, nothing is converted");
  list.set("Energy Density", "2 GPa", "what E0 stands for");
  list.set("Time", "1 ns", "what T0 stands for");
}

void add_spatula(List& list) {
  const SpatulaShape shape;
  list.set("Pad Length", shape.pad_length, "from rear end to tip [L0]", greater_than(0));
  list.set("Neck Width", shape.neck_width, "of the pad's rear end [L0]", greater_than(0));
  list.set("Tip Width", shape.tip_width, "largest width of the pad, at least Neck Width [L0]", greater_than(0));
  list.set("Widening Length", shape.widening_length,
           "the half-width grows as s^2 (3 - 2 s), s from 0 to 1 over this length from the rear end [L0]",
           greater_than(0));
  list.set("Tip Length", shape.tip_length,
           "the outline ends in half an ellipse, this long; at most Pad Length less Widening Length [L0]",
           greater_than(0));
  list.set("Rear Thickness", shape.rear_thickness, "of the pad, linear from rear end to tip [L0]", greater_than(0));
  list.set("Tip Thickness", shape.tip_thickness, "[L0]", greater_than(0));
  list.set("Transition Length", shape.transition_length,
           "along the centreline, from the pad's rectangle to the shaft's disk; at least the fillet [L0]",
           greater_than(0));
  list.set("Fillet Radius", shape.fillet_radius, "of the centreline, an arc tangent to pad and shaft [L0]",
           greater_than(0));
  list.set("Shaft Diameter", shape.shaft_diameter, "[L0]", greater_than(0));
  list.set("Shaft Length", shape.shaft_length, "beyond the transition [L0]", greater_than(0));
  list.set("Inclination", shape.inclination, "of the shaft to the pad [degrees]", greater_than_and_at_most(0, 90));
  list.set("Gap", shape.gap, "of the flat underside over the wall z = 0; the equilibrium gap [L0]", greater_than(0));
  list.set("Core Cells", shape.core_cells, "cells across a section's core; even", between(4, 1000));
  list.set("Core Layers", shape.core_layers, "layers of cells through the core", between(1, 100));
  list.set("Rings", shape.rings, "layers of cells around the core", between(1, 100));
  list.set("Tip Rows", shape.tip_rows, "rows of cells that turn around the tip; less than half of Core Cells",
           between(1, 499));
  list.set("Stations", shape.stations, "cells along; 0: chosen by Target Cells; else at least 3", between(0, 100000));
  list.set("Target Cells", shape.target_cells,
           "chooses Stations where that is 0, and below 50,000 fewer cells in a section than given",
           between(200, 20000000));
  list.set("Growth", shape.growth, "length of the shaft's cells over that of the pad's [-]", between(1, 100));
  list.set("Layer Ratio", shape.layer_ratio, "thickness of the pad's uppermost layer over the lowest's [-]",
           between(1, 100));
}

void add_mesh(List& list) {
  list.set("Type", "Disk", "a generator, or a file", one_of({"Disk", "Box", "Spatula", "Exodus"}));
  List& exodus = list.sublist("Exodus", false, "a mesh of QUAD4 (2D) or HEX8 (3D) elements");
  exodus.set("File", required, "path from the scene's folder, or from the working folder");
  exodus.set("Dimension", 0, "2 or 3 refuses a mesh of the other dimension; 0 takes any", between(0, 3));
  List& disk = list.sublist("Disk", false, "a disk of quadrilaterals on an O-grid: block \"body\", sets \"surface\"");
  disk.set("Diameter", 10.0, "[L0]", greater_than(0));
  disk.set("Center", Numbers(2, 0.0), "x and y of the centre [L0]", any_number());
  disk.set("Core Divisions", 4, "cells along a side of the square core; even", between(2, 10000));
  disk.set("Rings", 2, "layers of cells around the core", between(1, 10000));
  disk.set("Core Half Side", 0.4, "half side of the core over the radius [-]", greater_and_less_than(0, 0.7));
  List& box = list.sublist("Box", false,
                           "a box: block \"body\", sets \"left\", \"right\", \"bottom\", \"top\", in 3D \"front\" and "
                           "\"back\", and \"surface\"");
  box.set("Dimension", 2, "2: quadrilaterals in plane strain; 3: hexahedra", between(2, 3));
  box.set("Lower", Numbers(), "corner with the smallest coordinates [L0]; the origin when empty", any_number());
  box.set("Lengths", Numbers(2, 1.0), "edge lengths [L0]", greater_than(0));
  box.set("Divisions", Counts(2, 1), "cells along each edge", between(1, 100000));
  add_spatula(
      list.sublist("Spatula", false,
                   "a gecko's spatula of hexahedra: block \"body\", sets \"pad\" (its underside), \"shaft end\", "
                   "\"surface\", node set \"tip\""));
  List& set = list.sublist("Sets", false, "further sets, named by the scene, chosen by place").sublist(any_name);
  set.set("Kind", "Sides", "what the set holds", one_of({"Sides", "Nodes"}));
  set.set("From", "", "the set to choose from; of nodes, all where empty");
  set.set("Lower", Numbers(), "least coordinates of the region [L0]; no bound when empty", any_number());
  set.set("Upper", Numbers(), "largest coordinates of the region [L0]; no bound when empty", any_number());
}

void add_material(List& list) {
  list.set("Block", "body", "the block of cells that is made of this");
  list.set("Model", "Neo-Hooke", "elastic law", one_of({"Neo-Hooke", "Linear Elastic"}));
  list.set("Young's Modulus", 1.0, "E [E0]", greater_than(0));
  list.set("Poisson's Ratio", 0.2, "nu [-]", greater_and_less_than(-1, 0.5));
  list.set("Density", 5e-7, "rho [E0 T0^2/L0^2]; 5e-7 is 1000 kg/m^3 in the default units", greater_than(0));
  list.set("Mass Damping", 0.0, "Rayleigh's alpha_1 [1/T0]", at_least(0));
  list.set("Stiffness Damping", 0.0, "Rayleigh's alpha_2 [T0]; damps finite rigid rotations too", at_least(0));
  list.set("Quadrature Points", 2, "Gauss points a direction of elements that are not enriched", between(1, 10));
  list.set("Element Formulation", "Standard",
           "Mean Dilatation: against volumetric locking, forces and tangents 2 to 4 times dearer; Enhanced: against "
           "locking in bending too, not under strong compression, forces 5 to 40, tangents 3 to 10 times dearer, "
           "enriched elements stay Standard",
           one_of({"Standard", "Mean Dilatation", "Enhanced"}));
}

void add_interaction(List& list) {
  list.set("Law", "Van der Waals", "T(r) = c1/r^9 - c2/r^3", one_of({"Van der Waals"}));
  list.set("Side Set", required, "the surface that interacts");
  list.set("Gamma L", 2.5, "L0/r0 [-]", greater_than(0));
  list.set("Gamma W", 25.0, "E0/W0 [-]", greater_than(0));
  list.set("Contact Element", "Q1C1",
           "displacement along the side, in 3D in both directions: linear, of order 2, 3 or 4, or cubic Hermite with "
           "continuous slope (in 3D of faces in a regular grid)",
           one_of({"Q1C1", "Q1C2", "Q1C3", "Q1C4", "Q1CH"}));
  list.set(
      "Bulk Points", 0,
      "Gauss points along the side, in 3D in both directions, in the enriched elements; 0: order + 1, of Q1CH in 3D 5",
      between(0, 64));
  list.set("Surface Points", 0, "Gauss points a direction on each side; 0: 5, but 8 for Q1C3, Q1C4 and Q1CH",
           between(0, 64));
  list.set("Obstacle", "Half-Space", "what the surface interacts with: a rigid flat wall", one_of({"Half-Space"}));
  list.set("Point", Numbers(), "a point of the wall [L0]; the origin when empty", any_number());
  list.set("Normal", Numbers(), "out of the wall; the last axis when empty", any_number());
  list.set("Cutoff", 0.0,
           "gap beyond which the interaction is left out [L0]; the traction is off by at most its value there; 0: none",
           at_least(0));
  list.set("Step Margin", 0.8, "kappa: a Newton step keeps every gap r at least kappa min(r, equilibrium gap) [-]",
           greater_and_less_than(0, 1));
}

Teuchos::RCP<const Teuchos::ParameterEntryValidator> ramp_shapes() { return one_of({"Linear", "Cosine", "Quintic"}); }

void add_history(List& list) {
  list.set("Type", "Constant", "the kind of function",
           one_of({"Constant", "Ramp", "Rate Ramp", "Sine", "Table", "Expression"}));
  list.sublist("Constant", false, "one value at all times")
      .set("Value", 1.0, "a motion's in L0, a load's a factor of its Vector", any_number());
  List& ramp = list.sublist("Ramp", false, "from 0 to Value, then constant");
  require(ramp, "Value", "reached at Start + Length; a motion's in L0, a load's a factor of its Vector", any_number());
  ramp.set("Start", 0.0, "[T0]", any_number());
  require(ramp, "Length", "[T0]; a motion needs more than 0", at_least(0));
  ramp.set("Shape", "Quintic", "Cosine has a continuous rate, Quintic a continuous acceleration too", ramp_shapes());
  List& rate = list.sublist("Rate Ramp", false,
                            "the rate goes from 0 to Rate, then stays; the value is its integral, 0 until Start");
  require(rate, "Rate", "reached at Start + Length [1/T0]", any_number());
  rate.set("Start", 0.0, "[T0]", any_number());
  require(rate, "Length", "[T0]; a motion needs more than 0", at_least(0));
  rate.set("Shape", "Cosine", "of the rate", ramp_shapes());
  List& sine = list.sublist("Sine", false, "Offset + Amplitude sin(2 pi Frequency t + Phase)");
  sine.set("Offset", 0.0, "as Amplitude", any_number());
  sine.set("Amplitude", 1.0, "a motion's in L0, a load's a factor of its Vector", any_number());
  require(sine, "Frequency", "cycles per T0", greater_than(0));
  sine.set("Phase", 0.0, "[rad]", any_number());
  List& table = list.sublist("Table", false, "quintic interpolation, twice continuously differentiable");
  table.set("Times", Numbers(), "strictly increasing, over the whole run [T0]", any_number());
  table.set("Values", Numbers(), "as many as Times; a motion's in L0, a load's a factor of its Vector", any_number());
  List& formula = list.sublist("Expression", false, "muParser expressions in the time t");
  formula.set("Value", required, "a motion's in L0, a load's a factor of its Vector");
  formula.set("Velocity", "", "derivative of Value; a motion needs it, and it is checked by quadrature");
  formula.set("Acceleration", "", "derivative of Velocity; a motion needs it");
}

void add_condition(List& list) {
  list.set("Type", "Displacement", "prescribed displacement, force per reference length or area, per volume, per node",
           one_of({"Displacement", "Traction", "Body Force", "Point Force"}));
  list.set("Node Set", "", "of a Displacement or a Point Force (on each of its nodes)");
  list.set("Side Set", "", "of a Traction");
  list.set("Block", "", "of a Body Force; the whole body when empty");
  list.set("Components", "all", "the directions of a Displacement",
           one_of({"x", "y", "z", "xy", "xz", "yz", "xyz", "all"}));
  list.set("Vector", Numbers(),
           "of a load, for a history of 1: E0 (Traction), E0/L0 (Body Force), E0 L0^(D-1) (Point Force)", any_number());
  list.set("History", "",
           "its course in time, a list of Histories; when empty a Displacement is held, a load constant");
}

void add_initial_conditions(List& list) {
  list.set("Velocity", Numbers(), "uniform part [L0/T0]; zero when empty", any_number());
  list.set("Velocity Gradient", Numbers(),
           "L, row by row [1/T0]: v = Velocity + L (X - Origin); skew-symmetric for a spin; zero when empty",
           any_number());
  list.set("Origin", Numbers(), "[L0]; the origin of coordinates when empty", any_number());
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
  list.set("Type", default_scheme(), "the scheme; the driver lists what each is good for", one_of(names));
  list.set("Predictor", "Automatic", "where Newton's iteration starts; \"Automatic\" is the scheme's own choice",
           one_of({"Automatic", "Last Displacement", "Constant Velocity", "Constant Acceleration", "Newmark",
                   "Extrapolation"}));
  List& control = list.sublist("Time Step Control", false, "times and steps");
  control.set("Type", "Fixed", "how the step is chosen; Adaptive judges every step", one_of({"Fixed", "Adaptive"}));
  control.set("Initial Time", 0.0, "[T0]", any_number());
  require(control, "Final Time", "[T0]; later than Initial Time", any_number());
  require(control, "Time Step",
          "[T0]; Adaptive: the first; steps are shortened to end at Final Time and at the time intervals of Output",
          greater_than(0));
  control.set("Maximum Cuts", 0,
              "how often Time Step may be halved where a step fails; 0 ends the run; Adaptive runs need none",
              between(0, 60));
  control.set("Minimum Time Step", 0.0, "neither a cut nor an adaptive step goes below [T0]", at_least(0));
  List& adaptive = control.sublist("Adaptive", false, "a step that exceeds what is asked is done again, shorter");
  adaptive.set("Tolerance", 0.0, "largest local error of a displacement in a step [L0]; 0: not judged", at_least(0));
  adaptive.set("Maximum Gap Ratio", 0.0,
               "largest ratio of the gaps of a point of the surface at both ends of a step [-]; 0: not judged",
               at_least(0));
  adaptive.set("Choose Time Points", false,
               "take 5, 8 or 16 points in time for the interaction as the gap ratio of the step demands");
  adaptive.set("Safety", 0.9, "share of the length that the judgement allows [-]", greater_and_less_than(0, 1));
  adaptive.set("Largest Growth", 2.0, "of the length from step to step [-]", greater_than(1));
  adaptive.set("Maximum Time Step", 0.0, "[T0]; 0: none", at_least(0));
  List& stop =
      list.sublist("Stop", false, "ends of the run before Final Time; the first that holds counts").sublist(any_name);
  stop.set("Type", "Probe", "a probe's value, or no contact after there was some", one_of({"Probe", "Detached"}));
  List& probe = stop.sublist("Probe", false, "a probe of Output/Probes");
  probe.set("Name", required, "the probe");
  probe.set("Quantity", "y", "place, displacement or velocity of the probe",
            one_of({"x", "y", "z", "ux", "uy", "uz", "vx", "vy", "vz"}));
  probe.set("Side", "Above", "on which side of the limit the run ends", one_of({"Above", "Below"}));
  require(probe, "Limit", "in the quantity's unit", any_number());
}

void add_nonlinear_solver(List& list) {
  list.set("Tolerance", 1e-11, "|f| over the largest of |M a|, |f_el|, |f_c|, |f_ext| [-]",
           greater_and_less_than(0, 1));
  list.set("Linear Tolerance", 0.0,
           "relative residual of iterative linear solves; 0: Eisenstat and Walker's forcing terms, at most 1e-3 [-]",
           at_least(0));
  list.set("Maximum Iterations", 100, "more is a failed step", between(1, 10000));
  List& nox = list.sublist(
      "NOX", false,
      "overrides of NOX's own lists: Printing, Direction, Line Search, ...; another Line Search loses the admissible "
      "step, another Direction the relaxed tangents");
  mark_free_form(nox);
}

void add_output(List& list) {
  list.set("History Interval", 1, "steps between rows of history.csv; the last state is always a row",
           between(1, 1000000000));
  list.set("Fields Interval", 0, "steps between frames of fields.e; 0 writes none", between(0, 1000000000));
  list.set("Fields Format", "Exodus",
           "of fields.e: Exodus, a file for each rank, or HDF5, one that all write together (Exodus on HDF5)",
           one_of({"Exodus", "HDF5"}));
  list.set("History Time Interval", 0.0, "time between rows [T0], in place of History Interval; 0: off", at_least(0));
  list.set("Fields Time Interval", 0.0, "time between frames [T0], in place of Fields Interval; 0: off", at_least(0));
  List& checkpoint =
      list.sublist("Checkpoint", false, "what a run can be restarted from; one at its end and at signals too");
  checkpoint.set("Interval", 0, "steps between checkpoints; 0: the clock alone decides", between(0, 1000000000));
  checkpoint.set("Wall-Clock Interval", 600.0, "seconds between checkpoints; 0: steps alone decide", at_least(0));
  checkpoint.set("Keep", 2, "how many of the last ones are kept; 0 writes none", between(0, 1000));
  list.set("Energies", true, "energy columns");
  list.set("Momenta", true, "momentum columns");
  list.set("Interaction", true, "contact force, contact measure and least gap");
  list.set("Reactions", Teuchos::Array<std::string>(), "node sets whose reactions become columns");
  List& probe =
      list.sublist("Probes", false, "named points whose displacement and velocity become columns").sublist(any_name);
  probe.set("Point", Numbers(), "place in the reference configuration [L0]", any_number());
}

List make_scene_parameters() {
  List scene("Scene");
  add_units(scene.sublist("Units", false, "names of the units; every value of a scene is in L0, E0 and T0"));
  add_mesh(scene.sublist("Mesh", false, "the bodies"));
  add_material(scene.sublist("Materials", false, "a list for each block").sublist(any_name));
  add_interaction(scene.sublist("Interactions", false, "a list for each surface that sticks").sublist(any_name));
  add_history(scene.sublist("Histories", false, "named functions of time, for motions and loads").sublist(any_name));
  add_condition(
      scene.sublist("Boundary Conditions", false, "a list for each prescribed motion and each load").sublist(any_name));
  add_initial_conditions(scene.sublist("Initial Conditions", false, "velocities at the initial time"));
  add_time_integrator(scene.sublist("Time Integrator", false, "the scheme and its steps"));
  add_nonlinear_solver(scene.sublist("Nonlinear Solver", false, "Newton's method (NOX)"));
  mark_free_form(scene.sublist("Linear Solver", false,
                               "a Stratimikos list; Linear Solver Type is Automatic (default: chosen by size, shape "
                               "and step), Direct, Belos or Amesos2; Preconditioner Type None, Direct, MueLu, Ifpack2 "
                               "or Chebyshev"));
  add_output(scene.sublist("Output", false, "what is written"));
  return scene;
}

}  // namespace

const List& scene_parameters() {
  static const List parameters = make_scene_parameters();
  return parameters;
}

}  // namespace ixos
