#include "scene/read/initial_conditions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/simulation.hpp"
#include "support/comparison.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::count;
using test::counts;
using test::list;
using test::number;
using test::numbers;
using test::texts;
using test::word;
using test::world;

/// Two squares of 2 by 2, one at the origin, the other, three times as dense, 10 to the right.
Simulation two_squares(const std::string& initial) {
  const std::string square =
      word("Type", "Box") + list("Box", numbers("Lengths", {2, 2}) + counts("Divisions", {2, 2}));
  return Simulation(
      test::scene(
          list("Mesh", word("Type", "Parts") +
                           list("Parts", list("a", square) + list("b", square + numbers("Translation", {10, 0})))) +
          list("Materials", list("A", word("Block", "a_body") + number("Density", 1)) +
                                list("B", word("Block", "b_body") + number("Density", 3))) +
          list("Initial Conditions", initial) + test::time_integrator("Newmark", 0.1, 1)),
      world());
}

std::string of(const std::string& blocks, const std::string& motion) { return texts("Blocks", blocks) + motion; }

/// Expects v(x, y) at all nodes of the bodies with x < 5 (`a`) and x > 5 (`b`).
template <class A, class B>
void expect_velocities(const Simulation& s, const A& a, const B& b) {
  const LocalMesh& mesh = s.model().mesh();
  const std::vector<double>& v = s.integrator().state().v;
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.nodes()); ++node) {
    const double x = mesh.coordinates[2 * node], y = mesh.coordinates[2 * node + 1];
    const std::array<double, 2> expected = x < 5 ? a(x, y) : b(x, y);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(v[2 * node + i], expected[i], 1e-14) << x << ", " << y;
  }
}

using Velocity = std::array<double, 2>;

TEST(InitialConditionsTest, EachBlockHasItsVelocity) {
  const Simulation s =
      two_squares(numbers("Velocity", {1, 2}) + list("Right", of("{b_body}", numbers("Velocity", {-3, 0}))));
  expect_velocities(
      s,
      [](double, double) {
        return Velocity{1, 2};
      },
      [](double, double) {
        return Velocity{-3, 0};
      });
}

TEST(InitialConditionsTest, ABlockSpinsAboutItsCentreOfMass) {
  const Simulation s =
      two_squares(list("Right", of("{b_body}", numbers("Velocity", {0, -1}) + numbers("Angular Velocity", {0.5}))));
  expect_velocities(
      s,
      [](double, double) {
        return Velocity{0, 0};
      },
      [](double x, double y) {
        return Velocity{-0.5 * (y - 1), -1 + 0.5 * (x - 11)};
      });
}

// Their masses are 4 and 12, so the centre is at 1 + 3/4 10.
TEST(InitialConditionsTest, BlocksTogetherTurnAboutTheirCommonCentre) {
  const Simulation s = two_squares(list("Both", of("{a_body, b_body}", numbers("Angular Velocity", {2}))));
  const auto spin = [](double x, double y) { return Velocity{-2 * (y - 1), 2 * (x - 8.5)}; };
  expect_velocities(s, spin, spin);
  const Momenta momenta = test::report_of(s).momenta();
  EXPECT_NEAR(momenta.linear[0], 0, 1e-12);
  EXPECT_NEAR(momenta.linear[1], 0, 1e-12);
}

TEST(InitialConditionsTest, AnOriginTakesThePlaceOfTheCentre) {
  const Simulation s =
      two_squares(list("Left", of("{a_body}", numbers("Velocity Gradient", {1, 0, 0, 2}) + numbers("Origin", {1, 0}))));
  expect_velocities(
      s,
      [](double x, double y) {
        return Velocity{x - 1, 2 * y};
      },
      [](double, double) {
        return Velocity{0, 0};
      });
}

TEST(InitialConditionsTest, ASolidSpinsAboutAnyAxis) {
  const std::string solid =
      list("Box", count("Dimension", 3) + numbers("Lengths", {2, 2, 2}) + counts("Divisions", {2, 1, 1}));
  for (const std::string where : {"", "Blocks"}) {
    const std::string spin = numbers("Angular Velocity", {1, 2, 3}) + numbers("Origin", {1, 1, 0});
    const Simulation s(
        test::scene(list("Mesh", word("Type", "Box") + solid) + list("Materials", list("A", number("Density", 1))) +
                    list("Initial Conditions", where.empty() ? spin : list("A", of("{body}", spin))) +
                    test::time_integrator("Newmark", 0.1, 1)),
        world());
    const LocalMesh& mesh = s.model().mesh();
    for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.nodes()); ++node) {
      const double x = mesh.coordinates[3 * node] - 1, y = mesh.coordinates[3 * node + 1] - 1,
                   z = mesh.coordinates[3 * node + 2];
      const std::array<double, 3> expected{2 * z - 3 * y, 3 * x - z, y - 2 * x};  // omega x r
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(s.integrator().state().v[3 * node + i], expected[i], 1e-14) << where;
    }
  }
}

/// A box of two blocks, x < 1 and x > 1, which share nodes: sets of a file would make them; here a mesh does.
Mesh two_blocks() {
  Mesh mesh;
  mesh.coordinates = {0, 0, 1, 0, 2, 0, 0, 1, 1, 1, 2, 1};
  mesh.blocks = {{"left", CellType::Quad4, {0, 1, 4, 3}}, {"right", CellType::Quad4, {1, 2, 5, 4}}};
  return mesh;
}

std::string refusal_of_blocks(const std::string& initial) {
  return test::refusal([&] {
    Simulation(test::scene(list("Materials", list("A", word("Block", "left") + number("Density", 1)) +
                                                 list("B", word("Block", "right") + number("Density", 1))) +
                           list("Initial Conditions", initial) + test::time_integrator("Newmark", 0.1, 1)),
               two_blocks(), world());
  });
}

TEST(InitialConditionsTest, BlocksThatShareNodesMoveTogether) {
  const std::string moves = numbers("Velocity", {1, 0}),
                    turns = numbers("Angular Velocity", {0.1}) + numbers("Origin", {0.3, 0.7});
  EXPECT_EQ(refusal_of_blocks(list("L", of("{left}", moves)) + list("R", of("{right}", moves))), "");
  EXPECT_EQ(refusal_of_blocks(turns + list("R", of("{right}", turns))), "");
  test::expect_contains(refusal_of_blocks(list("L", of("{left}", moves))),
                        "Initial Conditions/L: its blocks share nodes with those of Initial Conditions, but not the "
                        "velocities there");
}

TEST(InitialConditionsTest, ListsThatSayNothingOrTooMuchAreRefused) {
  const auto refused = [](const std::string& initial, const std::string& words) {
    test::expect_contains(test::refusal([&] { two_squares(initial); }), words);
  };
  refused(list("A", ""), "Initial Conditions/A/Blocks: there is none");
  refused(list("A", of("{a_body, a_body}", "")), "Initial Conditions/A/Blocks: \"a_body\" is given twice");
  refused(list("A", of("{a_body}", "")) + list("B", of("{a_body}", "")),
          "Initial Conditions/B/Blocks: \"a_body\" also moves as Initial Conditions/A says");
  refused(list("A", of("{c_body}", "")), "Initial Conditions/A/Blocks: ");
  refused(list("A", of("{a_body}", numbers("Velocity", {1}))), "Initial Conditions/A/Velocity has 1 elements, not 2");
  refused(numbers("Angular Velocity", {1, 2, 3}), "Initial Conditions/Angular Velocity has 3 elements, not 1");
}

TEST(InitialConditionsTest, ABodyOfRevolutionStaysOnItsAxis) {
  const auto refused = [](const std::string& initial) {
    return test::refusal([&] {
      Simulation(test::scene(list("Mesh", word("Geometry", "Axisymmetric") + word("Type", "Box")) +
                             list("Materials", list("A", number("Density", 1))) + list("Initial Conditions", initial) +
                             test::time_integrator("Newmark", 0.1, 1)),
                 world());
    });
  };
  EXPECT_EQ(refused(list("A", of("{body}", numbers("Velocity", {0, 1})))), "");
  test::expect_contains(refused(list("A", of("{body}", numbers("Velocity", {1, 0})))),
                        "Initial Conditions/A/Velocity: the radial component 1");
  test::expect_contains(refused(numbers("Angular Velocity", {1})), "Initial Conditions/Angular Velocity: ");
}

}  // namespace
}  // namespace ixos
