// Study files, errors against a reference, and what follows from the results.
#include "study/study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "base/error.hpp"
#include "study/history_table.hpp"
#include "study/study_errors.hpp"
#include "study/study_result.hpp"
#include "support/files.hpp"

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
  /// Of the results in run against those in reference.
  StudyErrors study_errors(const ErrorOptions& options) const {
    return StudyReference(folder_ + "/reference", options).errors(folder_ + "/run");
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
                 "<Parameter name=\"Jobs\" type=\"int\" value=\"3\"/>"
                 "<ParameterList name=\"Common\">",
                 "Jobs: 3 is not allowed");
  std::string many;
  for (int i = 1; i < 6000; ++i) many += (i > 1 ? ", " : "") + std::to_string(i);
  expect_refused("{0.01, 0.001}", "{" + many + "}", "more than 10000 runs");
  EXPECT_THROW(read_study(folder_ + "/none.xml"), InputError);
}

/// Results whose contact force is that of `force` at each time, of a scheme.
template <class Force>
void write_results(const std::string& folder, const std::string& scheme, double dt, const Force& force) {
  std::filesystem::create_directories(folder);
  std::ofstream history(folder + "/history.csv");
  history.precision(17);
  history << "step,time,time_step,kinetic_energy,linear_momentum_x,linear_momentum_y,contact_force_x,contact_force_y,"
             "wall_seconds,reaction_top_y,P_ux,P_uy\n";
  for (int n = 0; n <= std::lround(1 / dt); ++n) {
    const double t = n * dt;
    history << n << ',' << t << ',' << dt << ',' << 2 * t << ",0," << t << ",0," << force(t) << ",,"
            << force(t - (n > 0 ? dt / 2 : 0)) << ",0," << t * t << '\n';
  }
  std::ofstream(folder + "/summary.json") << "{\"max_energy_error\": " << dt << "}";
  std::ofstream(folder + "/effective.xml")
      << "<ParameterList name=\"x\"><ParameterList name=\"Time Integrator\"><Parameter name=\"Type\" type=\"string\" "
         "value=\""
      << scheme << "\"/><ParameterList name=\"" << scheme << "\"/></ParameterList></ParameterList>";
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

TEST_F(StudyTest, ARunThatEndedEarlyHasNoErrors) {
  const auto sine = [](double t) { return std::sin(6 * t); };
  write_results(folder_ + "/reference", "Newmark", 1e-3, sine);
  write_results(folder_ + "/run", "Newmark", 0.01, sine);
  std::string text = contents(folder_ + "/run/history.csv");
  text.resize(text.find("\n80,") + 1);
  std::ofstream(folder_ + "/run/history.csv") << text;
  EXPECT_THROW(study_errors({}), InputError);
  ErrorOptions options;
  options.to = 0.7;
  EXPECT_LT(study_errors(options).force, 1e-5);
}

TEST_F(StudyTest, ErrorsAreThoseOfKnownFunctions) {
  const auto sine = [](double t) { return std::sin(6 * t); };
  write_results(folder_ + "/reference", "Newmark", 1e-4, sine);
  write_results(folder_ + "/run", "Newmark", 0.01, [&](double t) { return 1.1 * sine(t); });
  const StudyErrors errors = study_errors({});
  EXPECT_NEAR(errors.force, 0.1, 1e-6);
  EXPECT_NEAR(errors.momentum, 0, 1e-12);
  EXPECT_NEAR(errors.position, 0, 1e-7);
  EXPECT_NEAR(errors.energy, 0.01 / 2, 1e-12) << "the reference's kinetic energy reaches 2";
  ErrorOptions options;
  options.from = 0.5;
  options.to = 0.8;
  options.energy_scale = 0.1;
  options.force = {"reaction_top_y"};
  const StudyErrors part = study_errors(options);
  EXPECT_NEAR(part.energy, 0.1, 1e-12);
  EXPECT_GT(std::abs(part.force - 0.1), 0.005)
      << "Newmark's reactions belong to the end of the step, these were written to its middle";
  options.from = 2;
  options.to = 3;
  EXPECT_THROW(study_errors(options), InputError);
  options = {};
  options.force = {"contact_force_w"};
  EXPECT_THROW(study_errors(options), InputError);
}

TEST_F(StudyTest, ReactionsOfMomentumFormBelongToTheMiddleOfTheStep) {
  const auto sine = [](double t) { return std::sin(6 * t); };
  write_results(folder_ + "/reference", "Newmark", 1e-4, sine);
  write_results(folder_ + "/run", "Midpoint", 0.05, sine);
  ErrorOptions options;
  options.force = {"reaction_top_y"};
  // The reference's own column is shifted by half of its short step: 6 * 5e-5.
  EXPECT_LT(study_errors(options).force, 5e-4);
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

TEST_F(StudyTest, TheCheapestWithinTheToleranceIsRecommended) {
  Study study;
  study.axes = {{"Case", {}}};
  study.question = {"Case", "wall_seconds", "error_force", 0.05, 2.5};
  const std::vector<StudyResult> results{outcome("a", 1, 0.2),
                                         outcome("b", 2, 0.3),
                                         outcome("c", 3, 0.04),
                                         outcome("d", 9, 0.01),
                                         outcome("e", 0.1, 0, "diverged"),
                                         outcome("f", 0.5, std::numeric_limits<double>::quiet_NaN())};
  std::string names;
  for (const StudyResult* result : pareto(results, "wall_seconds", "error_force")) names += result->run.name;
  EXPECT_EQ(names, "acd");
  Recommendation answer = recommend(study, results);
  ASSERT_NE(answer.run, nullptr);
  EXPECT_EQ(answer.run->run.name, "c");
  EXPECT_NE(answer.sentence.find("The cheapest run within the tolerance 0.05: Case c"), std::string::npos)
      << answer.sentence;
  EXPECT_NE(answer.sentence.find("at most 2.5 s of wall-clock time: Case a"), std::string::npos) << answer.sentence;
  study.question.tolerance = 1e-4;
  answer = recommend(study, results);
  EXPECT_EQ(answer.run, nullptr);
  EXPECT_NE(answer.sentence.find("The most accurate run: Case d"), std::string::npos) << answer.sentence;
  study.question.tolerance = 0;
  EXPECT_EQ(recommend(study, results).run->run.name, "a");
  study.question.budget = 0.01;
  EXPECT_EQ(recommend(study, results).run, nullptr);
  EXPECT_EQ(recommend(study, {}).run, nullptr);
}

TEST_F(StudyTest, ResultsAreWrittenAsReadersNeedThem) {
  Study study;
  study.name = "Test";
  study.axes = {{"Case", {{"a", {}}, {"b, \"c\"", {}}}}};
  study.question = {"Case", "wall_seconds", "error_force", 0.05, 0};
  StudyResult odd = outcome("b", 2, 0.3, "diverged");
  odd.run.labels = {"b, \"c\""};
  odd.reason = "because";
  write_study(study, {outcome("a", 1, 0.2), odd}, folder_, "ixos-study x", "1");
  const std::string csv = contents(folder_ + "/study.csv");
  EXPECT_NE(csv.find("\na,a,completed,,,,0.2,,1,0,0,0,0,0,0,0\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\nb,\"b, \"\"c\"\"\",diverged,because,,,,,2,"), std::string::npos) << csv;
  const std::string json = contents(folder_ + "/study.json");
  EXPECT_NE(json.find("\"error_force\": [\n      \"a\"\n    ]"), std::string::npos) << json;
  EXPECT_THROW(write_study(study, {}, folder_ + "/none", "", ""), FileError);
}

}  // namespace
}  // namespace ixos
