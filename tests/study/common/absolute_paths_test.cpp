// Paths of files beside a scene.
#include "study/common/absolute_paths.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "support/temporary_folder.hpp"

namespace ixos {
namespace {

TEST(AbsolutePathsTest, FilesBesideTheSceneAreFoundFromElsewhere) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() + "/rough.txt") << "1";
  Teuchos::ParameterList scene;
  scene.sublist("Wall").sublist("Height Field").set("File", std::string("rough.txt"));
  scene.sublist("Other").set("File", std::string("missing.txt"));
  scene.sublist("None").set("File", std::string());
  make_paths_absolute(scene, folder.path() + "/scene.xml");
  EXPECT_EQ(scene.sublist("Wall").sublist("Height Field").get<std::string>("File"), folder.path() + "/rough.txt");
  EXPECT_EQ(scene.sublist("Other").get<std::string>("File"), "missing.txt");
  EXPECT_EQ(scene.sublist("None").get<std::string>("File"), "");
}

}  // namespace
}  // namespace ixos
