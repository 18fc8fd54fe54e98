#include "model/crossing.hpp"

#include <gtest/gtest.h>

#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "support/refusal.hpp"
#include "support/silent_interaction.hpp"
#include "support/solids.hpp"
#include "time/catalogue.hpp"

namespace ixos {
namespace {

/// A surface without forces: its lowest point is the lowest node of this rank above y = 0.
class Silent final : public test::SilentInteraction {
 public:
  Silent(const LocalMesh& mesh, bool positive) : mesh_(mesh), positive_(positive) {}
  bool add_force(const Segment&, const Rule&, double*) const override { return true; }
  void add_tangent(const Segment&, const Rule&, Tangent, double*) const override {}
  bool needs_positive_gaps() const override { return positive_; }
  /// Something below y = -1 has gone through a thin obstacle; the way is 0.25 deep.
  LowestPoint passage(const Segment& way) const override {
    const LowestPoint end = lowest_point(way.end());
    if (!(end.gap < -1 && lowest_point(way.begin()).gap > 0)) return {};
    return {-0.25, end.place};
  }
  LowestPoint lowest_point(const Place& at) const override {
    LowestPoint lowest;
    for (std::size_t node = 0; node < static_cast<std::size_t>(mesh_.owned_nodes); ++node) {
      const double x = mesh_.coordinates[2 * node] + at.u[2 * node],
                   y = mesh_.coordinates[2 * node + 1] + at.u[2 * node + 1];
      if (y < lowest.gap) lowest = {y, {x, y, 0}};
    }
    return lowest;
  }

 private:
  const LocalMesh& mesh_;
  bool positive_;
};

/// 2 x 1 cells of side 1, the lower left corner at (0, 0.5).
std::unique_ptr<Model> block(bool positive, Inertia inertia = Inertia::Consistent) {
  BoxShape shape;
  shape.lower = {0, 0.5, 0};
  shape.lengths = {2, 1, 1};
  shape.divisions = {2, 1, 1};
  auto model = test::model_of(box(shape), test::elastic(neo_hooke, 0.3), inertia);
  model->add_interaction(std::make_unique<Silent>(model->mesh(), positive), "Wall");
  return model;
}

std::vector<double> velocity(const Model& model, double x, double y) {
  std::vector<double> v = test::at_rest(model);
  for (std::size_t k = 0; k < v.size(); ++k) v[k] = k % 2 == 0 ? x : y;
  return v;
}

TEST(CrossingTest, NamesInteractionNodePlaceAndGap) {
  const auto model = block(true);
  EXPECT_EQ(crossing(*model, {nullptr, nullptr, test::at_rest(*model).data()}), "");
  std::vector<double> u = test::at_rest(*model);
  const LocalMesh& mesh = model->mesh();
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.nodes()); ++node)
    if (mesh.original_ids[node] == 2) u[2 * node + 1] = -0.515;
  EXPECT_EQ(crossing(*model, {nullptr, nullptr, u.data()}),
            "the surface of interaction \"Wall\" crosses the obstacle: the gap of node 3 of the mesh at (2, -0.015) is "
            "-0.015 L0");
}

TEST(CrossingTest, NodesOfContactElementsHaveNoNumberInTheMesh) {
  BoxShape shape;
  shape.divisions = {2, 1, 1};
  shape.lengths = {2, 1, 1};
  Mesh mesh = box(shape);
  enrich(mesh, "bottom", ContactElement::Q1C2);  // adds the middles of the sides
  const auto model = test::model_of(mesh, test::elastic(neo_hooke, 0.3), Inertia::None);
  const std::vector<double> u = test::at_rest(*model);
  EXPECT_EQ(in_words(model->mesh(), u.data(), {-0.1, {0.5, 0, 0}}), "the place (0.5, 0) on a side");
  EXPECT_EQ(in_words(model->mesh(), u.data(), {-0.1, {1, 0, 0}}), "node 2 of the mesh at (1, 0)");
}

TEST(CrossingTest, LawsOfAllGapsAreNotRefused) {
  const auto model = block(false);
  const std::vector<double> u = velocity(*model, 0, -0.6);
  EXPECT_EQ(crossing(*model, {nullptr, nullptr, u.data()}), "");
  EXPECT_NEAR(least_free_gap(*model, {u.data()}), -0.1, 1e-15);
  EXPECT_EQ(least_free_gap(*block(true), {u.data()}), std::numeric_limits<double>::infinity());
}

TEST(CrossingTest, BeyondTheEdgeNoLawIsAllowed) {
  for (const bool positive : {true, false}) {
    const auto model = block(positive);
    std::vector<double> u = test::at_rest(*model);
    u[1] = -std::numeric_limits<double>::infinity();
    EXPECT_NE(crossing(*model, {nullptr, nullptr, u.data()})
                  .find("the surface of interaction \"Wall\" is beyond the edge of the obstacle, at "),
              std::string::npos);
  }
}

TEST(CrossingTest, AStepThatCrossesIsRejectedByImplicitAndExplicitSchemes) {
  for (const char* name : {"Newmark", "Average Vector Field", "Central Difference"}) {
    const Scheme& chosen = scheme(name);
    const Table table = chosen.table(chosen.parameters);
    const auto model = block(true, table.mass);
    Integrator integrator = test::direct(*model, table);
    integrator.initialize(test::at_rest(*model), velocity(*model, 0, -1), 0);
    // It stands at 0.5 - t: the fifth step ends at a gap of 0 or, by rounding, a little beside it.
    for (int step = 0; step < 4; ++step) ASSERT_TRUE(integrator.step(0.1).converged) << name;
    const StepResult result = integrator.step(0.2);
    EXPECT_FALSE(result.converged) << name;
    EXPECT_TRUE(result.crossed) << name;
    test::expect_contains(result.reason, "the surface of interaction \"Wall\" crosses the obstacle: the gap of node");
    test::expect_contains(result.reason, "; allow Maximum Cuts, or use shorter steps or smaller faces");
    EXPECT_NEAR(integrator.time(), 0.4, 1e-12) << name;
    EXPECT_TRUE(integrator.step(0.05).converged) << name;
  }
}

TEST(CrossingTest, TellsOfAPointThatPassesThroughTheObstacle) {
  const auto model = block(false);
  const std::vector<double> rest = test::at_rest(*model), near = velocity(*model, 0, -0.6),
                            beyond = velocity(*model, 0, -2);
  EXPECT_EQ(crossing(*model, {rest.data(), nullptr, near.data()}), "");
  EXPECT_EQ(crossing(*model, {nullptr, nullptr, beyond.data()}), "") << "no step";
  EXPECT_EQ(crossing(*model, {near.data(), nullptr, beyond.data()}), "") << "the overlap was there before";
  const std::string found = crossing(*model, {rest.data(), nullptr, beyond.data()});
  test::expect_contains(found,
                        "the surface of interaction \"Wall\" passes through the obstacle, or through the other body, "
                        "within one step: the gap falls to -0.25 L0 on the way to node ");
}

TEST(CrossingTest, AStepThatPassesThroughTheObstacleIsRejectedWithEveryLaw) {
  for (const char* name : {"Newmark", "Average Vector Field", "Central Difference"}) {
    const Scheme& chosen = scheme(name);
    const Table table = chosen.table(chosen.parameters);
    const auto model = block(false, table.mass);
    Integrator integrator = test::direct(*model, table);
    integrator.initialize(test::at_rest(*model), velocity(*model, 0, -1), 0);
    const StepResult result = integrator.step(2);
    EXPECT_FALSE(result.converged) << name;
    EXPECT_TRUE(result.crossed) << name;
    test::expect_contains(result.reason, "passes through the obstacle");
    test::expect_contains(result.reason, "; allow Maximum Cuts, or use shorter steps");
    EXPECT_EQ(integrator.time(), 0) << name;
    EXPECT_TRUE(integrator.step(1).converged) << name;
  }
}

TEST(CrossingTest, AStateBelowTheObstacleIsNoBeginning) {
  const auto model = block(true);
  Integrator integrator = test::direct(*model, scheme("Newmark").table(scheme("Newmark").parameters));
  test::expect_contains(
      test::refusal([&] { integrator.initialize(velocity(*model, 0, -0.6), test::at_rest(*model), 0); }),
      "the state at the start is not admissible: the surface of interaction \"Wall\" crosses");
}

}  // namespace
}  // namespace ixos
