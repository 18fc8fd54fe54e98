// The command ixos-study --advise: advices that hold, resumption, chaos, refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "drivers/process.hpp"
#include "support/files.hpp"
#include "support/plane_block.hpp"

namespace ixos {
namespace {

using test::contents;
using test::Outcome;
using test::shell;

/// A block that is free to move, stretched and turned at first.
const char* const scene = R"x(<ParameterList name="Block">
  <ParameterList name="Mesh"><Parameter name="Type" type="string" value="Box"/>
    <ParameterList name="Box"><Parameter name="Lengths" type="Array(double)" value="{3, 2}"/>
      <Parameter name="Divisions" type="Array(int)" value="{6, 4}"/></ParameterList></ParameterList>
  <ParameterList name="Materials"><ParameterList name="Rubber">
    <Parameter name="Density" type="double" value="1"/></ParameterList></ParameterList>
  <ParameterList name="Initial Conditions">
    <Parameter name="Velocity Gradient" type="Array(double)" value="{0.3, -1, 1, -0.2}"/></ParameterList>
  <ParameterList name="Time Integrator"><Parameter name="Type" type="string" value="Newmark"/>
    <ParameterList name="Time Step Control">
      <Parameter name="Final Time" type="double" value="2"/>
      <Parameter name="Time Step" type="double" value="0.01"/></ParameterList></ParameterList>
  <ParameterList name="Output"><ParameterList name="Probes"><ParameterList name="P">
    <Parameter name="Point" type="Array(double)" value="{3, 2}"/></ParameterList></ParameterList></ParameterList>
</ParameterList>)x";

class AdviseDriverTest : public testing::Test {
 protected:
  void SetUp() override { std::ofstream(folder_ + "/block.xml") << scene; }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  Outcome run(const std::string& arguments) const { return shell("'" IXOS_STUDY_DRIVER "' " + arguments, folder_); }
  void expect_refused(const std::string& arguments, const std::string& message) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << outcome.output;
    EXPECT_NE(outcome.output.find(message), std::string::npos) << outcome.output;
  }
  /// Returns the last value of a column of a run.
  double last(const std::string& results, const std::string& column) const {
    std::istringstream file(contents(folder_ + "/" + results + "/history.csv"));
    std::string header, line, row, cell, name;
    std::getline(file, header);
    while (std::getline(file, line)) row = line;
    std::istringstream names(header), cells(row);
    while (std::getline(names, name, ',') && std::getline(cells, cell, ','))
      if (name == column) return std::stod(cell);
    ADD_FAILURE() << "no column " << column << " in " << header;
    return std::nan("");
  }
  std::string folder_ = test::scratch_folder();
};

/// The whole depth of a scene in space has three times the force of a unit.
TEST_F(AdviseDriverTest, APlaneSceneIsAnsweredInTwoDimensions) {
  std::ofstream(folder_ + "/spatial.xml") << test::plane_block;
  const Outcome outcome =
      run("--advise spatial.xml --quantity 'rms contact_force_z' --tolerance 10% --budget 60 --output out");
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("Two dimensions will do"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("rms contact_force_y: about"), std::string::npos) << outcome.output;
  EXPECT_NE(contents(folder_ + "/out/advice.json").find("\"depth\": 3.0"), std::string::npos);
  EXPECT_NE(contents(folder_ + "/out/advised.xml").find("name=\"Dimension\" type=\"int\" value=\"2\""),
            std::string::npos);
  for (const char* scene_in : {"out/plane.xml", "spatial.xml"})
    ASSERT_EQ(shell("'" IXOS_DRIVER "' " + std::string(scene_in) + " --quiet --output " +
                        std::to_string(scene_in[0] == 'o' ? 2 : 3),
                    folder_)
                  .status,
              0);
  EXPECT_NEAR(3 * last("2", "contact_force_y") / last("3", "contact_force_z"), 1, 1e-8);
  EXPECT_NEAR(last("2", "force_uy") / last("3", "force_uz"), 1, 1e-10);
}

TEST_F(AdviseDriverTest, TheAdvisedSceneKeepsTheTolerance) {
  const std::string command = "--advise block.xml --quantity 'final P_uy' --tolerance 2% --output out";
  const Outcome first = run(command);
  ASSERT_EQ(first.status, 0) << first.output;
  EXPECT_NE(first.output.find("Budget: "), std::string::npos) << first.output;
  EXPECT_NE(first.output.find("Recommended within the tolerance 2 %: "), std::string::npos) << first.output;
  EXPECT_NE(first.output.find("Costs of other tolerances:"), std::string::npos);
  EXPECT_EQ(first.output.find("Linear Elastic"), std::string::npos) << "the block turns by more than a radian";
  EXPECT_NE(contents(folder_ + "/out/advice.json").find("\"status\": \"advised\""), std::string::npos);
  // The scene as it is ready to run, against a much finer one.
  ASSERT_EQ(shell("'" IXOS_DRIVER "' out/advised.xml --quiet --output advised", folder_).status, 0);
  ASSERT_EQ(shell("'" IXOS_DRIVER "' block.xml --quiet --output fine --set 'Mesh/Box/Divisions={48, 32}' --set 'Time "
                  "Integrator/Time Step Control/Time Step=0.0025'",
                  folder_)
                .status,
            0);
  EXPECT_NEAR(last("advised", "P_uy") / last("fine", "P_uy"), 1, 0.02);
  // Nothing is repeated.
  const Outcome second = run(command);
  EXPECT_EQ(second.status, 0) << second.output;
  std::size_t runs = 0, reused = 0;
  std::istringstream lines(second.output);
  for (std::string line; std::getline(lines, line);) {
    runs += line.find(": completed, ") != std::string::npos ? 1 : 0;
    reused += line.find("(reused)") != std::string::npos ? 1 : 0;
  }
  EXPECT_GT(runs, 5U) << second.output;
  EXPECT_EQ(reused, runs) << second.output;
}

TEST_F(AdviseDriverTest, SeveralQuantitiesTwoJobsAndAReport) {
  const Outcome one = run("--advise block.xml --quantity 'final P_uy' --tolerance 5% --output one");
  const Outcome two =
      run("--advise block.xml --quantity 'final P_uy' --quantity 'peak P_ux' --tolerance 5% --jobs 2 --output two");
  ASSERT_EQ(one.status, 0) << one.output;
  ASSERT_EQ(two.status, 0) << two.output;
  for (const char* quantity : {"  final P_uy: about ", "  peak P_ux: about "})
    EXPECT_NE(two.output.find(quantity), std::string::npos) << two.output;
  EXPECT_NE(two.output.find("Plots and report: two/report.html"), std::string::npos) << two.output;
  EXPECT_NE(two.output.find("; not examined: "), std::string::npos) << "Newton's tolerance is the scene's own";
  const std::string page = contents(folder_ + "/two/report.html");
  for (const char* part : {"Recommendation", "Errors to expect", "final P_uy", "peak P_ux", "All runs"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  // Both quantities keep the tolerance, against a much finer run.
  ASSERT_EQ(shell("'" IXOS_DRIVER "' two/advised.xml --quiet --output advised", folder_).status, 0);
  ASSERT_EQ(shell("'" IXOS_DRIVER "' block.xml --quiet --output fine --set 'Mesh/Box/Divisions={48, 32}' --set 'Time "
                  "Integrator/Time Step Control/Time Step=0.0025'",
                  folder_)
                .status,
            0);
  EXPECT_NEAR(last("advised", "P_uy") / last("fine", "P_uy"), 1, 0.05);
}

TEST_F(AdviseDriverTest, AChaoticSceneIsCalledChaotic) {
  // The ball bounces twenty times or so.
  const Outcome outcome = run("--advise '" IXOS_XML_DIRECTORY
                              "/ball.xml' --quantity 'final linear_momentum_y' --tolerance 0.01% --output out");
  EXPECT_EQ(outcome.status, 3) << outcome.output;
  EXPECT_NE(outcome.output.find("The scene is chaotic for final linear_momentum_y"), std::string::npos)
      << outcome.output;
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/out/advised.xml"));
}

TEST_F(AdviseDriverTest, AToleranceThatTheBudgetDoesNotReach) {
  const Outcome outcome = run("--advise block.xml --quantity 'final P_uy' --tolerance 1e-8 --budget 4 --output out");
  EXPECT_EQ(outcome.status, 3) << outcome.output;
  EXPECT_NE(outcome.output.find("The smallest error seen is "), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find(", limited by the "), std::string::npos) << outcome.output;
}

TEST_F(AdviseDriverTest, AnInterruptedAdviceResumes) {
  const Outcome told = run(
      "--advise block.xml --quantity 'final P_uy' --tolerance 1e-8 --budget 100 --output out & pid=$!; until [ $(ls "
      "out/runs/*/run.json 2> /dev/null | wc -l) -ge 3 ] || ! kill -0 $pid; do sleep 0.02; done; kill -TERM $pid; wait "
      "$pid");
  EXPECT_EQ(told.status, 5) << told.output;
  EXPECT_NE(told.output.find("run the same command again to resume"), std::string::npos) << told.output;
  const Outcome resumed = run("--advise block.xml --quantity 'final P_uy' --tolerance 20% --output out");
  EXPECT_EQ(resumed.status, 0) << resumed.output;
  EXPECT_NE(resumed.output.find("(reused)"), std::string::npos) << resumed.output;
}

TEST_F(AdviseDriverTest, BadQuestionsAreRefused) {
  const std::string advise = "--advise block.xml --output out ";
  expect_refused("--advise none.xml --quantity 'peak P_uy'", "none.xml: the scene file cannot be read");
  expect_refused(advise, "an advice needs a quantity");
  expect_refused(advise + "--quantity 'peek P_uy'", "\"peek P_uy\": this is no quantity. Quantities are:");
  expect_refused(advise + "--quantity 'mean P_uy [3, 4]'", "the window holds no rows: the run is from 0 to 2 T0");
  const Outcome early =
      run("--advise block.xml --quantity 'mean P_uy [0, 1.9]' --output early --set 'Time Integrator/Stop/S/"
          "Type=Probe' --set 'Time Integrator/Stop/S/Probe/Name=P' --set 'Time "
          "Integrator/Stop/S/Probe/Quantity=uy' --set 'Time Integrator/Stop/S/Probe/Limit=0.1'");
  EXPECT_EQ(early.status, 3) << early.output;
  EXPECT_NE(
      early.output.find("The runs end as they should, but do not give the quantities: \"mean P_uy [0, 1.9]\": the "
                        "run ended at "),
      std::string::npos)
      << early.output;
  expect_refused(advise + "--quantity 'peak P_uu'", "column \"P_uu\" does not exist; did you mean \"P_u");
  expect_refused(advise + "--quantity 'peak P_uy' --tolerance much", "--tolerance: \"much\" is no tolerance");
  expect_refused(advise + "--quantity 'peak P_uy' --tolerance 0", "is no tolerance");
  expect_refused(advise + "--quantity 'peak P_uy' --set 'Mesh/Bax=1'", "Mesh/Bax");
  expect_refused("--quantity 'peak P_uy'", "--advise");
  expect_refused("block.xml --advise block.xml", "--advise");
}

}  // namespace
}  // namespace ixos
