// Nodal forces of a model without a scene.
#include <gtest/gtest.h>

#include <cmath>

#include "interaction/catalogue.hpp"
#include "interaction/obstacle.hpp"
#include "mesh/generators/shapes.hpp"
#include "model/surface_interaction.hpp"
#include "support/reports.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

/// A plate of 2 by 1 L0, half an L0 above a wall.
std::unique_ptr<Model> plate() {
  BoxShape shape;
  shape.lengths = {2, 1, 0};
  shape.divisions = {4, 2, 1};
  auto model = test::model_of(box(shape), test::elastic(neo_hooke, 0.3), Inertia::None);
  SurfaceInteraction wall;
  wall.side_set = "bottom";
  wall.law = make_gap_law("Van der Waals", {{"Gamma L", 2.5}, {"Gamma W", 25.0}});
  wall.obstacle = make_obstacle("Half-Space", 2, {{"Point", {0.0, -0.5}}});
  add_interaction(*model, wall);
  return model;
}

/// amplitude (x^2 + y, x y + 1 - x)
std::vector<double> field(const Model& model, double amplitude) {
  std::vector<double> u = test::at_rest(model);
  for (std::size_t i = 0; i < u.size(); i += 2) {
    const double x = model.mesh().coordinates[i], y = model.mesh().coordinates[i + 1];
    u[i] = amplitude * (x * x + y);
    u[i + 1] = amplitude * (x * y + 1 - x);
  }
  return u;
}

TEST(NodalForceTest, IsTheGradientOfTheEnergy) {
  const auto model = plate();
  const std::vector<double> u = field(*model, 0.03), along = field(*model, 1);
  for (const Part part : {Part::Elastic, Part::Interaction}) {
    const std::vector<double> force = test::ReportAt(*model, u.data()).nodal_force(part);
    double work = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(model->space().owned()); ++i) work += force[i] * along[i];
    model->space().sum(&work, 1);
    const double h = 1e-5;
    const double slope = (test::ReportAt(*model, field(*model, 0.03 + h).data()).energy(part) -
                          test::ReportAt(*model, field(*model, 0.03 - h).data()).energy(part)) /
                         (2 * h);
    EXPECT_GT(std::abs(slope), 1e-3);
    EXPECT_NEAR(work, slope, 1e-7 * std::abs(slope));
  }
}

TEST(NodalForceTest, IsNotANumberWhereTheStateIsInadmissible) {
  const auto model = plate();
  std::vector<double> u = test::at_rest(*model);
  for (std::size_t i = 0; i < u.size(); i += 2) u[i] = -2 * model->mesh().coordinates[i];  // inside out
  for (const double f : test::ReportAt(*model, u.data()).nodal_force(Part::Elastic)) EXPECT_TRUE(std::isnan(f));
}

}  // namespace
}  // namespace ixos
