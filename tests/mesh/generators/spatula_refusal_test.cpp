// Shapes of the spatula that are refused.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "mesh/generators/spatula.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

std::string refusal(const std::function<void(SpatulaShape&)>& change) {
  SpatulaShape shape;
  shape.target_cells = 1000;
  change(shape);
  return test::refusal([&] { spatula(shape); });
}

TEST(SpatulaRefusalTest, BadLengthsAreRefused) {
  const std::vector<std::pair<std::string, double SpatulaShape::*>> lengths{
      {"pad length", &SpatulaShape::pad_length},
      {"neck width", &SpatulaShape::neck_width},
      {"widening length", &SpatulaShape::widening_length},
      {"tip length", &SpatulaShape::tip_length},
      {"rear thickness", &SpatulaShape::rear_thickness},
      {"tip thickness", &SpatulaShape::tip_thickness},
      {"shaft diameter", &SpatulaShape::shaft_diameter},
      {"shaft length", &SpatulaShape::shaft_length},
      {"gap", &SpatulaShape::gap}};
  for (const auto& [name, member] : lengths) {
    const auto field = member;
    EXPECT_EQ(refusal([&](SpatulaShape& s) { s.*field = 0; }), "" + name + " 0 must be positive");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal([&](SpatulaShape& s) { s.*field = nan; }), "" + name + " nan must be positive");
  }
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.tip_width = 90; }), "tip width 90 must be at least the neck width, 100");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.tip_length = 140; }),
            "tip length 140 must be at most the pad length less the widening length, 130");
}

TEST(SpatulaRefusalTest, BadBendsAreRefused) {
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.inclination = 91; }),
            "inclination 91 must be greater than 0 and at most 90");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.fillet_radius = 40; }),
            "fillet radius 40 must be greater than half the thickness of shaft and pad, 40");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.transition_length = 50; }),
            "transition length 50 must be at least the length of the fillet, 53.4071");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.inclination = 20; }),
            "transition length 100 is too short, the transition sinks below the pad's underside: lengthen it, "
            "or choose a larger inclination or a smaller fillet radius or shaft diameter");
}

TEST(SpatulaRefusalTest, BadCountsAreRefused) {
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.core_cells = 5; }), "core cells 5 must be even and between 4 and 1000");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.core_layers = 0; }), "core layers 0 must be between 1 and 100");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.rings = 0; }), "rings 0 must be between 1 and 100");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.tip_rows = 22; }),
            "tip rows 22 must be between 1 and half the core cells less 1, 21");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.stations = 2; }), "stations 2 must be 0, or between 3 and 100000");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.target_cells = 100; }),
            "target cells 100 must be between 200 and 20000000");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.growth = 0.5; }), "growth 0.5 must be between 1 and 100");
  EXPECT_EQ(refusal([](SpatulaShape& s) { s.layer_ratio = 0; }), "layer ratio 0 must be between 1 and 100");
}

}  // namespace
}  // namespace ixos
