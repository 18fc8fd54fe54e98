// Directions of the scenes of xml/.
#include "study/advice/advice_directions.hpp"
#include "test_folders.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace ixos {
namespace {

std::string path(const std::string& scene) { return std::string(IXOS_XML_DIRECTORY) + "/" + scene; }

AdviceDirections directions(const std::string& scene, const Assignments& settings = {}) {
  return advice_directions(changed_scene(path(scene), settings));
}

const AdviceBranch* branch(const AdviceDirection& direction, const std::string& label) {
  for (const AdviceBranch& each : direction.branches)
    if (each.label == label) return &each;
  return nullptr;
}

TEST(AdviceDirectionsTest, EverySettingIsOneOfTheScene) {
  for (const char* scene : {"ball.xml", "strip.xml", "spatula.xml", "two-balls.xml", "jkr.xml", "rate-peel.xml"}) {
    const AdviceDirections found = directions(scene);
    ASSERT_GE(found.all.size(), 2U) << scene;
    for (const AdviceDirection& direction : found.all)
      for (const AdviceBranch& each : direction.branches) {
        Assignments settings = each.settings;
        settings.insert(settings.end(), each.levels.front().settings.begin(), each.levels.front().settings.end());
        EXPECT_NO_THROW(changed_scene(path(scene), settings)) << scene << ", " << direction.name << ", " << each.label;
      }
    EXPECT_NO_THROW(changed_scene(path(scene), found.perturbation)) << scene;
    EXPECT_FALSE(found.perturbation.empty());
  }
}

TEST(AdviceDirectionsTest, StepsOfTheStrip) {
  const AdviceDirections found = directions("strip.xml");
  const AdviceDirection& time = found.all[time_direction];
  // 16 times 0.1 T0 gives 100 steps.
  EXPECT_EQ(time.branches[0].label, "Gautam-Sauer Composite");
  EXPECT_EQ(time.branches[0].levels.front().settings, Assignments{"Time Integrator/Time Step Control/Time Step=1.6"});
  EXPECT_EQ(time.branches[0].levels[time.scene_level].size, 0.1);
  EXPECT_NE(branch(time, "Newmark"), nullptr);
  EXPECT_NE(branch(time, "Static"), nullptr);
  EXPECT_EQ(std::count_if(time.branches.begin(), time.branches.end(),
                          [](const AdviceBranch& each) { return each.label == "Gautam-Sauer Composite"; }),
            1);
  EXPECT_FALSE(found.adaptive);
}

TEST(AdviceDirectionsTest, NoFewerThanThirtySteps) {
  const AdviceDirections found = directions("strip.xml", {"Time Integrator/Time Step Control/Final Time=20"});
  EXPECT_EQ(found.all[time_direction].branches[0].levels.front().size, 0.4) << "50 steps; 0.8 would give 25";
}

TEST(AdviceDirectionsTest, AdaptiveStepsHaveATolerance) {
  const AdviceDirections found = directions("ball.xml", {"Time Integrator/Time Step Control/Type=Adaptive",
                                                         "Time Integrator/Time Step Control/Adaptive/Tolerance=1e-4"});
  EXPECT_TRUE(found.adaptive);
  const AdviceDirection& time = found.all[time_direction];
  EXPECT_EQ(time.name, "step tolerance");
  EXPECT_NEAR(time.branches[0].levels[time.scene_level + 1].size, 2.5e-5, 1e-12);
}

TEST(AdviceDirectionsTest, ElementsAndModels) {
  const AdviceDirections found = directions("strip.xml");
  const AdviceDirection& mesh = found.all[mesh_direction];
  EXPECT_EQ(mesh.branches[0].label, "Q1C4");
  for (const char* label : {"Q1C1", "Q1C2", "Enhanced cells", "quadratic cells"})
    EXPECT_NE(branch(mesh, label), nullptr) << label;
  const auto material = std::find_if(found.all.begin(), found.all.end(),
                                     [](const AdviceDirection& each) { return each.name == "material"; });
  ASSERT_NE(material, found.all.end());
  EXPECT_EQ(material->branches[1].settings, Assignments{"Materials/Strip/Model=Linear Elastic"});
  EXPECT_FALSE(material->converges);
}

TEST(AdviceDirectionsTest, AStaticSceneStaysStatic) {
  EXPECT_EQ(directions("strip.xml", {"Time Integrator/Type=Static"}).all[time_direction].branches.size(), 1U);
}

}  // namespace
}  // namespace ixos
