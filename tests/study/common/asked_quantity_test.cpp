// Quantities of histories that are known functions of time.
#include "study/common/asked_quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "support/temporary_folder.hpp"
#include "support/written_results.hpp"

namespace ixos {
namespace {

constexpr double pi = 3.14159265358979323846;

class AskedQuantityTest : public testing::Test {
 protected:
  void SetUp() override {
    test::write_results(folder_.path(), "Newmark", 0.01, 10,
                        {{"force", [](double t) { return 3 * std::sin(pi * t / 5); }},  // 3 at 2.5, -3 at 7.5
                         {"pull", [](double t) { return t < 4 ? t : (10 - t) / 2; }},   // 4 just before 4
                         {"external_work", [](double t) { return 2 * t * t; }},         //
                         {"kinetic_energy", [](double t) { return t < 8 ? 5 : 5 * std::exp(8 - 4 * (t - 6.0)); }},
                         {"contact_measure", [](double t) { return t > 2.001 && t < 6.001 ? 1.0 : 0.0; }},  //
                         {"momentum", [](double t) { return t < 5 ? -2 * t : 0.6 * (10 - t); }},  // -10, then 3
                         {"reaction_top_y", [](double t) { return t; }}},
                        0.25);
  }
  double value(const std::string& text) const { return AskedQuantity(text).value(RunHistory(folder_.path())); }
  std::string refusal(const std::string& text) const {
    try {
      const double found = value(text);
      return "accepted: " + std::to_string(found);
    } catch (const InputError& error) {
      return error.what();
    }
  }
  void expect_refused(const std::string& text, const std::string& part) const {
    const std::string message = refusal(text);
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
  test::TemporaryFolder folder_;
};

TEST_F(AskedQuantityTest, PeaksAndMeans) {
  EXPECT_NEAR(value("peak force"), 3, 1e-9);
  EXPECT_NEAR(value("peak force [6, 10]"), 3, 1e-9) << "a magnitude";
  EXPECT_NEAR(value("maximum force"), 3, 1e-9);
  EXPECT_NEAR(value("minimum force"), -3, 1e-9);
  EXPECT_NEAR(value("mean force [0, 5]"), 6 / pi, 1e-4);
  EXPECT_NEAR(value("mean force"), 0, 1e-9);
  EXPECT_NEAR(value("rms  force"), 3 / std::sqrt(2), 1e-4);
  EXPECT_NEAR(value("final momentum"), 0, 1e-9);
  EXPECT_NEAR(value("value momentum at 2.005"), -4.01, 1e-9);
  EXPECT_NEAR(value("work"), 200, 1e-9);
  EXPECT_NEAR(value("work [1, 2]"), 6, 1e-9);
  EXPECT_NEAR(value("energy error"), 0.05, 1e-9);
  EXPECT_NEAR(value("restitution momentum"), 0.3, 0.002);
}

TEST_F(AskedQuantityTest, Events) {
  EXPECT_NEAR(value("time of peak force [0, 5]"), 2.5, 1e-9);
  EXPECT_NEAR(value("time of force above 1.5"), 5.0 / 6, 1e-4);
  EXPECT_NEAR(value("time of force below -1.5"), 5 + 5.0 / 6, 1e-4);
  EXPECT_NEAR(value("time of first contact"), 2.001, 0.01);
  EXPECT_NEAR(value("time of detachment"), 6.001, 0.01);
  // 5 exp(8 - 4 (t - 6)) is a hundredth of 5 at 4 (t - 6) = 8 + ln 100.
  EXPECT_NEAR(value("time of arrest"), 8 + std::log(100) / 4, 0.001);
}

TEST_F(AskedQuantityTest, ReactionsInMomentumFormBelongToTheMiddleOfTheStep) {
  EXPECT_NEAR(value("time of reaction_top_y above 2"), 2, 1e-6);
  test::write_results(folder_.path(), "Average Vector Field", 0.01, 10,
                      {{"reaction_top_y", [](double t) { return t; }}});
  EXPECT_NEAR(value("time of reaction_top_y above 2"), 1.995, 1e-6);
}

TEST_F(AskedQuantityTest, TextsThatAreNoQuantity) {
  expect_refused("peek force", "this is no quantity. Quantities are:\n");
  expect_refused("peak", "this is no quantity");
  expect_refused("peak force [1]", "the window must be two times");
  expect_refused("peak force [2, 1]", "the start of the window must be less than its end");
  expect_refused("final force [1, 2]", "takes no window");
  expect_refused("time of force above high", "this is no quantity");
  expect_refused("", "this is no quantity");
  for (const char* form : {"peak COLUMN", "energy error", "time of COLUMN above LIMIT", "restitution COLUMN"})
    EXPECT_NE(quantity_forms().find(form), std::string::npos) << form;
}

TEST_F(AskedQuantityTest, ColumnsWindowsAndEventsThatAreNot) {
  expect_refused("final norm_velocity", "column \"norm_velocity\" does not exist; list the field in Output/Norms");
  expect_refused("peak forse", "column \"forse\" does not exist; did you mean \"force\"?");
  expect_refused("mean force [11, 12]", "the run ended at 10 T0, before the end of the window");
  expect_refused("mean force [3.001, 3.009]", "the window holds no rows");
  expect_refused("mean force [3.001, 3.011]", "one row only");
  expect_refused("value force at 11", "no value at that time");
  expect_refused("time of force above 4", "never passes the limit");
  expect_refused("time of first contact [7, 9]", "there is no contact");
  expect_refused("time of detachment [0, 5]", "lasts to the end");
  expect_refused("time of arrest [0, 7]", "still moves");
  expect_refused("restitution external_work", "does not change its sign");
}

TEST_F(AskedQuantityTest, ChecksBeforeARun) {
  EXPECT_NO_THROW(AskedQuantity("peak force").check_columns({"time", "force"}));
  EXPECT_THROW(AskedQuantity("peak force").check_columns({"time", "pull"}), InputError);
  EXPECT_THROW(AskedQuantity("work").check_columns({"time"}), InputError);
  EXPECT_NO_THROW(AskedQuantity("mean force [5, 20]").check_times(0, 10));
  EXPECT_THROW(AskedQuantity("mean force [10, 20]").check_times(0, 10), InputError);
  EXPECT_THROW(AskedQuantity("value force at 11").check_times(0, 10), InputError);
}

// The column runs from the beginning of the run, whatever the window.
TEST_F(AskedQuantityTest, ColumnsHaveTheTimeThatDecides) {
  const auto decided = [&](const std::string& text) {
    const ColumnHistory found = AskedQuantity(text).history(RunHistory(folder_.path()));
    EXPECT_EQ(found.times.front(), 0) << text;
    EXPECT_NEAR(found.times.back(), 10, 1e-9) << text;
    EXPECT_EQ(found.times.size(), found.values.size()) << text;
    return found.decided;
  };
  EXPECT_NEAR(decided("maximum force"), 2.5, 1e-9);
  EXPECT_NEAR(decided("minimum force"), 7.5, 1e-9);
  EXPECT_NEAR(decided("peak force [6, 10]"), 7.5, 1e-9);
  EXPECT_NEAR(decided("time of peak force [0, 5]"), 2.5, 1e-9);
  EXPECT_NEAR(decided("value momentum at 2.005"), 2.005, 1e-12);
  EXPECT_NEAR(decided("mean force [1, 4]"), 4, 1e-9);
  EXPECT_NEAR(decided("final momentum"), 10, 1e-9);
  EXPECT_NEAR(decided("work"), 10, 1e-9);
  EXPECT_NEAR(decided("time of force above 1.5"), 5.0 / 6, 1e-4);
  EXPECT_NEAR(decided("time of detachment"), 6.001, 0.01);
  EXPECT_THROW(decided("time of force above 4"), InputError);
}

TEST_F(AskedQuantityTest, AFailedRunHasWhatItPassed) {
  const auto is_decided = [&](const std::string& text) {
    return AskedQuantity(text).is_decided(RunHistory(folder_.path()));
  };
  for (const char* passed : {"value force at 9", "mean force [1, 9]", "work [1, 10]", "peak pull [0, 5]",
                             "time of force above 1", "time of first contact", "restitution momentum [0, 9]"})
    EXPECT_TRUE(is_decided(passed)) << passed;
  for (const char* open : {"final force", "mean force", "rms force [1, 11]", "peak pull", "maximum external_work",
                           "work", "value force at 11", "time of force above 4", "energy error", "time of arrest",
                           "restitution momentum", "final nothing"})
    EXPECT_FALSE(is_decided(open)) << open;
  EXPECT_TRUE(
      are_decided({AskedQuantity("value force at 9"), AskedQuantity("work [1, 2]")}, RunHistory(folder_.path())));
  EXPECT_FALSE(are_decided({AskedQuantity("value force at 9"), AskedQuantity("work")}, RunHistory(folder_.path())));
}

// The pull-off force is known once the contact is released, unless the force grows again.
TEST_F(AskedQuantityTest, ReleaseDecidesForces) {
  const auto write = [&](double release, double later) {
    test::write_results(folder_.path(), "Newmark", 0.01, 10,
                        {{"contact_measure", [=](double t) { return t < release ? 1.0 : 0.0; }},
                         {"reaction_top_y", [=](double t) { return t < 4   ? t
                                                                   : t < 8 ? 0.1
                                                                           : later; }},
                         {"kinetic_energy", [](double t) { return t < 4 ? t : 0.1; }}});
    return RunHistory(folder_.path());
  };
  const RunHistory released = write(4, 0.1);
  for (const char* known :
       {"peak reaction_top_y", "maximum reaction_top_y", "time of peak reaction_top_y", "time of detachment"})
    EXPECT_TRUE(AskedQuantity(known).is_decided(released)) << known;
  for (const char* open : {"mean reaction_top_y", "peak kinetic_energy"})
    EXPECT_FALSE(AskedQuantity(open).is_decided(released)) << open;
  EXPECT_FALSE(AskedQuantity("peak reaction_top_y").is_decided(write(4, 5))) << "a larger force follows";
  EXPECT_FALSE(AskedQuantity("peak reaction_top_y").is_decided(write(11, 0.1))) << "still in contact";
  EXPECT_FALSE(AskedQuantity("peak reaction_top_y").is_decided(write(0, 0.1))) << "never in contact";
}

TEST_F(AskedQuantityTest, AFirstEventNeedsNoEndOfItsWindow) {
  EXPECT_NEAR(value("time of force above 1.5 [0, 20]"), 5.0 / 6, 1e-4);
  EXPECT_NEAR(value("time of first contact [1, 20]"), 2.001, 0.01);
  expect_refused("time of force above 4 [0, 20]", "before the end of the window");
}

TEST_F(AskedQuantityTest, StatisticsAndErrors) {
  EXPECT_TRUE(AskedQuantity("mean force").is_statistic());
  EXPECT_FALSE(AskedQuantity("peak force").is_statistic());
  EXPECT_TRUE(AskedQuantity("energy error").is_error());
  EXPECT_EQ(AskedQuantity("  peak   force ").text(), "peak force");
}

}  // namespace
}  // namespace ixos
