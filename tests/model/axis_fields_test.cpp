// Pressures and tractions of nodes on the axis of a body of revolution.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/half_space.hpp"
#include "interaction/van_der_waals.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "model/interaction_group.hpp"
#include "model/model.hpp"
#include "model/surface_interaction.hpp"
#include "support/contact_element.hpp"
#include "support/reports.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

const VanDerWaals law(2.5, 25);

/// A rigid body of revolution of 3 by 2 L0 over the sphere of radius 2 about (0, -2.1), or over the wall y = 0.
std::unique_ptr<Model> revolved(ContactElement element, int across, bool sphere) {
  BoxShape shape;
  shape.lower = {0, 0.4, 0};
  shape.lengths = {3, 2, 0};
  shape.divisions = {across, 4, 1};
  Mesh mesh = box(shape);
  mesh.axisymmetric = true;
  test::give_contact_element(mesh, "bottom", element);
  auto model = test::model_of(mesh, test::elastic(linear_elastic, 0.2), Inertia::None);
  SurfaceInteraction below;
  below.name = "Below";
  below.side_set = "bottom";
  below.law = gap_law(law);
  below.obstacle = flat_wall({});
  if (sphere) below.obstacle = make_obstacle("Sphere", 2, {{"Radius", 2.0}, {"Center", {0.0, -2.1}}});
  add_interaction(*model, below);
  return model;
}

const ContactElement contact_elements[] = {ContactElement::Q1C1, ContactElement::Q1C2, ContactElement::Q1C3,
                                           ContactElement::Q1C4, ContactElement::Q1CH, ContactElement::Q2C2,
                                           ContactElement::Q2C4};

/// Returns pressure and traction at the node on the axis from the rank that owns it, on all ranks.
std::array<double, 3> on_axis(const Model& model) {
  const std::vector<double> u = test::at_rest(model);
  const test::ReportAt report(model, u.data());
  const InteractionGroup group = report.interaction("Below");
  const std::vector<double> pressure = group.pressure(), traction = group.traction();
  std::array<double, 3> values{};
  const LocalMesh& mesh = model.mesh();
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.owned_nodes); ++node)
    if (mesh.coordinates[2 * node] == 0 && mesh.coordinates[2 * node + 1] == 0.4 && !mesh.is_derivative(node))
      values = {pressure[node], traction[2 * node], traction[2 * node + 1]};
  model.space().sum(values.data(), 3);
  return values;
}

TEST(AxisFieldsTest, AUniformPressureIsTheLawsOnTheAxisToo) {
  for (const ContactElement element : contact_elements) {
    const auto model = revolved(element, 6, false);
    const std::array<double, 3> values = on_axis(*model);
    EXPECT_NEAR(values[0], law.traction(0.4), 1e-14);
    EXPECT_EQ(values[1], 0);
    EXPECT_NEAR(values[2], law.traction(0.4), 1e-14);
  }
}

// The pressure is even in the radius: nodal means differ from the law at the node's own gap by the square of the width.
TEST(AxisFieldsTest, ThePressureUnderASphereConvergesOnTheAxis) {
  const double exact = law.traction(0.5);
  for (const ContactElement element : contact_elements) {
    const double coarse = std::abs(on_axis(*revolved(element, 6, true))[0] - exact);
    const double fine = std::abs(on_axis(*revolved(element, 12, true))[0] - exact);
    EXPECT_LT(coarse, 0.2 * std::abs(exact)) << static_cast<int>(element);
    EXPECT_LT(fine, 0.35 * coarse) << static_cast<int>(element);
  }
}

// A quadratic side of width h: int N T ds/int N ds with N = (1 - s)(1 - 2 s), by Simpson's rule.
TEST(AxisFieldsTest, WhereTheRingVanishesTheMeanIsThatOverTheSection) {
  const double h = 0.25;
  const int intervals = 2000;
  double sum = 0;
  for (int i = 0; i <= intervals; ++i) {
    const double s = static_cast<double>(i) / intervals, gap = std::hypot(h * s, 2.5) - 2;
    sum += (i == 0 || i == intervals ? 1 : 2 + 2 * (i % 2)) * (1 - s) * (1 - 2 * s) * law.traction(gap);
  }
  const double mean = sum / (3 * intervals) * 6;
  const std::array<double, 3> values = on_axis(*revolved(ContactElement::Q1C2, 12, true));
  EXPECT_NEAR(values[0], mean, 1e-10 * std::abs(mean));
  EXPECT_EQ(values[1], 0);
  EXPECT_NEAR(values[2], mean, 1e-10 * std::abs(mean));
}

}  // namespace
}  // namespace ixos
