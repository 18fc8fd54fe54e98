// Meshes of half and of twice the cell length.
#include "study/advice/advice_mesh.hpp"

#include <gtest/gtest.h>

#include "study/compare/study.hpp"
#include "test_folders.hpp"

namespace ixos {
namespace {

MeshLevels levels(const std::string& scene, const Assignments& settings = {}) {
  return mesh_levels(changed_scene(std::string(IXOS_XML_DIRECTORY) + "/" + scene, settings).sublist("Mesh"));
}

TEST(AdviceMeshTest, ABoxIsHalvedAndRefined) {
  const MeshLevels found = levels("strip.xml");
  EXPECT_EQ(found.note, "");
  EXPECT_EQ(found.dimension, 2);
  ASSERT_GE(found.levels.size(), 5U);
  EXPECT_EQ(found.levels[0].settings, Assignments{"Mesh/Box/Divisions={40, 2}"});
  EXPECT_EQ(found.levels[0].size, 8);
  EXPECT_EQ(found.scene_level, 3U);
  EXPECT_EQ(found.levels[3].settings, Assignments{"Mesh/Box/Divisions={320, 16}"});
  EXPECT_EQ(found.levels[4].settings, Assignments{"Mesh/Box/Divisions={640, 32}"});
  EXPECT_EQ(found.levels[4].label, "640 x 32");
}

TEST(AdviceMeshTest, BoundsOfAMeshThatFollowsTheFrontGoWithTheCells) {
  const MeshLevels found = levels("strip-front.xml", {"Mesh/Adapt/Part=0.125", "Mesh/Adapt/Strain=0.02"});
  const AdviceLevel &own = found.levels[found.scene_level], &finer = found.levels[found.scene_level + 1];
  ASSERT_EQ(own.settings.size(), 3U);
  EXPECT_EQ(own.settings[1], "Mesh/Adapt/Part=0.125");
  ASSERT_EQ(finer.settings.size(), 3U);
  EXPECT_NE(finer.settings[0], own.settings[0]);
  EXPECT_EQ(finer.settings[1], "Mesh/Adapt/Part=0.0625");
  EXPECT_EQ(finer.settings[2], "Mesh/Adapt/Strain=0.01");
}

TEST(AdviceMeshTest, AMeshThatOnlyTheFrontRefinesHasLevelsOfHalvings) {
  const MeshLevels found = levels("spatula.xml", {"Mesh/Spatula/Stations=40", "Mesh/Adapt/Levels=2"});
  EXPECT_EQ(found.note, "");
  EXPECT_EQ(found.scene_level, 1U);
  ASSERT_EQ(found.levels.size(), 5U);
  EXPECT_EQ(found.levels[0].settings[0], "Mesh/Adapt/Levels=1");
  EXPECT_EQ(found.levels[0].settings[1], "Mesh/Adapt/Part=0.5");
  EXPECT_EQ(found.levels[2].settings[0], "Mesh/Adapt/Levels=3");
  EXPECT_EQ(found.levels[2].size, 0.5);
}

TEST(AdviceMeshTest, OddNumbersAreNotHalved) {
  const MeshLevels found = levels("strip.xml", {"Mesh/Box/Divisions={50, 3}"});
  EXPECT_EQ(found.scene_level, 0U);
  EXPECT_EQ(found.levels[1].settings, Assignments{"Mesh/Box/Divisions={100, 6}"});
}

TEST(AdviceMeshTest, ADiskKeepsAnEvenCore) {
  const MeshLevels found = levels("ball.xml", {"Mesh/Disk/Core Divisions=8", "Mesh/Disk/Rings=4"});
  EXPECT_EQ(found.scene_level, 1U) << "one ring is too few";
  EXPECT_EQ(found.levels[0].settings, (Assignments{"Mesh/Disk/Core Divisions=4", "Mesh/Disk/Rings=2"}));
  EXPECT_EQ(found.levels[2].settings, (Assignments{"Mesh/Disk/Core Divisions=16", "Mesh/Disk/Rings=8"}));
  EXPECT_EQ(levels("ball.xml", {"Mesh/Disk/Core Divisions=2", "Mesh/Disk/Rings=1"}).scene_level, 0U);
}

TEST(AdviceMeshTest, OneCellAcrossIsTooFewUnlessTheSceneHasIt) {
  EXPECT_EQ(levels("strip.xml", {"Mesh/Box/Divisions={80, 2}"}).scene_level, 0U);
  EXPECT_EQ(levels("strip.xml", {"Mesh/Box/Divisions={80, 1}"}).levels.front().settings,
            Assignments{"Mesh/Box/Divisions={80, 1}"});
}

TEST(AdviceMeshTest, ASpatulaIsAVolume) {
  const MeshLevels found = levels("spatula.xml", {"Mesh/Spatula/Target Cells=16000"});
  EXPECT_EQ(found.dimension, 3);
  EXPECT_EQ(found.levels[found.scene_level - 1].settings, Assignments{"Mesh/Spatula/Target Cells=2000"});
}

TEST(AdviceMeshTest, PartsAreRefinedTogether) {
  const MeshLevels found = levels("two-balls.xml");
  ASSERT_EQ(found.note, "");
  for (const std::string& setting : found.levels[found.scene_level + 1].settings)
    EXPECT_EQ(setting.rfind("Mesh/Parts/", 0), 0U) << setting;
}

TEST(AdviceMeshTest, AFileHasOneLevel) {
  const MeshLevels found = levels("ball.xml", {"Mesh/Type=Exodus", "Mesh/Exodus/File=x.e"});
  ASSERT_EQ(found.levels.size(), 1U);
  EXPECT_TRUE(found.levels[0].settings.empty());
  EXPECT_NE(found.note.find("Exodus"), std::string::npos);
}

}  // namespace
}  // namespace ixos
