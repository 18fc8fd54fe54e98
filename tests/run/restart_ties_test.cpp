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

/// A turned block on a wall that is turned, too, held by a plane of symmetry, and tied to another one of coarser cells.
std::string tied(const std::string& integrator, const std::string& output) {
  const std::string turn = number("Rotation Angle", 30);
  return list("Mesh",
              word("Type", "Parts") +
                  list("Parts",
                       list("foot", word("Type", "Box") + turn +
                                        list("Box", numbers("Lower", {0, 0.3}) + numbers("Lengths", {1, 1}) +
                                                        counts("Divisions", {4, 3}))) +
                           list("head", word("Type", "Box") + turn +
                                            list("Box", numbers("Lower", {0, 1.3}) + numbers("Lengths", {1.5, 0.5}) +
                                                            counts("Divisions", {4, 1})))) +
                  list("Ties", list("Joint", word("Side Set", "foot_top") + word("Primary Side Set", "head_bottom"))) +
                  list("Sets",
                       list("middle", word("Kind", "Nodes") + numbers("Plane Normal", {0.8660254037844386, 0.5})))) +
         list("Materials", list("Foot", word("Block", "foot_body") + number("Density", 1)) +
                               list("Head", word("Block", "head_body") + number("Density", 1))) +
         list("Interactions",
              list("Wall", word("Side Set", "foot_bottom") + numbers("Normal", {-0.5, 0.8660254037844386}))) +
         list("Boundary Conditions", list("Middle", word("Type", "Symmetry") + word("Node Set", "middle"))) +
         list("Initial Conditions", numbers("Velocity", {0.05, -0.1})) + list("Time Integrator", integrator) +
         list("Output", output);
}

TEST_F(RestartTiesTest, EverySchemeGoesOnBitForBitBesidePlanesOfSymmetryAndTiedSurfaces) {
  for (const std::string& scheme : moving_schemes()) {
    SCOPED_TRACE(scheme);
    const double step = scheme == "Central Difference" ? 0.01 : 0.05;
    expect_goes_on(tied(word("Type", scheme) + steps(step, 8 * step), count("Fields Interval", 4) + checkpoints(4, 10)),
                   {4});
  }
}

TEST_F(RestartTiesTest, TheGuidesScenesKeepTheirEnergy) {
  for (const std::string name : {"refined-foot", "periodic-strip", "tied-pillar", "turned-half"}) {
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
