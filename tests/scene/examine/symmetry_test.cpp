#include "scene/examine/symmetry.hpp"

#include <gtest/gtest.h>

#include "scene/simulation.hpp"
#include "support/bodies.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::word;

const test::Adhesion wall{}, sphere{"Morse", "Sphere", "Neo-Hooke"};

std::string exact_mean() {
  return test::time_integrator("Average Vector Field", 0.1, 1, test::count("Interaction Points", 0));
}

/// "Linear Solver" with one solver type.
std::string solver(const std::string& type, const std::string& kind, const std::string& more = "") {
  return list("Linear Solver", word("Linear Solver Type", type) +
                                   list("Linear Solver Types", list(type, word("Solver Type", kind))) + more);
}

std::string refusal(const std::string& scene) {
  return test::refusal([&] { const Simulation s(test::scene(scene), test::self()); });
}

std::string cause(const std::string& scene) {
  const Simulation s(test::scene(scene), test::self());
  return asymmetry(SceneNode(s.parameters(), ""), s.materials(), s.model(), s.integrator().table());
}

TEST(AsymmetryTest, IsNamed) {
  EXPECT_EQ(cause(test::adhesive_block(2, wall) + exact_mean()), "");
  EXPECT_EQ(cause(test::adhesive_block(2, sphere) + test::time_integrator("Newmark", 0.1, 1)), "");
  EXPECT_EQ(cause(test::adhesive_block(2, sphere) + test::time_integrator("Average Vector Field", 0.1, 1)), "");
  EXPECT_EQ(cause(test::adhesive_block(2, sphere) + exact_mean()),
            "the exact mean before the curved obstacle of Interactions/Wall");
  EXPECT_EQ(cause(test::adhesive_block(2, wall) + test::time_integrator("Energy-Momentum", 0.1, 1)),
            "the discrete gradient of the scheme \"Energy-Momentum\"");
}

TEST(AsymmetryTest, OnlyAnObstacleThatTurnsIsCalledMoved) {
  const std::string press = test::texts("Translation", "{-, Way}");
  const auto moved = [](const test::Adhesion& obstacle, const std::string& motion) {
    return cause(test::adhesive_block(2, obstacle, list("Motion", motion)) +
                 list("Histories", test::expression("Way", "0.02*t", "0.02", "0")) + exact_mean());
  };
  EXPECT_EQ(moved(wall, press), "");
  EXPECT_EQ(moved(sphere, press), "the exact mean before the curved obstacle of Interactions/Wall");
  EXPECT_EQ(moved(wall, word("Rotation", "Way")), "the exact mean before the moved obstacle of Interactions/Wall");
}

/// Two boxes that rub on each other.
std::string rubbing(std::size_t dimension, const std::string& scheme) {
  const auto box = [&](const std::string& name, double lower) {
    std::vector<double> corner(dimension, 0.0);
    corner.back() = lower;
    return list(name,
                word("Type", "Box") +
                    list("Box", test::count("Dimension", static_cast<int>(dimension)) + test::numbers("Lower", corner) +
                                    test::numbers("Lengths", std::vector<double>(dimension, 1.0)) +
                                    test::counts("Divisions", std::vector<int>(dimension, 1))));
  };
  return list("Mesh", word("Type", "Parts") + list("Parts", box("low", -1.26) + box("high", 0))) +
         list("Materials", list("Low", word("Block", "low_body")) + list("High", word("Block", "high_body"))) +
         list("Interactions",
              list("Pair", word("Side Set", "high_bottom") + word("Primary Side Set", "low_top") +
                               list("Friction", word("Type", "Constant Stress") + test::number("Stress", 0.02)))) +
         test::time_integrator(scheme, 0.1, 1);
}

TEST(AsymmetryTest, TheMeanFrictionBetweenBodiesIsNamedInSpace) {
  EXPECT_EQ(cause(rubbing(2, "Average Vector Field")), "");
  EXPECT_EQ(cause(rubbing(3, "Newmark")), "");
  EXPECT_EQ(cause(rubbing(3, "Average Vector Field")), "the mean friction between the bodies of Interactions/Pair");
}

TEST(LinearSolverCheckTest, SolversOfSymmetricMatricesAreRefusedForUnsymmetricTangents) {
  const struct {
    std::string scene, cause;
  } scenes[] = {{test::adhesive_block(3, sphere) + exact_mean(),
                 "because of the exact mean before the curved obstacle of Interactions/Wall, the tangent is not "
                 "symmetric; use "},
                {test::adhesive_block(3, wall) + test::time_integrator("Energy-Momentum", 0.1, 1),
                 "because of the discrete gradient of the scheme \"Energy-Momentum\", the tangent is not symmetric; "
                 "use "}};
  const std::string types = "Linear Solver/Linear Solver Types/";
  const struct {
    std::string solver, place, instead;
  } cases[] = {
      {solver("Direct", "MUMPS"), types + "Direct/Solver Type: \"MUMPS\" needs a symmetric matrix; ",
       "\"Band LU\" or \"KLU\""},
      {solver("Direct", "CHOLMOD"), types + "Direct/Solver Type: \"CHOLMOD\" needs a symmetric matrix; ",
       "\"Band LU\" or \"KLU\""},
      {solver("Belos", "Block CG"), types + "Belos/Solver Type: \"Block CG\" needs a symmetric matrix; ",
       "\"Pseudo Block GMRES\""},
      {solver("Amesos2", "CHOLMOD"), types + "Amesos2/Solver Type: \"CHOLMOD\" needs a symmetric matrix; ", "\"KLU2\""},
      {list("Linear Solver", list("Linear Solver Types", list("Direct", word("Solver Type", "MUMPS")))),
       types + "Direct/Solver Type: \"MUMPS\" needs a symmetric matrix; ", "\"Band LU\" or \"KLU\""},
      {list("Linear Solver", word("Linear Solver Type", "Belos") + word("Preconditioner Type", "Chebyshev")),
       "Linear Solver/Preconditioner Type: \"Chebyshev\" needs a symmetric matrix; ",
       "\"MueLu\", \"Ifpack2\" or \"Direct\""},
      {list("Linear Solver", word("Linear Solver Type", "Belos") + word("Operator", "Matrix-Free")),
       "Linear Solver/Operator: \"Matrix-Free\" needs a symmetric tangent; ", "\"Assembled\""},
  };
  for (const auto& scene : scenes)
    for (const auto& c : cases) EXPECT_EQ(refusal(scene.scene + c.solver), c.place + scene.cause + c.instead);
}

TEST(LinearSolverCheckTest, SolversOfAnyMatrixAreAccepted) {
  const std::string scene = test::adhesive_block(2, sphere) + exact_mean();
  for (const std::string& choice :
       {std::string(), solver("Direct", "KLU"), solver("Direct", "Band LU"), solver("Belos", "Block GMRES"),
        solver("Amesos2", "KLU2"),
        // A solver that is not the chosen one does no harm.
        list("Linear Solver", word("Linear Solver Type", "Belos") +
                                  list("Linear Solver Types", list("Direct", word("Solver Type", "MUMPS"))))})
    EXPECT_EQ(refusal(scene + choice), "") << choice;
  // Stratimikos would refuse these; the check leaves what it does not know to others.
  test::expect_contains(refusal(scene + list("Linear Solver", test::count("Operator", 1))), "must be a string");
  test::expect_contains(refusal(scene + list("Linear Solver", word("Linear Solver Types", "KLU"))), "Linear Solver: ");
}

TEST(LinearSolverCheckTest, SymmetricTangentsTakeAllSolvers) {
  const std::string scene = test::adhesive_block(3, wall) + exact_mean();
  for (const std::string& choice :
       {solver("Direct", "MUMPS"), solver("Belos", "Block CG"),
        list("Linear Solver", word("Linear Solver Type", "Belos") + word("Preconditioner Type", "Chebyshev") +
                                  word("Operator", "Matrix-Free"))})
    EXPECT_EQ(refusal(scene + choice), "") << choice;
}

TEST(LinearSolverCheckTest, MatrixFreeTangentsAreRefusedForTheFormulationThatHasNone) {
  const std::string matrix_free =
      test::time_integrator("Newmark", 0.1, 1) +
      list("Linear Solver", word("Linear Solver Type", "Belos") + word("Operator", "Matrix-Free"));
  const std::string place = "Linear Solver/Operator: \"Matrix-Free\" is not offered for Materials/Rubber/";
  std::string enhanced = test::adhesive_block(3, sphere);
  const std::string model = word("Model", "Neo-Hooke");
  enhanced.insert(enhanced.find(model), word("Element Formulation", "Enhanced"));
  EXPECT_EQ(refusal(enhanced + matrix_free), place + "Element Formulation \"Enhanced\"; use \"Assembled\"");
  for (const char* obstacle : {"Half-Space", "Sphere"})
    for (const char* law : {"Neo-Hooke", "Saint Venant-Kirchhoff", "Ogden"})
      EXPECT_EQ(refusal(test::adhesive_block(3, {"Morse", obstacle, law}) + matrix_free), "") << obstacle << law;
}

}  // namespace
}  // namespace ixos
