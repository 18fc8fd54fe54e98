// The driver: what it says, what it writes, and how it ends.
#include <algorithm>
#include <cmath>
#include <sstream>
#include <thread>

#include "drivers/driver_test.hpp"
#include "support/files.hpp"

namespace ixos::test {
namespace {

TEST_F(DriverTest, ARunStopsWhereAProbeSaysSoAndCutsAFailedStep) {
  // The wind is undefined from 20.85 to 20.95. The step from 20 to 24 has a Gauss point in time at 20.923; the two
  // halves of that step have none there.
  const std::vector<std::string> arguments{strip,      "--quiet",
                                           "--output", "out",
                                           "--set",    "Mesh/Box/Divisions={40, 2}",
                                           "--set",    "Time Integrator/Time Step Control/Time Step=4",
                                           "--set",    "Output/Fields Time Interval=0",
                                           "--set",    "Time Integrator/Stop/Peeled/Probe/Name=edge",
                                           "--set",    "Time Integrator/Stop/Peeled/Probe/Quantity=uy",
                                           "--set",    "Histories/Gap/Type=Expression",
                                           "--set",    "Histories/Gap/Expression/Value=1e-9*sqrt((t-20.85)*(t-20.95))",
                                           "--set",    "Boundary Conditions/Wind/Type=Traction",
                                           "--set",    "Boundary Conditions/Wind/Side Set=top",
                                           "--set",    "Boundary Conditions/Wind/Vector={0, 1}",
                                           "--set",    "Boundary Conditions/Wind/History=Gap",
                                           "--set",    "Time Integrator/Time Step Control/Maximum Cuts=8"};
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
  for (int step = 4; step < times.back(); step += 4)
    EXPECT_TRUE(std::any_of(times.begin(), times.end(), [&](double t) { return std::abs(t - step) < 1e-9; })) << step;
  const std::string header = history.substr(0, history.find('\n'));
  EXPECT_NE(header.find(",reaction_right_x,reaction_right_y,P_ux,P_uy,P_vx,P_vy,edge_ux,"), std::string::npos)
      << header;
}

TEST_F(DriverTest, SolversThatARunDoesNotAskForAreNotLoaded) {
  const std::string run = "LD_DEBUG=files " + quoted_driver() + " '" + ball +
                          "' --output out --overwrite --set 'Time Integrator/Time Step Control/Final Time=0.01'";
  const Outcome direct = shell(run, folder_);
  EXPECT_EQ(direct.status, 0);
  EXPECT_NE(direct.output.find("libixos.so"), std::string::npos);
  EXPECT_EQ(direct.output.find("libixos_solvers.so"), std::string::npos);
  EXPECT_EQ(direct.output.find("muelu"), std::string::npos);
  const Outcome krylov = shell(run + " --set 'Linear Solver/Linear Solver Type=Belos'", folder_);
  EXPECT_EQ(krylov.status, 0);
  EXPECT_NE(krylov.output.find("libixos_solvers.so"), std::string::npos);
}

TEST_F(DriverTest, CheckBuildsButDoesNotRun) {
  const Outcome outcome = ixos({ball, "--check", "--output", "out"}, folder_);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("48 cells, 114 degrees of freedom"), std::string::npos) << outcome.output;
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(DriverTest, ASceneWithWarningsIsNotCalledSound) {
  const std::string sound = ixos({ball, "--check"}, folder_).output;
  EXPECT_EQ(sound.find("warning"), std::string::npos) << sound;
  EXPECT_NE(sound.find("The scene is sound."), std::string::npos) << sound;
  const std::string soft = ixos({ball, "--check", "--set", "Materials/Ball/Young's Modulus=1e-3"}, folder_).output;
  EXPECT_NE(soft.find("warning"), std::string::npos) << soft;
  EXPECT_NE(soft.find("The scene can run, but "), std::string::npos) << soft;
  EXPECT_EQ(soft.find("is sound"), std::string::npos) << soft;
}

TEST_F(DriverTest, TheCostOfAPreconditionerMayBeWhole) {
  for (const char* type : {"Direct", "Belos"}) {
    const Outcome outcome = ixos({ball, "--check", "--set", "Linear Solver/Reuse/Setup Cost=5", "--set",
                                  std::string("Linear Solver/Linear Solver Type=") + type},
                                 folder_);
    EXPECT_EQ(outcome.status, 0) << type << ": " << outcome.output;
  }
}

TEST_F(DriverTest, OneProcessNeedsNoServerOfOpenMPI) {
  const Outcome outcome =
      shell("OPAL_BINDIR=/nowhere " + quoted_driver() + " '" + ball + "' --check", folder_);  // Open MPI's programs
  EXPECT_EQ(outcome.status, 0) << outcome.output;
}

TEST_F(DriverTest, WithoutASceneItTellsHowToBegin) {
  const Outcome outcome = ixos({}, folder_);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.output.find("ixos xml/ball.xml"), std::string::npos);
}

TEST_F(DriverTest, HelpHasOptionsAndExamplesInTheFormOfManualPages) {
  const Outcome help = ixos({"--help"}, folder_);
  EXPECT_EQ(help.status, 0);
  EXPECT_NE(help.output.find("\nUsage: ixos [OPTIONS] [SCENE]\n"), std::string::npos) << help.output;
  EXPECT_NE(help.output.find("\n  --ranks N  "), std::string::npos) << "without what it needs";
  EXPECT_NE(help.output.find("\nExamples:\n  ixos xml/ball.xml  "), std::string::npos);
}

TEST_F(DriverTest, TemplatesRunAsTheyAre) {
  for (const char* name : {"ball", "block"}) {
    const Outcome text = ixos({"--template", name}, folder_);
    EXPECT_EQ(text.status, 0);
    write(text.output);
    const Outcome run =
        ixos({"scene.xml", "--set", "Time Integrator/Time Step Control/Final Time=0.01", "--output", name}, folder_);
    EXPECT_EQ(run.status, 0) << run.output;
    EXPECT_TRUE(std::filesystem::exists(folder_ + "/" + name + "/fields.e"));
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

TEST_F(DriverTest, CheckTellsTheQualityOfTheMeshAndVeryBadCellsAreWarnedOf) {
  const Outcome good = ixos({ball, "--check"}, folder_);
  EXPECT_EQ(good.status, 0);
  EXPECT_NE(good.output.find("\nscaled Jacobian: least 0."), std::string::npos) << good.output;
  EXPECT_NE(good.output.find("\nlargest aspect ratio: "), std::string::npos) << good.output;
  EXPECT_NE(good.output.find("\nside set surface: 16 sides, 31.2145 L0\n"), std::string::npos) << good.output;
  EXPECT_EQ(good.output.find("warning"), std::string::npos) << good.output;
  // Two bricks of 250 to 1.
  const std::vector<std::string> flat{ball,
                                      "--set",
                                      "Mesh/Type=Box",
                                      "--set",
                                      "Mesh/Box/Lower={0, 1}",
                                      "--set",
                                      "Mesh/Box/Lengths={500, 1}",
                                      "--set",
                                      "Mesh/Box/Divisions={2, 1}",
                                      "--set",
                                      "Interactions/Wall/Side Set=bottom",
                                      "--set",
                                      "Time Integrator/Time Step Control/Final Time=0.002",
                                      "--output",
                                      "flat"};
  const Outcome bad = ixos(flat, folder_);
  EXPECT_EQ(bad.status, 0) << bad.output;
  const std::string warning =
      "ixos: warning: the mesh has very bad cells: block \"body\", cell 1 at (125, 1.5) has an aspect ratio of 250\n";
  EXPECT_NE(bad.output.find(warning), std::string::npos) << bad.output;
  const std::string summary = contents(folder_ + "/flat/summary.json");
  EXPECT_NE(summary.find("\"largest_aspect_ratio\": 250.0"), std::string::npos) << summary;
  EXPECT_NE(summary.find("\"least_scaled_jacobian\": 1.0"), std::string::npos) << summary;
}

TEST_F(DriverTest, WarningsArePrintedOnceAndListedInTheSummary) {
  const std::vector<std::string> heavy{ball, "--set", "Materials/Ball/Density=1000"};
  std::vector<std::string> check = heavy, run = heavy;
  check.emplace_back("--check");
  run.insert(run.end(), {"--set", "Time Integrator/Time Step Control/Final Time=0.002", "--output", "heavy"});
  const std::string line = "ixos: warning: Materials/Ball: the density is 2e+12 kg/m^3, but known materials have 2 to";
  for (const auto& arguments : {check, run}) {
    const Outcome outcome = ixos(arguments, folder_);
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    const auto first = outcome.output.find(line);
    EXPECT_NE(first, std::string::npos) << outcome.output;
    EXPECT_EQ(outcome.output.find(line, first + 1), std::string::npos) << outcome.output;
  }
  const std::string summary = contents(folder_ + "/heavy/summary.json");
  EXPECT_NE(summary.find("\"name\": \"material\""), std::string::npos) << summary;
  EXPECT_NE(summary.find("\"name\": \"wave and run\""), std::string::npos) << summary;
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
    const Outcome outcome =
        shell("mpiexec -np " + std::to_string(ranks) + " " + quoted_driver() + " " + cell + " --output out", folder_);
    EXPECT_EQ(outcome.status, 0) << ranks << " ranks: " << outcome.output;
    EXPECT_TRUE(std::filesystem::exists(folder_ + "/out/fields.e." + std::to_string(ranks) + ".1"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/out/fields.e.2.0")) << "left from an earlier run";
  const Outcome outcome = shell(
      "mpiexec -np 4 " + quoted_driver() + " " + cell + " --output out --set 'Output/Fields Format=HDF5'", folder_);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_TRUE(std::filesystem::exists(folder_ + "/out/fields.e"));
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/out/fields.e.4.0")) << "left from an earlier run";
}

TEST_F(DriverTest, ExplainTellsWhatIsModelledAndWhatIsLeftOut) {
  const Outcome outcome = ixos({ball, "--explain"}, folder_);
  EXPECT_EQ(outcome.status, 0);
  for (const char* part : {"48 cells, 114 degrees of freedom", "Neo-Hooke", "Van der Waals", "linear solver Direct",
                           "Sets:\n  side set surface: 16 sides, 31.2145 L0\n", "node set center: 1 node\n",
                           "Left out, at no cost:\n  friction: obstacles act along their normals only",
                           "\n  damping: ", "Fields of nodes: displacement [L0], velocity [L0/T0]", "jacobian [-]"})
    EXPECT_NE(outcome.output.find(part), std::string::npos) << part << " in " << outcome.output;
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(DriverTest, ExplainNamesRefinementsAndTies) {
  const auto expect = [this](const std::string& scene, const std::string& part) {
    const Outcome outcome = ixos({scene, "--explain"}, folder_);
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_NE(outcome.output.find(part), std::string::npos) << part << " in " << outcome.output;
  };
  expect(std::string(IXOS_XML_DIRECTORY) + "/pillar-backing.xml",
         "Tie Joint: the nodes of side set \"pillar_top\" follow side set \"backing_bottom\"\n");
  expect(std::string(IXOS_TEST_DIRECTORY) + "/guide/refined-foot.xml",
         "Refine Underside: 1 level\nRefine Left Edge: 3 levels\n");
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
  const std::string version = ixos({"--version"}, folder_).output;
  if (version.find("KLU2 from: ") == std::string::npos) GTEST_SKIP() << "this version of Trilinos needs no repair";
  EXPECT_NE(version.find("KLU2 from: libixos"), std::string::npos) << version;
}

TEST_F(DriverTest, OpenBlasHasOneThreadUnlessTheUserSetsMore) {
  const std::string unset = "env -u OPENBLAS_NUM_THREADS -u OMP_NUM_THREADS ", version = quoted_driver() + " --version";
  const std::string text = shell(unset + version, folder_).output;
  if (text.find("Threads of OpenBLAS") == std::string::npos) GTEST_SKIP() << "BLAS is another library";
  EXPECT_NE(text.find("Threads of OpenBLAS: 1\n"), std::string::npos) << text;
  if (std::thread::hardware_concurrency() < 2) return;  // OpenBLAS has no more threads than the machine
  EXPECT_NE(shell(unset + "OPENBLAS_NUM_THREADS=2 " + version, folder_).output.find("OpenBLAS: 2\n"),
            std::string::npos);
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

TEST_F(DriverTest, ResultFilesKeepTheirContract) {
  ASSERT_EQ(
      ixos({ball, "--set", "Time Integrator/Time Step Control/Final Time=0.01", "--output", "out"}, folder_).status, 0);
  const std::string history = contents(folder_ + "/out/history.csv");
  EXPECT_EQ(history.substr(0, history.find('\n')),
            "step,time,time_step,kinetic_energy,elastic_energy,contact_energy,external_work,dissipated_energy,"
            "total_energy,linear_momentum_x,linear_momentum_y,angular_momentum_z,contact_force_x,contact_force_y,"
            "contact_measure,min_gap,newton_iterations,linear_iterations,wall_seconds");
  const std::string summary = contents(folder_ + "/out/summary.json");
  for (const char* key :
       {"status", "reason", "scheme", "end_time", "steps", "rejected_steps", "dofs", "elements", "ranks",
        "newton_iterations", "linear_iterations", "wall_seconds", "setup_seconds", "seconds_per_increment", "seconds",
        "peak_memory_bytes", "max_energy_error", "largest_energy", "max_force"})
    EXPECT_NE(summary.find("\"" + std::string(key) + "\":"), std::string::npos) << key;
  EXPECT_NE(summary.find("\"contacts\": {"), std::string::npos);
}

TEST_F(DriverTest, TwoRanksEndAlike) {
  const std::string run = "mpiexec -np 2 " + quoted_driver() + " " + ball;
  EXPECT_EQ(shell(run + " --set 'Time Integrator/Time Step Control/Final Time=0.01' --output out", folder_).status, 0);
  const Outcome refused = shell(run + " --set Mesh/Disk/Rings=0 --output two", folder_);
  EXPECT_EQ(refused.status, 2) << refused.output;
  const std::string said = "Mesh/Disk/Rings: 0 is not allowed";
  EXPECT_NE(refused.output.find(said), std::string::npos) << refused.output;
  EXPECT_EQ(refused.output.find(said), refused.output.rfind(said)) << "said by both ranks";
  // A file that only rank 0 opens: both ranks must hear of it.
  std::filesystem::create_directories(folder_ + "/three/history.csv");
  EXPECT_EQ(shell(run + " --output three --overwrite", folder_).status, 4);
}

TEST_F(DriverTest, AFailedStepIsExitStatusThreeWithResultsOnDisk) {
  const Outcome outcome = ixos({ball, "--set", "Nonlinear Solver/Maximum Iterations=1", "--output", "out"}, folder_);
  EXPECT_EQ(outcome.status, 3) << outcome.output;
  EXPECT_NE(outcome.output.find("Newton's iteration did not converge in 1 iterations"), std::string::npos);
  EXPECT_NE(contents(folder_ + "/out/summary.json").find("\"status\": \"diverged\""), std::string::npos);
  EXPECT_NE(contents(folder_ + "/out/history.csv").find("\n0,0,"), std::string::npos);
}

// The pillar snaps off in more than four iterations. The first command resumes and completes the run.
TEST_F(DriverTest, AFailedRunOffersToResumeWithOtherSettings) {
  const std::string pillar = std::string(IXOS_XML_DIRECTORY) + "/pillar.xml";
  const std::vector<std::string> short_form = {pillar,
                                               "--set",
                                               "Mesh/Box/Divisions={20, 8}",
                                               "--set",
                                               "Nonlinear Solver/Maximum Iterations=4",
                                               "--set",
                                               "Nonlinear Solver/Snap Iterations=0",
                                               "--output",
                                               "out"};
  const Outcome outcome = ixos(short_form, folder_);
  EXPECT_EQ(outcome.status, 3) << outcome.output;
  const std::string offer = "to resume with more iterations: ";
  const auto place = outcome.output.find(offer);
  ASSERT_NE(place, std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("to resume with shorter steps: "), std::string::npos);
  const auto begin = place + offer.size();
  const std::string command = outcome.output.substr(begin, outcome.output.find('\n', begin) - begin);
  EXPECT_EQ(command.find("Snap Iterations=0"), std::string::npos) << command;
  const Outcome resumed = shell(quoted_driver() + command.substr(command.find(' ')), folder_);
  EXPECT_EQ(resumed.status, 0) << resumed.output;
}

}  // namespace
}  // namespace ixos::test
