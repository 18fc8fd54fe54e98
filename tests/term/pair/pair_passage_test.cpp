// Bodies that pass through each other within one step.
#include "term/pair/pair_passage.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "interaction/catalogue.hpp"
#include "model/term_sums.hpp"
#include "support/pair_of_bodies.hpp"

namespace ixos {
namespace {

std::shared_ptr<const GapLaw> penalty() { return make_gap_law("Penalty", {{"Stiffness", 1.0}, {"Gap", 0.1}}); }

/// A plate ("lower_...") from x = -1 to 3 (and z) whose upper face is at y = 0, and half a length above it a block of
/// side 1 ("upper_..."). In space, the last coordinate is the height.
Mesh plate_and_block(int dimension, double thickness) {
  Mesh mesh;
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = dimension == 2 ? std::array<double, 3>{4, thickness, 0} : std::array<double, 3>{4, 4, thickness};
  shape.divisions = dimension == 2 ? std::array<int, 3>{4, 1, 1} : std::array<int, 3>{4, 4, 1};
  shape.lower = dimension == 2 ? std::array<double, 3>{-1, -thickness, 0} : std::array<double, 3>{-1, -1, -thickness};
  test::append(mesh, box(shape), "lower_");
  shape.lengths = {1, 1, 1};
  shape.divisions = {3, 3, dimension == 2 ? 1 : 3};
  shape.lower = dimension == 2 ? std::array<double, 3>{0.3, 0.5, 0} : std::array<double, 3>{0.3, 0.4, 0.5};
  test::append(mesh, box(shape), "upper_");
  return mesh;
}

/// Returns a displacement: the block and the plate move along the height, and aside.
std::vector<double> moved(const Model& model, double block, double plate, double aside = 0) {
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  std::vector<double> u = test::at_rest(model);
  for (std::size_t k = 0; k < u.size(); k += d) {
    u[k] = aside;
    u[k + d - 1] = model.mesh().coordinates[k + d - 1] > 0.25 ? block : plate;
  }
  return u;
}

/// Whether a point passes when the bodies move from one of these states to another. Equal on all ranks.
bool passes(const test::PairOfBodies& bodies, const std::vector<double>& from, const std::vector<double>& to) {
  return bodies.model->space().minimum(bodies.term->admissibility().passage({from.data(), nullptr, to.data()}).gap) < 0;
}

/// A block passes a thin plate if it jumps over it, from above or from below, whichever is the primary surface, and
/// whether it is open or closed. It does not if it moves away, moves along with the plate or ends in its upper half.
TEST(PairPassageTest, ABlockPassesAThinPlate) {
  for (const int dimension : {2, 3})
    for (const double thickness : {0.01, 0.1})
      for (const char* face : {"lower_surface", "lower_top"})
        for (const bool swapped : {false, true}) {
          const std::string body = "upper_surface";
          const test::PairOfBodies bodies(plate_and_block(dimension, thickness), swapped ? face : body,
                                          swapped ? body : face, Smoothing::None, 0, penalty());
          const auto state = [&](double block, double own, double aside = 0) {
            return moved(*bodies.model, block, own, aside);
          };
          SCOPED_TRACE(std::to_string(dimension) + " " + std::to_string(thickness) + " " + face);
          EXPECT_TRUE(passes(bodies, state(0, 0), state(-3, 0)));
          EXPECT_TRUE(passes(bodies, state(0, 0), state(-3, 0, 0.2)));
          EXPECT_TRUE(passes(bodies, state(0, 0), state(-30, -10))) << "both move";
          EXPECT_FALSE(passes(bodies, state(0, 0), state(-0.45, 0))) << "ends above";
          EXPECT_FALSE(passes(bodies, state(0, 0), state(-0.5 - 0.3 * thickness, 0))) << "ends in the plate";
          EXPECT_FALSE(passes(bodies, state(0, 0), state(30, 0)));
          EXPECT_FALSE(passes(bodies, state(0, 0), state(-3, -3, 7))) << "along with the plate";
          EXPECT_FALSE(passes(bodies, state(0, 0), state(-0.6, -0.2, 1))) << "a little faster";
        }
}

/// Beyond the middle of a closed plate, the law pushes a point out behind it.
TEST(PairPassageTest, AnEndBeyondTheMiddleHasPassed) {
  const test::PairOfBodies bodies(plate_and_block(2, 0.4), "upper_bottom", "lower_surface", Smoothing::None, 0,
                                  penalty());
  const auto state = [&](double block) { return moved(*bodies.model, block, 0); };
  EXPECT_TRUE(passes(bodies, state(0), state(-0.5 - 0.3)));
  EXPECT_FALSE(passes(bodies, state(0), state(-0.5 - 0.1)));
  EXPECT_FALSE(passes(bodies, state(-0.5 - 0.1), state(0))) << "pushed out";
  EXPECT_FALSE(passes(bodies, state(-0.5 - 0.1), state(-0.5 - 0.15)));
}

/// Two parts of one surface, here two bodies, which exclude themselves.
struct OneSurface {
  std::unique_ptr<Model> model;
  Interaction* term;

  explicit OneSurface(Mesh mesh) {
    SideSet both{"both", {}};
    for (const SideSet& set : mesh.side_sets)
      if (set.name == "lower_surface" || set.name == "upper_surface")
        both.sides.insert(both.sides.end(), set.sides.begin(), set.sides.end());
    mesh.side_sets.push_back(both);
    model = test::model_of_bodies(mesh, {"both"});
    SurfacePair pair;
    pair.side_set = pair.primary = "both";
    pair.law = penalty();
    pair.smoothing = Smoothing::None;
    pair.exclusion = 20;
    add_pair(*model, pair);
    term = model->interactions().back().term;
  }
  double gap(double block) const {
    const std::vector<double> from = test::at_rest(*model), to = moved(*model, block, 0);
    const test::ByHand<Interaction> steps(*term, *model);
    return model->space().minimum(term->admissibility().passage(steps.segment(from.data(), nullptr, to.data())).gap);
  }
};

TEST(PairPassageTest, PartsOfOneSurfacePassEachOther) {
  const OneSurface surface(plate_and_block(2, 0.1));
  EXPECT_LT(surface.gap(-3), 0);
  EXPECT_FALSE(surface.gap(-0.45) < 0);
  EXPECT_LT(surface.gap(-0.53), 0) << "parts that do not see each other at the start have no force";
  EXPECT_FALSE(surface.gap(3) < 0);
}

/// Parts that overlap since they saw each other go on pushing, in later steps, too. Half of the law on the block's
/// lower face, of length 1, gives e (r_c + depth)/2; points of the plate and of the block's sides add to that.
TEST(PairPassageTest, PartsOfOneSurfaceThatOverlapPushEachOther) {
  const OneSurface surface(plate_and_block(2, 2));
  Model& model = *surface.model;
  std::vector<double> u = moved(model, -0.45, 0);
  test::ByHand<const Model> steps(model);
  steps.initialize(u.data());
  for (const double depth : {0.05, 0.2, 0.3}) {
    steps.begin_step(u.data(), 0, 1);
    const std::vector<double> before = u;
    u = moved(model, -0.5 - depth, 0);
    std::vector<double> f(u.size(), 0.0);
    TermSums(model).force(Part::Interaction, steps.segment(nullptr, nullptr, u.data()), end_rule(), f.data());
    double upwards = 0;
    for (std::size_t k = 1; k < static_cast<std::size_t>(model.space().owned()); k += 2)
      if (model.mesh().coordinates[k] > 0.25) upwards -= f[k];
    model.space().sum(&upwards, 1);
    EXPECT_GE(upwards, 0.5 * (0.1 + depth) - 1e-12) << depth;
    steps.accept({{{before.data()}, {u.data()}}, nullptr, 1});
  }
}

}  // namespace
}  // namespace ixos
