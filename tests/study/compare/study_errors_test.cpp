// Errors of results against a reference, from functions whose distances are known.
#include "study/compare/study_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>

#include "base/error.hpp"
#include "support/files.hpp"

namespace ixos {
namespace {

using Function = std::function<double(double)>;

double sine(double t) { return std::sin(6 * t); }
double zero(double) { return 0; }

/// The columns of a results folder, as functions of time from 0 to 1.
struct Columns {
  Function force = sine;  ///< the y component; also the reaction, at the middle of the step
  Function force_x = zero;
  Function momentum = [](double t) { return t; };
  Function position = [](double t) { return t * t; };
  Function work = [](double t) { return 3 * t; };
  Function kinetic_energy = [](double t) { return 2 * t; };
};

class StudyErrorsTest : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void write(const std::string& name, const std::string& scheme, double dt, const Columns& columns) const {
    const std::string folder = folder_ + "/" + name;
    std::filesystem::create_directories(folder);
    std::ofstream history(folder + "/history.csv");
    history.precision(17);
    history << "step,time,time_step,kinetic_energy,external_work,linear_momentum_x,linear_momentum_y,contact_force_x,"
               "contact_force_y,wall_seconds,reaction_top_y,P_ux,P_uy,contact_force_Wall_y\n";
    for (int n = 0; n <= std::lround(1 / dt); ++n) {
      const double t = n * dt;
      history << n << ',' << t << ',' << dt << ',' << columns.kinetic_energy(t) << ',' << columns.work(t) << ",0,"
              << columns.momentum(t) << ',' << columns.force_x(t) << ',' << columns.force(t) << ",,"
              << columns.force(t - (n > 0 ? dt / 2 : 0)) << ",0," << columns.position(t)
              << ",1e15\n";  // no measure looks at single interactions, whose forces may cancel
    }
    std::ofstream(folder + "/summary.json") << "{\"max_energy_error\": " << dt << "}";
    std::ofstream(folder + "/effective.xml")
        << "<ParameterList name=\"x\"><ParameterList name=\"Time Integrator\"><Parameter name=\"Type\" type=\"string\" "
           "value=\""
        << scheme << "\"/><ParameterList name=\"" << scheme << "\"/></ParameterList></ParameterList>";
  }
  /// Returns the errors of the results in run against those in reference.
  StudyErrors errors(const ErrorOptions& options) const {
    return StudyReference(folder_ + "/reference", options).errors(folder_ + "/run");
  }
  std::string folder_ = testing::TempDir() + "study_errors";
};

TEST_F(StudyErrorsTest, ARunThatEndedEarlyHasNoErrors) {
  write("reference", "Newmark", 1e-3, {});
  write("run", "Newmark", 0.01, {});
  std::string text = test::contents(folder_ + "/run/history.csv");
  text.resize(text.find("\n80,") + 1);
  std::ofstream(folder_ + "/run/history.csv") << text;
  EXPECT_THROW(errors({}), InputError);
  ErrorOptions options;
  options.to = 0.7;
  EXPECT_LT(errors(options).force, 1e-5);
}

TEST_F(StudyErrorsTest, ErrorsAreThoseOfKnownFunctions) {
  write("reference", "Newmark", 1e-4, {});
  Columns larger;
  larger.force = [](double t) { return 1.1 * sine(t); };
  write("run", "Newmark", 0.01, larger);
  const StudyErrors found = errors({});
  EXPECT_NEAR(found.force, 0.1, 1e-6);
  EXPECT_NEAR(found.momentum, 0, 1e-12);
  EXPECT_NEAR(found.position, 0, 1e-7);
  EXPECT_NEAR(found.energy, 0.01 / 2, 1e-12) << "the reference's kinetic energy reaches 2";
  ErrorOptions options;
  options.from = 0.5;
  options.to = 0.8;
  options.energy_scale = 0.1;
  options.force = {"reaction_top_y"};
  const StudyErrors part = errors(options);
  EXPECT_NEAR(part.energy, 0.1, 1e-12);
  EXPECT_GT(std::abs(part.force - 0.1), 0.005)
      << "Newmark's reactions belong to the end of the step, these were written to its middle";
  options.from = 2;
  options.to = 3;
  EXPECT_THROW(errors(options), InputError);
  options = {};
  options.force = {"contact_force_w"};
  EXPECT_THROW(errors(options), InputError);
}

TEST_F(StudyErrorsTest, ReactionsOfMomentumFormBelongToTheMiddleOfTheStep) {
  write("reference", "Newmark", 1e-4, {});
  write("run", "Midpoint", 0.05, {});
  ErrorOptions options;
  options.force = {"reaction_top_y"};
  // The reference's own column is shifted by half of its short step: 6 * 5e-5.
  EXPECT_LT(errors(options).force, 5e-4);
}

TEST_F(StudyErrorsTest, PeakAndWorkAreThoseOfKnownFunctions) {
  const double pi = std::acos(-1);
  Columns exact;  // the magnitude is 5 sin(pi t), largest at 0.5, a row of both
  exact.force = [=](double t) { return -4 * std::sin(pi * t); };
  exact.force_x = [=](double t) { return 3 * std::sin(pi * t); };
  Columns larger = exact;
  larger.force = [=](double t) { return -4.4 * std::sin(pi * t); };
  larger.force_x = [=](double t) { return 3.3 * std::sin(pi * t); };
  larger.work = [](double t) { return 2.7 * t; };
  write("reference", "Newmark", 1e-3, exact);
  write("run", "Newmark", 0.01, larger);
  StudyErrors found = errors({});
  EXPECT_NEAR(found.peak_force, 5.5, 1e-12);
  EXPECT_NEAR(found.peak, 0.1, 1e-12);
  EXPECT_NEAR(found.external_work, 2.7, 1e-12);
  EXPECT_NEAR(found.work, 0.1, 1e-12);
  // In the last quarter of the time the magnitude falls, and a quarter of the work is done.
  ErrorOptions options;
  options.from = 0.75;
  options.force = {"contact_force_y"};
  found = errors(options);
  EXPECT_NEAR(found.peak_force, 4.4 * std::sin(0.75 * pi), 1e-12);
  EXPECT_NEAR(found.peak, 0.1, 1e-12);
  EXPECT_NEAR(found.external_work, 2.7 * 0.25, 1e-12);
  EXPECT_NEAR(found.work, 0.1, 1e-12);
}

TEST_F(StudyErrorsTest, TheIntervalOfAPeakIsThatOfTheForcesOwnTimes) {
  // In momentum form the reaction of the row at 0.5 belongs to 0.45, before the interval; the one at 0.6 to 0.55.
  Columns falling;
  falling.force = [](double t) { return 1 - t; };
  write("reference", "Midpoint", 0.1, falling);
  write("run", "Midpoint", 0.1, falling);
  ErrorOptions options;
  options.from = 0.5;
  options.force = {"reaction_top_y"};
  EXPECT_NEAR(errors(options).peak_force, 0.45, 1e-12);
}

TEST_F(StudyErrorsTest, AReferenceAsGoodAsZeroHasNoRelativeErrors) {
  Columns still, noisy;
  still.force_x = [](double t) { return 1e-12 * sine(t); };
  still.work = zero;
  still.position = zero;
  noisy.force_x = [](double t) { return 9.78e-12 * sine(t); };
  noisy.work = [](double t) { return 1e-15 * t; };
  noisy.position = [](double t) { return 1e-15 * t; };
  write("reference", "Newmark", 1e-3, still);
  write("run", "Newmark", 0.01, noisy);
  ErrorOptions options;
  options.force = {"contact_force_x"};
  const StudyReference reference(folder_ + "/reference", options);
  const StudyErrors found = reference.errors(folder_ + "/run");
  for (const char* column : {"error_force", "error_position", "peak_error", "work_error"}) {
    EXPECT_TRUE(std::isnan(found.*measure(column).error)) << column;
    EXPECT_EQ(reference.quality().notes.count(column), 1U) << column;
  }
  EXPECT_NE(reference.quality().notes.at("error_force").find("as good as zero beside the largest force, 1."),
            std::string::npos)
      << reference.quality().notes.at("error_force");
  EXPECT_EQ(reference.quality().notes.size(), 4U);
  EXPECT_NEAR(found.peak_force, 9.78e-12, 1e-15) << "the number itself is told";
  EXPECT_NEAR(found.energy, 0.005, 1e-12);
  EXPECT_LT(found.momentum, 1e-12);
  options.force = {"contact_force_y"};
  EXPECT_LT(errors(options).force, 1e-4) << "beside it the other component counts";
}

TEST_F(StudyErrorsTest, AMomentumAsGoodAsZeroIsMeasuredByTheImpulse) {
  Columns still;
  still.momentum = [](double t) { return 1e-14 * std::cos(50 * t); };
  write("reference", "Newmark", 1e-3, still);
  write("run", "Newmark", 0.01, {});
  EXPECT_TRUE(std::isnan(errors({}).momentum));
}

TEST_F(StudyErrorsTest, TheReferenceIsJudgedByACoarserRun) {
  Columns coarser;
  coarser.force = [](double t) { return 1.004 * sine(t); };
  coarser.work = [](double t) { return 3.003 * t; };
  coarser.position = [](double t) { return 0.2 * t * t; };
  write("reference", "Newmark", 1e-3, {});
  write("check", "Newmark", 2e-3, coarser);
  write("run", "Newmark", 0.01, {});
  StudyReference reference(folder_ + "/reference", {});
  EXPECT_FALSE(std::isnan(reference.errors(folder_ + "/run").position));
  EXPECT_TRUE(reference.quality().origin.empty());
  reference.judge(folder_ + "/check", "a coarser run");
  const ReferenceQuality& quality = reference.quality();
  EXPECT_EQ(quality.origin, "a coarser run");
  EXPECT_NEAR(quality.own.force, 0.004, 1e-12);
  EXPECT_NEAR(quality.own.peak, 0.004, 1e-4) << "the rows of the coarser run miss the peak";
  EXPECT_NEAR(quality.own.work, 0.001, 1e-12);
  EXPECT_NEAR(quality.own.position, 0.8, 1e-12);
  EXPECT_TRUE(std::isnan(quality.own.energy)) << "it is no error against the reference";
  // A position of which the reference knows a fifth has no errors.
  const StudyErrors found = reference.errors(folder_ + "/run");
  EXPECT_TRUE(std::isnan(found.position));
  EXPECT_FALSE(std::isnan(found.force));
  ASSERT_EQ(quality.notes.size(), 1U);
  EXPECT_NE(quality.notes.at("error_position").find("a coarser run differs from the reference by 0.8"),
            std::string::npos);
}

TEST_F(StudyErrorsTest, ACheckThatIsNotCoarserShowsNothing) {
  write("reference", "Newmark", 1e-3, {});
  write("check", "Newmark", 1e-3, {});
  StudyReference reference(folder_ + "/reference", {});
  reference.judge(folder_ + "/check", "a run with twice its time step");
  EXPECT_TRUE(reference.quality().origin.empty());
  EXPECT_TRUE(std::isnan(reference.quality().own.force));
  EXPECT_EQ(reference.quality().unknown, "a run with twice its time step gives exactly the results of the reference");
}

TEST_F(StudyErrorsTest, MeasuresAreFoundByTheirColumns) {
  EXPECT_EQ(measures().size(), 6U);
  EXPECT_STREQ(measure("peak_error").quantity, "peak force");
  EXPECT_THROW(measure("peak"), std::invalid_argument);
}

}  // namespace
}  // namespace ixos
