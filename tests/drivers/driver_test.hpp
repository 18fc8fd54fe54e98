/// What the tests of the driver share.
#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "drivers/process.hpp"

namespace ixos::test {

inline const std::string ball = std::string(IXOS_XML_DIRECTORY) + "/ball.xml";
inline const std::string strip = std::string(IXOS_XML_DIRECTORY) + "/strip.xml";

/// A folder of its own for each test, gone after it.
class DriverTest : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Refused with this status and message, and without results.
  void expect_refused(int status, const std::vector<std::string>& arguments, const std::string& message) {
    const Outcome outcome = ixos(arguments, folder_);
    EXPECT_EQ(outcome.status, status) << outcome.output;
    EXPECT_NE(outcome.output.find(message), std::string::npos) << outcome.output;
    EXPECT_FALSE(std::filesystem::exists(folder_ + "/out")) << "something was written";
  }
  std::string write(const std::string& text) {
    std::ofstream(folder_ + "/scene.xml") << text;
    return "scene.xml";
  }

  std::string folder_ = scratch_folder();
};

}  // namespace ixos::test
