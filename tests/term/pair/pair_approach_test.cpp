// How far two surfaces may approach each other.
#include "term/pair/pair_approach.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/comparison.hpp"
#include "support/pair_of_bodies.hpp"

namespace ixos {
namespace {

/// The gap that the search for the lowest point found bounds the motion after which it must search again.
TEST(PairApproachTest, GapsAreKnownToBePositiveUntilTheBodiesMove) {
  const test::PairOfBodies bodies(test::two_disks(3, {5, 3.6}), "a_surface", "b_surface", Smoothing::CatmullRom);
  const std::vector<double> rest = test::at_rest(*bodies.model);
  std::vector<double> near = rest, far = rest;
  for (std::size_t k = 0; k < rest.size(); k += 2) {
    const double side = bodies.model->mesh().coordinates[k] > 2.5 ? -1 : 1;
    near[k] += 0.02 * side;
    far[k] += 0.5 * side;
  }
  bodies.steps->initialize(rest.data());
  EXPECT_FALSE(bodies.term->admissibility().is_clear(bodies.steps->at(far.data()))) << "farther than anything seen";
  const double gap = bodies.term->admissibility().lowest_point(bodies.steps->at(rest.data())).gap;
  EXPECT_GT(gap, 0.1);
  EXPECT_LT(gap, 0.5);
  EXPECT_TRUE(bodies.term->admissibility().is_clear(bodies.steps->at(rest.data())));
  EXPECT_TRUE(bodies.term->admissibility().is_clear(bodies.steps->at(near.data())));
  EXPECT_FALSE(bodies.term->admissibility().is_clear(bodies.steps->at(far.data())));
  far[0] = std::nan("");
  EXPECT_FALSE(bodies.term->admissibility().is_clear(bodies.steps->at(far.data())));
  const test::PairOfBodies open(test::two_blocks(0.3), "upper_bottom", "lower_top", Smoothing::None);
  const std::vector<double> still = test::at_rest(*open.model);
  open.term->admissibility().lowest_point(open.steps->at(still.data()));
  EXPECT_FALSE(open.term->admissibility().is_clear(open.steps->at(still.data()))) << "a free rim";
}

}  // namespace
}  // namespace ixos
