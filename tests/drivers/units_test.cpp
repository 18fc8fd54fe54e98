// Scenes with units, in the command: their numbers, their results and what is refused.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "drivers/driver_test.hpp"
#include "support/files.hpp"

namespace ixos::test {
namespace {

class UnitsTest : public DriverTest {
 protected:
  /// Explains a scene of two plates from gmsh, "soft" and "hard one", under a load with these parameters.
  std::string explain_plates(const std::vector<std::string>& load) {
    std::vector<std::string> arguments{
        "scene.xml", "--explain",
        "--set",     "Mesh/Type=Gmsh",
        "--set",     "Mesh/Gmsh/File=" + std::string(IXOS_TEST_DIRECTORY) + "/io/gmsh/plates.msh",
        "--set",     "Materials/Soft/Block=soft",
        "--set",     "Materials/Hard/Block=hard one",
        "--set",     "Time Integrator/Time Step Control/Final Time=1",
        "--set",     "Time Integrator/Time Step Control/Time Step=0.1"};
    for (const std::string& parameter : load) {
      arguments.emplace_back("--set");
      arguments.push_back("Boundary Conditions/Load/" + parameter);
    }
    write(R"(<ParameterList><ParameterList name="Histories"><ParameterList name="Slow">
        <Parameter name="Type" type="string" value="Constant"/></ParameterList></ParameterList></ParameterList>)");
    const Outcome outcome = ixos(arguments, folder_);
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    return outcome.output;
  }
};

TEST_F(UnitsTest, ExplainGivesNumbersInSIUnitsAndWhatFollowsFromThem) {
  const std::string scene = std::string(IXOS_TEST_DIRECTORY) + "/guide/ball-si.xml";
  const Outcome outcome = ixos({scene, "--explain", "--quiet"}, folder_);
  EXPECT_EQ(outcome.status, 0);
  // E = 2 GPa, nu = 0.2, rho = 1000 kg/m^3: a wave has sqrt(E (1 - nu)/(rho (1 + nu)(1 - 2 nu))) = 1490.7 m/s.
  for (const char* part :
       {"Units: L0 = 1 nm, T0 = 1 ns, E0 = 2 GPa, L0/T0 = 1 m/s, E0 L0 = 2 N/m", "per depth",
        "Mesh/Disk/Diameter: 10 L0 = 10 nm\n", "Materials/Ball/Density: 5e-07 E0 T0^2/L0^2 = 1000 kg/m^3\n",
        "Time Integrator/Time Step Control/Time Step: 0.001 T0 = 1 ps\n", "wave speed 1490.71 L0/T0 = 1.491 km/s",
        "work of adhesion W 0.0154957 E0 L0 = 30.99 mJ/m^2", "elasto-adhesive length W/E 0.0154957 L0 = 15.5 pm",
        "Tabor number", "gravity length E/weight of Ball: 2.03874e+14 L0 = 203.9 km"})
    EXPECT_NE(outcome.output.find(part), std::string::npos) << part << " in " << outcome.output;
}

TEST_F(UnitsTest, ASceneInSIUnitsGivesTheHistoryOfPlainNumbers) {
  const std::string step = "Time Integrator/Time Step Control/";
  ASSERT_EQ(ixos({ball, "--output", "plain", "--quiet", "--set", step + "Final Time=0.05"}, folder_).status, 0);
  const std::vector<std::string> si{ball,    "--output",
                                    "si",    "--quiet",
                                    "--set", step + "Final Time=50 ps",
                                    "--set", step + "Time Step=1 ps",
                                    "--set", "Mesh/Disk/Diameter=1e-2 um",
                                    "--set", "Mesh/Disk/Center={0, 72.54709287789268 Å}",
                                    "--set", "Materials/Ball/Density=1 g/cm^3",
                                    "--set", "Materials/Ball/Young's Modulus=2000 MPa"};
  const Outcome outcome = ixos(si, folder_);
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(history_rows(folder_ + "/plain"), history_rows(folder_ + "/si"));
  const std::string effective = contents(folder_ + "/si/effective.xml");
  EXPECT_EQ(effective, contents(folder_ + "/plain/effective.xml"));
  EXPECT_EQ(effective.find("MPa"), std::string::npos);
  const std::string summary = contents(folder_ + "/si/summary.json");
  for (const char* part : {"\"units\": {", "\"symbol\": \"E0 L0\"", "\"si\": 2.0", "\"unit\": \"N/m\""})
    EXPECT_NE(summary.find(part), std::string::npos) << part << " in " << summary;
}

TEST_F(UnitsTest, ScalesOfManyDigitsGiveASummary) {
  const std::string end = "Time Integrator/Time Step Control/Final Time=0.01";
  const Outcome outcome = ixos({ball, "--output", "out", "--quiet", "--set", end, "--set",
                                "Units/Length=7.254709287789268 nm", "--set", "Units/Energy Density=2.345678 GPa"},
                               folder_);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  const auto units = nlohmann::json::parse(contents(folder_ + "/out/summary.json"))["units"];
  EXPECT_EQ(units["energy"]["si"], 1.2345492575108215e-07);  // E0 L0^2 in J/m, by fractions.Fraction of Python
}

TEST_F(UnitsTest, ScalesWithoutSoundResultsAreRefusedBeforeTheRun) {
  expect_refused(2, {ball, "--output", "out", "--set", "Units/Length=1e-200 m"},
                 "Units: Length \"1e-200 m\", Energy Density \"2 GPa\" and Time \"1 ns\" make the unit E0 L0^2: it is "
                 "beyond the range of numbers");
  expect_refused(2, {ball, "--output", "out", "--set", "Units/Time=1e-400 s"},
                 "Units/Time: \"1e-400 s\": it is beyond the range of numbers");
  expect_refused(2, {ball, "--output", "out", "--set", "Mesh/Disk/Diameter=1e999999999 nm"},
                 "Mesh/Disk/Diameter: \"1e999999999 nm\": it is beyond the range of numbers");
}

TEST_F(UnitsTest, MeshesFromFilesStateTheirSizeAndTheUnitsOfTheirDimension) {
  const std::string text = explain_plates({"Type=Point Force", "Node Set=corner", "Vector={0, 0.5}"});
  EXPECT_NE(text.find("Note: the mesh spans 4 x 2 L0 = 4 nm x 2 nm\n"), std::string::npos) << text;
  EXPECT_NE(text.find("Boundary Conditions/Load/Vector: {0, 0.5} E0 L0 = {0 N/m, 1 N/m}\n"), std::string::npos) << text;
}

TEST_F(UnitsTest, GravityLengthsAreThoseOfTheLoadedBlock) {
  const auto expect_lengths = [&](const std::vector<std::string>& more, bool hard, const std::string& words) {
    std::vector<std::string> load{"Type=Gravity", "Vector={0, -9.81} m/s^2"};
    load.insert(load.end(), more.begin(), more.end());
    const std::string text = explain_plates(load);
    EXPECT_NE(text.find("Load: gravity length E/weight of Soft" + words + ": 2.03874e+14 L0"), std::string::npos)
        << text;
    EXPECT_EQ(text.find("E/weight of Hard") != std::string::npos, hard) << text;
  };
  expect_lengths({}, true, "");
  expect_lengths({"Block=soft"}, false, "");
  expect_lengths({"Block=soft", "History=Slow"}, false, " for a value of 1 of the history \"Slow\"");
}

}  // namespace
}  // namespace ixos::test
