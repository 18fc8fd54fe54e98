// Laws that hold, and do not, for the rotations and strains that a run measured.
#include "study/advice/strain_measure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/temporary_folder.hpp"
#include "support/written_results.hpp"

namespace ixos {
namespace {

constexpr double pi = 3.14159265358979323846;

// The strain (H + H^T)/2 of a rotation by 45 degrees is (cos 45 - 1) I.
TEST(StrainMeasureTest, LinearElasticityTakesARotationForAStrain) {
  EXPECT_NEAR(measure_error("Linear Elastic", {pi / 4, 0, 0}), 1 - std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(measure_error("Linear Elastic", {0.1, 0, 0}), 0.1 * 0.1 / 2, 1e-5);
  EXPECT_NEAR(measure_error("Linear Elastic", {1e-6, 0, 0}), 5e-13, 1e-20) << "no cancellation";
  EXPECT_NEAR(measure_error("Linear Elastic", {0, -0.03, 0.02}), 0.03, 1e-15);
  EXPECT_NEAR(measure_error("Linear Elastic", {pi, -0.01, 0.02}), 2.02, 1e-14);
  EXPECT_EQ(measure_error("Linear Elastic", {0, 0, 0}), 0);
}

// In uniaxial compression to the stretch s, P = E s (s^2 - 1)/2, and Hooke's law has E (s - 1).
TEST(StrainMeasureTest, SaintVenantAndKirchhoffsLawSoftensInCompression) {
  const char* const law = "Saint Venant-Kirchhoff";
  for (double s : {0.99, 0.8, 0.6})
    EXPECT_NEAR(measure_error(law, {2, s - 1, 0.5}), 1 - s * (s * s - 1) / 2 / (s - 1), 1e-14) << s;
  EXPECT_TRUE(std::isinf(measure_error(law, {0, 0.57 - 1, 0}))) << "dP/ds < 0 below 1/sqrt(3)";
  EXPECT_EQ(measure_error(law, {pi, 0, 2}), 0) << "turns and tension";
}

TEST(StrainMeasureTest, OtherLawsHoldAndUnknownStrainsDoNot) {
  EXPECT_EQ(measure_error("Neo-Hooke", {}), 0);
  EXPECT_EQ(measure_error("", {}), 0);
  EXPECT_TRUE(std::isinf(measure_error("Linear Elastic", {})));
  EXPECT_TRUE(std::isinf(measure_error("Saint Venant-Kirchhoff", {})));
}

TEST(StrainMeasureTest, ExtremesOverRunsAndRows) {
  MeasuredStrains all;
  all.add({});
  EXPECT_FALSE(all.known());
  all.add({0.1, -0.2, 0.3});
  all.add({0.05, -0.4, 0.1});
  all.add({});
  EXPECT_EQ(all.rotation, 0.1);
  EXPECT_EQ(all.least, -0.4);
  EXPECT_EQ(all.largest, 0.3);

  const test::TemporaryFolder folder;
  const auto write = [&](const std::string& last) {
    test::write_results(folder.path(), "Newmark", 1, 10,
                        {{"largest_rotation", [](double t) { return 0.1 * t; }},
                         {"least_strain", [](double t) { return t < 5 ? -t : 0; }},
                         {last, [](double t) { return 2 * t; }}});
    return HistoryTable(folder.path() + "/history.csv");
  };
  const MeasuredStrains early = measured_strains(write("largest_strain"), 7);
  EXPECT_NEAR(early.rotation, 0.7, 1e-15);
  EXPECT_EQ(early.least, -4);
  EXPECT_EQ(early.largest, 14);
  EXPECT_FALSE(measured_strains(write("other"), 7).known());
}

}  // namespace
}  // namespace ixos
