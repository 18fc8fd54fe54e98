// Two surfaces that interact.
#include "term/pair/pair_term.hpp"

#include <gtest/gtest.h>

#include <Teuchos_CommHelpers.hpp>

#include <cmath>

#include "interaction/catalogue.hpp"
#include "interaction/van_der_waals.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/facing_nodes.hpp"
#include "model/term_sums.hpp"
#include "support/comparison.hpp"
#include "support/pair_checks.hpp"
#include "support/reports.hpp"
#include "support/simplices.hpp"
#include "support/tangents.hpp"
#include "term/wall/surface_terms.hpp"

namespace ixos {
namespace {

const std::shared_ptr<const GapLaw>& law() {
  static const std::shared_ptr<const GapLaw> law = gap_law(VanDerWaals(2.5, 25));
  return law;
}

/// A model with one pair.
struct Bodies : test::PairOfBodies {
  double rounding = 1;     ///< of sums of weights, over that of sides of low order
  double left_out = 1e-2;  ///< of the matrix, over its largest product

  Bodies(const Mesh& mesh, const std::string& secondary, const std::string& primary, Smoothing smoothing)
      : PairOfBodies(mesh, secondary, primary, smoothing) {}
};

/// Disks and blocks, balls and boxes, smooth and with straight sides.
std::vector<Bodies> cases() {
  std::vector<Bodies> all;
  for (const Smoothing smoothing : {Smoothing::None, Smoothing::CatmullRom}) {
    all.emplace_back(test::two_balls(2, {2.4, 2, 2.9}), "a_surface", "b_surface", smoothing);
    all.emplace_back(test::two_boxes(0.3), "upper_bottom", "lower_top", smoothing);
    all.emplace_back(test::two_disks(3, {5, 3.6}), "a_surface", "b_surface", smoothing);
    all.emplace_back(test::two_blocks(0.3), "upper_bottom", "lower_top", smoothing);
  }
  all.emplace_back(test::two_balls(2, {2.4, 2, 2.9}), "a_surface", "b_surface", Smoothing::Spline);
  all.emplace_back(test::two_boxes(0.3), "upper_bottom", "lower_top", Smoothing::Spline);
  Mesh enriched = test::two_blocks(0.3), quadratic = test::two_blocks(0.3), in_space = test::two_boxes(0.3);
  enrich(enriched, "upper_bottom", ContactElement::Q1C3);
  all.emplace_back(enriched, "upper_bottom", "lower_top", Smoothing::CatmullRom);
  for (Mesh* mesh : {&quadratic, &in_space}) {
    raise_order(*mesh);
    all.emplace_back(*mesh, "upper_bottom", "lower_top", Smoothing::None);
    enrich(*mesh, "upper_bottom", ContactElement::Q2C4);
    all.emplace_back(*mesh, "upper_bottom", "lower_top", Smoothing::None);
    all.back().rounding = 20;
  }
  for (const ContactElement element : {ContactElement::Q1C2, ContactElement::Q1C4}) {
    Mesh tied = test::two_boxes(0.3);  // the faces at the rim have straight edges
    enrich(tied, "upper_bottom", element);
    all.emplace_back(tied, "upper_bottom", "lower_top", Smoothing::CatmullRom);
    if (element == ContactElement::Q1C4) all.back().rounding = 20;
  }
  for (const Smoothing smoothing : {Smoothing::None, Smoothing::CatmullRom, Smoothing::Spline}) {
    all.emplace_back(test::two_blocks(0.3), "lower_surface", "upper_surface", smoothing);
  }
  all.emplace_back(test::two_disks(3, {5, 3.6}), "a_surface", "b_surface", Smoothing::Spline);
  const std::size_t triangles = all.size();
  for (const Smoothing smoothing : {Smoothing::None, Smoothing::CatmullRom}) {  // triangles, also beside quadrilaterals
    all.emplace_back(test::split_cells(test::two_balls(2, {2.4, 2, 2.9}), "twelve tetrahedra"), "a_surface",
                     "b_surface", smoothing);
    all.emplace_back(test::split_cells(test::two_boxes(0.31), "hexahedra and prisms"), "upper_bottom", "lower_top",
                     smoothing);
  }
  for (const bool bubbles : {false, true}) {
    Mesh curved = test::split_cells(test::two_boxes(0.3), "tetrahedra");
    raise_order(curved, bubbles);
    all.emplace_back(curved, "upper_bottom", "lower_top", Smoothing::CatmullRom);
  }
  // Patches of a third of a triangle end nearer to each other than whole sides: the matrix leaves out more.
  for (std::size_t k = triangles; k < all.size(); ++k) all[k].left_out = 2e-2;
  return all;
}

TEST(PairTermTest, ForceAndTangentAreDerivatives) {
  int number = 0;
  for (const Bodies& bodies : cases()) {
    SCOPED_TRACE("case " + std::to_string(number++));
    test::expect_derivatives(bodies, 4, 1e-8, 0.01);
  }
}

/// The matrix leaves out sides that are far apart, as a whole: a common motion of both bodies has no force.
TEST(PairTermTest, TheMatrixLeavesOutLittle) {
  for (const Bodies& bodies : cases()) {
    const std::vector<double> u = test::smooth_field(*bodies.model, 0.02), way = test::noise(*bodies.model, 1),
                              common(u.size(), 1.0);
    const Segment segment{nullptr, nullptr, u.data()};
    const auto matrix = bodies.matrix_times(segment, end_rule(), way), all = bodies.product(segment, end_rule(), way),
               none = bodies.matrix_times(segment, end_rule(), common);
    double largest = 0;
    for (const double value : all) largest = std::max(largest, std::abs(value));
    largest = bodies.model->space().maximum(largest);
    for (std::size_t k = 0; k < all.size(); ++k) {
      EXPECT_NEAR(matrix[k], all[k], bodies.left_out * largest);
      EXPECT_NEAR(none[k], 0, 1e-13 * bodies.rounding * largest);
    }
  }
}

TEST(PairTermTest, NetForceAndNetMomentVanish) {
  for (const Bodies& bodies : cases())
    test::expect_no_net_force(bodies, 1e-14 * bodies.rounding, 1e-13 * bodies.rounding, 0.01);
}

/// A flat primary surface at rest is the rigid wall: the forces on the secondary one are those of the flat term. Smooth
/// surfaces distribute the same sums over more nodes.
TEST(PairTermTest, BeforeAFlatSurfaceItIsTheWall) {
  Mesh plane = test::two_blocks(0.3), around = plane;
  around.axisymmetric = true;
  for (std::size_t k = 0; k < around.coordinates.size(); k += 2) around.coordinates[k] += 0.5;
  for (const auto& [blocks, smoothing] : {std::pair{plane, Smoothing::None}, std::pair{plane, Smoothing::CatmullRom},
                                          std::pair{around, Smoothing::None}, std::pair{around, Smoothing::CatmullRom},
                                          std::pair{plane, Smoothing::Spline}, std::pair{around, Smoothing::Spline}}) {
    const Bodies bodies(blocks, "upper_bottom", "lower_top", smoothing);
    const LocalMesh& mesh = bodies.model->mesh();
    HalfSpace wall;
    wall.normal = {0, 1, 0};
    const auto& sides = mesh.side_sets[mesh.side_set("upper_bottom")];
    const Interactions flat = make_surface_terms(mesh, sides, bodies.model->pattern(), law(), flat_wall(wall), {});
    // A rotation and a stretch of the upper body: straight sides stay straight.
    std::vector<double> u = test::at_rest(*bodies.model);
    for (std::size_t k = 0; k < u.size(); k += 2)
      if (mesh.coordinates[k + 1] > 0.1) {
        u[k] = 0.02 * mesh.coordinates[k] - 0.01 * mesh.coordinates[k + 1];
        u[k + 1] = 0.03 * mesh.coordinates[k];
      }
    const auto f = bodies.force({nullptr, nullptr, u.data()}, end_rule());
    std::vector<double> g(u.size(), 0.0);
    for (const auto& term : flat) EXPECT_TRUE(term->add_force({nullptr, nullptr, u.data()}, end_rule(), g.data()));
    for (std::size_t k = 0; k < static_cast<std::size_t>(bodies.model->space().owned()); ++k)
      if (smoothing == Smoothing::None && mesh.coordinates[k / 2 * 2 + 1] > 0.1) {
        EXPECT_NEAR(f[k], g[k], 1e-14);
      }
    InteractionReport a, b;
    bodies.term->reports().report({u.data()}, a);
    for (const auto& term : flat) term->reports().report({u.data()}, b);
    EXPECT_NEAR(a.measure, b.measure, 1e-14);
    EXPECT_NEAR(a.force[1], b.force.empty() ? 0 : b.force[1], 1e-14);
  }
}

/// The force at each owned node is that of one rank that owns all, bit for bit: every rank finds the same closest
/// points.
TEST(PairTermTest, RanksDoNotMatter) {
  const Mesh mesh = test::two_disks(3, {5, 3.6});
  const Bodies bodies(mesh, "a_surface", "b_surface", Smoothing::CatmullRom);
  const std::vector<double> u = test::noise(*bodies.model, 0.01);
  std::vector<double> own = test::gathered(*bodies.model, bodies.force({nullptr, nullptr, u.data()}, gauss_rule(2)));
  const std::vector<double> whole_u = test::gathered(*bodies.model, u);
  const LocalMesh whole = localize(mesh, partition_nodes(mesh, 1), 0, 1, {"a_surface", "b_surface"});
  const auto curves = [&](const char* set) {
    return surface_patches<2>(whole, whole.whole_side_sets.at(set), Smoothing::CatmullRom, set);
  };
  const Pattern pattern(whole);
  const auto term = make_pair_term<2>(whole, {curves("a_surface"), curves("b_surface")}, pattern, law(), {});
  std::vector<double> f(whole_u.size(), 0.0);
  EXPECT_TRUE(term->add_force({nullptr, nullptr, whole_u.data()}, gauss_rule(2), f.data()));
  ASSERT_EQ(own.size(), f.size());
  EXPECT_LT(test::distance(own, f), 1e-15);
  EXPECT_NEAR(bodies.energy(u), term->energy({whole_u.data()}), 1e-15);
  EXPECT_EQ(bodies.model->space().minimum(bodies.term->admissibility().lowest_point(bodies.steps->at(u.data())).gap),
            term->admissibility().lowest_point({whole_u.data()}).gap);
}

/// Along the largest admissible step all gaps keep their margin, and a step that changes no gap is not limited.
TEST(PairTermTest, AdmissibleStepsKeepTheMargin) {
  const Bodies bodies(test::two_disks(3, {5, 3.6}), "a_surface", "b_surface", Smoothing::CatmullRom);
  const LocalMesh& mesh = bodies.model->mesh();
  std::vector<double> u = test::at_rest(*bodies.model), way(u.size());
  const auto set_way = [&](double own, double other, double turn) {
    for (std::size_t k = 0; k < u.size(); k += 2) {
      const bool second = 5 * mesh.coordinates[k] + 3.6 * mesh.coordinates[k + 1] > (25 + 3.6 * 3.6) / 2;
      way[k] = (second ? other : own) * 0.8 - turn * mesh.coordinates[k + 1];
      way[k + 1] = (second ? other : own) * 0.6 + turn * mesh.coordinates[k];
    }
  };
  set_way(3, -2, 0);  // towards each other
  const double step = bodies.model->space().minimum(
      bodies.term->admissibility().admissible_step({nullptr, nullptr, u.data()}, end_rule(), way.data()));
  InteractionReport before, after;
  bodies.term->reports().report({u.data()}, before);
  for (std::size_t k = 0; k < u.size(); ++k) u[k] += step * way[k];
  bodies.term->reports().report({u.data()}, after);
  const double g0 = bodies.model->space().minimum(before.least_gap),
               g1 = bodies.model->space().minimum(after.least_gap);
  const double least = 0.8 * std::min(g0, law()->equilibrium_gap());
  EXPECT_GE(g1, least - 1e-12);
  EXPECT_LT(g1, least + 0.02);  // not shorter than need be
  u = test::at_rest(*bodies.model);
  set_way(30, 30, 0);
  EXPECT_EQ(bodies.term->admissibility().admissible_step({nullptr, nullptr, u.data()}, end_rule(), way.data()), 1);
  set_way(-30, 30, 0);
  EXPECT_EQ(bodies.term->admissibility().admissible_step({nullptr, nullptr, u.data()}, end_rule(), way.data()), 1);
  set_way(1, -1, 0);
  for (std::size_t k = 0; k < u.size(); ++k) u[k] += way[k];
  bodies.force({nullptr, nullptr, u.data()}, end_rule(), false);
  EXPECT_LT(bodies.term->admissibility().lowest_point(bodies.steps->at(u.data())).gap, 0);
}

/// Bodies that are cut across slide over the cut and come nearer, in several parts: the ranks' least step is that of
/// one rank that owns all.
TEST(PairTermTest, AdmissibleStepsDoNotDependOnRanks) {
  const Comm comm = test::world();
  const Mesh mesh = test::two_blocks(0.3, 40, 40);
  const FacingNodes facing = facing_nodes(mesh, "upper_bottom", "lower_top", 0.3);
  const auto step = [&](const LocalMesh& part, double slide, double fall) {
    const auto surface = [&](const char* set) {
      return surface_patches<2>(part, part.whole_side_sets.at(set), Smoothing::CatmullRom, set);
    };
    const Pattern pattern(part);
    const auto term = make_pair_term<2>(part, {surface("upper_bottom"), surface("lower_top")}, pattern, law(), {});
    std::vector<double> u(part.coordinates.size(), 0.0), way = u;
    for (std::size_t k = 0; k < u.size(); k += 2) {
      if (part.coordinates[k + 1] < 0.1) continue;
      way[k] = slide;
      way[k + 1] = -fall * (1 + 0.5 * part.coordinates[k]);
    }
    return term->admissibility().admissible_step({nullptr, nullptr, u.data()}, end_rule(), way.data());
  };
  const std::vector<int> owner =
      partition_nodes(mesh, comm->getSize(), node_work(mesh, {}, 500, facing.sides), facing.pairs);
  const std::vector<std::string> sets{"upper_bottom", "lower_top"};
  for (const auto& [slide, fall] : {std::pair{0.8, 0.2}, std::pair{-1.5, 0.4}, std::pair{0.05, 0.06}}) {
    const double own = step(localize(mesh, owner, comm->getRank(), comm->getSize(), sets), slide, fall);
    const double whole = step(localize(mesh, partition_nodes(mesh, 1), 0, 1, sets), slide, fall);
    double least = 0;
    Teuchos::reduceAll(*comm, Teuchos::REDUCE_MIN, own, Teuchos::outArg(least));
    EXPECT_NEAR(least, whole, 1e-12) << slide;
    EXPECT_GT(whole, 0.01);
    EXPECT_LT(whole, 1);
  }
}

TEST(PairTermTest, GapsPressuresAndRatios) {
  const Bodies bodies(test::two_blocks(0.3), "upper_bottom", "lower_top", Smoothing::CatmullRom);
  const LocalMesh& mesh = bodies.model->mesh();
  const std::vector<double> u = test::at_rest(*bodies.model);
  std::vector<double> gap = test::ReportAt(*bodies.model, u.data()).nodal_gap(),
                      pressure = test::ReportAt(*bodies.model, u.data()).contact_pressure();
  const std::vector<double> traction = test::ReportAt(*bodies.model, u.data()).interaction_traction();
  const double expected = law()->traction(0.3)[0];
  for (std::size_t n = 0; n < static_cast<std::size_t>(mesh.owned_nodes); ++n) {
    const double y = mesh.coordinates[2 * n + 1];
    if (std::abs(y - 0.3) < 1e-12) {
      EXPECT_NEAR(gap[n], 0.3, 1e-15);
      EXPECT_NEAR(pressure[n], expected, 1e-14);
      EXPECT_NEAR(traction[2 * n + 1], expected, 1e-14);
      EXPECT_NEAR(traction[2 * n], 0, 1e-15);
    } else {
      EXPECT_TRUE(std::isnan(gap[n]));
      EXPECT_EQ(pressure[n], 0);
      EXPECT_EQ(traction[2 * n + 1], 0);
    }
  }
  const InteractionReport report = test::ReportAt(*bodies.model, u.data()).interaction_report();
  EXPECT_NEAR(report.force[1], 2 * expected, 1e-14);
  EXPECT_NEAR(report.measure, 2, 1e-14);
  EXPECT_NEAR(report.least_gap, 0.3, 1e-15);
  std::vector<double> higher = u;
  for (std::size_t k = 1; k < u.size(); k += 2)
    if (mesh.coordinates[k] > 0.2) higher[k] = 0.3;
  EXPECT_NEAR(TermSums(*bodies.model).gap_ratio({u.data(), nullptr, higher.data()}), 2, 1e-12);
  EXPECT_EQ(TermSums(*bodies.model).gap_ratio({u.data(), nullptr, u.data()}), 1);
  EXPECT_GT(bodies.term->rounding(bodies.steps->at(u.data())), bodies.model->space().comm()->getSize() == 1 ? 0 : -1);
}

/// Turns two equal disks by 180 degrees into each other. Two passes with half the weight treat them alike, one pass
/// does not.
TEST(PairTermTest, TwoHalfWeightedPassesHaveNoBias) {
  const Mesh mesh = test::two_disks(3, {5, 3.6});
  const auto bias = [&](bool both) {
    const auto model = test::model_of_bodies(mesh, {"a_surface", "b_surface"});
    SurfacePair pair;
    pair.law = law();
    pair.factor = [both](const std::array<double, 3>&) { return both ? 0.5 : 1.0; };
    pair.side_set = "a_surface";
    pair.primary = "b_surface";
    add_pair(*model, pair);
    std::swap(pair.side_set, pair.primary);
    if (both) add_pair(*model, pair);
    const auto& x = model->mesh().coordinates;
    std::vector<double> u = test::at_rest(*model), f(u.size());
    for (std::size_t k = 0; k < u.size(); k += 2) {
      const bool second = 5 * x[k] + 3.6 * x[k + 1] > (25 + 3.6 * 3.6) / 2;
      const double sign = second ? -1 : 1, a = second ? 5 - x[k] : x[k], b = second ? 3.6 - x[k + 1] : x[k + 1];
      u[k] = sign * 0.05 * std::sin(a + 0.5 * b);
      u[k + 1] = sign * 0.05 * std::cos(1.3 * a - b);
    }
    EXPECT_TRUE(TermSums(*model).force(Part::Interaction, {nullptr, nullptr, u.data()}, end_rule(), f.data()));
    const std::vector<double> whole = test::gathered(*model, f), &places = mesh.coordinates;
    double largest = 0;
    for (std::size_t k = 0; k < whole.size(); k += 2)
      for (std::size_t j = 0; j < whole.size(); j += 2)
        if (std::hypot(places[k] + places[j] - 5, places[k + 1] + places[j + 1] - 3.6) < 1e-9)
          largest = std::max({largest, std::abs(whole[k] + whole[j]), std::abs(whole[k + 1] + whole[j + 1])});
    return largest;
  };
  EXPECT_LT(bias(true), 1e-13);
  EXPECT_GT(bias(false), 1e-4);
}

TEST(PairTermTest, NotANumberShowsInTheForceAndMeansInClosedFormAreRefused) {
  const Bodies bodies(test::two_blocks(0.3), "upper_bottom", "lower_top", Smoothing::CatmullRom);
  std::vector<double> u(static_cast<std::size_t>(bodies.model->space().local()), std::nan(""));
  std::vector<double> f(u.size(), 0.0);
  bodies.term->add_force({nullptr, nullptr, u.data()}, end_rule(), f.data());
  double sum = 0;
  for (double value : f) sum += value;
  EXPECT_TRUE(std::isnan(sum));
  EXPECT_FALSE(bodies.term->follows(Mean::Exact));
  EXPECT_THROW(bodies.term->add_force({u.data(), nullptr, u.data()}, exact_rule(), f.data()), std::logic_error);
}

}  // namespace
}  // namespace ixos
