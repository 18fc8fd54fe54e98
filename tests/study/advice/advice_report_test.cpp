// An advice as text and as files.
#include "study/advice/advice_report.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scene/scene_file.hpp"
#include "support/files.hpp"
#include "support/temporary_folder.hpp"
#include "test_folders.hpp"

namespace ixos {
namespace {

class AdviceReportTest : public testing::Test {
 protected:
  void SetUp() override {
    question_.scene = IXOS_XML_DIRECTORY "/strip.xml";
    question_.quantities = {AskedQuantity("peak reaction_right_y")};
    advice_.directions = advice_directions(changed_scene(question_.scene, {}));
    advice_.status = AdviceStatus::Advised;
    advice_.best.point = scene_point(advice_.directions);
    advice_.best.point[time_direction].level -= 1;
    advice_.best.error = 0.006;
    advice_.best.seconds = 12;
    advice_.best.estimate.errors = {0.006};
    advice_.best.estimate.parts = {std::vector<double>(advice_.directions.all.size(), 0)};
    advice_.best.estimate.parts[0][time_direction] = 0.002;
    advice_.best.estimate.parts[0][mesh_direction] = 0.004;
    advice_.reasons.assign(advice_.directions.all.size(), {"asymptotic, of order 2"});
    advice_.examined.assign(advice_.directions.all.size(), {true});
    advice_.exact = {0.1234};
    advice_.confirmed = true;
    advice_.other_tolerances = {{0.1, advice_.best}, {0.001, {}}};
  }
  test::TemporaryFolder folder_;
  AdviceQuestion question_;
  Advice advice_;
};

TEST_F(AdviceReportTest, TellsWhatAReaderNeeds) {
  const std::string text = advice_text(question_, advice_);
  for (const char* part :
       {"Recommended within the tolerance 1 %: Gautam-Sauer Composite, time step 0.2, Q1C4, mesh 320 x 16, which took "
        "12 s",
        "peak reaction_right_y: about 0.1234, error at most 0.6 % of time step, mesh",
        "time step: 0.2 % (asymptotic, of order 2)", "mesh: 0.4 %", "The accuracy is limited by the mesh.",
        "no settings that the runs tell of"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST_F(AdviceReportTest, WhatWasNotExaminedIsInNoBound) {
  advice_.examined[mesh_direction] = {false};
  advice_.reasons[mesh_direction] = {not_examined};
  advice_.best.estimate.parts[0][mesh_direction] = 0;
  advice_.best.estimate.errors = {0.002};
  advice_.directions.mesh_note = "the mesh is not made by a generator";
  const std::string text = advice_text(question_, advice_);
  for (const char* part : {"Recommended within the tolerance 1 % but for the mesh, which the runs did not examine: ",
                           "error at most 0.2 % of time step", "; not examined: mesh\n", "    mesh: not examined\n",
                           "The mesh was not examined: the mesh is not made by a generator.",
                           "The accuracy, as far as it was examined, is limited by the time step."})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  EXPECT_EQ(text.find("mesh: 0 %"), std::string::npos) << text;
  write_advice(question_, advice_, folder_.path(), "command", "1");
  const nlohmann::json json = nlohmann::json::parse(test::contents(folder_.path() + "/advice.json"))["quantities"][0];
  EXPECT_TRUE(json["parts"]["mesh"]["error"].is_null());
  EXPECT_EQ(json["parts"]["mesh"]["examined"], false);
  EXPECT_EQ(json["parts"]["time step"]["error"], 0.002);
  EXPECT_EQ(json["not_examined"], nlohmann::json::array({"mesh"}));
}

TEST_F(AdviceReportTest, AVerificationSaysWhatWasFiner) {
  EXPECT_EQ(advice_text(question_, advice_).find("erified"), std::string::npos) << "nobody asked";
  advice_.verification = {true, true, 0.003, ""};
  const auto told = [&](const std::string& part) {
    return advice_text(question_, advice_).find(part) != std::string::npos;
  };
  EXPECT_TRUE(told("Verified: half the step on the next finer mesh changes the quantities by at most 0.3 %.\n"));
  advice_.verification.mesh = false;
  EXPECT_TRUE(
      told("Verified for the step alone: half the step changes the quantities by at most 0.3 %; there is no "
           "finer mesh.\n"));
  advice_.verification = {false, true, 0.003, ""};
  EXPECT_TRUE(told("Verified for the mesh alone: "));
  advice_.verification = {false, false, -1, "there is neither a shorter step nor a finer mesh"};
  EXPECT_TRUE(told("Not verified: there is neither a shorter step nor a finer mesh.\n"));
}

TEST_F(AdviceReportTest, TellsThatTheRecommendedRunFailsLater) {
  advice_.fails_later = "the step is too short";
  EXPECT_NE(advice_text(question_, advice_)
                .find("That run fails after the times that decide the quantities: the step is too short.\n"),
            std::string::npos);
}

TEST_F(AdviceReportTest, TellsTheSmallestErrorIfNothingIsGoodEnough) {
  advice_.status = AdviceStatus::Unreachable;
  question_.tolerance = 0.001;
  const std::string text = advice_text(question_, advice_);
  EXPECT_NE(text.find("No settings were found within the tolerance 0.1 %. The smallest error seen is 0.6 %, limited by "
                      "the mesh"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("The runs do not tell what budget would do.\n"), std::string::npos) << text;
  advice_.budget = 20;
  advice_.sufficient_budget = 130;
  const std::string hopeful = advice_text(question_, advice_);
  EXPECT_NE(hopeful.find("If errors and costs go on as they did, a budget of 1.3e+02 s will do.\n"), std::string::npos)
      << hopeful;
  write_advice(question_, advice_, folder_.path(), "command", "1");
  EXPECT_EQ(nlohmann::json::parse(test::contents(folder_.path() + "/advice.json"))["sufficient_budget_seconds"], 130);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() + "/advised.xml"));
}

TEST_F(AdviceReportTest, WritesASceneAndARecord) {
  write_advice(question_, advice_, folder_.path(), "command", "1");
  const Teuchos::ParameterList expected =
      changed_scene(question_.scene, {"Time Integrator/Time Step Control/Time Step=0.2"});
  EXPECT_EQ(changed_scene_text(folder_.path() + "/advised.xml", {}), scene_text(expected));
  const nlohmann::json json = nlohmann::json::parse(test::contents(folder_.path() + "/advice.json"));
  EXPECT_EQ(json["status"], "advised");
  EXPECT_EQ(json["recommended"]["settings"][0], "Time Integrator/Time Step Control/Time Step=0.2");
  EXPECT_EQ(json["quantities"][0]["parts"]["mesh"]["error"], 0.004);
  EXPECT_TRUE(json["other_tolerances"][1]["settings"].is_null());
}

TEST_F(AdviceReportTest, FilesBesideTheSceneAreFound) {
  std::ofstream(folder_.path() + "/x.e") << "mesh";
  question_.common = {"Mesh/Type=Exodus", "Mesh/Exodus/File=x.e"};
  std::filesystem::copy(question_.scene, folder_.path() + "/strip.xml");
  question_.scene = folder_.path() + "/strip.xml";
  advice_.directions = advice_directions(changed_scene(question_.scene, question_.common));
  advice_.best.point = scene_point(advice_.directions);
  advice_.other_tolerances.clear();
  std::filesystem::create_directories(folder_.path() + "/out");
  write_advice(question_, advice_, folder_.path() + "/out", "command", "1");
  const Teuchos::ParameterList written = read_scene_file(folder_.path() + "/out/advised.xml");
  const std::string file = written.sublist("Mesh").sublist("Exodus").get<std::string>("File");
  EXPECT_TRUE(std::filesystem::path(file).is_absolute()) << file;
  EXPECT_TRUE(std::filesystem::exists(file)) << file;
}

}  // namespace
}  // namespace ixos
