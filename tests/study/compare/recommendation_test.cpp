// Recommendations from costs and errors.
#include "study/compare/recommendation.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace ixos {
namespace {

StudyResult outcome(const std::vector<std::string>& labels, double cost, double error,
                    const std::string& status = "completed") {
  StudyResult result;
  result.run = {labels.back(), labels, {"A/B=" + labels.back()}};
  result.status = status;
  result.wall_seconds = cost;
  result.errors.force = error;
  result.errors.energy = error;
  return result;
}

/// A study of steps, the dearest of which is the finest, with a tolerance of the force.
Study study_of_steps(double tolerance) {
  Study study;
  study.axes = {{"Scheme", {{"N", {}}, {"B", {}}}}, {"Time Step", {{"0.4", {}}, {"0.2", {}}, {"0.1", {}}}}};
  study.question = {"Time Step", "wall_seconds", "error_force", tolerance, 0};
  return study;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(RecommendationTest, TheCheapestWithinTheTolerance) {
  Study study;
  study.axes = {{"Case", {}}};
  study.question = {"Case", "wall_seconds", "error_force", 0.05, 2.5};
  const std::vector<StudyResult> results{outcome({"a"}, 1, 0.2),
                                         outcome({"b"}, 2, 0.3),
                                         outcome({"c"}, 3, 0.04),
                                         outcome({"d"}, 9, 0.01),
                                         outcome({"e"}, 0.1, 0, "diverged"),
                                         outcome({"f"}, 0.5, std::numeric_limits<double>::quiet_NaN())};
  std::string names;
  for (const StudyResult* result : pareto(results, "wall_seconds", "error_force")) names += result->run.name;
  EXPECT_EQ(names, "acd");
  Recommendation answer = recommend(study, results, {});
  ASSERT_NE(answer.run, nullptr);
  EXPECT_EQ(answer.run->run.name, "c");
  EXPECT_EQ(
      answer.sentence,
      "The cheapest run within the tolerance 0.05: Case c has a relative error of the force of 0.04 for 3 s of "
      "wall-clock time. The most accurate run for at most 2.5 s of wall-clock time: Case a has a relative error of "
      "the force of 0.2 for 1 s of wall-clock time.");
  study.question.tolerance = 1e-4;
  answer = recommend(study, results, {});
  EXPECT_EQ(answer.run, nullptr);
  EXPECT_TRUE(has(answer.sentence, "The most accurate run: Case d")) << answer.sentence;
  study.question.tolerance = 0;
  EXPECT_EQ(recommend(study, results, {}).run->run.name, "a");
  study.question.budget = 0.01;
  EXPECT_EQ(recommend(study, results, {}).run, nullptr);
  EXPECT_EQ(recommend(study, {}, {}).run, nullptr);
}

TEST(RecommendationTest, AnErrorCountsAsThatOfTheFinerRuns) {
  // The error of N changes its sign near 0.4; its convergence begins at 0.2. B converges.
  const std::vector<StudyResult> results{outcome({"N", "0.4"}, 1, 0.0105), outcome({"N", "0.2"}, 2, 0.03),
                                         outcome({"N", "0.1"}, 4, 0.008),  outcome({"B", "0.4"}, 3, 0.04),
                                         outcome({"B", "0.2"}, 6, 0.01),   outcome({"B", "0.1"}, 12, 0.0025)};
  // The errors alone would have 0.1 and 0.4, far apart, recommended.
  for (double tolerance : {0.010, 0.011}) {
    const Recommendation answer = recommend(study_of_steps(tolerance), results, {});
    ASSERT_NE(answer.run, nullptr);
    EXPECT_EQ(answer.run->run.labels, (std::vector<std::string>{"N", "0.1"})) << tolerance;
    EXPECT_EQ(has(answer.sentence,
                  "Scheme N, Time Step 0.4 is not recommended: its error of 0.0105 is a coincidence, because the finer "
                  "Time Step 0.2 has 0.03."),
              tolerance == 0.011)
        << answer.sentence;
  }
  // Within a wide tolerance it is recommended, with the error that counts.
  const Recommendation wide = recommend(study_of_steps(0.03), results, {});
  ASSERT_NE(wide.run, nullptr);
  EXPECT_EQ(wide.run->run.name, "0.4");
  EXPECT_TRUE(has(wide.sentence, "force of 0.0105 (but 0.03 with the finer Time Step 0.2) for 1 s")) << wide.sentence;
  // For a cost, too.
  Study study = study_of_steps(0);
  study.question.budget = 3.5;
  EXPECT_EQ(recommend(study, results, {}).run->run.name, "0.4") << "the errors of 0.4 and 0.2 count as equal";
}

TEST(RecommendationTest, TheBallsLuckyCrossingIsNotRecommended) {
  // Generalized-Alpha on the ball: 0.052 with a step of 0.005 T0, but 0.26 with 0.001.
  Study study = study_of_steps(0.1);
  study.axes[1].values = {{"0.005", {}}, {"0.002", {}}, {"0.001", {}}};
  const std::vector<StudyResult> results{outcome({"G", "0.005"}, 1, 0.052), outcome({"G", "0.002"}, 2, 0.4),
                                         outcome({"G", "0.001"}, 4, 0.26), outcome({"B", "0.001"}, 9, 0.03)};
  const Recommendation answer = recommend(study, results, {});
  ASSERT_NE(answer.run, nullptr);
  EXPECT_EQ(answer.run->run.labels.front(), "B");
  EXPECT_TRUE(has(answer.sentence, "Scheme G, Time Step 0.005 is not recommended: its error of 0.052 is a coincidence"))
      << answer.sentence;
}

TEST(RecommendationTest, LabelsThatAreNoNumbersHaveNoFinerOnes) {
  const std::vector<StudyResult> results{outcome({"N", "0.4"}, 1, 0.01), outcome({"B", "0.4"}, 3, 0.04)};
  Study study = study_of_steps(0.02);
  study.question.connect = "Scheme";
  EXPECT_EQ(recommend(study, results, {}).run->run.labels.front(), "N");
  // Nor have numbers that neither rise nor fall.
  study = study_of_steps(0.02);
  study.axes[1].values = {{"0.4", {}}, {"0.1", {}}, {"0.2", {}}};
  const std::vector<StudyResult> line{outcome({"N", "0.4"}, 1, 0.01), outcome({"N", "0.2"}, 3, 0.04)};
  EXPECT_EQ(recommend(study, line, {}).run->run.name, "0.4");
}

TEST(RecommendationTest, TheFinerEndOfALineIsTheDearerOne) {
  Study study = study_of_steps(0.02);
  study.axes[1] = {"Level", {{"1", {}}, {"2", {}}, {"3", {}}}};
  study.question.connect = "Level";
  std::vector<StudyResult> rising{outcome({"N", "1"}, 1, 0.01), outcome({"N", "2"}, 2, 0.04),
                                  outcome({"N", "3"}, 3, 0.005)};
  EXPECT_EQ(recommend(study, rising, {}).run->run.name, "3");
  rising[0].wall_seconds = 9;  // then level 1 is the finest
  EXPECT_EQ(recommend(study, rising, {}).run->run.name, "1");
}

TEST(RecommendationTest, OneNumberThatAgreesIsDoubtedIfTheForceOverTimeDoesNot) {
  Study study;
  study.axes = {{"Case", {}}};
  study.question = {"Case", "wall_seconds", "peak_error", 0.05, 0};
  const std::string doubt =
      " Its peak force may agree by coincidence: its force over time differs by 0.2 of the reference's, more than the "
      "tolerance.";
  for (double force : {0.2, 0.04}) {
    StudyResult result = outcome({"a"}, 1, force);
    result.errors.peak = 0.01;
    const Recommendation answer = recommend(study, {result}, {});
    EXPECT_EQ(has(answer.sentence, doubt), force > 0.05) << answer.sentence;
  }
}

TEST(RecommendationTest, AMeshThatNoCheckExaminesIsNamed) {
  ReferenceQuality reference;
  reference.own.force = 0.001;
  reference.origin = "a coarser run";
  Study study = study_of_steps(0.05);
  const std::vector<StudyResult> results{outcome({"N", "0.4"}, 1, 0.01)};
  const std::string open = " The error of its mesh was not examined";
  EXPECT_TRUE(has(recommend(study, results, reference).sentence, open));
  study.check.settings = {"Mesh/Box/Divisions={4, 4}"};
  EXPECT_FALSE(has(recommend(study, results, reference).sentence, open));
}

TEST(RecommendationTest, TheReferencesOwnErrorIsAdded) {
  const std::vector<StudyResult> results{outcome({"N", "0.4"}, 1, 0.09), outcome({"N", "0.2"}, 2, 0.04),
                                         outcome({"N", "0.1"}, 4, 0.01)};
  ReferenceQuality reference;
  reference.own.force = 0.015;
  reference.origin = "a run with twice its time step";
  const Recommendation answer = recommend(study_of_steps(0.05), results, reference);
  ASSERT_NE(answer.run, nullptr);
  EXPECT_EQ(answer.run->run.name, "0.1") << "0.04 + 0.015 is more than 0.05";
  EXPECT_TRUE(has(answer.sentence, "force of 0.01 +- 0.015 for 4 s")) << answer.sentence;
  EXPECT_TRUE(has(answer.sentence,
                  "The reference's own error of the force is about 0.015 (from a run with twice its time step)."))
      << answer.sentence;
  EXPECT_FALSE(has(answer.sentence, "too coarse")) << answer.sentence;
  // More than a third of the tolerance, then more than all of it.
  const Recommendation near = recommend(study_of_steps(0.03), results, reference);
  EXPECT_EQ(near.run->run.name, "0.1");
  EXPECT_TRUE(has(near.sentence, "more than a third of the tolerance 0.03: the reference is too coarse"))
      << near.sentence;
  const Recommendation none = recommend(study_of_steps(0.012), results, reference);
  EXPECT_EQ(none.run, nullptr);
  EXPECT_TRUE(has(none.sentence, "No run is within the tolerance 0.012.")) << none.sentence;
  EXPECT_TRUE(has(none.sentence, "the reference is too coarse")) << none.sentence;
}

TEST(RecommendationTest, WhatIsUnknownIsTold) {
  ReferenceQuality reference;
  reference.unknown = "Reference/Check is false";
  const std::vector<StudyResult> results{outcome({"N", "0.4"}, 1, 0.01)};
  Study study = study_of_steps(0.02);
  EXPECT_TRUE(has(recommend(study, results, reference).sentence,
                  "The reference's own error is unknown: Reference/Check is false."));
  study.question.measure = "error_energy";  // it is no error against the reference
  EXPECT_FALSE(has(recommend(study, results, reference).sentence, "unknown"));
  study.question.measure = "peak_error";
  reference.notes["peak_error"] = "It is zero.";
  EXPECT_EQ(recommend(study, results, reference).sentence,
            "No run that reached its end has a known error of the peak force. It is zero.");
}

}  // namespace
}  // namespace ixos
