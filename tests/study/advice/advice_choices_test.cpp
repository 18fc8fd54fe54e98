// Directions beside step and mesh, of the scenes of xml/.
#include "study/advice/advice_choices.hpp"

#include <gtest/gtest.h>

#include "study/advice/advice_point.hpp"
#include "test_folders.hpp"

namespace ixos {
namespace {

Teuchos::ParameterList complete(const Assignments& settings) {
  return changed_scene(std::string(IXOS_XML_DIRECTORY) + "/strip.xml", settings);
}

/// Returns a direction of the strip with these settings; one without branches if there is none.
AdviceDirection choice(const std::string& name, const Assignments& settings = {}) {
  for (const AdviceDirection& each : advice_choices(complete(settings)))
    if (each.name == name) return each;
  return {};
}

TEST(AdviceChoicesTest, ATighterToleranceIsRunOnlyIfTheScenesOwnIsLoose) {
  const AdviceDirection usual = choice("Newton tolerance");
  EXPECT_FALSE(usual.suspect);
  EXPECT_EQ(usual.branches[0].levels.size(), 3U);
  EXPECT_EQ(usual.scene_level, 2U);
  EXPECT_EQ(usual.branches[0].levels[0].settings, Assignments{"Nonlinear Solver/Tolerance=1e-06"});
  const AdviceDirection loose = choice("Newton tolerance", {"Nonlinear Solver/Tolerance=1e-4"});
  EXPECT_TRUE(loose.suspect);
  EXPECT_EQ(loose.scene_level, 0U);
  ASSERT_EQ(loose.branches[0].levels.size(), 2U);
  EXPECT_NEAR(loose.branches[0].levels[1].size, 1e-6, 1e-12);
}

TEST(AdviceChoicesTest, SurfacePointsAreDoubled) {
  const AdviceDirection usual = choice("surface points");  // 8, because the strip has Q1C4
  EXPECT_FALSE(usual.suspect);
  ASSERT_EQ(usual.branches[0].levels.size(), 3U);
  EXPECT_EQ(usual.branches[0].levels[0].settings, Assignments{"Interactions/Wall/Surface Points=3"});
  EXPECT_EQ(usual.branches[0].levels[2].settings, Assignments{"Interactions/Wall/Surface Points=16"});
  const AdviceDirection few = choice("surface points", {"Interactions/Wall/Surface Points=2"});
  EXPECT_TRUE(few.suspect);
  EXPECT_EQ(few.scene_level, 0U);
  EXPECT_EQ(few.branches[0].levels[1].settings, Assignments{"Interactions/Wall/Surface Points=4"});
  EXPECT_TRUE(choice("surface points", {"Interactions/Wall/Contact Element=Q1C1"}).branches[0].levels.size() == 3);
}

TEST(AdviceChoicesTest, ACutoffIsSuspect) {
  EXPECT_TRUE(choice("cutoff").branches.empty());
  const AdviceDirection found = choice("cutoff", {"Interactions/Wall/Cutoff=3"});
  ASSERT_FALSE(found.branches.empty());
  EXPECT_TRUE(found.suspect);
  EXPECT_EQ(found.branches[0].levels[found.scene_level + 1].settings, Assignments{"Interactions/Wall/Cutoff=6"});
}

TEST(AdviceChoicesTest, DampingCanBeLeftOut) {
  EXPECT_TRUE(choice("damping").branches.empty());
  const AdviceDirection found = choice("damping", {"Materials/Strip/Mass Damping=0.1"});
  ASSERT_EQ(found.branches.size(), 2U);
  EXPECT_FALSE(found.converges);
  EXPECT_EQ(found.branches[1].settings[0], "Materials/Strip/Mass Damping=0");
}

TEST(AdviceChoicesTest, ALinearMaterialIsAChoiceOfSomeOthers) {
  EXPECT_EQ(choice("material").branches[1].label, "Linear Elastic");
  EXPECT_EQ(choice("material").branches[1].law, "Linear Elastic") << "its strain measure must hold";
  EXPECT_TRUE(choice("material", {"Materials/Strip/Model=Linear Elastic"}).branches.empty());
}

TEST(AdviceChoicesTest, EverySettingIsOneOfTheScene) {
  const Assignments settings{"Interactions/Wall/Cutoff=3", "Materials/Strip/Mass Damping=0.1"};
  for (const AdviceDirection& direction : advice_choices(complete(settings)))
    for (const AdviceBranch& branch : direction.branches)
      for (const AdviceLevel& level : branch.levels) {
        Assignments all = settings;
        all.insert(all.end(), branch.settings.begin(), branch.settings.end());
        all.insert(all.end(), level.settings.begin(), level.settings.end());
        EXPECT_NO_THROW(complete(all)) << direction.name << ", " << branch.label << level.label;
      }
}

}  // namespace
}  // namespace ixos
