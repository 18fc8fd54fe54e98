// The lines on runs to an accuracy, and the object in summary.json.
#include "study/accuracy/accuracy_report.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "scene/read/scene_units.hpp"
#include "scene/scene_file.hpp"
#include "support/files.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"
#include "support/temporary_folder.hpp"

namespace ixos {
namespace {

using test::expect_contains;

AccuracyQuestion question() { return {{AskedQuantity("final x"), AskedQuantity("peak y")}, 0.01}; }

AccuracyResult result(AccuracyStatus status, double error) {
  AccuracyRun run;
  run.settings = {1e-3, 1.5, 0.25, 1e-7};
  run.steps = 12;
  run.seconds = 0.5;
  run.values = {3.25, 2};
  return {status, {run, run, run}, {{3.25, 0.001, "asymptotic, of order 2"}, {2, error, "two sizes only"}}, ""};
}

TEST(AccuracyReportTest, ALineForEachRun) {
  AccuracyRun run = result(AccuracyStatus::Kept, 0).runs.front();
  EXPECT_EQ(run_text(question(), run, 3),
            "Run 3: local error 0.001 L0, gap ratio 1.5: 12 steps, 0.5 s: final x = 3.25, peak y = 2\n");
  run.settings.gap_ratio = 0;
  run.values.clear();
  run.problem = "there is no contact";
  EXPECT_EQ(run_text(question(), run, 1), "Run 1: local error 0.001 L0: 12 steps, 0.5 s: there is no contact\n");
}

TEST(AccuracyReportTest, TheAnswerNamesErrorsLimitAndScope) {
  const std::string kept = accuracy_text(question(), result(AccuracyStatus::Kept, 0.005));
  expect_contains(kept,
                  "The accuracy 1 % is kept by the time steps; the mesh, surface points, cutoffs were not examined:\n"
                  "  final x = 3.25, estimated error 0.1 % (asymptotic, of order 2)\n");
  expect_contains(kept, "not the mesh; for the mesh, use ixos-study --advise");
  expect_contains(kept, "3 runs took 1.5 s, the last one 0.5 s");
  EXPECT_EQ(kept.find("The last run failed"), std::string::npos);
  AccuracyResult late = result(AccuracyStatus::Kept, 0.005);
  late.runs.back().problem = "the step is too short";
  expect_contains(accuracy_text(question(), late),
                  "The last run failed after the times that decide the quantities: the step is too short.\n");
  AccuracyResult missed = result(AccuracyStatus::Missed, std::numeric_limits<double>::infinity());
  missed.limit = "10 runs are the most";
  expect_contains(accuracy_text(question(), missed),
                  "The accuracy 1 % is not reached, limited by: 10 runs are the most.");
  expect_contains(accuracy_text(question(), missed), "peak y = 2, estimated error unknown");
  missed.achieved.clear();
  EXPECT_EQ(accuracy_text(question(), missed), "The accuracy 1 % cannot be judged: 10 runs are the most.\n");
}

TEST(AccuracyReportTest, AMeshCountsOnceAFinerOneJudgedIt) {
  AccuracyResult own = result(AccuracyStatus::Kept, 0.005);
  own.runs.back().settings.mesh = {3, 0.125, 0.01};
  expect_contains(run_text(question(), own.runs.back(), 4), "gap ratio 1.5, 3 levels, part 0.125: 12 steps");
  expect_contains(accuracy_text(question(), own), "the mesh, surface points, cutoffs were not examined");
  own.mesh_is_judged = true;
  own.achieved[0].mesh_error = 0.0004;
  const std::string text = accuracy_text(question(), own);
  expect_contains(text,
                  "kept by the time steps and the mesh at the front; the coarse cells, surface points, cutoffs were");
  expect_contains(text, "estimated error 0.1 % (asymptotic, of order 2; of it 0.04 % by the mesh)");
  expect_contains(text, "for the coarse cells, use ixos-study --advise");
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() + "/summary.json") << "{}";
  add_accuracy(question(), own, folder.path());
  for (const char* part : {"\"error_by_mesh\": 0.0004", "\"part\": 0.125", "Mesh/Adapt/Levels=3"})
    expect_contains(test::contents(folder.path() + "/summary.json"), part);
}

TEST(AccuracyReportTest, TheSummaryKeepsItsEntriesAndGetsTheObject) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() + "/summary.json") << "{\"status\": \"completed\", \"steps\": 12}";
  add_accuracy(question(), result(AccuracyStatus::Missed, std::numeric_limits<double>::infinity()), folder.path());
  const std::string text = test::contents(folder.path() + "/summary.json");
  for (const char* part : {"\"status\": \"completed\"", "\"asked\": 0.01", "\"kept\": false",
                           "\"quantity\": \"peak y\"", "\"error\": null", "\"known_by\": \"asymptotic, of order 2\"",
                           "\"longest_step\": 0.25", "\"not_examined\"", "Adaptive/Maximum Gap Ratio=1.5"})
    expect_contains(text, part);
}

TEST(AccuracyReportTest, OnlyResultsOfTheSameSceneWithSuchAnObjectMayBeReplaced) {
  const test::TemporaryFolder folder;
  const Teuchos::ParameterList scene = complete_scene(test::scene_file("ball.xml"));
  EXPECT_FALSE(holds_accuracy(folder.path(), scene)) << "an empty folder";
  const auto write = [&](const std::vector<std::string>& assignments) {
    write_scene_file(complete_scene(test::scene_file("ball.xml", assignments)), folder.path() + "/effective.xml");
  };
  const std::string control = "Time Integrator/Time Step Control/";
  write({control + "Type=Adaptive", control + "Adaptive/Tolerance=0.1"});
  std::ofstream(folder.path() + "/summary.json") << "{\"status\": \"completed\"}";
  EXPECT_FALSE(holds_accuracy(folder.path(), scene)) << "a plain run";
  add_accuracy(question(), result(AccuracyStatus::Kept, 0), folder.path());
  EXPECT_TRUE(holds_accuracy(folder.path(), scene));
  write({control + "Type=Adaptive", control + "Adaptive/Tolerance=0.1", "Materials/Ball/Density=1e-7"});
  EXPECT_FALSE(holds_accuracy(folder.path(), scene)) << "another density";
}

}  // namespace
}  // namespace ixos
