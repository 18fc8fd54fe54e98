#include "scene/read/obstacle_files.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "scene/scene_changes.hpp"
#include "scene/scene_file.hpp"
#include "scene/simulation.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"
#include "support/temporary_folder.hpp"
#include "test_folders.hpp"

namespace ixos {
namespace {

Teuchos::ParameterList scene_with(const std::string& file) {
  Teuchos::ParameterList scene;
  Teuchos::ParameterList& wall = scene.sublist("Interactions").sublist("Wall");
  wall.set("Obstacle", "Height Field");
  wall.sublist("Height Field").set("File", file);
  return scene;
}

Teuchos::ParameterList field_of(const Teuchos::ParameterList& scene) {
  return Teuchos::ParameterList(scene.sublist("Interactions").sublist("Wall").sublist("Height Field"));
}

TEST(ObstacleFilesTest, AFileBesideTheSceneIsFound) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() + "/scan.gsf") << "1";
  EXPECT_EQ(field_of(with_obstacle_files(scene_with("scan.gsf"), folder.path())).get<std::string>("File"),
            folder.path() + "/scan.gsf");
  EXPECT_EQ(field_of(with_obstacle_files(scene_with("other.gsf"), folder.path())).get<std::string>("File"),
            (std::filesystem::current_path() / "other.gsf").string());
}

TEST(ObstacleFilesTest, AMetreIsThatOfTheScenesUnits) {
  Teuchos::ParameterList scene = scene_with("scan.gsf");
  scene.sublist("Units").set("Length", "20 nm");
  EXPECT_NEAR(field_of(with_obstacle_files(scene, ".")).get<double>("Metre"), 5e7, 1e-7);
  scene.sublist("Interactions").sublist("Wall").sublist("Height Field").set("Metre", 3.0);
  EXPECT_EQ(field_of(with_obstacle_files(scene, ".")).get<double>("Metre"), 3);
}

// A restart recognises the heights, not the place of their file.
TEST(ObstacleFilesTest, ChecksumsAreThoseOfTheContents) {
  const test::TemporaryFolder folder;
  const auto sums = [&](const std::string& name, const std::string& text) {
    if (!text.empty()) std::ofstream(folder.path() + name) << text;
    return obstacle_file_checksums(scene_with(folder.path() + name));
  };
  const std::vector<double> first = sums("/one.txt", "0 0 1 0 0");
  EXPECT_EQ(first.size(), 4U);
  EXPECT_EQ(sums("/two.txt", "0 0 1 0 0"), first);
  EXPECT_NE(sums("/one.txt", "0 0 2 0 0"), first);
  EXPECT_TRUE(sums("/none.txt", "").empty());
  EXPECT_TRUE(obstacle_file_checksums(Teuchos::ParameterList()).empty());

  const auto changes = scene_changes(scene_with("/one.txt"), scene_with("/two.txt"));
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].bearing, Bearing::None);
  EXPECT_TRUE(scene_changes(scene_with("/here/one.txt"), scene_with("/there/one.txt")).empty());
}

// Nobody is at the other end of the pipe, and the device has no end: an ordinary reader would wait.
TEST(ObstacleFilesTest, APipeOrADeviceIsRefusedAtOnce) {
  const test::TemporaryFolder folder;
  const std::string pipe = folder.path() + "/scan.gsf";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_TRUE(obstacle_file_checksums(scene_with(pipe)).empty());
  EXPECT_TRUE(obstacle_file_checksums(scene_with("/dev/zero")).empty());
  const std::string scene = std::string(IXOS_TEST_DIRECTORY) + "/guide/rough-wall.xml";
  const std::string message = test::refusal([&] { Simulation(read_scene_file(scene), test::self(), folder.path()); });
  test::expect_contains(message, "Interactions/Wall");
  test::expect_contains(message, pipe + ": the file of heights cannot be read");
}

TEST(ObstacleFilesTest, OtherScenesStayAsTheyAre) {
  Teuchos::ParameterList scene;
  EXPECT_TRUE(with_obstacle_files(scene, ".") == scene);
  scene.sublist("Interactions").set("Wall", "a text where a list has to be");
  EXPECT_TRUE(with_obstacle_files(scene, ".") == scene);
}

TEST(ObstacleFilesTest, AFieldCountsForTheFingerprintButNotItsPlace) {
  const std::string guide = std::string(IXOS_TEST_DIRECTORY) + "/guide";
  const test::TemporaryFolder folder;
  const std::string scan = folder.path() + "/scan.gsf";
  std::filesystem::copy(guide + "/scan.gsf", scan);
  const auto fingerprint_in = [&](const std::string& place) {
    return Simulation(read_scene_file(guide + "/rough-wall.xml"), test::self(), place).mesh_fingerprint();
  };
  const std::string first = fingerprint_in(guide);
  EXPECT_EQ(fingerprint_in(folder.path()), first);
  std::fstream file(scan, std::ios::in | std::ios::out | std::ios::binary);
  file.seekg(-4, std::ios::end);  // the lowest byte of the last height
  const int byte = file.get();
  file.seekp(-4, std::ios::end);
  file.put(static_cast<char>(byte ^ 1));
  file.close();
  EXPECT_NE(fingerprint_in(folder.path()), first);
}

// The wall is a wave of length 64 nm and amplitude 0.2 nm, whose crest is below the middle of the plate. Its slopes are
// so small that the distance is the height to 2e-4.
TEST(ObstacleFilesTest, TheSceneOfTheGuideFeelsTheScan) {
  const std::string folder = std::string(IXOS_TEST_DIRECTORY) + "/guide";
  const Simulation simulation(read_scene_file(folder + "/rough-wall.xml"), test::world(), folder);
  const std::vector<double> rest = test::at_rest(simulation.model());
  const InteractionReport report = test::ReportAt(simulation.model(), rest.data()).interaction_report();
  const auto law = make_gap_law("Van der Waals")->cut_off(1.5);
  double force = 0;
  constexpr int parts = 3200;
  for (int k = 0; k < parts; ++k) {
    const double x = -16 + 32 * (k + 0.5) / parts;
    force += 32.0 / parts * law->traction(0.35 + 0.2 * (1 - std::cos(2 * M_PI * x / 64)))[0];
  }
  EXPECT_NEAR(report.least_gap, 0.35, 1e-3);
  EXPECT_NEAR(report.force[1], force, 3e-3 * std::abs(force));
  EXPECT_NEAR(report.force[0], 0, 1e-6);
}

}  // namespace
}  // namespace ixos
