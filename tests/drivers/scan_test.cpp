// ixos-study --scan: a number over varied parameters.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <sstream>

#include "drivers/driver_test.hpp"
#include "support/files.hpp"

namespace ixos::test {
namespace {

/// A square that is stretched by a tenth: with nu = 0 its reaction is E/10 a depth of 1.
const char* const stretched = R"x(<ParameterList name="Stretched">
  <ParameterList name="Mesh">
    <Parameter name="Type" type="string" value="Box"/>
    <ParameterList name="Box">
      <Parameter name="Lengths" type="Array(double)" value="{1, 1}"/>
      <Parameter name="Divisions" type="Array(int)" value="{2, 2}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Materials">
    <ParameterList name="Rubber">
      <Parameter name="Model" type="string" value="Linear Elastic"/>
      <Parameter name="Poisson's Ratio" type="double" value="0"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Histories">
    <ParameterList name="Up">
      <Parameter name="Type" type="string" value="Ramp"/>
      <ParameterList name="Ramp">
        <Parameter name="Value" type="double" value="0.1"/>
        <Parameter name="Length" type="double" value="1"/>
        <Parameter name="Shape" type="string" value="Linear"/>
      </ParameterList>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Boundary Conditions">
    <ParameterList name="Floor"><Parameter name="Node Set" type="string" value="bottom"/></ParameterList>
    <ParameterList name="Lift">
      <Parameter name="Node Set" type="string" value="top"/>
      <Parameter name="Components" type="string" value="y"/>
      <Parameter name="History" type="string" value="Up"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Output">
    <Parameter name="Reactions" type="Array(string)" value="{top}"/>
  </ParameterList>
  <ParameterList name="Time Integrator">
    <Parameter name="Type" type="string" value="Static"/>
    <ParameterList name="Time Step Control">
      <Parameter name="Time Step" type="double" value="0.5"/>
      <Parameter name="Final Time" type="double" value="1"/>
    </ParameterList>
  </ParameterList>
</ParameterList>)x";

class ScanTest : public DriverTest {
 protected:
  void SetUp() override { write(stretched); }
  Outcome scan(const std::string& options) const {
    return shell("'" IXOS_STUDY_DRIVER "' --scan scene.xml " + options, folder_);
  }
  /// The cells of a column of scan.csv without quotes.
  std::vector<std::string> column(std::size_t place, const std::string& folder = "scene-scan.results") const {
    std::istringstream lines(contents(folder_ + "/" + folder + "/scan.csv"));
    std::vector<std::string> cells;
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
      std::istringstream row(line);
      std::string cell;
      for (std::size_t i = 0; i <= place; ++i) std::getline(row, cell, ',');
      cells.push_back(cell);
    }
    return cells;
  }
};

const std::string moduli = "--vary \"Materials/Rubber/Young's Modulus=1:16:5:log\" ";
const std::string force = "--collect \"final reaction_top_y\" ";

TEST_F(ScanTest, TheForceIsProportionalToTheModulusAndRunsAreReused) {
  const Outcome told = scan(moduli + force + "--jobs 2");
  EXPECT_EQ(told.status, 0) << told.output;
  const std::vector<std::string> found = column(2);
  ASSERT_EQ(found.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(std::stod(found[i]), 0.1 * std::pow(2, i), 1e-9);
  EXPECT_NE(told.output.find("Young's Modulus  final reaction_top_y\n"), std::string::npos) << told.output;
  EXPECT_TRUE(std::filesystem::exists(folder_ + "/scene-scan.results/scan.png"));
  const std::string again = scan(moduli + force).output;
  EXPECT_NE(again.find("[5/5] 16: completed"), std::string::npos) << again;
  std::size_t reused = 0;
  for (auto at = again.find("(reused)"); at != std::string::npos; at = again.find("(reused)", at + 1)) ++reused;
  EXPECT_EQ(reused, 5U) << again;
}

TEST_F(ScanTest, CombinationsOfSeveralParametersAreRun) {
  ASSERT_EQ(scan("--vary 'Histories/Up/Ramp/Value={0.1, 0.2}' " + moduli + force + "--quiet --output both").status, 0);
  EXPECT_EQ(column(1, "both"),
            (std::vector<std::string>{"0.1", "0.1", "0.1", "0.1", "0.1", "0.2", "0.2", "0.2", "0.2", "0.2"}));
  EXPECT_NEAR(std::stod(column(3, "both").back()), 3.2, 1e-9);
}

TEST_F(ScanTest, ARunThatFailsLeavesItsCellEmpty) {
  const Outcome told =
      scan("--vary 'Histories/Up/Ramp/Value={0.1, -3}' " + force + "--set 'Materials/Rubber/Model=Neo-Hooke'");
  EXPECT_EQ(told.status, 0) << told.output;
  EXPECT_NE(column(2)[0], "");
  EXPECT_EQ(column(2)[1], "");
  EXPECT_EQ(column(3), (std::vector<std::string>{"completed", "diverged"}));
  EXPECT_NE(told.output.find("diverged: no equilibrium found"), std::string::npos) << told.output;
  const Outcome none = scan("--vary 'Histories/Up/Ramp/Value={-3, -4}' " + force + "--output none " +
                            "--set 'Materials/Rubber/Model=Neo-Hooke'");
  EXPECT_EQ(none.status, 3) << none.output;
  EXPECT_NE(none.output.find("no run has a value"), std::string::npos) << none.output;
}

TEST_F(ScanTest, TheScenesOwnQuantitiesAreTheDefault) {
  ASSERT_EQ(scan(moduli + "--quiet --set 'Output/Quantities={work}'").status, 0);
  EXPECT_NEAR(std::stod(column(2)[0]), 0.005, 1e-10);
}

TEST_F(ScanTest, WhatCannotBeRunIsRefused) {
  const auto expect = [&](const std::string& options, const std::string& words) {
    const Outcome told = scan(options);
    EXPECT_EQ(told.status, 2) << told.output;
    EXPECT_NE(told.output.find(words), std::string::npos) << told.output;
  };
  expect(force, "--vary");
  expect(moduli, "--collect is missing, and the scene names no Output/Quantities");
  expect("--vary 'Materials/Rubber/Young=1:2:3' " + force, "run 1: --set Materials/Rubber/Young");
  const std::string unknown = "--collect 'final reaction_foot_y' ";
  const std::string words =
      "--collect: \"final reaction_foot_y\": column \"reaction_foot_y\" does not exist; did you mean";
  expect(moduli + unknown + "--output new", words);
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/new")) << "refused before a run";
  expect("--vary 'Boundary Conditions/Lift/Node Set={tip, top}' " + unknown, words);  // the second run can tell
  ASSERT_EQ(scan(moduli + force + "--quiet").status, 0);
  expect(moduli + unknown, words);
  EXPECT_TRUE(std::filesystem::exists(folder_ + "/scene-scan.results/scan.csv")) << "the results stay";
  EXPECT_NE(contents(folder_ + "/scene-scan.results/scan.json").find("\"unit\": \"E0\""), std::string::npos);
  expect(moduli + moduli + force, "\"Materials/Rubber/Young's Modulus\" is varied twice");
  const Outcome other = shell("'" IXOS_STUDY_DRIVER "' study.xml --jobs 2", folder_);
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.output.find("--set and --jobs need --advise or --scan"), std::string::npos) << other.output;
}

TEST_F(ScanTest, MoreJobsThanProcessorsAreNoted) {
  const Outcome told = scan(moduli + force + "--jobs 64");
  EXPECT_EQ(told.status, 0) << told.output;
  EXPECT_NE(told.output.find("Note: 64 jobs share "), std::string::npos) << told.output;
}

}  // namespace
}  // namespace ixos::test
