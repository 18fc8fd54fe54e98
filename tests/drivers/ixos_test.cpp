// The driver: what it says and how it ends. Every bad input gets one clear message and leaves nothing half-written.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "drivers/process.hpp"
#include "support/files.hpp"

namespace ixos::test {
namespace {

const std::string ball = std::string(IXOS_XML_DIRECTORY) + "/ball.xml";

class DriverTest : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Refused with this status and message, and without results.
  void expect_refused(int status, const std::vector<std::string>& arguments, const std::string& message) {
    const Outcome outcome = ixos(arguments, folder_);
    EXPECT_EQ(outcome.status, status) << outcome.output;
    EXPECT_NE(outcome.output.find(message), std::string::npos) << outcome.output;
    EXPECT_FALSE(std::filesystem::exists(folder_ + "/out")) << "something was written";
  }
  void expect_refused_setting(const std::string& assignment, const std::string& message) {
    expect_refused(2, {ball, "--output", "out", "--set", assignment}, message);
  }
  std::string write(const std::string& text) {
    std::ofstream(folder_ + "/scene.xml") << text;
    return "scene.xml";
  }

  std::string folder_ = scratch_folder();
};

TEST_F(DriverTest, BadValuesAreRefused) {
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
  expect_refused_setting("Time Integrator/Time Step Control/Final Time=-1", "-1 must be later than Initial Time, 0");
  expect_refused_setting("Materials/Ball/Young's Modulus=inf", "inf is not allowed");
  expect_refused_setting("Mesh/Disk/Center={0, nan}", "Mesh/Disk/Center: nan is not allowed");
  expect_refused_setting("Mesh/Disk/Center={0}", "Mesh/Disk/Center has 1 elements, not 2");
  expect_refused_setting("Interactions/Wall/Normal={0, 0}", "Interactions/Wall/Normal is zero");
  expect_refused_setting("Linear Solver/Linear Solver Type=Belso",
                         "Linear Solver/Linear Solver Type: \"Belso\" does not exist; did you mean \"Belos\"?");
  expect_refused_setting("Linear Solver/Preconditioner Type=Foo", "\"Foo\" does not exist");
  expect_refused_setting("Linear Solver/Linear Solver Types=foo", "Linear Solver: ");
  expect_refused_setting("Linear Solver/Linear Solver Types/Direct/Solver Type=Nonsense",
                         "Linear Solver: Stratimikos refuses the list");
}

TEST_F(DriverTest, SolversForSymmetricMatricesAreRefusedForUnsymmetricTangents) {
  const auto refused = [&](const std::string& solver, const std::string& message) {
    expect_refused(2,
                   {ball, "--output", "out", "--set", "Time Integrator/Type=Energy-Momentum", "--set",
                    "Linear Solver/Linear Solver Type=" + solver.substr(0, solver.find('/')), "--set",
                    "Linear Solver/Linear Solver Types/" + solver},
                   message);
  };
  refused("Direct/Solver Type=CHOLMOD", "Direct/Solver Type: \"CHOLMOD\" needs a symmetric matrix");
  refused("Belos/Solver Type=Pseudo Block CG", "tangent is not symmetric; use \"Pseudo Block GMRES\"");
}

TEST_F(DriverTest, BadStepControlAndCutoffsAreRefused) {
  const auto refused = [&](const std::vector<std::string>& assignments, const std::string& message) {
    std::vector<std::string> arguments{ball, "--output", "out"};
    for (const std::string& assignment : assignments) arguments.insert(arguments.end(), {"--set", assignment});
    expect_refused(2, arguments, message);
  };
  const std::string control = "Time Integrator/Time Step Control/", adaptive = control + "Type=Adaptive",
                    list = control + "Adaptive/";
  refused({control + "Type=Adaptve"}, "did you mean \"Adaptive\"?");
  refused({adaptive}, "neither Tolerance nor Maximum Gap Ratio is given");
  refused({adaptive, list + "Tolerance=-1"}, "-1 is not allowed: it must be at least 0");
  refused({adaptive, list + "Maximum Gap Ratio=0.5"}, "Maximum Gap Ratio: must be greater than 1");
  refused({adaptive, list + "Tolerance=1e-3", "Time Integrator/Type=Static"}, "has no estimate of its local error");
  refused({adaptive, list + "Tolerance=1e-3", list + "Choose Time Points=true", "Time Integrator/Type=Newmark"},
          "has no points in time of the interaction that could be chosen");
  refused({"Interactions/Wall/Cutoff=0.1"}, "Cutoff: 0.1 cuts the attraction off");
  refused({"Interactions/Wall/Cutoff=2", "Time Integrator/Gautam-Sauer Composite/Interaction Points=0"},
          "takes the exact mean of the interaction");
  refused({"Time Integrator/Type=Central Difference", "Interactions/Wall/Contact Element=Q1CH"}, "has no lumped mass");
  refused({"Time Integrator/Type=Central Difference", "Time Integrator/Central Difference/Safety=1.5"},
          "1.5 is not allowed: it must be greater than 0 and at most 1");
}

TEST_F(DriverTest, BadMotionsLoadsAndElementsAreRefused) {
  const std::string strip = std::string(IXOS_XML_DIRECTORY) + "/strip.xml";
  const auto refused = [&](const std::vector<std::string>& assignments, const std::string& message) {
    std::vector<std::string> arguments{strip, "--output", "out", "--set", "Mesh/Box/Divisions={40, 2}"};
    for (const std::string& assignment : assignments) arguments.insert(arguments.end(), {"--set", assignment});
    expect_refused(2, arguments, message);
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
          "the table goes from 0 to 5, but the run from 0 to 160");
  refused({"Histories/Pull/Rate Ramp/Length=200"},
          "the ramp ends at 200, Start + Length, after the run's Final Time, 160");
  refused({"Histories/Pull/Rate Ramp/Length=-1"}, "must be at least 0");
  refused({"Boundary Conditions/Pull/History=Pul"}, "history \"Pul\" does not exist; did you mean \"Pull\"?");
  refused({"Boundary Conditions/Guide/History=Pull", "Boundary Conditions/Guide/Components=xy",
           "Boundary Conditions/Pull/History="},
          "prescribe different motions for one degree of freedom");
  refused({"Boundary Conditions/Other/Node Set=right", "Boundary Conditions/Other/Components=y"},
          "Boundary Conditions/Other: two conditions prescribe different motions");
  refused({"Boundary Conditions/Guide/Vector={1, 0}"}, "Boundary Conditions/Guide/Vector: a Displacement takes none");
  refused({"Boundary Conditions/Wind/Type=Traction"}, "Boundary Conditions/Wind/Side Set is missing");
  refused({"Boundary Conditions/Wind/Type=Traction", "Boundary Conditions/Wind/Side Set=top"},
          "Boundary Conditions/Wind/Vector is missing");
  refused({"Boundary Conditions/Weight/Type=Body Force", "Boundary Conditions/Weight/Vector={0, -1}",
           "Boundary Conditions/Weight/Block=bodi"},
          "did you mean \"body\"?");
  refused({"Output/Probes/P/Point={0, 0}"}, "Output/Probes/P/Point: the point (0, 0) lies outside the body");
  refused({"Output/Probes/P/Point={0}"}, "Output/Probes/P/Point has 1 elements, not 2");
  refused({"Output/Reactions={rihgt}"}, "Output/Reactions: node set \"rihgt\" does not exist; did you mean \"right\"?");
  refused({"Time Integrator/Stop/Peeled/Probe/Name=Q"}, "Time Integrator/Stop/Peeled/Probe/Name: probe \"Q\"");
  refused({"Time Integrator/Stop/Peeled/Probe/Quantity=z"}, "names z, but the scene has 2 dimensions");
  refused({"Interactions/Wall/Contact Element=Q1C5"}, "\"Q1C5\" does not exist");
  refused({"Interactions/Wall/Side Set=surface"},
          "Interactions/Wall/Contact Element: side set \"surface\", block \"body\", cell 1: two sides");
  refused({"Interactions/Second/Side Set=contact"}, "another interaction wants Q1C4 on the side set \"contact\"");
  refused({"Interactions/Second/Side Set=bottom", "Interactions/Second/Contact Element=Q1C2"},
          "the cell has an enriched side already");
  refused({"Mesh/Sets/contact/From=botom"}, "Mesh/Sets/contact: side set \"botom\" does not exist");
  refused({"Mesh/Sets/contact/Upper={-1, 1}"}, "Mesh/Sets/contact: no side of \"bottom\" lies in the region");
  expect_refused(2,
                 {ball, "--output", "out", "--set", "Mesh/Type=Box", "--set", "Mesh/Box/Dimension=3", "--set",
                  "Mesh/Box/Lengths={1, 1, 1}", "--set", "Mesh/Box/Divisions={1, 1, 1}", "--set",
                  "Interactions/Wall/Side Set=bottom", "--set", "Interactions/Wall/Contact Element=Q1CH"},
                 "the Hermite contact element Q1CH is for quadrilaterals; hexahedra have Q1C1 to Q1C4");
}

TEST_F(DriverTest, ARunStopsWhereAProbeSaysSoAndCutsAFailedStep) {
  const std::string strip = std::string(IXOS_XML_DIRECTORY) + "/strip.xml";
  const std::vector<std::string> arguments{
      strip, "--quiet", "--output", "out", "--set", "Mesh/Box/Divisions={40, 2}", "--set",
      "Time Integrator/Time Step Control/Time Step=4", "--set", "Output/Fields Time Interval=0", "--set",
      "Time Integrator/Stop/Peeled/Probe/Name=edge", "--set", "Time Integrator/Stop/Peeled/Probe/Quantity=uy", "--set",
      // Too few iterations for the steps in which peeling begins.
      "Nonlinear Solver/Maximum Iterations=6", "--set", "Time Integrator/Time Step Control/Maximum Cuts=8"};
  const Outcome outcome = ixos(arguments, folder_);
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const std::string summary = contents(folder_ + "/out/summary.json");
  EXPECT_NE(summary.find("\"status\": \"stopped\""), std::string::npos) << summary;
  EXPECT_NE(summary.find("Peeled: uy of probe edge is 1"), std::string::npos) << summary;
  EXPECT_EQ(summary.find("\"rejected_steps\": 0"), std::string::npos) << summary;
  EXPECT_NE(summary.find("reaction_right_y"), std::string::npos) << summary;
  const std::string history = contents(folder_ + "/out/history.csv");
  // The grid of nominal times, 4, 8, ..., is hit whatever was cut.
  std::vector<double> times;
  std::istringstream rows(history);
  for (std::string row; std::getline(rows, row);)
    if (row.front() != 's') times.push_back(std::stod(row.substr(row.find(',') + 1)));
  for (double grid = 4; grid < times.back(); grid += 4)
    EXPECT_TRUE(std::any_of(times.begin(), times.end(), [&](double t) { return std::abs(t - grid) < 1e-9; })) << grid;
  const std::string header = history.substr(0, history.find('\n'));
  EXPECT_NE(header.find(",reaction_right_x,reaction_right_y,P_ux,P_uy,P_vx,P_vy,edge_ux,"), std::string::npos)
      << header;
}

TEST_F(DriverTest, UnknownNamesAreRefusedWithTheNearest) {
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

TEST_F(DriverTest, ASurfaceBelowTheWallIsRefused) {
  expect_refused_setting("Mesh/Disk/Center={0, 4}",
                         "Interactions/Wall: the surface \"surface\" starts in or below the wall, least gap");
}

TEST_F(DriverTest, BadFilesAreRefused) {
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

TEST_F(DriverTest, BadCommandLinesAreRefused) {
  expect_refused(2, {ball, "--frobnicate"}, "frobnicate");
  expect_refused(2, {ball, "--set", "Mesh/Type"}, "write \"List/Sublist/Name=value\"");
  expect_refused(2, {ball, "--set"}, "--set");
}

TEST_F(DriverTest, AFolderThatCannotBeWrittenIsExitStatusFour) {
  expect_refused(4, {ball, "--output", "/dev/null/out"}, "the results folder cannot be used");
}

TEST_F(DriverTest, CheckBuildsButDoesNotRun) {
  const Outcome outcome = ixos({ball, "--check", "--output", "out"}, folder_);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("48 cells, 114 degrees of freedom"), std::string::npos) << outcome.output;
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(DriverTest, WithoutASceneItTellsHowToBegin) {
  const Outcome outcome = ixos({}, folder_);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.output.find("ixos xml/ball.xml"), std::string::npos);
  EXPECT_EQ(ixos({"--help"}, folder_).status, 0);
}

TEST_F(DriverTest, TemplatesRunAsTheyAre) {
  for (const char* name : {"ball", "block"}) {
    const Outcome text = ixos({"--template", name}, folder_);
    EXPECT_EQ(text.status, 0);
    write(text.output);
    const Outcome run =
        ixos({"scene.xml", "--set", "Time Integrator/Time Step Control/Final Time=0.01", "--output", "out"}, folder_);
    EXPECT_EQ(run.status, 0) << run.output;
    EXPECT_TRUE(std::filesystem::exists(folder_ + "/out/fields.e"));
  }
  EXPECT_EQ(ixos({"--template", "bal"}, folder_).status, 2);
}

TEST_F(DriverTest, AMeshThatIsWrittenRunsAsTheOneThatIsGenerated) {
  ASSERT_EQ(ixos({ball, "--write-mesh", "ball.e"}, folder_).status, 0);
  const std::string end = "Time Integrator/Time Step Control/Final Time=0.02";
  ASSERT_EQ(ixos({ball, "--set", end, "--output", "one"}, folder_).status, 0);
  ASSERT_EQ(
      ixos({ball, "--set", end, "--set", "Mesh/Type=Exodus", "--set", "Mesh/Exodus/File=ball.e", "--output", "two"},
           folder_)
          .status,
      0);
  EXPECT_EQ(history_rows(folder_ + "/one"), history_rows(folder_ + "/two"));
  expect_refused(2,
                 {ball, "--set", "Mesh/Type=Exodus", "--set", "Mesh/Exodus/File=ball.e", "--set",
                  "Mesh/Exodus/Dimension=3", "--output", "out"},
                 "ball.e is a mesh of 2 dimensions, but the scene wants 3");
  expect_refused(2, {ball, "--set", "Mesh/Type=Exodus", "--set", "Mesh/Exodus/File=none.e", "--output", "out"},
                 "none.e: the mesh file cannot be read");
  expect_refused(4, {ball, "--write-mesh", "/dev/null/ball.e"}, "/dev/null/ball.e: cannot be written");
}

TEST_F(DriverTest, TheShortestSceneOfTheReadmeRuns) {
  const std::string readme = contents(std::string(IXOS_DOCS_DIRECTORY) + "/../README.md");
  const auto start = readme.find("```xml\n") + 7;
  write(readme.substr(start, readme.find("```", start) - start));
  const Outcome outcome = ixos({"scene.xml", "--output", "out"}, folder_);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
}

TEST_F(DriverTest, HelpBeginsWithIxos) {
  EXPECT_EQ(ixos({"--help"}, folder_).output.find("Ixos simulates dynamic adhesion."), 0U);
}

TEST_F(DriverTest, RanksWithoutCellsWriteTheirFields) {
  const std::string cell = write(R"(<ParameterList>
    <ParameterList name="Mesh"><Parameter name="Type" type="string" value="Box"/></ParameterList>
    <ParameterList name="Materials"><ParameterList name="A"/></ParameterList>
    <ParameterList name="Output"><Parameter name="Fields Interval" type="int" value="1"/></ParameterList>
    <ParameterList name="Time Integrator"><ParameterList name="Time Step Control">
      <Parameter name="Final Time" type="double" value="0.01"/><Parameter name="Time Step" type="double" value="0.001"/>
    </ParameterList></ParameterList></ParameterList>)");
  for (int ranks : {2, 4, 6}) {
    const Outcome outcome = shell(
        "mpiexec -np " + std::to_string(ranks) + " --oversubscribe " + quoted_driver() + " " + cell + " --output out",
        folder_);
    EXPECT_EQ(outcome.status, 0) << ranks << " ranks: " << outcome.output;
    EXPECT_TRUE(std::filesystem::exists(folder_ + "/out/fields.e." + std::to_string(ranks) + ".1"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/out/fields.e.2.0")) << "left from an earlier run";
}

TEST_F(DriverTest, ExplainTellsWhatIsModelledAndWhatIsLeftOut) {
  const Outcome outcome = ixos({ball, "--explain"}, folder_);
  EXPECT_EQ(outcome.status, 0);
  for (const char* part : {"48 cells, 114 degrees of freedom", "Neo-Hooke", "Van der Waals", "linear solver Direct",
                           "Left out, at no cost:", "damping"})
    EXPECT_NE(outcome.output.find(part), std::string::npos) << part << " in " << outcome.output;
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(DriverTest, TheParameterDocumentIsCurrent) {
  EXPECT_EQ(ixos({"--parameters"}, folder_).output, contents(std::string(IXOS_DOCS_DIRECTORY) + "/parameters.md"))
      << "renew it: ixos --parameters > docs/parameters.md";
}

TEST_F(DriverTest, SchemesAreListedWithWhatTheyConserve) {
  const std::string text = ixos({"--list-schemes"}, folder_).output;
  for (const char* name : {"Newmark", "Bathe Composite", "Gautam-Sauer Composite", "Average Vector Field", "Beta",
                           "Interaction Points", "conserves", "order", "stability"})
    EXPECT_NE(text.find(name), std::string::npos) << name;
}

TEST_F(DriverTest, TheRepairedSolverIsInForceInTheDriver) {
  EXPECT_NE(ixos({"--version"}, folder_).output.find("KLU2 from: libixos"), std::string::npos);
}

TEST_F(DriverTest, ResultsAreWrittenAndTheEffectiveSceneRepeatsTheRun) {
  const std::string end = "Time Integrator/Time Step Control/Final Time=0.05";
  ASSERT_EQ(ixos({ball, "--set", end, "--output", "one", "--quiet"}, folder_).status, 0);
  ASSERT_EQ(ixos({"one/effective.xml", "--output", "two", "--quiet"}, folder_).status, 0);
  EXPECT_EQ(history_rows(folder_ + "/one"), history_rows(folder_ + "/two"));
  EXPECT_EQ(history_rows(folder_ + "/one").size(), 1U + 51U);
  const std::string summary = contents(folder_ + "/one/summary.json");
  for (const char* key : {"\"status\": \"completed\"", "\"steps\": 50", "\"dofs\": 114", "\"elements\": 48",
                          "\"max_energy_error\"", "\"peak_memory_bytes\"", "\"seconds_per_increment\""})
    EXPECT_NE(summary.find(key), std::string::npos) << key;
}

TEST_F(DriverTest, NewmarkFailsOnTheBallWithReadableResults) {
  const Outcome outcome = ixos({ball, "--set", "Time Integrator/Type=Newmark", "--output", "out"}, folder_);
  EXPECT_EQ(outcome.status, 3) << outcome.output;
  EXPECT_NE(outcome.output.find("the run ended at t = "), std::string::npos);
  EXPECT_NE(contents(folder_ + "/out/summary.json").find("\"status\": \"diverged\""), std::string::npos);
  const std::string history = contents(folder_ + "/out/history.csv");
  EXPECT_GT(std::count(history.begin(), history.end(), '\n'), 1500);
}

TEST_F(DriverTest, ASignalIsExitStatusFiveWithResultsOnDisk) {
  const Outcome outcome = shell(
      quoted_driver() + " " + ball + " --quiet --output out & pid=$!; sleep 1.5; kill -TERM $pid; wait $pid", folder_);
  EXPECT_EQ(outcome.status, 5) << outcome.output;
  EXPECT_NE(contents(folder_ + "/out/summary.json").find("\"status\": \"interrupted\""), std::string::npos);
}

TEST_F(DriverTest, ResultFilesKeepTheirContract) {
  ASSERT_EQ(
      ixos({ball, "--set", "Time Integrator/Time Step Control/Final Time=0.01", "--output", "out"}, folder_).status, 0);
  const std::string history = contents(folder_ + "/out/history.csv");
  EXPECT_EQ(history.substr(0, history.find('\n')),
            "step,time,time_step,kinetic_energy,elastic_energy,contact_energy,external_work,dissipated_energy,"
            "total_energy,linear_momentum_x,linear_momentum_y,angular_momentum_z,contact_force_x,contact_force_y,"
            "contact_measure,min_gap,newton_iterations,linear_iterations,wall_seconds");
  const std::string summary = contents(folder_ + "/out/summary.json");
  for (const char* key : {"status", "reason", "scheme", "end_time", "steps", "rejected_steps", "dofs", "elements",
                          "ranks", "newton_iterations", "linear_iterations", "wall_seconds", "setup_seconds",
                          "seconds_per_increment", "seconds", "peak_memory_bytes", "max_energy_error", "max_force"})
    EXPECT_NE(summary.find("\"" + std::string(key) + "\":"), std::string::npos) << key;
}

TEST_F(DriverTest, TwoRanksEndAlike) {
  const std::string run = "mpiexec -np 2 --oversubscribe " + quoted_driver() + " " + ball;
  EXPECT_EQ(shell(run + " --set 'Time Integrator/Time Step Control/Final Time=0.01' --output out", folder_).status, 0);
  const Outcome refused = shell(run + " --set Mesh/Disk/Rings=0 --output two", folder_);
  EXPECT_EQ(refused.status, 2) << refused.output;
  const std::string said = "Mesh/Disk/Rings: 0 is not allowed";
  EXPECT_NE(refused.output.find(said), std::string::npos) << refused.output;
  EXPECT_EQ(refused.output.find(said), refused.output.rfind(said)) << "said by both ranks";
  // A file that only rank 0 opens: both ranks must hear of it.
  std::filesystem::create_directories(folder_ + "/three/history.csv");
  EXPECT_EQ(shell("timeout 30 " + run + " --output three", folder_).status, 4);
}

TEST_F(DriverTest, AFailedStepIsExitStatusThreeWithResultsOnDisk) {
  const Outcome outcome = ixos({ball, "--set", "Nonlinear Solver/Maximum Iterations=1", "--output", "out"}, folder_);
  EXPECT_EQ(outcome.status, 3) << outcome.output;
  EXPECT_NE(outcome.output.find("Newton's iteration did not converge in 1 iterations"), std::string::npos);
  EXPECT_NE(contents(folder_ + "/out/summary.json").find("\"status\": \"diverged\""), std::string::npos);
  EXPECT_NE(contents(folder_ + "/out/history.csv").find("\n0,0,"), std::string::npos);
}

}  // namespace
}  // namespace ixos::test
