// Overlaps of two bodies under laws that are defined at every gap: the pair acts as a wall does.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "interaction/catalogue.hpp"
#include "mesh/partition.hpp"
#include "support/comparison.hpp"
#include "support/obstacle_geometry.hpp"
#include "support/pair_checks.hpp"
#include "term/pair/pair_points.hpp"
#include "term/wall/surface_terms.hpp"

namespace ixos {
namespace {

constexpr double stiffness = 0.05, range = 0.1;

std::shared_ptr<const GapLaw> penalty() { return make_gap_law("Penalty", {{"Stiffness", stiffness}, {"Gap", range}}); }

/// Returns all laws without a history that are defined at every gap, by name: with a range below the overlaps of these
/// tests, their own or a cutoff.
std::map<std::string, std::shared_ptr<const GapLaw>> laws_of_all_gaps() {
  std::map<std::string, std::shared_ptr<const GapLaw>> result;
  for (const LawEntry& entry : laws().entries()) {
    const Teuchos::ParameterList list = test::complete(laws(), entry.name);
    const std::shared_ptr<const GapLaw> law = laws().make(SceneNode(list, ""));
    if (law->domain() == GapDomain::All && !law->has_history()) result[entry.name] = law->cut_off(range);
  }
  return result;
}

/// Two blocks of the same width, 2, that overlap by `depth`; the upper face of the lower one is at y = 0.
Mesh equal_blocks(double depth) {
  Mesh mesh;
  BoxShape shape;
  shape.dimension = 2;
  shape.lengths = {2, 1, 0};
  shape.divisions = {4, 2, 1};
  shape.lower = {0, -1, 0};
  test::append(mesh, box(shape), "lower_");
  shape.divisions = {6, 3, 1};
  shape.lower = {0, -depth, 0};
  test::append(mesh, box(shape), "upper_");
  return mesh;
}

/// The sum of the report over all ranks; the least gap of all.
InteractionReport report(const test::PairOfBodies& bodies, const std::vector<double>& u) {
  InteractionReport own;
  bodies.term->reports().report({u.data()}, own);
  bodies.model->space().sum(own.force.data(), static_cast<int>(own.force.size()));
  bodies.model->space().sum(&own.measure, 1);
  own.least_gap = bodies.model->space().minimum(own.least_gap);
  return own;
}

/// Both blocks have the force e (r_c + depth) on the length 2, whichever is the secondary one, and however deep they
/// overlap, until the point is behind the other body.
TEST(PairOverlapTest, APenaltyPushesAtEveryOverlap) {
  for (const double depth : {0.02, 0.09, 0.11, 0.474, 0.95})
    for (const bool swapped : {false, true})
      for (const Passes passes : {Passes::One, Passes::Two}) {
        const std::string first = swapped ? "lower_top" : "upper_bottom",
                          second = swapped ? "upper_bottom" : "lower_top";
        const test::PairOfBodies bodies(equal_blocks(depth), first, second, Smoothing::None, 0, penalty(), passes);
        const std::vector<double> rest = test::at_rest(*bodies.model);
        const InteractionReport found = report(bodies, rest);
        EXPECT_NEAR(found.force[1], (swapped ? -1 : 1) * 2 * stiffness * (range + depth), 1e-13) << depth;
        EXPECT_NEAR(found.force[0], 0, 1e-13);
        EXPECT_NEAR(found.least_gap, -depth, 1e-13);
        EXPECT_NEAR(found.measure, 2, 1e-13);
        EXPECT_NEAR(bodies.energy(rest), 2 * stiffness / 2 * (range + depth) * (range + depth), 1e-13);
        EXPECT_NEAR(
            bodies.model->space().minimum(bodies.term->admissibility().lowest_point(bodies.steps->at(rest.data())).gap),
            -depth, 1e-13);
      }
}

/// A surface with a free rim does not act on bodies behind its own one.
TEST(PairOverlapTest, BehindTheBodyNothingActs) {
  const test::PairOfBodies bodies(equal_blocks(1.3), "upper_bottom", "lower_top", Smoothing::None, 0, penalty());
  const std::vector<double> rest = test::at_rest(*bodies.model);
  EXPECT_EQ(bodies.energy(rest), 0);
  for (const double f : bodies.force({nullptr, nullptr, rest.data()}, end_rule())) EXPECT_EQ(f, 0);
}

/// Where both bodies end, points pass beyond the free end of the other surface one after the other. Their energy does
/// not jump: its slope is less than the traction times the length.
TEST(PairOverlapTest, BesideACommonEdgeTheEnergyIsContinuous) {
  const double depth = 0.4, step = 1e-3, farthest = 0.1;
  const test::PairOfBodies bodies(equal_blocks(depth), "upper_bottom", "lower_top", Smoothing::None, 0, penalty());
  // The lower block has the first 5 by 3 nodes.
  const LocalMesh& mesh = bodies.model->mesh();
  const auto shifted = [&](double by) {
    std::vector<double> u = test::at_rest(*bodies.model);
    for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.nodes()); ++node)
      if (mesh.original_ids[node] >= 5 * 3) u[2 * node] = by;
    return bodies.energy(u);
  };
  const double most = 2 * stiffness * (range + std::hypot(depth, farthest));
  double before = shifted(0);
  for (double by = step; by < farthest; by += step) {
    const double now = shifted(by);
    EXPECT_LE(std::abs(now - before), most * step) << by;
    before = now;
  }
}

/// The forces on the upper body are those before a flat wall at the place of the lower face: of every law, in the
/// plane, around an axis and in space, at depths within the range and beyond.
TEST(PairOverlapTest, EachLawActsAsBeforeAWall) {
  for (const auto& [name, law] : laws_of_all_gaps())
    for (const double gap : {0.05, -0.05, -0.45})
      for (const int kind : {0, 1, 2}) {
        SCOPED_TRACE(name + " " + std::to_string(gap) + " " + std::to_string(kind));
        Mesh mesh = kind == 2 ? test::two_boxes(gap) : test::two_blocks(gap);
        mesh.axisymmetric = kind == 1;
        if (kind == 1)
          for (std::size_t k = 0; k < mesh.coordinates.size(); k += 2) mesh.coordinates[k] += 0.5;
        const test::PairOfBodies bodies(mesh, "upper_bottom", "lower_top", Smoothing::None, 0, law);
        const LocalMesh& own = bodies.model->mesh();
        HalfSpace wall;
        wall.normal = kind == 2 ? std::array<double, 3>{0, 0, 1} : std::array<double, 3>{0, 1, 0};
        const Interactions flat = make_surface_terms(own, own.side_sets[own.side_set("upper_bottom")],
                                                     bodies.model->pattern(), law, flat_wall(wall), {});
        const std::vector<double> rest = test::at_rest(*bodies.model);
        const std::vector<double> f = bodies.force({nullptr, nullptr, rest.data()}, end_rule());
        std::vector<double> g(f.size(), 0.0);
        double energy = 0;
        for (const auto& term : flat) {
          EXPECT_TRUE(term->add_force({nullptr, nullptr, rest.data()}, end_rule(), g.data()));
          energy += term->energy({rest.data()});
        }
        bodies.model->space().sum(&energy, 1);
        EXPECT_NEAR(bodies.energy(rest), energy, 1e-12 * (1 + std::abs(energy)));
        double largest = 0;
        for (const double value : g) largest = std::max(largest, std::abs(value));
        const std::vector<LocalSide>& sides = own.side_sets[own.side_set("upper_bottom")];
        const auto d = static_cast<std::size_t>(own.dimension);
        for (const LocalSide& side : sides)
          for (const int node : side.nodes)
            if (node < own.owned_nodes)
              for (std::size_t i = 0; i < d; ++i) {
                const std::size_t k = d * static_cast<std::size_t>(node) + i;
                EXPECT_NEAR(f[k], g[k], 1e-12 * (1 + largest));
              }
      }
}

/// In front of a closed surface, too; its smooth sides distribute the same forces over more nodes.
TEST(PairOverlapTest, AClosedSurfaceActsToo) {
  for (const Smoothing smoothing : {Smoothing::None, Smoothing::CatmullRom, Smoothing::Spline}) {
    const auto law = make_gap_law("Penalty", {{"Stiffness", stiffness}, {"Gap", 0.02}});
    const test::PairOfBodies bodies(test::two_blocks(-0.06), "upper_bottom", "lower_surface", smoothing, 0, law);
    const InteractionReport found = report(bodies, test::at_rest(*bodies.model));
    EXPECT_NEAR(found.force[1], 2 * stiffness * (0.02 + 0.06), 1e-12);
    EXPECT_NEAR(found.least_gap, -0.06, 1e-12);
  }
}

/// Deep in each other, forces are the derivatives of the energy, and balance each other; the matrix has all blocks.
TEST(PairOverlapTest, DeepForcesAreDerivatives) {
  const auto law = make_gap_law("Penalty", {{"Stiffness", 1.0}, {"Gap", 0.15}});
  for (const Smoothing smoothing : {Smoothing::None, Smoothing::CatmullRom}) {
    const test::PairOfBodies disks(test::two_disks(3, {4, 2.6}), "a_surface", "b_surface", smoothing, 0, law),
        blocks(test::two_blocks(-0.4), "upper_bottom", "lower_top", smoothing, 0, law),
        boxes(test::two_boxes(-0.4), "upper_bottom", "lower_top", smoothing, 0, law);
    for (const test::PairOfBodies* bodies : {&disks, &blocks, &boxes}) {
      test::expect_no_net_force(*bodies, 1e-13, 1e-12, 0.01);
      const std::vector<double> u = test::smooth_field(*bodies->model, 0.01), way = test::noise(*bodies->model, 1);
      const double h = 1e-6;
      const std::vector<double> f = bodies->force({nullptr, nullptr, u.data()}, end_rule());
      double work = 0;
      for (std::size_t k = 0; k < static_cast<std::size_t>(bodies->model->space().owned()); ++k) work += f[k] * way[k];
      bodies->model->space().sum(&work, 1);
      const double slope = (bodies->energy(test::moved(u, h, way)) - bodies->energy(test::moved(u, -h, way))) / (2 * h);
      EXPECT_NEAR(slope, work, 1e-6 * (1 + std::abs(work)));
      const Segment segment{nullptr, nullptr, u.data()};
      const auto matrix = bodies->matrix_times(segment, end_rule(), way),
                 all = bodies->product(segment, end_rule(), way);
      double largest = 0;
      for (const double value : all) largest = std::max(largest, std::abs(value));
      largest = bodies->model->space().maximum(largest);
      EXPECT_GT(largest, 0.01);
      for (std::size_t k = 0; k < all.size(); ++k) EXPECT_NEAR(matrix[k], all[k], 1e-12 * largest);
    }
  }
}

/// The discrete gradient does the work of the energy from outside the range into deep overlaps and back.
TEST(PairOverlapTest, TheDiscreteGradientDoesTheWorkOfTheEnergy) {
  const test::PairOfBodies bodies(equal_blocks(-0.05), "upper_bottom", "lower_top", Smoothing::None, 0, penalty());
  const LocalMesh& mesh = bodies.model->mesh();
  const auto lowered = [&](double by) {
    std::vector<double> u = test::at_rest(*bodies.model);
    for (std::size_t k = 1; k < u.size(); k += 2)
      if (mesh.coordinates[k] > 0.04) u[k] = -by;
    return u;
  };
  for (const auto& [start, end] : {std::pair{-0.1, 0.3}, std::pair{0.3, 0.5}, std::pair{0.5, -0.1}}) {
    const std::vector<double> from = lowered(start), to = lowered(end);
    const std::vector<double> f = bodies.force({from.data(), nullptr, to.data()}, discrete_gradient_rule());
    double work = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(bodies.model->space().owned()); ++k)
      work += f[k] * (to[k] - from[k]);
    bodies.model->space().sum(&work, 1);
    EXPECT_NEAR(work, bodies.energy(to) - bodies.energy(from), 1e-13);
    EXPECT_GT(std::abs(work), 1e-3);
  }
}

/// Every point that a search finds is the one that a search among all patches finds, as deep as the bodies go into each
/// other, also with neighbours of a search at other places.
template <std::size_t D>
void expect_all_projections(const Mesh& bodies, const Vec<D>& way) {
  const LocalMesh mesh = localize(bodies, partition_nodes(bodies, 1), 0, 1, {"a_surface", "b_surface"});
  const auto surface = [&](const std::string& set) {
    return surface_patches<D>(mesh, mesh.whole_side_sets.at(set), Smoothing::CatmullRom, set);
  };
  PairOptions options;
  options.depth = HUGE_VAL;
  const PairPoints<D> points(mesh, {surface("a_surface"), surface("b_surface")}, penalty(), options);
  std::size_t deep = 0;
  for (const double share : {0.0, 0.2, 0.21, 0.215, 0.3, 0.5, 0.7, 1.0, 0.98, 0.2, 0.0}) {
    std::vector<PairPlaces<D>> places{points.places(std::vector<double>(mesh.coordinates.size(), 0.0).data())};
    for (Vec<D>& x : places.front().secondary) x = x + share * way;
    const auto found = points.contacts(places, PairPoints<D>::Share::All);
    const PlacedSurface<D> primary(points.primary().patches, places.front().primary),
        secondary(points.secondary().patches, places.front().secondary);
    for (std::size_t s = 0; s < points.secondary().patches.size(); ++s)
      for (std::size_t q = 0; q < points.points_of_a_patch(); ++q) {
        const PairContact<D> own{s, q, 0};
        Vec<D> place{};
        const SurfacePatch<D>& patch = points.secondary().patches[s];
        for (std::size_t a = 0; a < patch.count; ++a)
          place = place + points.weights(own)[a] * places.front().secondary[static_cast<std::size_t>(patch.nodes[a])];
        const SurfaceProjection<D> expected = primary.nearest(place);
        const PairContact<D>* const contact = found->front().find(s, q);
        if (expected.gap < range - 1e-12) {
          ASSERT_TRUE(contact != nullptr && contact->projection.patch >= 0) << share << " " << expected.gap;
          EXPECT_NEAR(contact->projection.gap, expected.gap, 1e-12);
          deep += expected.gap < -2 * range ? 1 : 0;
        } else if (expected.gap > range + 1e-12 && contact != nullptr) {
          EXPECT_LT(contact->projection.patch, 0);
        }
      }
  }
  EXPECT_GT(deep, 20U);
}

TEST(PairOverlapSerialTest, SearchesFindTheProjectionsOfDeepPoints) {
  expect_all_projections<2>(test::two_disks(3, {6.2, 1}, 8, 2), {3, 0.4});
  expect_all_projections<3>(test::two_balls(2, {2.4, 2, 2.9}), {1, 1, 1});
}

}  // namespace
}  // namespace ixos
