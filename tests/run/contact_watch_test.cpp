#include "run/contact_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ixos {
namespace {

using Forces = std::vector<std::pair<std::string, double>>;

/// A front that moves a fifth of a face a row, over 20 faces of length 2; the forces are a smooth one, and one with
/// that amplitude and the wavelength of the faces.
ContactWatch peeled(double amplitude) {
  ContactWatch watch(2);
  for (int row = 0; row <= 100; ++row) {
    const double length = 40 - 0.4 * row;
    watch.row(row, length,
              Forces{{"smooth", 0.5 + 0.001 * length},
                     {"rippled", 1 + amplitude * std::cos(M_PI * length)},
                     {"across", 2 * amplitude * std::cos(M_PI * length)}});
  }
  return watch;
}

TEST(ContactWatchTest, ARippleHasTheSizeOfItsSecondDifference) {
  // f_k - (f_k-1 + f_k+1)/2 = A (1 - cos(2 pi/5)) cos(...), whose mean square is half that of its amplitude.
  const double amplitude = 0.3, difference = amplitude * (1 - std::cos(2 * M_PI / 5));
  const Ripple ripple = peeled(amplitude).ripple();
  EXPECT_EQ(ripple.column, "rippled");
  EXPECT_NEAR(ripple.roughness, difference / std::sqrt(2) / std::sqrt(1 + amplitude * amplitude / 2), 2e-3);
  EXPECT_NEAR(ripple.faces, 20, 0.5);
}

TEST(ContactWatchTest, SmoothForcesAndFrontsAtRestHaveNone) {
  EXPECT_LT(peeled(0).ripple().roughness, 1e-12);
  ContactWatch still(2);
  for (int row = 0; row < 50; ++row) still.row(row, 40, Forces{{"force", row % 2 == 0 ? 1.0 : -1.0}});
  EXPECT_EQ(still.ripple().column, "");
  ContactWatch leaping(2);  // 10 faces a row
  for (int row = 0; row < 50; ++row) leaping.row(row, 2000 - 20.0 * row, Forces{{"force", row % 2 == 0 ? 1.0 : -1.0}});
  EXPECT_EQ(leaping.ripple().column, "");
}

TEST(ContactWatchTest, TheLargestFallIsKept) {
  ContactWatch watch;
  const double measures[] = {10, 9, 3, 3.5, 0};
  for (int row = 0; row < 5; ++row) watch.row(0.5 * row, measures[row], {});
  EXPECT_EQ(watch.largest_measure(), 10);
  EXPECT_EQ(watch.largest_fall().before, 9);
  EXPECT_EQ(watch.largest_fall().after, 3);
  EXPECT_EQ(watch.largest_fall().from, 0.5);
  EXPECT_EQ(watch.largest_fall().to, 1);
  watch.row(3, std::nan(""), {});  // a row without an interaction
  EXPECT_EQ(watch.largest_fall().before, 9);
}

}  // namespace
}  // namespace ixos
