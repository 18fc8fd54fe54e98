// Newton's iterations near nu = 1/2: as many as at 0.3, whatever the cells, the law, the scheme and the solver.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "mesh/cell_order.hpp"
#include "mesh/generators/shapes.hpp"
#include "scene/simulation.hpp"
#include "solve/choice/linear_solver_defaults.hpp"
#include "support/comparison.hpp"
#include "support/scene_text.hpp"
#include "support/simplices.hpp"
#include "support/solids.hpp"
#include "support/time_functions.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

/// A unit square or cube, of split cells unless `kind` is "".
Mesh block(int dimension, const std::string& kind, int divisions, int order) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.divisions = {divisions, divisions, divisions};
  Mesh mesh = kind.empty() ? box(shape) : test::split_cells(box(shape), kind);
  if (order == 2) raise_order(mesh);
  return mesh;
}

Mesh with_bubbles(Mesh mesh) {
  add_bubbles(mesh);
  return mesh;
}

struct Body {
  Mesh mesh;
  Formulation formulation = Formulation::Standard;
  std::shared_ptr<const ElasticLaw> law;
};

struct Motion {
  std::vector<int> iterations;  ///< of each step
  std::vector<double> end;      ///< displacements of all nodes
};

struct Way {
  Table table = static_equilibrium();
  int steps = 10;
  double press = 0.2;  ///< share of the height
  bool mixed = true, matrix_free = false;
};

/// Shears a body by 0.3 of its height and presses it, both ends held.
Motion squeezed(const Body& body, const Way& way) {
  Material material;
  material.law = body.law;
  material.density = 1;
  material.formulation = body.formulation;
  const auto model = test::model_of(body.mesh, material, is_static(way.table) ? Inertia::None : Inertia::Consistent);
  const LocalMesh& local = model->mesh();
  const int d = local.dimension;
  for (int node : local.node_sets[local.node_set("bottom")])
    for (int i = 0; i < d; ++i) model->constraints().add(node * d + i, 0.0, nullptr);
  const auto function = is_static(way.table) ? test::polynomial(1, 0) : test::polynomial(0, 2);
  for (int node : local.node_sets[local.node_set("top")])
    for (int i = 0; i < d; ++i)
      model->constraints().add(node * d + i, i == 0 ? 0.3 : i == d - 1 ? -way.press : 0.0, function);
  Teuchos::ParameterList linear;
  if (way.matrix_free)
    linear.set("Operator", "Matrix-Free").set("Linear Solver Type", "Belos").set("Preconditioner Type", "Chebyshev");
  else
    linear.set("Linear Solver Type", "Direct").set("Preconditioner Type", "None");
  NewtonOptions newton;
  newton.tolerance = 1e-9;  // the bulk stiffness costs digits
  newton.mixed_steps = way.mixed;
  Integrator integrator(*model, way.table, std::make_shared<LinearSolverFactory>(completed_linear_solver(linear, {})),
                        newton);
  integrator.initialize(test::at_rest(*model), test::at_rest(*model), 0);
  Motion motion;
  for (int step = 0; step < way.steps; ++step) {
    const StepResult result = integrator.step(1.0 / way.steps);
    EXPECT_TRUE(result.converged) << result.reason;
    if (!result.converged) break;
    motion.iterations.push_back(result.newton_iterations);
  }
  motion.end = test::gathered(*model, integrator.state().u);
  return motion;
}

std::shared_ptr<const ElasticLaw> neo_hooke_at(double nu) { return neo_hooke(lame_constants(1, nu)); }

/// At nu = 0.49999 a step takes two iterations more than at 0.3 at most, on average.
void expect_as_many_iterations(const std::string& name, const Mesh& mesh, Formulation formulation,
                               const Way& way = {}) {
  const auto all = [&](double nu) {
    const Motion motion = squeezed({mesh, formulation, neo_hooke_at(nu)}, way);
    EXPECT_EQ(motion.iterations.size(), static_cast<std::size_t>(way.steps)) << name;
    return std::accumulate(motion.iterations.begin(), motion.iterations.end(), 0);
  };
  const int soft = all(0.3);
  EXPECT_LE(all(0.49999), soft + 2 * way.steps) << name << ", of " << soft;
}

// Standard linear cells lock so much that a press makes them buckle: they are sheared alone.
Way sheared() {
  Way way;
  way.press = 0;
  return way;
}

TEST(MixedStepsTest, PlaneCellsTakeAsManyIterationsAtAnyPoissonsRatio) {
  expect_as_many_iterations("Quad4", block(2, "", 8, 1), Formulation::Standard, sheared());
  expect_as_many_iterations("Quad4 Mean", block(2, "", 8, 1), Formulation::MeanDilatation);
  expect_as_many_iterations("Quad9", block(2, "", 8, 2), Formulation::Standard);
  expect_as_many_iterations("Quad9 Mean", block(2, "", 8, 2), Formulation::MeanDilatation);
  expect_as_many_iterations("Tri3", block(2, "triangles", 8, 1), Formulation::Standard, sheared());
  expect_as_many_iterations("Tri6", block(2, "triangles", 8, 2), Formulation::Standard);
  expect_as_many_iterations("Tri7 Mean", with_bubbles(block(2, "triangles", 8, 2)), Formulation::MeanDilatation);
}

TEST(MixedStepsTest, SolidCellsTakeAsManyIterationsAtAnyPoissonsRatio) {
  expect_as_many_iterations("Hex8", block(3, "", 3, 1), Formulation::Standard, sheared());
  expect_as_many_iterations("Hex8 Mean", block(3, "", 3, 1), Formulation::MeanDilatation);
  expect_as_many_iterations("Hex27 Mean", block(3, "", 2, 2), Formulation::MeanDilatation);
  expect_as_many_iterations("Tet10", block(3, "tetrahedra", 2, 2), Formulation::Standard);
  expect_as_many_iterations("Tet15 Mean", with_bubbles(block(3, "tetrahedra", 2, 2)), Formulation::MeanDilatation);
}

// The motion starts gently: a jump of the velocity would make the pressure jump from step to step.
TEST(MixedStepsTest, SchemesWithInertiaTakeAsManyIterationsAtAnyPoissonsRatio) {
  for (const Table& table : {newmark(0.25, 0.5), generalized_alpha(0.8), bathe_composite(0, bathe_default_split(0))}) {
    Way way;
    way.table = table;
    expect_as_many_iterations(table.name, block(2, "", 6, 2), Formulation::MeanDilatation, way);
  }
  // The straight path of a rotation changes the volume: its steps are small.
  Way way;
  way.table = average_vector_field(2, 2);
  way.steps = 40;
  expect_as_many_iterations(way.table.name, block(2, "", 6, 1), Formulation::MeanDilatation, way);
}

TEST(MixedStepsTest, TheSolutionIsThatOfPlainSteps) {
  for (const Formulation formulation : {Formulation::Standard, Formulation::MeanDilatation})
    for (const int order : {1, 2}) {
      const Body body{block(2, "", 4, order), formulation, neo_hooke_at(0.495)};
      Way way, plain;
      way.press = plain.press = 0;
      plain.mixed = false;
      const Motion mixed = squeezed(body, way), other = squeezed(body, plain);
      ASSERT_EQ(mixed.end.size(), other.end.size());
      for (std::size_t i = 0; i < mixed.end.size(); ++i) EXPECT_NEAR(mixed.end[i], other.end[i], 1e-8);
    }
}

TEST(MixedStepsTest, WithoutAMatrixTheyAreTheSame) {
  Way way = sheared(), free = sheared();
  free.matrix_free = true;
  for (const int dimension : {2, 3}) {
    const Body body{block(dimension, "", dimension == 2 ? 6 : 3, 2), Formulation::Standard, neo_hooke_at(0.4999)};
    const Motion assembled = squeezed(body, way), applied = squeezed(body, free);
    ASSERT_EQ(assembled.end.size(), applied.end.size());
    for (std::size_t i = 0; i < assembled.end.size(); ++i) EXPECT_NEAR(assembled.end[i], applied.end[i], 1e-6);
    // Linear systems are solved to a share of the residual.
    EXPECT_LE(std::accumulate(applied.iterations.begin(), applied.iterations.end(), 0),
              2 * std::accumulate(assembled.iterations.begin(), assembled.iterations.end(), 0));
  }
}

/// Newton's iterations of the steps of a scene.
int iterations(Simulation& simulation, int steps) {
  int sum = 0;
  for (int step = 0; step < steps; ++step) {
    const StepResult result = simulation.integrator().step(simulation.step_control().time_step);
    EXPECT_TRUE(result.converged) << result.reason;
    sum += result.newton_iterations;
  }
  return sum;
}

// The block that squeezed() shears, of each law of rubber.
TEST(MixedStepsTest, LawsOfRubberTakeAsManyIterationsAtAnyPoissonsRatio) {
  using namespace test;
  const auto taken = [](const std::string& law, const std::string& volumetric, double nu) {
    const auto condition = [](const std::string& name, const std::string& set, const std::string& components,
                              const std::string& history) {
      return list(name, word("Node Set", set) + word("Components", components) +
                            (history.empty() ? "" : word("History", history)));
    };
    const Teuchos::ParameterList text =
        scene(list("Mesh", word("Type", "Box") + count("Cell Order", 2) + list("Box", counts("Divisions", {6, 6}))) +
              list("Materials",
                   list("Body", word("Model", law) + word("Element Formulation", "Mean Dilatation") +
                                    list(law, number("Poisson's Ratio", nu) + word("Volumetric Energy", volumetric)))) +
              list("Histories", expression("Aside", "0.3*t", "0.3", "0")) +
              list("Boundary Conditions", condition("Foot", "bottom", "all", "") + condition("Held", "top", "y", "") +
                                              condition("Head", "top", "x", "Aside")) +
              time_integrator("Static", 0.2, 1));
    Simulation simulation(text, world());
    return iterations(simulation, 5);
  };
  for (const char* law : {"Mooney-Rivlin", "Yeoh", "Gent", "Ogden"})
    for (const char* volumetric : {"Logarithm", "Convex"})
      EXPECT_LE(taken(law, volumetric, 0.49999), taken(law, volumetric, 0.3) + 10) << law << ' ' << volumetric;
}

TEST(MixedStepsTest, ABodyThatSticksToAWallPullsAsWithPlainSteps) {
  const auto pulled = [](const char* mixed) {
    Simulation simulation(test::scene_file("jkr.xml", {"Materials/Sphere/Poisson's Ratio=0.4999",
                                                       "Materials/Sphere/Element Formulation=Mean Dilatation",
                                                       std::string("Nonlinear Solver/Mixed Steps=") + mixed}),
                          test::world());
    const int taken = iterations(simulation, 30);
    return std::pair{taken, test::gathered(simulation.model(), simulation.integrator().state().u)};
  };
  const auto mixed = pulled("true"), plain = pulled("false");
  ASSERT_EQ(mixed.second.size(), plain.second.size());
  for (std::size_t i = 0; i < mixed.second.size(); ++i) EXPECT_NEAR(mixed.second[i], plain.second[i], 1e-7);
  EXPECT_LE(mixed.first, plain.first + 30);
}

}  // namespace
}  // namespace ixos
