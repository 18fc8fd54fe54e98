// Fields of surfaces with friction.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "interaction/catalogue.hpp"
#include "interaction/friction_law.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/half_space.hpp"
#include "interaction/van_der_waals.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "model/model.hpp"
#include "model/surface_interaction.hpp"
#include "support/by_hand.hpp"
#include "support/contact_element.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

constexpr double stress = 0.03, stiffness = 5, way = 0.4, radius = 50, lowest = 0.15;

const ContactElement contact_elements[] = {ContactElement::Q1C1, ContactElement::Q1C2, ContactElement::Q1C3,
                                           ContactElement::Q1C4, ContactElement::Q1CH, ContactElement::Q2C2,
                                           ContactElement::Q2C4};

enum class Shape { Plane, Sphere, Ring };

/// A body and its state after steps.
struct Body {
  std::unique_ptr<Model> model;
  std::unique_ptr<test::ByHand<const Model>> steps;
  std::vector<double> u;

  void step(const std::vector<double>& to) {
    steps->step(u.data(), to.data(), 0, 1);
    u = to;
  }
  InteractionGroup wall() const { return StateReport(*model, steps->at(u.data())).interaction("Wall"); }
};

/// A rigid body of 3 by 1 (by 1) L0 over a wall or a sphere, or one of revolution with a radius of 3 L0 over a wall.
Body resting(int dimension, ContactElement element, Shape shape, double eps, double factor, double sharpness = 0,
             bool current = false) {
  BoxShape own;
  own.dimension = dimension;
  own.lengths = {3, 1, 1};
  own.divisions = {6, 2, 2};
  Mesh mesh = box(own);
  mesh.axisymmetric = shape == Shape::Ring;
  test::give_contact_element(mesh, "bottom", element);
  auto model = test::model_of(mesh, test::elastic(linear_elastic, 0.2), Inertia::None);
  SurfaceInteraction wall;
  wall.name = "Wall";
  wall.side_set = "bottom";
  wall.law = gap_law(VanDerWaals(2.5, 25));
  const auto up = static_cast<std::size_t>(dimension - 1);
  std::vector<double> below(up + 1, 0.0);
  below[up] = -lowest;
  HalfSpace half_space;
  std::copy(below.begin(), below.end(), half_space.point.begin());
  half_space.normal = {0, 0, 0};
  half_space.normal[up] = 1;
  wall.obstacle = flat_wall(half_space);
  below[up] -= radius;
  if (shape == Shape::Sphere)
    wall.obstacle =
        make_obstacle("Sphere", static_cast<std::size_t>(dimension), {{"Radius", radius}, {"Center", below}});
  wall.friction.type = FrictionType::ConstantStress;
  wall.friction.stress = stress;
  wall.friction.stiffness = eps;
  wall.friction.cutoff_share = 1;
  wall.friction.sharpness = sharpness;
  wall.friction.current = current;
  if (factor != 1) wall.factor = [factor](const std::array<double, 3>&) { return factor; };
  add_interaction(*model, wall);
  Body body{std::move(model), nullptr, {}};
  body.steps = std::make_unique<test::ByHand<const Model>>(*body.model);
  body.u = test::at_rest(*body.model);
  body.steps->initialize(body.u.data());
  return body;
}

/// Takes one step from rest in which each place X moves by factor(X) along x.
template <class Function>
void slide(Body& body, const Function& factor) {
  const LocalMesh& mesh = body.model->mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> to = test::at_rest(*body.model);
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.nodes()); ++node)
    if (!mesh.is_derivative(node)) to[node * d] = factor(mesh.coordinates[node * d]);
  body.step(to);
}

/// Calls visit(node) at the owned nodes of the surface.
template <class Visit>
void for_each_node(const Model& model, const Visit& visit) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.owned_nodes); ++node)
    if (!mesh.is_derivative(node) && mesh.coordinates[node * d + d - 1] == 0) visit(node);
}

TEST(FrictionFieldsTest, AUniformSlideAlongAPlaneIsExact) {
  for (const int dimension : {2, 3})
    for (const ContactElement element : contact_elements)
      for (const double factor : {1.0, 2.0}) {
        SCOPED_TRACE(testing::Message() << dimension << "D, element " << static_cast<int>(element) << ", " << factor);
        Body body = resting(dimension, element, Shape::Plane, stiffness, factor);
        const auto d = static_cast<std::size_t>(dimension);
        slide(body, [](double) { return way; });
        const InteractionGroup group = body.wall();
        const auto traction = group.friction(), slip = group.mean(SurfaceNumber::Slip),
                   lost = group.mean(SurfaceNumber::Dissipated), slides = group.mean(SurfaceNumber::Sliding);
        const double slid = way - stress / stiffness;
        for_each_node(*body.model, [&](std::size_t node) {
          for (std::size_t i = 0; i < d; ++i) EXPECT_NEAR(traction[node * d + i], i == 0 ? -factor * stress : 0, 1e-14);
          EXPECT_NEAR(slip[node], slid, 1e-13);
          EXPECT_NEAR(lost[node], factor * stress * slid, 1e-14);
          EXPECT_NEAR(slides[node], 1, 1e-13);
        });
        EXPECT_NEAR(group.friction_force()[0], -3 * factor * stress, 1e-14);
        const FrictionReport report = group.friction_report();
        EXPECT_NEAR(report.acting, 3, 1e-13);
        EXPECT_NEAR(report.sliding, 3, 1e-13);
        EXPECT_EQ(report.sticking, 0);
        EXPECT_NEAR(report.mean_slip(), slid, 1e-13);
      }
}

// The threshold changes with the gap while the surface slides; where it falls, the spring's slip becomes free.
TEST(FrictionFieldsTest, AStepTellsHowFarItsThresholdLags) {
  Friction friction;
  friction.type = FrictionType::ConstantStress;
  friction.stress = stress;
  friction.stiffness = stiffness;
  friction.sharpness = 20;
  const FrictionLaw law(friction, gap_law(VanDerWaals(2.5, 25)));
  for (const int dimension : {2, 3})
    for (const double rise : {-0.02, 0.04, 0.1})
      for (const double factor : {1.0, 2.0}) {
        Body body = resting(dimension, ContactElement::Q1C1, Shape::Plane, stiffness, factor, 20);
        const auto d = static_cast<std::size_t>(dimension);
        const std::vector<double> from = test::at_rest(*body.model);
        std::vector<double> to = from;
        for (std::size_t i = 0; i < to.size(); ++i) to[i] = i % d == 0 ? way : i % d + 1 == d ? rise : 0.0;
        EXPECT_EQ(body.wall().friction_report().work, 0);
        body.step(to);
        const InteractionGroup group = body.wall();
        const double begins = law.threshold_at(lowest), ends = law.threshold_at(lowest + rise);
        const double slip = way - begins / stiffness + std::max(begins - ends, 0.0) / stiffness;
        const FrictionReport report = group.friction_report();
        EXPECT_NEAR(report.work, 3 * factor * begins * slip, 1e-13);
        EXPECT_NEAR(report.lag, 3 * factor * (ends - begins) * slip, 1e-13);
      }
}

TEST(FrictionFieldsTest, AThresholdAtTheEndOfTheStepDoesNotLag) {
  Body body = resting(2, ContactElement::Q1C1, Shape::Plane, stiffness, 1, 20, true);
  slide(body, [](double) { return way; });
  EXPECT_GT(body.wall().friction_report().work, 0);
  EXPECT_NEAR(body.wall().friction_report().lag, 0, 1e-15);
}

// The places x < 1.5 stay, those beyond 2 slide, and the slip is linear between.
TEST(FrictionFieldsTest, APartOfTheSurfaceSlides) {
  Body body = resting(2, ContactElement::Q1C1, Shape::Plane, stiffness, 1);
  slide(body, [](double x) { return x > 1.75 ? way : 0; });
  const FrictionReport report = body.wall().friction_report();
  const double spring = stress / stiffness;  // 0.015 of the way: no point of the cell between sticks
  EXPECT_NEAR(report.sliding, 1.5, 1e-13);
  EXPECT_NEAR(report.sticking, 1.5, 1e-13);
  EXPECT_NEAR(report.acting, 3, 1e-13);
  EXPECT_NEAR(report.mean_slip(), (1.0 * (way - spring) + 0.5 * (way / 2 - spring)) / 3, 1e-13);
}

// The slip stays where it is, but friction does not act on a surface that is lifted, nor where the factor is zero.
TEST(FrictionFieldsTest, FrictionDoesNotActOnASurfaceThatIsApart) {
  for (const bool lifted : {true, false}) {
    Body body = resting(2, ContactElement::Q1C1, Shape::Plane, stiffness, lifted ? 1 : 0);
    slide(body, [](double) { return way; });
    std::vector<double> to = body.u;
    for (std::size_t k = 1; lifted && k < to.size(); k += 2) to[k] += 2;
    for (int n = 0; n < 2; ++n) body.step(to);
    const FrictionReport report = body.wall().friction_report();
    for (const double value : {report.acting, report.sliding, report.sticking, report.mean_slip()})
      EXPECT_EQ(value, 0) << lifted;
  }
}

// A surface that sticks has a spring's traction, and no slip.
TEST(FrictionFieldsTest, ASurfaceThatSticksDoesNotSlide) {
  Body body = resting(2, ContactElement::Q1C2, Shape::Plane, stiffness, 1);
  slide(body, [](double) { return 0.5 * stress / stiffness; });
  const InteractionGroup group = body.wall();
  const auto traction = group.friction();
  for_each_node(*body.model, [&](std::size_t node) { EXPECT_NEAR(traction[2 * node], -0.5 * stress, 1e-15); });
  for (const SurfaceNumber number : {SurfaceNumber::Slip, SurfaceNumber::Dissipated, SurfaceNumber::Sliding})
    for (double value : group.mean(number)) EXPECT_EQ(value, 0);
  const FrictionReport report = group.friction_report();
  EXPECT_NEAR(report.sticking, 3, 1e-13);
  EXPECT_EQ(report.sliding, 0);
  EXPECT_EQ(report.mean_slip(), 0);
}

// The traction turns with the sphere. Nodal means differ from the values at the node by the angle over a side, 0.01.
TEST(FrictionFieldsTest, AUniformSlideAlongASphereFollowsItsTangent) {
  for (const int dimension : {2, 3})
    for (const ContactElement element : contact_elements) {
      SCOPED_TRACE(testing::Message() << dimension << "D, element " << static_cast<int>(element));
      Body body = resting(dimension, element, Shape::Sphere, stiffness, 1);
      const LocalMesh& mesh = body.model->mesh();
      const auto d = static_cast<std::size_t>(dimension);
      slide(body, [](double) { return way; });
      const InteractionGroup group = body.wall();
      const auto traction = group.friction(), slip = group.mean(SurfaceNumber::Slip);
      for_each_node(*body.model, [&](std::size_t node) {
        const double x = mesh.coordinates[node * d], height = radius + lowest;
        const double y = d == 3 ? mesh.coordinates[node * d + 1] : 0;
        const double at_start = std::atan(x / std::hypot(y, height)), at_end = std::atan((x + way) / height);
        EXPECT_NEAR(traction[node * d], -stress * std::cos(at_end), 5e-4 * stress);
        EXPECT_NEAR(traction[node * d + d - 1], stress * std::sin(at_end), 7e-3 * stress);
        EXPECT_NEAR(slip[node], way * std::cos(at_start) - stress / stiffness, 5e-4 * way);
      });
    }
}

// A surface of revolution that widens. On the axis nothing has a direction across it, and the mean of the slip c R,
// with the weights of the section where the ring vanishes, has a closed form: int N s ds = 0 for quadratic sides.
TEST(FrictionFieldsTest, NothingSlidesOnTheAxis) {
  const double c = 0.1, hard = 1e5;
  for (const ContactElement element : {ContactElement::Q1C1, ContactElement::Q1C2, ContactElement::Q1C4}) {
    SCOPED_TRACE(static_cast<int>(element));
    Body body = resting(2, element, Shape::Ring, hard, 1);
    const LocalMesh& mesh = body.model->mesh();
    slide(body, [&](double x) { return c * x; });
    const InteractionGroup group = body.wall();
    const auto friction = group.friction(), slip = group.mean(SurfaceNumber::Slip),
               lost = group.mean(SurfaceNumber::Dissipated);
    for_each_node(*body.model, [&](std::size_t node) {
      EXPECT_NEAR(lost[node], stress * slip[node], 1e-14);
      if (mesh.coordinates[2 * node] > 0) {
        EXPECT_NEAR(friction[2 * node], -stress, 1e-13);
        return;
      }
      EXPECT_EQ(friction[2 * node], 0);
      EXPECT_EQ(friction[2 * node + 1], 0);
      // A linear side has the weight (1 - s) s: int (1 - s) s^2 over int (1 - s) s is a half of it.
      EXPECT_NEAR(slip[node], element == ContactElement::Q1C1 ? 0.5 * c * 0.5 : 0, 2 * stress / hard);
    });
    EXPECT_NEAR(group.friction_force()[0], -stress * M_PI * 9, 1e-13);  // radial, around the ring
  }
}

}  // namespace
}  // namespace ixos
