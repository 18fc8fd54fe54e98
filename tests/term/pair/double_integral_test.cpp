// Two surfaces that interact by all pairs of their points.
#include "term/pair/double_integral.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/cell_order.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "support/comparison.hpp"
#include "support/pair_checks.hpp"
#include "support/reports.hpp"
#include "support/sanitized.hpp"
#include "support/simplices.hpp"
#include "support/tangents.hpp"
#include "term/pair/dense_pairs.hpp"

namespace ixos {
namespace {

/// A model with one pair of three points a direction.
struct Bodies : test::PairOfBodies {
  Bodies(const Mesh& mesh, const std::string& secondary, const std::string& primary,
         Smoothing smoothing = Smoothing::CatmullRom)
      : PairOfBodies(mesh, secondary, primary, smoothing, 0, gap_law(VanDerWaals(2.5, 25)), Passes::DoubleIntegral, 3) {
  }
};

/// In the plane and in space, smooth and with straight sides, enriched and quadratic.
std::vector<Bodies> cases() {
  std::vector<Bodies> all;
  for (const Smoothing smoothing : {Smoothing::None, Smoothing::CatmullRom}) {
    all.emplace_back(test::two_balls(2, {2.4, 2, 2.9}), "a_surface", "b_surface", smoothing);
    all.emplace_back(test::two_boxes(0.3), "upper_bottom", "lower_top", smoothing);
    all.emplace_back(test::two_disks(3, {5, 3.6}), "a_surface", "b_surface", smoothing);
  }
  Mesh enriched = test::two_blocks(0.3), quadratic = test::two_boxes(0.3);
  enrich(enriched, "upper_bottom", ContactElement::Q1C3);
  all.emplace_back(enriched, "upper_bottom", "lower_top");
  raise_order(quadratic);
  all.emplace_back(quadratic, "upper_bottom", "lower_top", Smoothing::None);
  const Mesh boxes = test::two_boxes(0.3);
  all.emplace_back(test::split_cells(boxes, "tetrahedra"), "upper_bottom", "lower_top");
  all.emplace_back(test::split_cells(boxes, "hexahedra and prisms"), "upper_bottom", "lower_top", Smoothing::None);
  return all;
}

/// The matrix couples all nodes of both surfaces, so nothing is left out.
TEST(DoubleIntegralTest, ForceAndTangentAreDerivatives) {
  for (const Bodies& bodies : cases()) test::expect_derivatives(bodies, 2, 1e-9, 1e-3);
}

/// The matrix without negative stiffness has none.
TEST(DoubleIntegralTest, TheConvexTangentIsPositive) {
  for (const Bodies& bodies : cases()) {
    const std::vector<double> u = test::smooth_field(*bodies.model, 0.02);
    std::vector<double> values = test::no_values(*bodies.model);
    bodies.term->add_tangent({nullptr, nullptr, u.data()}, end_rule(), Tangent::Convex, values.data());
    double largest = 0;
    for (int seed = 1; seed < 6; ++seed) {
      const std::vector<double> way = test::noise(*bodies.model, seed);
      const auto product = test::matrix_product(*bodies.model, values.data(), way);
      double work = 0;
      for (std::size_t k = 0; k < product.size(); ++k) work += product[k] * way[k];
      bodies.model->space().sum(&work, 1);
      EXPECT_GE(work, 0);
      largest = std::max(largest, work);
    }
    EXPECT_GT(largest, 1e-3);
  }
}

TEST(DoubleIntegralTest, NetForceAndNetMomentVanish) {
  for (const Bodies& bodies : cases()) test::expect_no_net_force(bodies, 2e-14, 1e-12, 1e-3);
}

/// Exchanged surfaces have the same energy and force, and the report says the force on the secondary one.
TEST(DoubleIntegralTest, TheOrderOfTheSurfacesDoesNotMatter) {
  for (const Mesh& mesh : {test::two_disks(3, {5, 3.6}), test::two_balls(2, {2.4, 2, 2.9})}) {
    const Bodies there(mesh, "a_surface", "b_surface"), back(mesh, "b_surface", "a_surface");
    const std::vector<double> u = test::smooth_field(*there.model, 0.02);
    const auto f = there.force({nullptr, nullptr, u.data()}, end_rule()),
               g = back.force({nullptr, nullptr, u.data()}, end_rule());
    double largest = 0;
    for (const double value : f) largest = std::max(largest, std::abs(value));
    for (std::size_t k = 0; k < static_cast<std::size_t>(there.model->space().owned()); ++k)
      EXPECT_NEAR(f[k], g[k], 1e-13 * largest);
    EXPECT_NEAR(there.energy(u), back.energy(u), 1e-13 * std::abs(there.energy(u)));
    const InteractionReport on_first = test::ReportAt(*there.model, u.data()).interaction_report(),
                            on_second = test::ReportAt(*back.model, u.data()).interaction_report();
    for (std::size_t i = 0; i < on_first.force.size(); ++i)
      EXPECT_NEAR(on_first.force[i], -on_second.force[i], 1e-12 * largest);
    EXPECT_GT(std::abs(on_first.force[0]), 1e-4);
  }
}

/// The force at each owned node is that of one rank that owns all.
TEST(DoubleIntegralTest, RanksDoNotMatter) {
  const Mesh mesh = test::two_disks(3, {5, 3.6});
  const Bodies bodies(mesh, "a_surface", "b_surface");
  const std::vector<double> u = test::noise(*bodies.model, 0.01);
  const std::vector<double> own =
      test::gathered(*bodies.model, bodies.force({nullptr, nullptr, u.data()}, gauss_rule(2)));
  const std::vector<double> whole_u = test::gathered(*bodies.model, u);
  const LocalMesh whole = localize(mesh, partition_nodes(mesh, 1), 0, 1, {"a_surface", "b_surface"});
  const auto curves = [&](const char* set) {
    return surface_patches<2>(whole, whole.whole_side_sets.at(set), Smoothing::CatmullRom, set);
  };
  const PairSurfaces<2> surfaces{curves("a_surface"), curves("b_surface")};
  const DensePairs<2> pairs(surfaces, PairKernel<2>(gap_law(VanDerWaals(2.5, 25))->powers()), 3);
  const std::vector<char> all(surfaces.secondary.patches.size(), 1);
  std::vector<double> f(whole_u.size(), 0.0);
  const Rule rule = gauss_rule(2);
  for (const RulePoint& point : rule.points) {
    const NodeParts parts{{{point.to, whole_u.data()}, {0, nullptr}, {0, nullptr}}};
    const auto sums = pairs.gradient({combined_places<2>(surfaces.secondary.nodes, whole.coordinates, 1, parts),
                                      combined_places<2>(surfaces.primary.nodes, whole.coordinates, 1, parts)},
                                     all);
    for (std::size_t n = 0; n < sums.size(); ++n) {
      const std::size_t first = surfaces.secondary.nodes.size();
      const int node = n < first ? surfaces.secondary.nodes[n] : surfaces.primary.nodes[n - first];
      for (std::size_t i = 0; i < 2; ++i) f[2 * static_cast<std::size_t>(node) + i] += point.weight * sums[n][i];
    }
  }
  ASSERT_EQ(own.size(), f.size());
  // Under sanitizers the library fuses other operations than this test.
  EXPECT_LE(test::distance(own, f), test::sanitized() ? 1e-15 : 0);
}

/// Overlaps are found by the least distance.
TEST(DoubleIntegralTest, OverlapsAreInadmissible) {
  const Bodies bodies(test::two_blocks(0.3), "upper_bottom", "lower_top");
  std::vector<double> u = test::at_rest(*bodies.model), way(u.size());
  for (std::size_t k = 1; k < u.size(); k += 2)
    if (bodies.model->mesh().coordinates[k] > 0.2) u[k] = -0.4;
  bodies.force({nullptr, nullptr, u.data()}, end_rule(), false);
  EXPECT_LT(bodies.term->admissibility().lowest_point(bodies.steps->at(u.data())).gap, 0);
  u = test::at_rest(*bodies.model);
  for (std::size_t k = 1; k < u.size(); k += 2) way[k] = bodies.model->mesh().coordinates[k] > 0.2 ? -1 : 0;
  const double step = bodies.model->space().minimum(
      bodies.term->admissibility().admissible_step({nullptr, nullptr, u.data()}, end_rule(), way.data()));
  EXPECT_GT(step, 0);
  EXPECT_LE(step, 0.3 - 0.8 * test::ReportAt(*bodies.model, u.data()).interaction_report().least_gap / 0.3 * 0.2);
  EXPECT_FALSE(bodies.term->follows(Mean::Exact));
  EXPECT_FALSE(bodies.term->follows(Mean::DiscreteGradient));
  EXPECT_THROW(bodies.term->add_force({u.data(), nullptr, u.data()}, exact_rule(), way.data()), std::logic_error);
}

}  // namespace
}  // namespace ixos
