// Restarts of bodies of hexahedra, pyramids and tetrahedra, with every scheme.
#include "run/restart_fixture.hpp"
#include "support/bodies.hpp"
#include "test_folders.hpp"

namespace ixos::test {
namespace {

using RestartSimplicesTest = RestartTest;

/// Two cubes of gmsh side by side above a wall, thrown at it.
std::string mixed(const std::string& integrator, const std::string& output, const std::string& material = "") {
  return list("Mesh", word("Type", "Gmsh") + count("Cell Order", 2) +
                          list("Gmsh", word("File", IXOS_TEST_DIRECTORY "/io/gmsh/mixed.msh"))) +
         list("Materials", list("Rubber", number("Density", 1) + material)) +
         list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, 0, -0.3}))) +
         list("Initial Conditions", numbers("Velocity", {0.02, 0.01, -0.05})) + list("Time Integrator", integrator) +
         list("Output", output);
}

TEST_F(RestartSimplicesTest, EverySchemeGoesOnBitForBit) {
  for (const std::string& scheme : moving_schemes()) {
    SCOPED_TRACE(scheme);
    const double step = scheme == "Central Difference" ? 2e-4 : 0.05;
    expect_goes_on(
        mixed(word("Type", scheme) + steps(step, 8 * step), count("Fields Interval", 4) + checkpoints(4, 10)), {4});
  }
}

TEST_F(RestartSimplicesTest, CellsWithBubblesGoOnBitForBit) {
  expect_goes_on(
      mixed(word("Type", "Average Vector Field") + steps(0.05, 0.4), count("Fields Interval", 4) + checkpoints(4, 10),
            word("Element Formulation", "Mean Dilatation") + number("Poisson's Ratio", 0.49)),
      {4});
}

/// The upper of two such bodies is pressed onto the lower one and slides: surfaces of triangles and quadrilaterals.
std::string rubbed(const std::string& integrator, const std::string& output, const std::string& pair) {
  const std::string cubes = word("Type", "Gmsh") + list("Gmsh", word("File", IXOS_TEST_DIRECTORY "/io/gmsh/mixed.msh"));
  return list("Mesh",
              word("Type", "Parts") +
                  list("Parts",
                       list("lower", cubes + numbers("Translation", {0.1, 0.05, -1.26})) + list("upper", cubes)) +
                  list("Sets", list("lid", numbers("Lower", {-1, -1, -0.27}) + numbers("Upper", {3, 3, -0.25})))) +
         list("Materials", list("Lower", word("Block", "lower_body") + number("Density", 1)) +
                               list("Upper", word("Block", "upper_body") + number("Density", 1))) +
         list("Interactions",
              list("Pair", word("Side Set", "upper_bottom") + word("Primary Side Set", "lid") + pair +
                               list("Friction", word("Type", "Extended Amontons") + number("Coefficient", 0.3)))) +
         list("Initial Conditions",
              list("Upper", "<Parameter name=\"Blocks\" type=\"Array(string)\" value=\"{upper_body}\"/>" +
                                numbers("Velocity", {0.1, 0.02, -0.05}))) +
         list("Boundary Conditions", list("Floor", word("Node Set", "lower_bottom"))) +
         list("Time Integrator", integrator) + list("Output", output);
}

TEST_F(RestartSimplicesTest, PairsOfTrianglesGoOnBitForBit) {
  for (const std::string& scheme : moving_schemes()) {
    SCOPED_TRACE(scheme);
    const double step = scheme == "Central Difference" ? 2e-4 : 0.05;
    expect_goes_on(rubbed(word("Type", scheme) + steps(step, 8 * step), checkpoints(4, 10), ""), {4});
  }
  expect_goes_on(rubbed(word("Type", "Newmark") + steps(0.05, 0.4), checkpoints(4, 10), word("Smoothing", "None")),
                 {4});
}

}  // namespace
}  // namespace ixos::test
