// Restarts of refined meshes, whose hanging nodes follow others, with every scheme.
#include "run/restart_fixture.hpp"
#include "scene/scene_file.hpp"
#include "support/bodies.hpp"
#include "test_folders.hpp"

namespace ixos::test {
namespace {

using RestartTiesTest = RestartTest;

/// The block of drawn(), refined around the foot's corner and, in one direction, under the load.
std::string refined(const std::string& integrator, const std::string& output) {
  std::string scene = drawn(integrator, output);
  const std::string box = list("Box", numbers("Lengths", {2, 1}) + counts("Divisions", {6, 3}));
  scene.replace(scene.find(box), box.size(),
                box + list("Refine", list("Corner", count("Levels", 2) + number("Sphere Radius", 0.4)) +
                                         list("Edge", word("Directions", "y") + numbers("Lower", {1.9, 0.5}))));
  return scene;
}

TEST_F(RestartTiesTest, EverySchemeGoesOnBitForBit) {
  for (const std::string& scheme : moving_schemes()) {
    SCOPED_TRACE(scheme);
    const double step = scheme == "Central Difference" ? 0.01 : 0.05;
    expect_goes_on(
        refined(word("Type", scheme) + steps(step, 8 * step), count("Fields Interval", 4) + checkpoints(4, 10)), {4});
  }
}

TEST_F(RestartTiesTest, TheGuidesScenesKeepTheirEnergy) {
  for (const std::string name : {"refined-foot", "periodic-strip"}) {
    Simulation simulation(read_scene_file(std::string(IXOS_TEST_DIRECTORY) + "/guide/" + name + ".xml"), world());
    RunOptions options;
    options.folder = folder(name);
    const RunResult result = run(simulation, options);
    EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
    EXPECT_LT(result.max_energy_error, 1e-11) << name;
  }
}

}  // namespace
}  // namespace ixos::test
