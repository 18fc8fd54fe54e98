#include "interaction/friction_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "interaction/catalogue.hpp"
#include "interaction/damage_law.hpp"
#include "interaction/van_der_waals.hpp"
#include "support/obstacle_geometry.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

const VanDerWaals wall(2.5, 25);  // the largest attraction is 0.0624428, at 0.3058898
const std::shared_ptr<const GapLaw> law = gap_law(wall);

Friction amontons(double coefficient, double share) {
  Friction friction;
  friction.type = FrictionType::ExtendedAmontons;
  friction.coefficient = coefficient;
  friction.cutoff_share = share;
  return friction;
}

Friction constant(double stress, double sharpness = 0) {
  Friction friction;
  friction.type = FrictionType::ConstantStress;
  friction.stress = stress;
  friction.sharpness = sharpness;
  return friction;
}

TEST(FrictionLawTest, AContactWithoutLoadSlidesAtTheLargestAttraction) {
  const FrictionLaw adhesive(amontons(0.7, 1), law);
  EXPECT_NEAR(adhesive.cutoff(), 0.3058898, 1e-7);
  EXPECT_NEAR(adhesive.threshold(wall.equilibrium_gap())[0], 0.7 * 0.0624428, 1e-8);
  EXPECT_EQ(adhesive.threshold(0.31)[0], 0);
  EXPECT_NEAR(adhesive.slope(adhesive.cutoff() - 1e-9)[0], 0, 1e-7);  // C1
  const FrictionLaw pressed(amontons(0.7, 0), law);
  EXPECT_NEAR(pressed.threshold(0.24)[0], 0.7 * wall.traction(Pack(0.24))[0], 1e-15);
  EXPECT_NEAR(pressed.threshold(wall.equilibrium_gap() - 1e-12)[0], 0, 1e-10);
  EXPECT_EQ(pressed.threshold(0.26)[0], 0);
}

TEST(FrictionLawTest, AConstantStressEndsAtTheCutoff) {
  const FrictionLaw hard(constant(0.02), law);
  EXPECT_EQ(hard.threshold(0.1)[0], 0.02);
  EXPECT_EQ(hard.threshold(0.3)[0], 0.02);
  EXPECT_EQ(hard.threshold_at(0.3), 0.02);
  EXPECT_EQ(hard.threshold(0.31)[0], 0);
  const FrictionLaw smooth(constant(0.02, 100), law);
  EXPECT_EQ(smooth.threshold(smooth.cutoff())[0], 0.01);
  EXPECT_NEAR(smooth.threshold(smooth.cutoff() + 0.01)[0], 0.02 / (1 + std::exp(1.0)), 1e-16);
  EXPECT_EQ(smooth.threshold(1e6)[0], 0);
  EXPECT_EQ(smooth.slope(1e6)[0], 0);
}

TEST(FrictionLawTest, SlopesAreDifferencesAndPlacesWithoutAGapHaveNone) {
  for (const Friction& friction : {amontons(0.7, 1), amontons(0.7, 0.5), constant(0.02), constant(0.02, 30)}) {
    const FrictionLaw own(friction, law);
    for (const double gap : {0.2, 0.25, 0.28, 0.305, 0.35, 2.0})
      EXPECT_NEAR((own.threshold(gap + 1e-6)[0] - own.threshold(gap - 1e-6)[0]) / 2e-6, own.slope(gap)[0], 1e-7) << gap;
    EXPECT_EQ(own.threshold(-std::numeric_limits<double>::infinity())[0], 0);
    EXPECT_EQ(own.slope(-std::numeric_limits<double>::infinity())[0], 0);
  }
}

// A scene that asks for friction gets some, or a refusal: at gaps that surfaces reach some threshold is above 0.
TEST(FrictionLawTest, EveryLawHasAThresholdOrARefusal) {
  int thresholds = 0, refusals = 0;
  for (const LawEntry& entry : laws().entries()) {
    const Teuchos::ParameterList list = test::complete(laws(), entry.name);
    const auto own = laws().make(SceneNode(list, ""));
    for (const double share : {0.0, 0.3, 1.0})
      for (Friction friction : {constant(0.02), constant(0.02, 20), amontons(0.7, share)}) {
        friction.cutoff_share = share;
        SCOPED_TRACE(testing::Message() << entry.name << ", share " << share << ", type "
                                        << static_cast<int>(friction.type));
        if (!test::refusal([&] { FrictionLaw(friction, own); }).empty()) {
          ++refusals;
          EXPECT_TRUE(!own->repels() || own->has_history());
          continue;
        }
        ++thresholds;
        const FrictionLaw of(friction, own);
        EXPECT_GT(of.threshold(0.5 * of.cutoff())[0], 1e-3);
        EXPECT_GE(of.threshold(own->equilibrium_gap())[0], 0);
        // It begins where the traction does not jump.
        if (friction.type == FrictionType::ExtendedAmontons) {
          EXPECT_NEAR(of.threshold(of.cutoff() * (1 - 1e-9))[0], 0, 1e-6);
        }
      }
  }
  EXPECT_GT(thresholds, 40);
  EXPECT_GT(refusals, 20);
}

TEST(FrictionLawTest, TheDefaultElasticSlipIsAShareOfTheEquilibriumGap) {
  const double slip = 0.003 * wall.equilibrium_gap();
  for (double coefficient : {1e-9, 1e-3, 0.3}) {
    const FrictionLaw friction(amontons(coefficient, 1), law);
    EXPECT_NEAR(friction.threshold_at(wall.equilibrium_gap()) / friction.friction().stiffness / slip, 1, 1e-6);
  }
  EXPECT_NEAR(0.02 / FrictionLaw(constant(0.01), law).friction().stiffness, 2 * slip, 1e-15);
  const double stiffest = 100 * 0.0624428 / wall.equilibrium_gap();
  EXPECT_NEAR(FrictionLaw(amontons(10, 1), law).friction().stiffness, stiffest, 1e-4);
  EXPECT_NEAR(FrictionLaw(constant(1), law).friction().stiffness, stiffest, 1e-4);
  EXPECT_GT(FrictionLaw(constant(0), law).friction().stiffness, 0) << "a surface without a threshold needs one too";
  Friction given = constant(0.02);
  given.stiffness = 7;
  EXPECT_EQ(FrictionLaw(given, law).friction().stiffness, 7);
}

TEST(FrictionLawTest, RefusesWhatDoesNotFit) {
  const auto refused = [](const Friction& friction, const std::shared_ptr<const GapLaw>& of, const char* words) {
    test::expect_contains(test::refusal([&] { FrictionLaw(friction, of); }), words);
  };
  const auto bond = gap_law(DamageLaw(0.5, 0.05, 0.8));
  refused({}, law, "has no type");
  refused(amontons(-1, 1), law, "the coefficient -1; it must be finite and at least 0");
  refused(amontons(1, 1.5), law, "the cutoff share 1.5; it must be at least 0 and at most 1");
  refused(constant(-0.1), law, "the stress -0.1");
  refused(amontons(1, 1), bond, "the traction of a law with a history; use the type \"Constant Stress\"");
  Friction soft = constant(1);
  soft.stiffness = -1;
  refused(soft, law, "the stiffness -1; it must be finite and at least 0");
  Friction creeping = amontons(1, 1);
  creeping.type = FrictionType::Smoothed;
  refused(creeping, law, "the slip speed 0");
  EXPECT_EQ(test::refusal([&] { FrictionLaw(constant(1), bond); }), "");
  Friction shared = constant(1);
  shared.cutoff_share = 0.5;
  refused(shared, bond, "the cutoff share 0.5, but the law has a history: it must be 1");
  const auto dugdale = make_gap_law("Smooth Dugdale");
  refused(amontons(1, 1), dugdale, "grows with repulsion, but the law only attracts");
  refused(shared, dugdale, "the law only attracts, without a gap of equilibrium: it must be 1");
  refused(constant(1),
          make_gap_law("Electrostatic", {{"Voltage", 20.0}, {"Permittivity", 4.4e-3}, {"Insulation", 0.1}}),
          "acts at gaps below 0, the gap of the law's largest attraction");
}

}  // namespace
}  // namespace ixos
