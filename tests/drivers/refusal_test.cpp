// What the driver refuses: every bad input gets one clear message and leaves nothing half-written.
#include "drivers/driver_test.hpp"

namespace ixos::test {
namespace {

class DriverRefusalTest : public DriverTest {
 protected:
  void expect_refused_setting(const std::string& assignment, const std::string& message) {
    expect_refused(2, {ball, "--output", "out", "--set", assignment}, message);
  }
  /// Several settings of a scene.
  void expect_refused_settings(const std::string& scene, const std::vector<std::string>& assignments,
                               const std::string& message) {
    std::vector<std::string> arguments{scene, "--output", "out"};
    for (const std::string& assignment : assignments) arguments.insert(arguments.end(), {"--set", assignment});
    expect_refused(2, arguments, message);
  }
};

TEST_F(DriverRefusalTest, BadValuesAreRefused) {
  expect_refused_setting("Materials/Ball/Density=-5e-7",
                         "Materials/Ball/Density: -5e-07 is not allowed: it must be greater than 0");
  expect_refused_setting("Materials/Ball/Poisson's Ratio=0.5",
                         "0.5 is not allowed: it must be greater than -1 and less than 0.5");
  expect_refused_setting("Time Integrator/Time Step Control/Time Step=0",
                         "Time Step: 0 is not allowed: it must be greater than 0");
  expect_refused_setting("Time Integrator/Time Step Control/Time Step=nan",
                         "Time Integrator/Time Step Control/Time Step: nan is not allowed");
  expect_refused_setting("Time Integrator/Time Step Control/Initial Time=-1e20", "is lost in rounding");
  expect_refused_setting("Interactions/Wall/Gamma L=1e-40", "Gamma L and Gamma W are too extreme");
  expect_refused_setting("Nonlinear Solver/NOX/Direction/Method=Foo", "Nonlinear Solver/NOX: NOX refuses the list");
  expect_refused_setting("Nonlinear Solver/NOX/Nonlinear Solver=1", "Nonlinear Solver/NOX: NOX refuses the list");
  expect_refused_setting("Nonlinear Solver/NOX/Lien Search/Method=Foo", "did you mean \"Line Search\"?");
  expect_refused_setting("Linear Solver/Linear Solver Type=1", "Linear Solver/Linear Solver Type: must be a string");
  expect_refused_setting("Materials/Bal/Density=5e-7", "block \"body\" has two materials");
  expect_refused_setting("Linear Solver/Reuse/Cost=1.0", "allowed: \"Setup Cost\"");
  expect_refused_setting("Linear Solver/Reuse/Setup Cost=-0.5", "Setup Cost: it must be a number of at least 0");
  expect_refused_setting("Linear Solver/Reuse/Setup Cost=much", "Setup Cost: it must be a number of at least 0");
  expect_refused_setting("Time Integrator/Time Step Control/Final Time=-1", "-1 must be later than Initial Time, 0");
  expect_refused_setting("Materials/Ball/Young's Modulus=inf", "inf is not allowed");
  expect_refused_setting("Mesh/Disk/Center={0, nan}", "Mesh/Disk/Center: nan is not allowed");
  expect_refused_setting("Mesh/Disk/Center={0}", "Mesh/Disk/Center has 1 elements, not 2");
  expect_refused_setting("Interactions/Wall/Normal={0, 0}", "Interactions/Wall/Normal is zero");
  expect_refused_setting("Interactions/Wall/Factor=x + t",
                         "Interactions/Wall/Factor: the factor \"x + t\" is not an expression in x, y, z");
  expect_refused_setting("Interactions/Wall/Factor=-1", "Interactions/Wall: the factor at (");
  expect_refused_setting("Linear Solver/Linear Solver Type=Belso",
                         "Linear Solver/Linear Solver Type: \"Belso\" does not exist; did you mean \"Belos\"?");
  expect_refused_setting("Linear Solver/Preconditioner Type=Foo", "\"Foo\" does not exist");
  expect_refused_setting("Linear Solver/Linear Solver Types=foo", "Linear Solver: ");
  expect_refused_setting("Linear Solver/Linear Solver Types/Direct/Solver Type=Nonsense",
                         "Linear Solver: Stratimikos refuses the list");
}

TEST_F(DriverRefusalTest, BadUnitsAreRefused) {
  expect_refused_setting(
      "Materials/Ball/Density=1000 kg/m^2",
      "ball.xml: Materials/Ball/Density: \"1000 kg/m^2\" is a mass per area; a density is needed, as "
      "in \"1000 kg/m^3\"");
  expect_refused_setting("Materials/Ball/Young's Modulus=2 mpa",
                         "--set Materials/Ball/Young's Modulus: \"2 mpa\": unit \"mpa\" does not exist; did you mean "
                         "\"MPa\"?");
  expect_refused_setting("Units/Energy Density=2 m", "Units/Energy Density: \"2 m\" is a length; a stress or energy");
  expect_refused_setting("Interactions/Wall/Hamaker Constant=1e-19 J",
                         "\"Hamaker Constant\" belongs to Constants \"Hamaker\", but Constants is \"Ratios\"");
}

TEST_F(DriverRefusalTest, SolversForSymmetricMatricesAreRefusedForUnsymmetricTangents) {
  const auto refused = [&](const std::string& solver, const std::string& message) {
    expect_refused(2,
                   {ball, "--output", "out", "--set", "Time Integrator/Type=Energy-Momentum", "--set",
                    "Linear Solver/Linear Solver Type=" + solver.substr(0, solver.find('/')), "--set",
                    "Linear Solver/Linear Solver Types/" + solver},
                   message);
  };
  refused("Direct/Solver Type=MUMPS", "Direct/Solver Type: \"MUMPS\" needs a symmetric matrix");
  refused("Belos/Solver Type=Pseudo Block CG", "tangent is not symmetric; use \"Pseudo Block GMRES\"");
}

TEST_F(DriverRefusalTest, BadStepControlAndCutoffsAreRefused) {
  const auto refused = [&](const std::vector<std::string>& assignments, const std::string& message) {
    expect_refused_settings(ball, assignments, message);
  };
  const std::string control = "Time Integrator/Time Step Control/", adaptive = control + "Type=Adaptive",
                    list = control + "Adaptive/";
  refused({control + "Type=Adaptve"}, "did you mean \"Adaptive\"?");
  refused({adaptive}, "neither Tolerance nor Maximum Gap Ratio is given");
  refused({adaptive, list + "Tolerance=-1"}, "-1 is not allowed: it must be at least 0");
  refused({adaptive, list + "Maximum Gap Ratio=0.5"}, "Maximum Gap Ratio: 0.5 must be greater than 1, or 0");
  refused({adaptive, list + "Tolerance=1e-3", "Time Integrator/Type=Static"}, "has no estimate of its local error");
  refused({adaptive, list + "Tolerance=1e-3", list + "Choose Time Points=true", "Time Integrator/Type=Newmark"},
          "has no Gauss points in time for the interaction");
  refused({adaptive, list + "Maximum Gap Ratio=2", "Interactions/Wall/Law=Morse"},
          "Maximum Gap Ratio: 2 has no effect: Interactions/Wall/Law \"Morse\" is defined at every gap");
  refused({"Interactions/Wall/Cutoff=0.1"}, "Cutoff: 0.1 cuts off the attraction");
  refused({"Time Integrator/Type=Central Difference", "Interactions/Wall/Contact Element=Q1CH"}, "has no lumped mass");
  refused({"Time Integrator/Type=Central Difference", "Time Integrator/Central Difference/Safety=1.5"},
          "1.5 is not allowed: it must be greater than 0 and at most 1");
}

TEST_F(DriverRefusalTest, BadMotionsLoadsAndElementsAreRefused) {
  const auto refused = [&](std::vector<std::string> assignments, const std::string& message) {
    assignments.emplace_back("Mesh/Box/Divisions={40, 2}");
    expect_refused_settings(strip, assignments, message);
  };
  const std::string formula = "Histories/Pull/Type=Expression";
  const std::string value = "Histories/Pull/Expression/Value=", rate = "Histories/Pull/Expression/Velocity=",
                    acceleration = "Histories/Pull/Expression/Acceleration=";
  refused({formula, value + "2*s"}, "Histories/Pull/Expression: the value \"2*s\" is not an expression in t");
  refused({formula, value + "sin(t", rate + "0", acceleration + "0"}, "is not an expression in t");
  refused({formula, value + "1/(t-1)", rate + "-1/(t-1)^2", acceleration + "2/(t-1)^3"}, "not finite at t = 1");
  refused({formula, value + "t^2", rate + "t", acceleration + "1"}, "the rate is not the derivative of the value");
  refused({formula, value + "t^2"}, "Histories/Pull");
  const std::string table = "Histories/Pull/Type=Table";
  refused({table, "Histories/Pull/Table/Times={0, 2, 1}", "Histories/Pull/Table/Values={0, 1, 2}"},
          "Histories/Pull/Table: ");
  refused({table, "Histories/Pull/Table/Times={0, 2}", "Histories/Pull/Table/Values={0, 1, 2}"},
          "Histories/Pull/Table: ");
  refused({table, "Histories/Pull/Table/Times={0, 2, 5}", "Histories/Pull/Table/Values={0, 1, 2}"},
          "the table covers the times 0 to 5, but the run goes from 0 to 160");
  const std::string ramp = "Histories/Pull/Type=Ramp";
  refused({ramp, "Histories/Pull/Ramp/Value=1", "Histories/Pull/Ramp/Length=20", "Histories/Pull/Ramp/Shape=Linear"},
          "Histories/Pull: Shape Linear cannot drive a motion of a dynamic scheme: its rate jumps at the time 20, ");
  refused(
      {"Histories/Pull/Rate Ramp/Start=2", "Histories/Pull/Rate Ramp/Length=0"},
      "Histories/Pull: a ramp of Length 0 cannot drive a motion of a dynamic scheme: its rate jumps at the time 2, ");
  for (const std::string interpolation : {"Linear", "Step"})
    refused({table, "Histories/Pull/Table/Times={0, 80, 160}", "Histories/Pull/Table/Values={0, 1, 3}",
             "Histories/Pull/Table/Interpolation=" + interpolation},
            "Histories/Pull: Interpolation " + interpolation + " cannot drive a motion of a dynamic scheme: ");
  refused({"Histories/Pull/Rate Ramp/Length=-1"}, "must be at least 0");
  refused({"Boundary Conditions/Pull/History=Pul"}, "history \"Pul\" does not exist; did you mean \"Pull\"?");
  refused({"Boundary Conditions/Guide/History=Pull", "Boundary Conditions/Guide/Components=xy",
           "Boundary Conditions/Pull/History="},
          "prescribe different motions for one degree of freedom");
  refused({"Boundary Conditions/Other/Node Set=right", "Boundary Conditions/Other/Components=y"},
          "Boundary Conditions/Other: two conditions prescribe different motions");
  refused({"Boundary Conditions/Guide/Vector={1, 0}"},
          "Boundary Conditions/Guide/Vector: a Displacement has no Vector");
  refused({"Boundary Conditions/Wind/Type=Traction"}, "Boundary Conditions/Wind/Side Set is missing");
  refused({"Boundary Conditions/Wind/Type=Traction", "Boundary Conditions/Wind/Side Set=top"},
          "Boundary Conditions/Wind/Vector is missing");
  refused({"Boundary Conditions/Weight/Type=Body Force", "Boundary Conditions/Weight/Vector={0, -1}",
           "Boundary Conditions/Weight/Block=bodi"},
          "did you mean \"body\"?");
  refused({"Output/Probes/P/Point={0, 0}"}, "Output/Probes/P/Point: the point (0, 0) lies outside the body");
  refused({"Output/Probes/P/Point={0}"}, "Output/Probes/P/Point has 1 elements, not 2");
  refused({"Output/Fields={default, gpa}"}, "Output/Fields: field \"gpa\" does not exist; did you mean \"gap\"?");
  refused({"Output/Reactions={rihgt}"}, "Output/Reactions: node set \"rihgt\" does not exist; did you mean \"right\"?");
  refused({"Time Integrator/Stop/Peeled/Probe/Name=Q"}, "Time Integrator/Stop/Peeled/Probe/Name: probe \"Q\"");
  refused({"Time Integrator/Stop/Peeled/Probe/Quantity=z"}, "names z, but the mesh has 2 dimensions");
  refused({"Interactions/Wall/Contact Element=Q1C5"}, "\"Q1C5\" does not exist");
  refused({"Interactions/Wall/Side Set=surface"},
          "Interactions/Wall/Contact Element: side set \"surface\", block \"body\", cell 1: two sides");
  refused({"Interactions/Second/Side Set=contact"}, "another interaction wants Q1C4 on the side set \"contact\"");
  refused({"Interactions/Second/Side Set=bottom", "Interactions/Second/Contact Element=Q1C2"},
          "the cell already has an enriched side");
  refused({"Mesh/Sets/contact/From=botom"}, "Mesh/Sets/contact: side set \"botom\" does not exist");
  refused({"Mesh/Sets/contact/Upper={-1, 1}"}, "Mesh/Sets/contact: no side of \"bottom\" lies in the region");
  // The end of the shaft is an O-grid in part: three faces meet at some nodes.
  expect_refused_settings(
      std::string(IXOS_XML_DIRECTORY) + "/spatula.xml",
      {"Mesh/Spatula/Target Cells=400", "Interactions/Wall/Side Set=shaft end",
       "Interactions/Wall/Contact Element=Q1CH"},
      "3 faces meet around it; the Hermite contact element Q1CH needs a regular grid of faces, four around each node "
      "inside the set and at most three around one of its rim; Q1C1 to Q1C4 take any faces");
}

TEST_F(DriverRefusalTest, UnknownNamesAreRefusedWithTheNearest) {
  expect_refused_setting("Interactions/Wall/Side Set=surfaces",
                         "Interactions/Wall/Side Set: side set \"surfaces\" does not exist; did you mean \"surface\"?");
  expect_refused_setting("Time Integrator/Type=Newmrak",
                         "Time Integrator/Type: \"Newmrak\" does not exist; did you mean \"Newmark\"?");
  expect_refused_setting("Materials/Ball/Block=bodi",
                         "Materials: block \"bodi\" does not exist; did you mean \"body\"?");
  expect_refused_setting("Matrials/Ball/Density=1", "did you mean \"Materials\"?");
  expect_refused(2, {write("<ParameterList><ParameterList name=\"Interaction\"/></ParameterList>"), "--output", "out"},
                 "scene.xml: Interaction: there is no list \"Interaction\" here; did you mean \"Interactions\"?");
}

TEST_F(DriverRefusalTest, ParametersOfWhatIsNotChosenAreRefused) {
  expect_refused_setting("Interactions/Wall/Morse/Strength=0.1",
                         "ball.xml: Interactions/Wall: \"Morse\" belongs to Law \"Morse\", but Law is \"Van der "
                         "Waals\"; remove it, or set Law to \"Morse\"");
  expect_refused_settings(ball, {"Mesh/Type=Box", "Mesh/Disk/Diameter=5"},
                          "Mesh: \"Disk\" belongs to Type \"Disk\", but Type is \"Box\"");
}

TEST_F(DriverRefusalTest, NamesThatCannotHeadAColumnAreRefused) {
  expect_refused_setting("Output/Probes/a,b/Point={0, 8}", "Output/Probes/a,b: \"a,b_ux\" cannot name a column");
}

TEST_F(DriverRefusalTest, ASurfaceBelowTheWallIsRefused) {
  expect_refused_setting("Mesh/Disk/Center={0, 4}",
                         "Interactions/Wall: the surface \"surface\" starts in or below the wall, least gap");
}

TEST_F(DriverRefusalTest, ASphereAtAQuadraturePointIsRefused) {
  // One side from (0, 0) to (2, 0), and a small sphere that reaches 0.01 beyond the fourth of its five Gauss points.
  write(R"xml(<ParameterList>
    <ParameterList name="Mesh"><Parameter name="Type" type="string" value="Box"/><ParameterList name="Box">
      <Parameter name="Lengths" type="Array(double)" value="{2, 1}"/>
      <Parameter name="Divisions" type="Array(int)" value="{1, 1}"/>
    </ParameterList></ParameterList>
    <ParameterList name="Materials"><ParameterList name="Rubber"/></ParameterList>
    <ParameterList name="Interactions"><ParameterList name="Grain">
      <Parameter name="Side Set" type="string" value="bottom"/>
      <Parameter name="Obstacle" type="string" value="Sphere"/><ParameterList name="Sphere">
        <Parameter name="Radius" type="double" value="0.02"/>
        <Parameter name="Center" type="Array(double)" value="{1.5384693101056831, -0.01}"/>
    </ParameterList></ParameterList></ParameterList>
    <ParameterList name="Time Integrator"><ParameterList name="Time Step Control">
      <Parameter name="Time Step" type="double" value="1e-4"/><Parameter name="Final Time" type="double" value="1e-3"/>
    </ParameterList></ParameterList>
  </ParameterList>)xml");
  expect_refused(2, {"scene.xml", "--output", "out"},
                 "the surface \"bottom\" starts in or below the obstacle, least gap -0.01 at a quadrature point; all "
                 "gaps must be positive");
}

TEST_F(DriverRefusalTest, BadFilesAreRefused) {
  expect_refused(2, {"nowhere.xml", "--output", "out"}, "nowhere.xml: the scene file cannot be read");
  expect_refused(2, {".", "--output", "out"}, "cannot be read");
  expect_refused(2, {write("<ParameterList"), "--output", "out"}, "scene.xml: XML parse error at line 1");
  expect_refused(2, {write("no XML at all"), "--output", "out"}, "scene.xml: XML parse error at line 1");
  expect_refused(2, {write(""), "--output", "out"}, "scene.xml:");
  expect_refused(2,
                 {write("<ParameterList><Parameter name=\"x\" type=\"double\" value=\"abc\"/></ParameterList>"),
                  "--output", "out"},
                 "scene.xml: x: \"abc\" is not of type double");
}

TEST_F(DriverRefusalTest, BadCommandLinesAreRefused) {
  expect_refused(2, {ball, "--frobnicate"}, "frobnicate");
  expect_refused(2, {ball, "--set", "Mesh/Type"}, "write \"List/Sublist/Name=value\"");
  expect_refused(2, {ball, "--set"}, "--set");
}

TEST_F(DriverRefusalTest, AFolderThatCannotBeWrittenIsExitStatusFour) {
  expect_refused(4, {ball, "--output", "/dev/null/out"}, "the results folder cannot be used");
}

// Before gmsh sees them, on one rank and on two.
TEST_F(DriverRefusalTest, ScriptsOfDrawingsThatStartProgramsAreRefused) {
  std::ofstream(folder_ + "/drawing.geo") << "SystemCall \"touch " << folder_ << "/out\";\n";
  const std::string scene = std::string(IXOS_XML_DIRECTORY) + "/../meshes/pillar.xml";
  expect_refused(
      2, {scene, "--output", "out", "--set", "Mesh/Gmsh/File=" + folder_ + "/drawing.geo"},
      "drawing.geo: line 1: \"SystemCall\" starts a program, which a drawing has no need of; if you know the "
      "file, allow it with --trust-geometry");
}

TEST_F(DriverRefusalTest, BoxesBesideADrawingAreRefused) {
  if (std::system("gmsh --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "gmsh is not installed";
  expect_refused(
      2,
      {std::string(IXOS_XML_DIRECTORY) + "/../meshes/finger.xml", "--check", "--set",
       "Mesh/Gmsh/Drawing/Size At/pad/Upper={-0.5, 10, 53} mm"},
      "Size At/pad: the box from -1 to -0.5 L0 in direction x lies beside the drawing, which is from 0 to 16");
}

}  // namespace
}  // namespace ixos::test
