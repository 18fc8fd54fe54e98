// ixos-study as a process of its own: runs, resumption after kills, refusals.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "drivers/process.hpp"
#include "support/files.hpp"

namespace ixos {
namespace {

using test::contents;
using test::Outcome;
using test::shell;

const char* const scene = R"x(<ParameterList name="Block">
  <ParameterList name="Mesh"><Parameter name="Type" type="string" value="Box"/>
    <ParameterList name="Box"><Parameter name="Lengths" type="Array(double)" value="{3, 2}"/>
      <Parameter name="Divisions" type="Array(int)" value="{3, 2}"/></ParameterList></ParameterList>
  <ParameterList name="Materials"><ParameterList name="Rubber">
    <Parameter name="Density" type="double" value="1"/></ParameterList></ParameterList>
  <ParameterList name="Initial Conditions">
    <Parameter name="Velocity Gradient" type="Array(double)" value="{0.3, -1, 1, -0.2}"/></ParameterList>
  <ParameterList name="Time Integrator"><ParameterList name="Time Step Control">
    <Parameter name="Final Time" type="double" value="2"/>
    <Parameter name="Time Step" type="double" value="0.1"/></ParameterList></ParameterList>
  <ParameterList name="Output"><ParameterList name="Probes"><ParameterList name="P">
    <Parameter name="Point" type="Array(double)" value="{3, 2}"/></ParameterList></ParameterList></ParameterList>
</ParameterList>)x";

const char* const study = R"x(<ParameterList name="Test">
  <Parameter name="Scene" type="string" value="block.xml"/>
  <Parameter name="Jobs" type="int" value="2"/>
  <ParameterList name="Axes">
    <ParameterList name="Scheme"><Parameter name="Parameter" type="string" value="Time Integrator/Type"/>
      <Parameter name="Values" type="Array(string)" value="{Newmark, Energy-Momentum, Central Difference}"/></ParameterList>
    <ParameterList name="Time Step">
      <Parameter name="Parameter" type="string" value="Time Integrator/Time Step Control/Time Step"/>
      <Parameter name="Values" type="Array(string)" value="{0.2, 0.1, 0.05}"/></ParameterList>
  </ParameterList>
  <ParameterList name="Reference"><ParameterList name="Settings">
    <Parameter name="Time Integrator/Time Step Control/Time Step" type="double" value="0.002"/></ParameterList></ParameterList>
  <ParameterList name="Question"><Parameter name="Measure" type="string" value="error_position"/></ParameterList>
</ParameterList>)x";

class StudyDriverTest : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_ + "/block.xml") << scene;
    std::ofstream(folder_ + "/study.xml") << study;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  Outcome run(const std::string& arguments) const { return shell("'" IXOS_STUDY_DRIVER "' " + arguments, folder_); }
  /// Starts the study, and sends a signal once that many of its eleven runs have ended.
  Outcome signal_after(int runs, const std::string& results, const std::string& signal) const {
    return run("study.xml --output " + results + " & pid=$!; until [ $(ls " + results +
               "/runs/*/run.json 2> /dev/null | wc -l) -ge " + std::to_string(runs) +
               " ] || ! kill -0 $pid; do sleep 0.02; done; kill -" + signal + " $pid; wait $pid");
  }
  /// study.csv without the columns that clocks and memory make.
  std::string timeless(const std::string& results) const {
    std::istringstream csv(contents(folder_ + "/" + results + "/study.csv"));
    std::string text;
    for (std::string line; std::getline(csv, line);) {
      std::istringstream row(line);
      std::string cell;
      for (int c = 0; std::getline(row, cell, ','); ++c)
        if (c != 9 && c != 10 && c != 15) text += cell + ",";
      text += '\n';
    }
    return text;
  }
  std::string folder_ = test::scratch_folder();
};

TEST_F(StudyDriverTest, RunsEverythingOnceAndReports) {
  const Outcome first = run("study.xml --output out");
  ASSERT_EQ(first.status, 0) << first.output;
  EXPECT_NE(first.output.find("The most accurate run: ") == std::string::npos,
            first.output.find("The cheapest run within") == std::string::npos);
  for (const char* file : {"study.csv", "study.json", "report.html", "work-precision-position.png"})
    EXPECT_GT(std::filesystem::file_size(folder_ + "/out/" + file), 100U) << file;
  const std::string csv = contents(folder_ + "/out/study.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 10);
  // Halving the step quarters the error of a scheme of second order.
  std::map<std::string, double> error;
  std::istringstream rows(csv);
  for (std::string line; std::getline(rows, line);) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    if (cells[0] != "run") error[cells[0]] = std::stod(cells[8]);
  }
  for (const char* scheme : {"Newmark", "Energy-Momentum"})
    EXPECT_NEAR(error.at(std::string(scheme) + "_0.1") / error.at(std::string(scheme) + "_0.05"), 4, 0.8) << scheme;
  // The check of the reference takes twice its step, and half of its steps.
  EXPECT_NE(contents(folder_ + "/out/runs/reference/summary.json").find("\"steps\": 1000,"), std::string::npos);
  EXPECT_NE(contents(folder_ + "/out/runs/reference-check/summary.json").find("\"steps\": 500,"), std::string::npos);
  const std::string json = contents(folder_ + "/out/study.json");
  const auto own = json.find("\"error_position\": ", json.find("\"own_errors\""));
  ASSERT_NE(own, std::string::npos) << json;
  // The errors of steps h and 2 h differ by 3 parts of the error of h: here 3 (0.002 / 0.05)^2 of that of 0.05.
  EXPECT_NEAR(std::stod(json.substr(own + 18)) / error.at("Newmark_0.05"), 3 * 0.0016, 0.0016);
  EXPECT_NE(first.output.find("The reference's own error of the position is about "), std::string::npos);
  // Nothing is repeated: the records stay as they are.
  const auto written = std::filesystem::last_write_time(folder_ + "/out/runs/Newmark_0.1/run.json");
  const Outcome second = run("study.xml --output out");
  EXPECT_EQ(second.status, 0) << second.output;
  EXPECT_EQ(std::filesystem::last_write_time(folder_ + "/out/runs/Newmark_0.1/run.json"), written);
  EXPECT_EQ(contents(folder_ + "/out/study.csv"), csv);
  std::size_t reused = 0;
  for (auto at = second.output.find("(reused)"); at != std::string::npos; at = second.output.find("(reused)", at + 1))
    ++reused;
  EXPECT_EQ(reused, 11U) << second.output;
  // A changed scene is another one.
  std::string changed = scene;
  changed.replace(changed.find("value=\"2\""), 9, "value=\"1.8\"");
  std::ofstream(folder_ + "/block.xml") << changed;
  EXPECT_EQ(run("study.xml --output out").output.find("(reused)"), std::string::npos);
}

TEST_F(StudyDriverTest, AKilledStudyGoesOnAndEndsAlike) {
  ASSERT_EQ(run("study.xml --output whole --quiet").status, 0);
  for (int runs : {1, 3, 6}) {
    signal_after(runs, "pieces", "KILL");
    EXPECT_FALSE(std::filesystem::exists(folder_ + "/pieces/report.html")) << "killed too late";
  }
  ASSERT_EQ(run("study.xml --output pieces --quiet").status, 0);
  EXPECT_EQ(timeless("pieces"), timeless("whole"));
  // Told to end, it says how to go on.
  for (const char* signal : {"TERM", "HUP"}) {
    const Outcome told = signal_after(signal == std::string("TERM") ? 2 : 4, "other", signal);
    EXPECT_EQ(told.status, 5) << signal << told.output;
    EXPECT_NE(told.output.find("run the same command again to resume"), std::string::npos);
  }
  ASSERT_EQ(run("study.xml --output other --quiet").status, 0);
  EXPECT_EQ(timeless("other"), timeless("whole"));
}

TEST_F(StudyDriverTest, RecordsThatMakeNoSenseAreMadeAgain) {
  std::string text = study;
  const std::string values = "{0.2, 0.1, 0.05}";
  text.replace(text.find(values), values.size(), "{0.2}");
  const std::string schemes = "{Newmark, Energy-Momentum, Central Difference}";
  text.replace(text.find(schemes), schemes.size(), "{Newmark}");
  std::ofstream(folder_ + "/study.xml") << text;
  ASSERT_EQ(run("study.xml --output out --quiet").status, 0);
  const std::string whole = timeless("out");
  for (const char* record : {R"x({"scene": 5, "exit_status": "x", "version": [], "time_limit": {}})x", "["}) {
    std::ofstream(folder_ + "/out/runs/Newmark_0.2/run.json") << record;
    const Outcome outcome = run("study.xml --output out --quiet");
    EXPECT_EQ(outcome.status, 0) << record << outcome.output;
    EXPECT_EQ(timeless("out"), whole) << record;
  }
}

/// Returns the study with one run, which has these settings in place of the schemes.
std::string study_of(const std::string& name, const std::string& settings) {
  std::string text = study;
  const std::string values = "{0.2, 0.1, 0.05}";
  text.replace(text.find(values), values.size(), "{0.2}");
  const std::string schemes = R"x(<Parameter name="Parameter" type="string" value="Time Integrator/Type"/>
      <Parameter name="Values" type="Array(string)" value="{Newmark, Energy-Momentum, Central Difference}"/>)x";
  text.replace(text.find(schemes), schemes.size(),
               "<ParameterList name=\"Settings\"><ParameterList name=\"" + name + "\">" + settings +
                   "</ParameterList></ParameterList>");
  return text;
}

/// Returns the study with the results in the folder "alone" as its reference.
std::string compared_with_a_folder(std::string text) {
  const auto start = text.find("<ParameterList name=\"Settings\">", text.find("<ParameterList name=\"Reference\">"));
  const auto end = text.find("</ParameterList></ParameterList>\n  <ParameterList name=\"Question\">");
  return text.replace(start, end - start + 16, "<Parameter name=\"Folder\" type=\"string\" value=\"alone\"/>");
}

TEST_F(StudyDriverTest, ACheckThatFailsIsTold) {
  std::string text = study_of("N", "");
  const std::string reference = "<ParameterList name=\"Reference\">";
  text.replace(text.find(reference), reference.size(), reference + R"x(<ParameterList name="Check Settings">
      <Parameter name="Nonlinear Solver/Maximum Iterations" type="int" value="1"/></ParameterList>)x");
  std::ofstream(folder_ + "/study.xml") << text;
  const Outcome outcome = run("study.xml --output out");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("The reference's own error is unknown: a run with Nonlinear Solver/Maximum "
                                "Iterations=1 did not reach its end: "),
            std::string::npos)
      << outcome.output;
}

TEST_F(StudyDriverTest, FailuresAreResults) {
  // One iteration is never enough for a nonlinear step.
  std::ofstream(folder_ + "/study.xml") << study_of(
      "hasty", R"x(<Parameter name="Nonlinear Solver/Maximum Iterations" type="int" value="1"/>)x");
  const Outcome outcome = run("study.xml --output out");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  const std::string csv = contents(folder_ + "/out/study.csv");
  EXPECT_NE(csv.find("hasty_0.2,hasty,0.2,diverged,"), std::string::npos) << csv;
  EXPECT_NE(outcome.output.find("No run that reached its end"), std::string::npos) << outcome.output;
}

TEST_F(StudyDriverTest, ATimeLimitEndsARunThatWouldNotEnd) {
  // The time limit would hold for a reference that the study runs itself.
  ASSERT_EQ(shell("'" IXOS_DRIVER "' block.xml --quiet --output alone", folder_).status, 0);
  std::string text = compared_with_a_folder(
      study_of("endless", R"x(<Parameter name="Time Integrator/Time Step Control/Final Time" type="double" value="1e9"/>
        <Parameter name="Initial Conditions/Velocity Gradient" type="Array(double)" value="{0, 0, 0, 0}"/>)x"));
  text.insert(text.find("<ParameterList name=\"Axes\">"),
              R"x(<Parameter name="Time Limit" type="double" value="1"/>)x");
  std::ofstream(folder_ + "/study.xml") << text;
  const Outcome outcome = run("study.xml --output out");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  const std::string csv = contents(folder_ + "/out/study.csv");
  EXPECT_NE(csv.find("endless_0.2,endless,0.2,failed,not finished after the time limit of 1 s,"), std::string::npos)
      << csv;
  EXPECT_NE(outcome.output.find("No run that reached its end"), std::string::npos) << outcome.output;
}

TEST_F(StudyDriverTest, BadStudiesAreRefused) {
  const auto refused = [&](const std::string& arguments, int status, const std::string& message) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, status) << outcome.output;
    EXPECT_NE(outcome.output.find(message), std::string::npos) << outcome.output;
    EXPECT_FALSE(std::filesystem::exists(folder_ + "/out"));
  };
  refused("none.xml --output out", 2, "none.xml: the scene file cannot be read");
  refused("study.xml --output out --jobs", 2, "--help lists the options");
  std::string text = study;
  text.replace(text.find("Newmark"), 7, "Newmrak");
  std::ofstream(folder_ + "/bad.xml") << text;
  refused("bad.xml --output out", 2, "run Newmrak_0.2: Time Integrator/Type: \"Newmrak\" does not exist");
  std::ofstream(folder_ + "/file") << "";
  refused("study.xml --output file/out", 4, "the results folder cannot be used");
  refused("", 0, "ixos-study xml/ball-study.xml");
  refused("study.xml --list", 0, "Newmark_0.2: Time Integrator/Type=Newmark");
}

TEST_F(StudyDriverTest, ResultsOfAnotherStudyStay) {
  std::string small = study;
  small.replace(small.find("{0.2, 0.1, 0.05}"), 16, "{0.2}");
  std::ofstream(folder_ + "/study.xml") << small;
  ASSERT_EQ(run("study.xml --output out --quiet").status, 0);
  const std::string table = contents(folder_ + "/out/study.csv");
  std::filesystem::copy(folder_ + "/block.xml", folder_ + "/other.xml");
  small.replace(small.find("block.xml"), 9, "other.xml");
  std::ofstream(folder_ + "/other-study.xml") << small;
  const Outcome refused = run("other-study.xml --output out");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.output.find("out: holds the results of the study \"Test\" of "), std::string::npos)
      << refused.output;
  EXPECT_EQ(contents(folder_ + "/out/study.csv"), table);
  EXPECT_EQ(run("study.xml --output out --quiet").status, 0) << "Ixos refuses the same study";
  EXPECT_EQ(run("other-study.xml --output out --overwrite --quiet").status, 0);
}

TEST_F(StudyDriverTest, AReferenceThatFailsEndsTheStudy) {
  std::string text = study;
  text.replace(text.find("value=\"0.002\""), 13, "value=\"5\"");
  text.replace(text.find("<ParameterList name=\"Axes\">"), 0,
               "<ParameterList name=\"Common\"><Parameter name=\"Nonlinear Solver/Maximum Iterations\" type=\"int\" "
               "value=\"1\"/></ParameterList>");
  std::ofstream(folder_ + "/study.xml") << text;
  const Outcome outcome = run("study.xml --output out");
  EXPECT_EQ(outcome.status, 3) << outcome.output;
  EXPECT_NE(outcome.output.find("the reference did not reach its end: diverged"), std::string::npos) << outcome.output;
}

TEST_F(StudyDriverTest, ColumnsThatOnlySomeRunsHaveDoNoHarm) {
  std::string text = study;
  const std::string values = "<Parameter name=\"Values\" type=\"Array(string)\" value=\"{0.2, 0.1, 0.05}\"/>";
  text.replace(text.find(values), values.size(), "<Parameter name=\"Values\" type=\"Array(string)\" value=\"{0.2}\"/>");
  text.replace(text.find("<ParameterList name=\"Axes\">"), 0,
               "<ParameterList name=\"Common\"><Parameter name=\"Output/Probes/Q/Point\" type=\"Array(double)\" "
               "value=\"{0, 2}\"/></ParameterList>");
  std::ofstream(folder_ + "/study.xml") << text;
  ASSERT_EQ(run("study.xml --output out --quiet").status, 0);
  // With the results of a run without that probe as the reference.
  ASSERT_EQ(shell("'" IXOS_DRIVER "' block.xml --quiet --output alone", folder_).status, 0);
  std::ofstream(folder_ + "/study.xml") << compared_with_a_folder(text);
  const Outcome outcome = run("study.xml --output out");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("error_position"), std::string::npos) << outcome.output;
  // A column that the reference has not is refused.
  std::string bad = text;
  bad.replace(bad.find("<ParameterList name=\"Question\">"), 0,
              "<ParameterList name=\"Errors\"><Parameter name=\"Position\" type=\"Array(string)\" "
              "value=\"{P_uz}\"/></ParameterList>");
  std::ofstream(folder_ + "/study.xml") << bad;
  const Outcome refused = run("study.xml --output out");
  EXPECT_EQ(refused.status, 2) << refused.output;
  EXPECT_NE(refused.output.find("did you mean \"P_u"), std::string::npos) << refused.output;
}

TEST_F(StudyDriverTest, TheDocumentationIsThatOfTheValidators) {
  EXPECT_EQ(run("--parameters").output, contents(IXOS_DOCS_DIRECTORY "/study-parameters.md"));
}

TEST_F(StudyDriverTest, StudiesInXmlAreSound) {
  for (const char* name :
       {"ball-study", "ball-adaptive-study", "strip-study", "strip-options-study", "rate-peel-study"})
    EXPECT_EQ(run(std::string("'" IXOS_XML_DIRECTORY "/") + name + ".xml' --list").status, 0) << name;
}

}  // namespace
}  // namespace ixos
