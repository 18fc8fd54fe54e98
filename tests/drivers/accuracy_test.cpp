// The command ixos --accuracy: what it writes and tells, and what it refuses.
#include "drivers/driver_test.hpp"
#include "support/files.hpp"

namespace ixos {
namespace {

using test::contents;
using test::Outcome;
using test::shell;

const std::string oscillator = std::string(IXOS_TEST_DIRECTORY) + "/verification/oscillator.xml";
const std::string static_scheme = "Time Integrator/Type=Static";

class AccuracyDriverTest : public test::DriverTest {
 protected:
  Outcome run(const std::vector<std::string>& arguments) const { return test::ixos(arguments, folder_); }
  static bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
  std::string summary() const { return contents(folder_ + "/out/summary.json"); }
};

TEST_F(AccuracyDriverTest, TellsTheRunsAndTheErrors) {
  const Outcome outcome = run({oscillator, "--accuracy", "1%", "--output", "out"});
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  for (const char* part :
       {"Run 1: local error 0.01 L0: ", "Run 3: ", "The accuracy 1 % is kept by the time steps; the mesh, ",
        "\n  final P_ux = ", "not the mesh; for the mesh, use ixos-study --advise", "Results are in out"})
    EXPECT_TRUE(has(outcome.output, part)) << part << " in " << outcome.output;
  for (const char* part : {"\"status\": \"completed\"", "\"asked\": 0.01", "\"kept\": true",
                           "\"quantity\": \"peak P_ux\"", "Adaptive/Maximum Time Step="})
    EXPECT_TRUE(has(summary(), part)) << part << " in " << summary();
  EXPECT_TRUE(std::filesystem::exists(folder_ + "/out/checkpoint.h5")) << "the results are those of any run";
}

TEST_F(AccuracyDriverTest, APlainRunOfTheEffectiveSceneRepeatsTheLastOne) {
  ASSERT_EQ(run({oscillator, "--accuracy", "1%", "--output", "out"}).status, 0);
  ASSERT_EQ(run({"out/effective.xml", "--output", "again"}).status, 0);
  const std::string rows = "cut -d, -f1-10";  // the clock is not among them
  EXPECT_EQ(shell(rows + " out/history.csv", folder_).output, shell(rows + " again/history.csv", folder_).output);
  EXPECT_FALSE(has(contents(folder_ + "/again/summary.json"), "\"accuracy\"")) << "nobody asked for it";
}

TEST_F(AccuracyDriverTest, TwoRanksFindTheSame) {
  ASSERT_EQ(run({oscillator, "--accuracy", "1%", "--output", "out", "--set", "Mesh/Box/Divisions={4, 2}"}).status, 0);
  const Outcome two = shell("mpirun -np 2 " + test::quoted_driver() + " '" + oscillator +
                                "' --accuracy 1% --output two --set 'Mesh/Box/Divisions={4, 2}'",
                            folder_);
  ASSERT_EQ(two.status, 0) << two.output;
  const auto after = [](const std::string& text) { return std::stod(text.substr(text.find("\"value\": ") + 9)); };
  EXPECT_NEAR(after(contents(folder_ + "/two/summary.json")), after(summary()), 1e-9);
}

TEST_F(AccuracyDriverTest, TheSameCommandReplacesItsResultsAndAnotherSceneDoesNot) {
  ASSERT_EQ(run({oscillator, "--accuracy", "1%", "--output", "out"}).status, 0);
  const Outcome again = run({oscillator, "--accuracy", "0.1%", "--output", "out"});
  EXPECT_EQ(again.status, 0) << again.output;
  EXPECT_TRUE(has(again.output, "out: these runs replace the results of an earlier --accuracy")) << again.output;
  const Outcome other = run({oscillator, "--accuracy", "1%", "--output", "out", "--set", "Materials/Cell/Density=2"});
  EXPECT_EQ(other.status, 2) << other.output;
  EXPECT_TRUE(has(other.output, "out: the folder holds results of another scene")) << other.output;
}

TEST_F(AccuracyDriverTest, AnAccuracyThatIsNotReachedIsNoSuccess) {
  // After half a period the displacement is 0, and so its relative error is not known.
  const Outcome missed = run({oscillator, "--accuracy", "1%", "--output", "missed", "--set",
                              "Time Integrator/Time Step Control/Final Time=1.8137993642342178", "--set",
                              "Output/Quantities={final P_ux}"});
  EXPECT_EQ(missed.status, 3) << missed.output;
  EXPECT_TRUE(has(missed.output, "ixos: The accuracy 1 % is not reached, limited by: ")) << missed.output;
  EXPECT_TRUE(has(contents(folder_ + "/missed/summary.json"), "\"kept\": false"));
}

TEST_F(AccuracyDriverTest, ChecksAndExplainsTheFirstRun) {
  const Outcome explained = run({oscillator, "--accuracy", "1%", "--explain"});
  EXPECT_EQ(explained.status, 0) << explained.output;
  EXPECT_TRUE(has(explained.output, "in adaptive steps")) << explained.output;
  EXPECT_EQ(run({oscillator, "--accuracy", "1%", "--check"}).status, 0);
  EXPECT_EQ(run({oscillator, "--accuracy", "1%", "--check", "--set", static_scheme}).status, 2);
}

TEST_F(AccuracyDriverTest, RefusesWhatItCannotDo) {
  const auto refused = [this](std::vector<std::string> arguments, const std::string& message) {
    arguments.insert(arguments.end(), {"--output", "out"});
    expect_refused(2, arguments, message);
  };
  refused({test::ball, "--accuracy", "1%", "--set", "Output/Quantities={}"},
          "Output/Quantities: --accuracy needs quantities; name them in the scene");
  refused({oscillator, "--accuracy", "0"}, "--accuracy: \"0\" is no tolerance");
  refused({oscillator, "--accuracy", "-1%"}, "is no tolerance");
  refused({oscillator, "--accuracy", "1%", "--set", static_scheme}, "\"Static\" has load steps");
  refused({oscillator, "--accuracy", "1%", "--restart", "x"}, "--accuracy does not go with --restart");
  refused({oscillator, "--accuracy", "1%", "--verify-restart"}, "--accuracy excludes --verify-restart");
  refused({oscillator, "--accuracy", "1%", "--write-mesh", "x.e"}, "--accuracy excludes --write-mesh");
  refused({"--accuracy", "1%"}, "a scene is needed");
  refused({oscillator, "--accuracy", "1%", "--set", "Output/Quantities={work [6, 9]}"}, "the window holds no rows");
  for (const char* accuracy : {"--quiet", "--accuracy=1%"})  // with and without
    refused({oscillator, accuracy, "--set", "Output/Quantities={peak P_uz}"},
            "Output/Quantities: \"peak P_uz\": column \"P_uz\" does not exist; did you mean \"P_ux\"?");
}

TEST_F(AccuracyDriverTest, AQuantityWithoutAValueIsBadInput) {
  const Outcome outcome =
      run({oscillator, "--accuracy", "1%", "--output", "out", "--set", "Output/Quantities={time of P_ux above 5}"});
  EXPECT_EQ(outcome.status, 2) << outcome.output;
  EXPECT_TRUE(has(outcome.output, "cannot be judged: \"time of P_ux above 5\": the column never passes"))
      << outcome.output;
}

}  // namespace
}  // namespace ixos
