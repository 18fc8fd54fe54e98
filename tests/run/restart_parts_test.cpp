// Restarts of scenes with several bodies.
#include "run/restart_fixture.hpp"

namespace ixos::test {
namespace {

using RestartPartsTest = RestartTest;

/// A disk that falls on a sticky wall, and a box elsewhere that spins; probes and reactions by part.
std::string disk_and_box(const std::string& order, const std::string& output) {
  return list("Mesh",
              word("Type", "Parts") + order +
                  list("Parts",
                       list("ball", numbers("Translation", {0, 5.6})) +
                           list("block", word("Type", "Box") +
                                             list("Box", numbers("Lengths", {4, 2}) + counts("Divisions", {4, 2})) +
                                             number("Rotation Angle", 30) + numbers("Translation", {40, 3})))) +
         list("Materials", list("A", word("Block", "ball_body") + number("Density", 1)) +
                               list("B", word("Block", "block_body") + number("Density", 3))) +
         list("Interactions", list("Wall", word("Side Set", "ball_surface"))) +
         list("Initial Conditions",
              list("A", texts("Blocks", "{ball_body}") + numbers("Velocity", {0, -0.3})) +
                  list("B", texts("Blocks", "{block_body}") + numbers("Angular Velocity", {0.2}))) +
         list("Output", output + list("Probes", list("Corner", numbers("Point", {40, 3})))) +
         list("Time Integrator", word("Type", "Energy-Momentum") + steps(0.1, 1));
}

TEST_F(RestartPartsTest, BodiesThatAreNotConnectedGoOnBitForBit) {
  const std::string output = count("Fields Interval", 5) + checkpoints(5, 10);
  for (const std::string& order : {std::string(), count("Cell Order", 2)})
    expect_goes_on(disk_and_box(order, output), {5});
}

}  // namespace
}  // namespace ixos::test
