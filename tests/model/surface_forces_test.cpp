// Settings of interactions that are refused.
#include "model/surface_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "interaction/catalogue.hpp"

namespace ixos {
namespace {

/// Returns the refusal of a cutoff of the law; empty if there is none.
std::string cutoff_refusal(const char* law, double cutoff) {
  SurfaceForces forces;
  forces.law = make_gap_law(law);
  forces.cutoff = cutoff;
  const auto refusal = refusal_of_forces(forces);
  return refusal ? refusal->in_words() : "";
}

TEST(SurfaceForcesTest, ACutoffLeavesTheLargestTraction) {
  EXPECT_EQ(cutoff_refusal("Van der Waals", 0.3),
            "Cutoff 0.3 cuts off the attraction; it must be 0, or greater than the gap of largest attraction, 0.30589");
  EXPECT_EQ(cutoff_refusal("Penalty", 0.2),
            "Cutoff 0.2 cuts off the repulsion; it must be 0, or greater than the gap at which it ends, 0.25");
  EXPECT_EQ(cutoff_refusal("Penalty", 0.3), "");
  EXPECT_EQ(cutoff_refusal("Triangle", 0.2), "");
  EXPECT_EQ(cutoff_refusal("Bilinear Damage", 0.2),
            "Cutoff 0.2 cuts off a law with a history, which ends by itself at 0.496316; it must be 0");
  EXPECT_EQ(cutoff_refusal("Bilinear Damage", 0.5), "");
}

TEST(SurfaceForcesTest, TheFirstSettingThatIsNotAllowedIsNamed) {
  SurfaceForces forces;
  EXPECT_EQ(refusal_of_forces(forces)->in_words(), "Law is missing");
  forces.law = make_gap_law("Van der Waals");
  EXPECT_FALSE(refusal_of_forces(forces));
  forces.points = 65;
  EXPECT_EQ(refusal_of_forces(forces)->in_words(),
            "Surface Points 65 is out of range: 0 to 64 Gauss points a direction are allowed");
  forces.points = 64;
  for (const double margin : {0.0, 1.0, std::nan("")}) {
    forces.margin = margin;
    EXPECT_EQ(refusal_of_forces(forces)->setting, "Step Margin") << margin;
  }
}

TEST(SurfaceForcesTest, FrictionWhoseTractionJumpsWithinAStepIsRefused) {
  SurfaceForces forces;
  forces.law = make_gap_law("Van der Waals");
  forces.friction.type = FrictionType::ConstantStress;
  forces.friction.current = true;
  EXPECT_EQ(refusal_of_forces(forces)->in_words().find("Friction/Threshold \"Current\" with the Type"), 0U);
  forces.friction.sharpness = 20;
  EXPECT_FALSE(refusal_of_forces(forces));
  forces.friction.sharpness = 0;
  forces.friction.current = false;
  EXPECT_FALSE(refusal_of_forces(forces));
}

}  // namespace
}  // namespace ixos
