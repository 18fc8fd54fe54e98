// Study files, tables read back, and the files of results.
#include "study/compare/study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "study/common/history_table.hpp"
#include "study/compare/study_result.hpp"
#include "support/files.hpp"
#include "test_folders.hpp"

namespace ixos {
namespace {

using test::contents;

class StudyTest : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string write(const std::string& name, const std::string& text) const {
    const std::string path = folder_ + "/" + name;
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    std::ofstream(path) << text;
    return path;
  }
  /// A study of the ball with two schemes and two steps, with a change of its text.
  std::string study(const std::string& from = "", const std::string& to = "") const {
    std::string text = R"x(<ParameterList name="Test">
  <Parameter name="Scene" type="string" value=")x" IXOS_XML_DIRECTORY R"x(/ball.xml"/>
  <ParameterList name="Common">
    <Parameter name="Mesh/Disk/Center" type="Array(double)" value="{0, 8}"/>
  </ParameterList>
  <ParameterList name="Axes">
    <ParameterList name="Scheme">
      <ParameterList name="Settings">
        <ParameterList name="N"><Parameter name="Time Integrator/Type" type="string" value="Newmark"/></ParameterList>
        <ParameterList name="A, exact">
          <Parameter name="Time Integrator/Type" type="string" value="Average Vector Field"/>
          <Parameter name="Time Integrator/Average Vector Field/Interaction Points" type="int" value="0"/>
        </ParameterList>
      </ParameterList>
    </ParameterList>
    <ParameterList name="Time Step">
      <Parameter name="Parameter" type="string" value="Time Integrator/Time Step Control/Time Step"/>
      <Parameter name="Values" type="Array(string)" value="{0.01, 0.001}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Reference">
    <ParameterList name="Settings"><Parameter name="Time Integrator/Type" type="string" value="Newmark"/></ParameterList>
  </ParameterList>
</ParameterList>)x";
    if (!from.empty()) {
      EXPECT_NE(text.find(from), std::string::npos) << from;
      text.replace(text.find(from), from.size(), to);
    }
    return write("study.xml", text);
  }
  void expect_refused(const std::string& from, const std::string& to, const std::string& message) const {
    try {
      read_study(study(from, to));
      ADD_FAILURE() << "accepted: " << to;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).rfind(folder_ + "/study.xml: ", 0), 0U) << error.what();
    }
  }
  std::string folder_ = testing::TempDir() + "study";
};

TEST_F(StudyTest, EveryCombinationIsARun) {
  const Study read = read_study(study());
  EXPECT_EQ(read.name, "Test");
  ASSERT_EQ(read.runs.size(), 4U);
  EXPECT_EQ(read.runs[0].name, "N_0.01");
  EXPECT_EQ(read.runs[3].name, "A-exact_0.001");
  EXPECT_EQ(read.runs[3].labels, (std::vector<std::string>{"A, exact", "0.001"}));
  EXPECT_EQ(read.runs[3].settings.size(), 4U);
  EXPECT_EQ(read.runs[3].settings[3], "Time Integrator/Time Step Control/Time Step=0.001");
  EXPECT_EQ(read.question.connect, "Time Step");
  const std::string scene = scene_text(read, read.runs[3].settings);
  EXPECT_NE(scene.find("Average Vector Field"), std::string::npos);
  EXPECT_NE(scene, scene_text(read, read.runs[1].settings));
}

TEST_F(StudyTest, AnAxisMayChooseALaw) {
  const std::string steps = R"x(value="Time Integrator/Time Step Control/Time Step"/>
      <Parameter name="Values" type="Array(string)" value="{0.01, 0.001}"/>)x";
  const std::string laws = R"x(value="Interactions/Wall/Law"/>
      <Parameter name="Values" type="Array(string)" value="{Van der Waals, Morse}"/>)x";
  const Study read = read_study(study(steps, laws));
  ASSERT_EQ(read.runs.size(), 4U);
  // The scene has parameters of the Van der Waals law.
  EXPECT_NE(scene_text(read, read.runs[0].settings).find("Gamma L"), std::string::npos);
  const std::string morse = scene_text(read, read.runs[1].settings);
  EXPECT_NE(morse.find("\"Morse\""), std::string::npos) << morse;
  EXPECT_EQ(morse.find("Gamma L"), std::string::npos) << morse;
}

TEST_F(StudyTest, TheReferenceIsCheckedWithTwiceItsTimeStep) {
  const std::string settings =
      R"x(<ParameterList name="Settings"><Parameter name="Time Integrator/Type" type="string" value="Newmark"/>)x";
  const std::string path = "Time Integrator/Time Step Control/";
  const auto check = [&](const std::string& more) { return read_study(study(settings, settings + more)).check; };
  const auto parameter = [](const std::string& name, const std::string& type, const std::string& value) {
    return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
  };
  EXPECT_EQ(check(parameter(path + "Time Step", "double", "0.003")).settings, Assignments{path + "Time Step=0.006"});
  EXPECT_EQ(check("").description, "a run with twice its time step");
  // 0.004 T0 in the scene's unit of time.
  EXPECT_EQ(check(parameter(path + "Time Step", "string", "2 ps")).settings, Assignments{path + "Time Step=0.004"});
  const ReferenceCheck adaptive =
      check(parameter(path + "Type", "string", "Adaptive") + parameter(path + "Adaptive/Tolerance", "double", "0.01"));
  EXPECT_TRUE(adaptive.settings.empty());
  EXPECT_NE(adaptive.description.find("its time steps are not fixed"), std::string::npos) << adaptive.description;
  const std::string off = parameter("Check", "bool", "false");
  const std::string coarser = "<ParameterList name=\"Check Settings\">" +
                              parameter("Nonlinear Solver/Tolerance", "double", "0.001") + "</ParameterList>";
  const std::string reference = "<ParameterList name=\"Reference\">";
  EXPECT_EQ(read_study(study(reference, reference + off)).check.description, "Reference/Check is false");
  const ReferenceCheck given = read_study(study(reference, reference + coarser)).check;
  EXPECT_EQ(given.settings, Assignments{"Nonlinear Solver/Tolerance=0.001"});
  EXPECT_EQ(given.description, "a run with Nonlinear Solver/Tolerance=0.001");
  expect_refused(reference, reference + off + coarser, "Reference: Check Settings need Settings, not Folder");
}

TEST_F(StudyTest, BadStudiesAreRefused) {
  expect_refused("<ParameterList name=\"Common\">",
                 "<ParameterList name=\"Common\">"
                 "<Parameter name=\"Interactions/Wall/Morse/Strength\" type=\"double\" value=\"0.1\"/>",
                 "run reference: Interactions/Wall: \"Morse\" belongs to Law \"Morse\", but Law is \"Van der Waals\"");
  expect_refused("ball.xml", "bal.xml", "bal.xml: the scene file cannot be read");
  expect_refused("value=\"Newmark\"", "value=\"Newmrak\"",
                 "run N_0.01: Time Integrator/Type: \"Newmrak\" does not exist");
  expect_refused("{0.01, 0.001}", "{0.01, x}", "run N_x: --set Time Integrator/Time Step Control/Time Step");
  expect_refused("{0.01, 0.001}", "{0.01, -1}", "-1 is not allowed");
  expect_refused("{0.01, 0.001}", "{0.01, 0.01}", "\"0.01\" is given twice");
  expect_refused("{0.01, 0.001}", "{}", "Axes/Time Step: give either Parameter and Values, or Settings");
  expect_refused("Time Step Control/Time Step\"", "Time Step Control/Tim Step\"", "did you mean \"Time Step\"?");
  expect_refused("name=\"A, exact\"", "name=\"N\"", "N");
  expect_refused("name=\"A, exact\"", "name=\"N!\"", "give the folder name");
  expect_refused("<ParameterList name=\"Scheme\">", "<ParameterList name=\"steps\">", "this is the name of a column");
  expect_refused("<ParameterList name=\"Scheme\">", "<ParameterList name=\"peak_error\">",
                 "this is the name of a column");
  expect_refused("<ParameterList name=\"Reference\">",
                 "<ParameterList name=\"Question\"><Parameter name=\"Measure\" type=\"string\" "
                 "value=\"peak\"/></ParameterList><ParameterList name=\"Reference\">",
                 "\"work_error\"");
  expect_refused("name=\"Axes\"", "name=\"Axis\"", "did you mean \"Axes\"?");
  expect_refused("<ParameterList name=\"Reference\">",
                 "<ParameterList name=\"Errors\"/><ParameterList name=\"Reference\">"
                 "<Parameter name=\"Folder\" type=\"string\" value=\"x\"/>",
                 "give either Folder or Settings");
  expect_refused("<ParameterList name=\"Reference\">",
                 "<ParameterList name=\"Question\"><Parameter name=\"Connect\" "
                 "type=\"string\" value=\"Time Stop\"/></ParameterList><ParameterList name=\"Reference\">",
                 "did you mean \"Time Step\"?");
  expect_refused("<ParameterList name=\"Common\">",
                 "<Parameter name=\"Jobs\" type=\"int\" value=\"0\"/>"
                 "<ParameterList name=\"Common\">",
                 "Jobs: 0 is not allowed");
  std::string many;
  for (int i = 1; i < 6000; ++i) many += (i > 1 ? ", " : "") + std::to_string(i);
  expect_refused("{0.01, 0.001}", "{" + many + "}", "more than 10000 runs");
  EXPECT_THROW(read_study(folder_ + "/none.xml"), InputError);
}

TEST_F(StudyTest, StudiesOutOfProportionAreRefused) {
  const auto axes = [](int count, const std::string& values) {
    std::string text;
    for (int i = 0; i < count; ++i)
      text += "<ParameterList name=\"axis" + std::to_string(i) +
              "\"><Parameter name=\"Parameter\" type=\"string\" value=\"Units/Time\"/><Parameter name=\"Values\" "
              "type=\"Array(string)\" value=\"" +
              values + "\"/></ParameterList>";
    return "<ParameterList name=\"Axes\">" + text;
  };
  expect_refused("<ParameterList name=\"Axes\">", axes(10000, "{value}"), "give the folder name");
  expect_refused("<ParameterList name=\"Axes\">", axes(6, "{1,2,3,4,5,6,7,8,9}"), "Axes: more than 10000 runs");
  std::string many, common;
  for (int i = 0; i < 1000; ++i) {
    many += (i > 0 ? "," : "") + std::to_string(i);
    common += "<Parameter name=\"Linear Solver/" + std::to_string(i) + "\" type=\"int\" value=\"1\"/>";
  }
  expect_refused("</ParameterList>\n  <ParameterList name=\"Axes\">",
                 common + "</ParameterList>" + axes(1, "{" + many + "}"),
                 "Axes: more than 1000000 settings of all runs together");
}

TEST_F(StudyTest, TablesReadBack) {
  const HistoryTable table(write("a.csv", "time,x\n0,1\n1,\n2,5e-3\n"));
  EXPECT_EQ(table.rows(), 3U);
  EXPECT_TRUE(std::isnan(table.column("x")[1]));
  EXPECT_EQ(table.column("x")[2], 5e-3);
  EXPECT_THROW(table.column("y"), InputError);
  EXPECT_THROW(HistoryTable(folder_ + "/none.csv"), FileError);
  EXPECT_THROW(HistoryTable(write("b.csv", "time,x\n0\n")), FileError);
  EXPECT_THROW(HistoryTable(write("c.csv", "time,x\n0,1x\n")), FileError);
  EXPECT_THROW(HistoryTable(write("d.csv", "x,x\n0,1\n")), FileError);
  EXPECT_THROW(HistoryTable(write("e.csv", "time,x\n")), FileError) << "no rows";
  EXPECT_THROW(HistoryTable(write("f.csv", std::string("time,x\n0,1\0x\n", 13))), FileError) << "a zero byte";
  EXPECT_EQ(interpolated({0, 1, 3}, {0, 2, 4}, 2), 3);
  EXPECT_EQ(interpolated({0, 1, 3}, {0, 2, 4}, 3), 4);
  EXPECT_TRUE(std::isnan(interpolated({0, 1, 3}, {0, 2, 4}, 3.1)));
}

StudyResult outcome(const std::string& name, double cost, double error, const std::string& status = "completed") {
  StudyResult result;
  result.run = {name, {name}, {"A/B=" + name}};
  result.status = status;
  result.wall_seconds = cost;
  result.errors.force = error;
  return result;
}

TEST_F(StudyTest, ResultsAreWrittenAsReadersNeedThem) {
  Study study;
  study.name = "Test";
  study.axes = {{"Case", {{"a", {}}, {"b, \"c\"", {}}}}};
  study.question = {"Case", "wall_seconds", "error_force", 0.05, 0};
  StudyResult odd = outcome("b", 2, 0.3, "diverged");
  odd.run.labels = {"b, \"c\""};
  odd.reason = "because";
  StudyResult first = outcome("a", 1, 0.2);
  first.errors.peak = 0.03;
  first.errors.work = 0.5;
  first.errors.peak_force = 1.25;
  first.errors.external_work = -4;
  ReferenceQuality reference;
  reference.own.force = 0.001;
  reference.origin = "a run with twice its time step";
  reference.notes["error_position"] = "It does not move.";
  write_study(study, {first, odd}, reference, folder_, "ixos-study x", "1");
  const std::string csv = contents(folder_ + "/study.csv");
  EXPECT_NE(csv.find("\na,a,completed,,,,0.2,,1,0,0,0,0,0,0,0,0.03,0.5,1.25,-4\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\nb,\"b, \"\"c\"\"\",diverged,because,,,,,2,"), std::string::npos) << csv;
  const std::string json = contents(folder_ + "/study.json");
  EXPECT_NE(json.find("\"error_force\": [\n      \"a\"\n    ]"), std::string::npos) << json;
  EXPECT_EQ(
      csv.substr(0, csv.find('\n')),
      "run,Case,status,reason,error_energy,error_momentum,error_force,error_position,wall_seconds,cpu_seconds,steps,"
      "rejected_steps,newton_iterations,linear_iterations,peak_memory_bytes,end_time,peak_error,work_error,peak,"
      "work");
  for (const char* part :
       {"\"judgement\": \"Its own errors are taken from a run with twice its time step.\"",
        "\"own_errors\": {\n      \"error_force\": 0.001\n    }", "\"notes\": [\n      \"It does not move.\"\n    ]"})
    EXPECT_NE(json.find(part), std::string::npos) << part << json;
  EXPECT_THROW(write_study(study, {}, {}, folder_ + "/none", "", ""), FileError);
}

}  // namespace
}  // namespace ixos
