// Planes of symmetry in any direction: turned bodies move as those before the turn, and Lamé's tube from a sector.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "mesh/cell_order.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/joined_parts.hpp"
#include "mesh/mortar/tied_surfaces.hpp"
#include "mesh/placement.hpp"
#include "mesh/splitting/refine.hpp"
#include "model/conditions.hpp"
#include "model/set_reactions.hpp"
#include "model/state_report.hpp"
#include "solve/choice/linear_solver_defaults.hpp"
#include "support/comparison.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"
#include "time/integrator.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

constexpr double pi = 3.14159265358979323846;

/// How a test holds the two sides of a box that are planes of symmetry.
enum class Hold { ByComponents, ByPlanes };

struct Box {
  std::unique_ptr<Model> model;
  Placement turn;
};

Vec<3> turned(const Placement& placement, const Vec<3>& x) {
  Mesh point;
  point.dimension = 3;
  point.coordinates.assign(x.begin(), x.end());
  move_nodes(placement, point);
  return {point.coordinates[0], point.coordinates[1], point.coordinates[2]};
}

Placement turn_of(int dimension, double angle) {
  Placement turn;
  turn.angle = angle;
  if (dimension == 3) turn.axis = {0.48, 0.6, 0.64};
  return turn;
}

/// A box with hanging nodes, held on three sides (2D: two) that are planes of symmetry, and loaded at the others.
Box box_of(int dimension, Hold hold, double angle, Inertia inertia) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.divisions = {3, 3, 3};
  Mesh mesh = box(shape);
  RefinedRegion corner;
  corner.upper.assign(static_cast<std::size_t>(dimension), 0.2);
  refine(mesh, {{"corner", corner}}, 1);
  const Placement turn = turn_of(dimension, angle);
  move_nodes(turn, mesh);
  Box result{test::model_of(mesh, test::elastic(neo_hooke, 0.3), inertia), turn};
  Model& model = *result.model;
  const std::vector<std::pair<const char*, const char*>> sides =
      dimension == 2 ? std::vector<std::pair<const char*, const char*>>{{"left", "x"}, {"bottom", "y"}}
                     : std::vector<std::pair<const char*, const char*>>{{"left", "x"}, {"front", "y"}, {"bottom", "z"}};
  for (const auto& [set, component] : sides)
    if (hold == Hold::ByPlanes)
      hold_in_plane(model, set);
    else
      prescribe(model, set, component);
  const Vec<3> pull = turned(turn, {0.08, 0.02, dimension == 3 ? 0.01 : 0.0});
  add_traction(model, "right", {pull.begin(), pull.begin() + dimension}, rate_ramp(1.0, 0.0, 0.0, RampShape::Linear));
  return result;
}

/// Displacements after some steps, turned back, and the reaction of the left side.
std::vector<double> run(int dimension, Hold hold, double angle, const Table& table, bool matrix_free,
                        std::vector<double>& reaction) {
  Inertia inertia = Inertia::Consistent;
  if (table.name == "Static") inertia = Inertia::None;
  if (is_explicit(table)) inertia = Inertia::Lumped;
  Box body = box_of(dimension, hold, angle, inertia);
  const auto d = static_cast<std::size_t>(dimension);
  const LocalMesh& mesh = body.model->mesh();
  std::vector<double> velocity = test::at_rest(*body.model);
  const Vec<3> drift = turned(body.turn, {0.1, -0.2, dimension == 3 ? 0.1 : 0.0});  // a part of it is across the planes
  for (std::size_t n = 0; n < velocity.size() / d; ++n)
    for (std::size_t i = 0; i < d; ++i) velocity[n * d + i] = drift[i];
  Teuchos::ParameterList linear;
  if (matrix_free)
    linear.set("Linear Solver Type", "Belos").set("Preconditioner Type", "Chebyshev").set("Operator", "Matrix-Free");
  Integrator integrator =
      matrix_free
          ? Integrator(*body.model, table,
                       std::make_shared<LinearSolverFactory>(completed_linear_solver(linear, {}), body.model.get()), {})
          : test::direct(*body.model, table);
  integrator.initialize(test::at_rest(*body.model), velocity, 0.0);
  for (int step = 0; step < 5; ++step) EXPECT_TRUE(integrator.step(0.02).converged) << table.name;
  std::vector<double> u = integrator.state().u;
  Placement back = body.turn;
  back.angle = -back.angle;
  const auto turn_back = [&](double* x) {
    Vec<3> vector{};
    std::copy_n(x, d, vector.begin());
    vector = turned(back, vector);
    std::copy_n(vector.begin(), d, x);
  };
  for (int node = 0; node < mesh.nodes(); ++node) turn_back(&u[static_cast<std::size_t>(node) * d]);
  reaction = set_reaction(*body.model, integrator.state().reaction, "left");
  turn_back(reaction.data());
  return u;
}

void expect_the_same(int dimension, const Table& table, bool matrix_free) {
  SCOPED_TRACE(table.name);
  std::vector<double> reaction, turned_reaction;
  const std::vector<double> u = run(dimension, Hold::ByComponents, 0, table, false, reaction);
  const double tolerance = matrix_free ? 1e-8 : 1e-11;
  for (const double angle : {0.0, 30.0}) {
    EXPECT_LT(test::distance(run(dimension, Hold::ByPlanes, angle, table, matrix_free, turned_reaction), u), tolerance);
    // Where two planes meet, the sides share the reaction otherwise.
    EXPECT_NEAR(turned_reaction[0], reaction[0], 1e3 * tolerance);
  }
}

TEST(SymmetryPlanesTest, TurnedBodiesMoveAlike) {
  for (const int dimension : {2, 3}) {
    expect_the_same(dimension, static_equilibrium(), false);
    expect_the_same(dimension, newmark(0.25, 0.5), false);
    expect_the_same(dimension, central_difference(0.9), false);
    expect_the_same(dimension, average_vector_field(2, 4), false);
  }
  expect_the_same(2, energy_momentum(), false);
  expect_the_same(2, bathe_composite(0.0, 0.5), false);
  expect_the_same(2, generalized_alpha(0.8), false);
}

TEST(SymmetryPlanesTest, TurnedBodiesMoveAlikeMatrixFree) {
  for (const int dimension : {2, 3}) {
    expect_the_same(dimension, static_equilibrium(), true);
    expect_the_same(dimension, newmark(0.25, 0.5), true);
  }
}

/// A part of a tube of radii 1 and 2 between two angles. `lower`, `upper`: its radii; cells along the arc.
Mesh sector(double lower, double upper, int radial, int along, double turn, int order) {
  BoxShape shape;
  shape.divisions = {radial, along, 1};
  Mesh mesh = box(shape);
  if (order == 2) raise_order(mesh);
  for (std::size_t n = 0; n < static_cast<std::size_t>(mesh.nodes()); ++n) {
    double* const x = &mesh.coordinates[2 * n];
    const double r = lower + (upper - lower) * x[0], phi = turn + pi / 6 * x[1];
    x[0] = r * std::cos(phi);
    x[1] = r * std::sin(phi);
  }
  return mesh;
}

/// The error of the displacement, by the largest, of a tube under pressure from a sector of 30 degrees between planes.
/// `rings`: it consists of two rings, tied, whose cells do not match.
double error_of_tube(int cells, double turn, int order, bool rings = false) {
  constexpr double a = 1, b = 2, p = 1e-3, nu = 0.3;
  Mesh mesh = sector(a, b, cells, cells, turn, order);
  const std::string first = rings ? "inner_" : "";
  if (rings) {
    mesh = joined_parts({{"inner", sector(a, 1.5, cells / 2, cells, turn, order)},
                         {"outer", sector(1.5, b, cells / 2, 3 * cells / 2, turn, order)}});
    for (ElementBlock& block : mesh.blocks) block.name = "body";
    tie_surfaces(mesh, "outer_left", "inner_right", 0);
  }
  const auto model = test::model_of(mesh, test::elastic(linear_elastic, nu), Inertia::None);
  for (const char* plane : {"bottom", "top"}) {
    hold_in_plane(*model, first + plane);
    if (rings) hold_in_plane(*model, std::string("outer_") + plane);
  }
  // The pressure on the inner arc: its integral over each node's share of the arc.
  const LocalMesh& local = model->mesh();
  std::vector<double> forces(static_cast<std::size_t>(model->space().local()), 0.0);
  const int along = cells * order;
  for (const int node : local.node_sets[local.node_set(first + "left")]) {
    const auto n = static_cast<std::size_t>(node);
    const double x = local.coordinates[2 * n], y = local.coordinates[2 * n + 1];
    const double place = (std::atan2(y, x) - turn) / (pi / 6) * along;
    const bool end = place < 0.5 || place > along - 0.5, middle = order == 2 && std::lround(place) % 2 == 1;
    const double share = pi / 6 * a / cells *
                         (order == 1 ? (end ? 0.5 : 1)
                          : middle   ? 4.0 / 6
                          : end      ? 1.0 / 6
                                     : 2.0 / 6);
    forces[2 * n] = p * share * x / a;
    forces[2 * n + 1] = p * share * y / a;
  }
  model->loads().add(forces, rate_ramp(1.0, 0.0, 0.0, RampShape::Linear));
  Integrator integrator = test::direct(*model, static_equilibrium());
  integrator.initialize(test::at_rest(*model), test::at_rest(*model), 0.0);
  EXPECT_TRUE(integrator.step(1.0).converged);
  double worst = 0;
  for (std::size_t n = 0; n < static_cast<std::size_t>(local.nodes()); ++n) {
    const double x = local.coordinates[2 * n], y = local.coordinates[2 * n + 1], r = std::hypot(x, y);
    const double u = p * a * a / (b * b - a * a) * (1 + nu) * ((1 - 2 * nu) * r + b * b / r);  // Lamé, E = 1
    worst = std::max(worst,
                     std::hypot(integrator.state().u[2 * n] - u * x / r, integrator.state().u[2 * n + 1] - u * y / r));
  }
  return model->space().maximum(worst) / p;
}

TEST(SymmetryPlanesTest, ASectorOfATubeIsTheTube) {
  for (const double turn : {0.0, 0.4}) {
    const double coarse = error_of_tube(4, turn, 1), fine = error_of_tube(8, turn, 1);
    EXPECT_LT(fine, 0.01);
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.3) << turn;
    EXPECT_LT(error_of_tube(4, turn, 2), 0.1 * fine) << turn;
  }
}

TEST(SymmetryPlanesTest, TwoTiedRingsAreTheTube) {
  const double coarse = error_of_tube(4, 0.4, 1, true), fine = error_of_tube(8, 0.4, 1, true);
  EXPECT_LT(fine, 2 * error_of_tube(8, 0.4, 1));
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.4);
  EXPECT_LT(error_of_tube(4, 0.4, 2, true), 0.2 * fine);
}

TEST(SymmetryPlanesTest, EnergyIsKept) {
  Box body = box_of(2, Hold::ByPlanes, 30, Inertia::Consistent);
  std::vector<double> velocity = test::at_rest(*body.model);
  for (std::size_t i = 0; i < velocity.size(); ++i) velocity[i] = 0.3 * std::sin(5 * body.model->mesh().coordinates[i]);
  body.model->space().interpolate_tied(velocity.data());
  Integrator integrator = test::direct(*body.model, energy_momentum());
  integrator.initialize(test::at_rest(*body.model), velocity, 0.0);
  const auto energy = [&] {
    const StateReport report(*body.model, integrator.state());
    return report.momenta().kinetic_energy + report.elastic_energy();
  };
  const double start = energy();
  double work = 0;
  for (int step = 0; step < 20; ++step) {
    ASSERT_TRUE(integrator.step(0.05).converged);
  }
  work = integrator.external_work();
  EXPECT_NEAR(energy(), start + work, 1e-10 * start);
}

/// Every predictor extrapolates the rounding across the planes, too.
TEST(SymmetryPlanesTest, ManyStepsStayInThePlanes) {
  for (const Predictor predictor : {Predictor::Quadratic, Predictor::Extrapolation, Predictor::ConstantVelocity}) {
    Box body = box_of(2, Hold::ByPlanes, 30, Inertia::Consistent);
    std::vector<double> velocity = test::at_rest(*body.model);
    for (std::size_t i = 0; i < velocity.size(); ++i)
      velocity[i] = 0.3 * std::sin(5 * body.model->mesh().coordinates[i]);
    body.model->space().interpolate_tied(velocity.data());
    Table table = newmark(0.25, 0.5);
    table.predictor = predictor;
    Integrator integrator = test::direct(*body.model, table);
    integrator.initialize(test::at_rest(*body.model), velocity, 0.0);
    for (int step = 0; step < 1000; ++step) ASSERT_TRUE(integrator.step(0.02).converged);
    std::vector<double> inside = integrator.state().u;
    body.model->constraints().planes().project(inside.data(), body.model->mesh().nodes());
    EXPECT_LT(test::distance(inside, integrator.state().u), 1e-15) << static_cast<int>(predictor);
  }
}

TEST(SymmetryPlanesTest, WhatCannotBeIsRefused) {
  const auto expect = [](const char* words, const auto& action) {
    BoxShape shape;
    Mesh mesh = box(shape);
    move_nodes(turn_of(2, 30), mesh);
    const auto model = test::model_of(mesh, test::elastic(neo_hooke, 0.3), Inertia::None);
    test::expect_contains(test::refusal([&] { action(*model); }), words);
  };
  expect("not in one plane", [](Model& model) { hold_in_plane(model, "surface"); });
  expect("across a plane", [](Model& model) {
    hold_in_plane(model, "left");
    prescribe(model, "left", "x", rate_ramp(1.0, 0.0, 0.0, RampShape::Linear));
  });
  expect("across a plane", [](Model& model) {
    prescribe(model, "left", "x", rate_ramp(1.0, 0.0, 0.0, RampShape::Linear));
    hold_in_plane(model, "left");
  });
  expect("\"left\"", [](Model& model) { hold_in_plane(model, "lef"); });
}

}  // namespace
}  // namespace ixos
