// File names that a shell would take for something else: none reaches one. Each would leave a file "touched".
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "drivers/process.hpp"
#include "support/files.hpp"

namespace ixos {
namespace {

using test::contents;
using test::Outcome;

const char* const scene = R"x(<ParameterList name="$(touch touched)">
  <ParameterList name="Mesh"><Parameter name="Type" type="string" value="Box"/></ParameterList>
  <ParameterList name="Materials"><ParameterList name="`touch touched`"/></ParameterList>
  <ParameterList name="Histories"><ParameterList name="; touch touched"/></ParameterList>
  <ParameterList name="Time Integrator"><ParameterList name="Time Step Control">
    <Parameter name="Final Time" type="double" value="0.02"/>
    <Parameter name="Time Step" type="double" value="0.01"/></ParameterList></ParameterList>
</ParameterList>)x";

const std::vector<std::string> names{"'; touch touched; '", "$(touch touched)",  "`touch touched`",
                                     "a\ntouch touched\n",  "\"; touch touched", "a b & touch touched #",
                                     "| touch touched",     "\xff\x1b[2J",       "*"};

class HostileNamesTest : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ + "/" + name) << text; }
  Outcome study(const std::vector<std::string>& arguments) const {
    return test::program(IXOS_STUDY_DRIVER, arguments, folder_);
  }
  void expect_untouched() const {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_))
      EXPECT_NE(entry.path().filename(), "touched") << entry.path();
  }
  std::string folder_ = test::scratch_folder();
};

TEST_F(HostileNamesTest, OfScenesAndResultsReachNoShell) {
  for (const std::string& name : names) {
    write(name + ".xml", scene);
    const Outcome outcome = test::ixos({name + ".xml", "--output", name}, folder_);
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_TRUE(std::filesystem::exists(folder_ + "/" + name + "/history.csv")) << name;
    const Outcome mesh = test::ixos({name + ".xml", "--write-mesh", name + ".e"}, folder_);
    EXPECT_EQ(mesh.status, 0) << mesh.output;
    const Outcome restart =
        test::ixos({name + ".xml", "--output", name + "2", "--restart", name + "/checkpoint.h5"}, folder_);
    EXPECT_EQ(restart.status, 0) << restart.output;
    const Outcome missing = test::ixos({name + ".gone"}, folder_);
    EXPECT_EQ(missing.status, 2);
    const Outcome check =
        test::ixos({name + ".xml", "--check", "--output", name, "--restart", name + "/checkpoint.h5"}, folder_);
    EXPECT_EQ(check.status, 0) << check.output;
    for (const Outcome& said : {outcome, mesh, restart, missing, check})
      EXPECT_EQ(said.output.find('\x1b'), std::string::npos) << "a terminal would obey";
  }
  expect_untouched();
}

TEST_F(HostileNamesTest, AMeshReachesNoShell) {
  ASSERT_EQ(
      (write("scene.xml", scene), test::ixos({"scene.xml", "--write-mesh", "$(touch touched).e"}, folder_).status), 0);
  const Outcome outcome = test::ixos(
      {"scene.xml", "--check", "--set", "Mesh/Type=Exodus", "--set", "Mesh/Exodus/File=$(touch touched).e"}, folder_);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  const Outcome pipe = test::ixos(
      {"scene.xml", "--check", "--set", "Mesh/Type=Exodus", "--set", "Mesh/Exodus/File=|touch touched"}, folder_);
  EXPECT_EQ(pipe.status, 2) << pipe.output;
  expect_untouched();
}

TEST_F(HostileNamesTest, ALeadingDashIsAnOptionUntilAPathSaysOtherwise) {
  write("-rf.xml", scene);
  EXPECT_EQ(test::ixos({"-rf.xml"}, folder_).status, 2);
  const Outcome outcome = test::ixos({"./-rf.xml", "--output", "./-o"}, folder_);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
}

TEST_F(HostileNamesTest, OfStudiesTheirScenesAndLabelsReachNoShell) {
  for (const std::string& name : {names[0], names[1], names[3]}) {
    write(name + ".xml", scene);
    std::string in_xml = name;
    for (auto at = in_xml.find('\n'); at != std::string::npos; at = in_xml.find('\n')) in_xml.replace(at, 1, "&#10;");
    const std::string text = R"x(<ParameterList name="`touch touched`">
      <Parameter name="Scene" type="string" value=")x" +
                             in_xml + R"x(.xml"/>
      <ParameterList name="Axes"><ParameterList name="$(touch touched)"><ParameterList name="Settings">
        <ParameterList name="; touch touched"><Parameter name="Nonlinear Solver/NOX/Status Tests/Note" type="string"
           value="$(touch touched)"/>
        </ParameterList></ParameterList></ParameterList></ParameterList>
      <ParameterList name="Reference"><ParameterList name="Settings">
        <Parameter name="Nonlinear Solver/NOX/Status Tests/Note" type="string" value="'; touch touched; '"/></ParameterList></ParameterList>
      </ParameterList>)x";
    write("study " + name, text);
    const Outcome outcome = study({"study " + name, "--output", "results of " + name});
    if (name.find('\n') != std::string::npos) {  // no string of a study holds a line end
      EXPECT_EQ(outcome.status, 2) << outcome.output;
      continue;
    }
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_TRUE(std::filesystem::exists(folder_ + "/results of " + name + "/report.html"));
    EXPECT_TRUE(std::filesystem::exists(folder_ + "/results of " + name + "/runs/touch-touched/history.csv"));
  }
  expect_untouched();
}

}  // namespace
}  // namespace ixos
