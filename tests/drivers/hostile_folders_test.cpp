// Links, pipes and devices in results folders: nothing is written where they lead, and nobody waits for them.
#include <gtest/gtest.h>

#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "drivers/process.hpp"
#include "support/files.hpp"

namespace ixos {
namespace {

namespace fs = std::filesystem;
using test::contents;
using test::Outcome;

class HostileFoldersTest : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_ + "/scene.xml") << R"x(<ParameterList name="Small">
  <ParameterList name="Mesh"><Parameter name="Type" type="string" value="Box"/></ParameterList>
  <ParameterList name="Materials"><ParameterList name="Rubber"/></ParameterList>
  <ParameterList name="Time Integrator"><ParameterList name="Time Step Control">
    <Parameter name="Final Time" type="double" value="0.02"/>
    <Parameter name="Time Step" type="double" value="0.01"/></ParameterList></ParameterList>
  <ParameterList name="Output"><Parameter name="Fields Interval" type="int" value="1"/></ParameterList>
</ParameterList>)x";
  }
  void TearDown() override { fs::remove_all(folder_); }
  Outcome ixos(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "scene.xml");
    return test::ixos(arguments, folder_);
  }
  std::string folder_ = test::scratch_folder();
};

TEST_F(HostileFoldersTest, WhatIsWrittenDoesNotFollowLinks) {
  std::ofstream(folder_ + "/precious") << "keep me";
  for (const char* format : {"Exodus", "HDF5"}) {
    const std::string out = std::string("out-") + format;
    fs::create_directory(folder_ + "/" + out);
    for (const char* name : {"history.csv", "fields.e", "effective.xml", "effective.xml.tmp", "summary.json",
                             "summary.json.tmp", "checkpoint-2.h5", "checkpoint-2.h5.tmp", "checkpoint.h5"})
      fs::create_symlink("../precious", folder_ + "/" + out + "/" + name);
    const std::string setting = std::string("Output/Fields Format=") + format;
    const Outcome refused = ixos({"--output", out, "--set", setting});
    EXPECT_EQ(refused.status, 2) << refused.output;
    const Outcome outcome = ixos({"--output", out, "--overwrite", "--set", setting});
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_EQ(contents(folder_ + "/precious"), "keep me") << format;
    EXPECT_GT(contents(folder_ + "/" + out + "/history.csv").size(), 100U);
  }
  fs::create_symlink("precious", folder_ + "/mesh.e");
  EXPECT_EQ(ixos({"--write-mesh", "mesh.e"}).status, 2);
  EXPECT_TRUE(fs::is_symlink(folder_ + "/mesh.e"));
  EXPECT_EQ(ixos({"--write-mesh", "mesh.e", "--overwrite"}).status, 0);
  EXPECT_EQ(contents(folder_ + "/precious"), "keep me");
}

TEST_F(HostileFoldersTest, PipesAndDevicesAreNotReadFrom) {
  ASSERT_EQ(ixos({"--output", "out", "--set", "Output/Checkpoint/Interval=1"}).status, 0);
  const auto with = [&](const char* name, const char* device) {
    fs::remove_all(folder_ + "/bad");
    fs::copy(folder_ + "/out", folder_ + "/bad", fs::copy_options::copy_symlinks | fs::copy_options::recursive);
    const std::string path = folder_ + "/bad/" + name;
    fs::remove(path);
    if (device == nullptr)
      EXPECT_EQ(mkfifo(path.c_str(), 0600), 0);
    else
      fs::create_symlink(device, path);
    return ixos({"--output", "bad", "--restart", "bad", "--set", "Time Integrator/Time Step Control/Final Time=0.03"});
  };
  for (const char* device : {static_cast<const char*>(nullptr), "/dev/zero"}) {
    const Outcome history = with("history.csv", device);
    EXPECT_EQ(history.status, 2);
    EXPECT_NE(history.output.find("cannot resume: the table is missing"), std::string::npos) << history.output;
    const Outcome fields = with("fields.e", device);
    EXPECT_EQ(fields.status, 2);
    EXPECT_NE(fields.output.find("cannot resume: "), std::string::npos) << fields.output;
    // The newest sound checkpoint is another one.
    EXPECT_EQ(with("checkpoint-9.h5", device).status, 0);
    EXPECT_EQ(with("checkpoint-2.h5", device).status, 0);
  }
}

}  // namespace
}  // namespace ixos
