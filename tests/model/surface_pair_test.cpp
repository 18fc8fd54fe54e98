// Pairs of surfaces that are added to models, and those that are refused.
#include "model/surface_pair.hpp"

#include <gtest/gtest.h>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/van_der_waals.hpp"
#include "support/reports.hpp"
#include "support/two_bodies.hpp"

namespace ixos {
namespace {

SurfacePair pair_of(const std::string& secondary, const std::string& primary) {
  SurfacePair pair;
  pair.side_set = secondary;
  pair.primary = primary;
  pair.law = gap_law(VanDerWaals(2.5, 25));
  return pair;
}

const std::vector<std::string> faces{"upper_bottom", "lower_top"};

/// Expects an InputError whose message has the text.
void expect_refusal(const Mesh& mesh, const SurfacePair& pair, const std::string& text,
                    const std::vector<std::string>& whole = faces) {
  const auto model = test::model_of_bodies(mesh, whole);
  try {
    add_pair(*model, pair);
    ADD_FAILURE() << "not refused: " << text;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
}

TEST(SurfacePairTest, RefusesWhatPairsDoNotHave) {
  const Mesh mesh = test::two_blocks(0.3);
  const SurfacePair good = pair_of("upper_bottom", "lower_top");
  expect_refusal(mesh, pair_of("upper_bottum", "lower_top"), "upper_bottom");
  expect_refusal(mesh, pair_of("upper_bottom", "upper_bottom"), "Exclusion 0 is too short for a surface with itself");
  SurfacePair self = pair_of("upper_bottom", "upper_bottom");
  self.exclusion = 3;
  expect_refusal(mesh, self, "Cutoff 0 is none, and a surface with itself needs one");
  self.primary = "lower_top";
  expect_refusal(mesh, self, "Exclusion 3 is for a surface that interacts with itself");
  expect_refusal(mesh, pair_of("upper_bottom", "upper_left"), "common nodes", {"upper_bottom", "upper_left"});
  SurfacePair bad = good;
  bad.law = nullptr;
  expect_refusal(mesh, bad, "Law is missing");
  bad = good;
  bad.law = make_gap_law("Bilinear Damage");
  expect_refusal(mesh, bad, "Law has a history");
  bad = good;
  bad.points = 65;
  expect_refusal(mesh, bad, "Surface Points 65");
  bad = good;
  bad.margin = 1;
  expect_refusal(mesh, bad, "Step Margin 1");
  bad = good;
  bad.cutoff = 0.1;
  expect_refusal(mesh, bad, "Cutoff 0.1");
  bad = good;
  bad.factor = [](const std::array<double, 3>& x) { return 1 - x[0]; };
  expect_refusal(mesh, bad, "has the factor -");
  if (test::world()->getSize() > 1) expect_refusal(mesh, good, "each needs all sides", {});
}

TEST(SurfacePairTest, TellsWhereBodiesOverlapAndHowDeep) {
  expect_refusal(test::two_blocks(-0.02), pair_of("upper_bottom", "lower_top"), "least gap -0.02 at");
  expect_refusal(test::two_disks(3, {5.5, 0}), pair_of("a_surface", "b_surface"), "overlap or touch, least gap -0.5",
                 {"a_surface", "b_surface"});
  expect_refusal(test::two_balls(2, {0, 0, 3.9}), pair_of("a_surface", "b_surface"), "overlap or touch",
                 {"a_surface", "b_surface"});
  // A law of every gap has forces there.
  SurfacePair pair = pair_of("upper_bottom", "lower_top");
  pair.law = make_gap_law("Penalty");
  const auto model = test::model_of_bodies(test::two_blocks(-0.02), faces);
  add_pair(*model, pair);
  EXPECT_GT(test::ReportAt(*model, test::at_rest(*model).data()).energy(Part::Interaction), 0);
}

TEST(SurfacePairTest, TheNodesOfBothSurfacesAreCoupled) {
  const auto model = test::model_of_bodies(test::two_blocks(0.3), faces);
  const int before = model->pattern().pairs();
  add_pair(*model, pair_of("upper_bottom", "lower_top"));
  EXPECT_GE(model->pattern().pairs(), before);
  EXPECT_EQ(model->discretization().version(), 1);
  EXPECT_EQ(model->interaction_names(), std::vector<std::string>{"interaction"});
}

/// Far from each other nothing is coupled; a motion that brings the bodies near couples what faces each other.
TEST(SurfacePairTest, BodiesThatComeNearAreCoupled) {
  const auto model = test::model_of_bodies(test::two_boxes(20), faces);
  add_pair(*model, pair_of("upper_bottom", "lower_top"));
  EXPECT_TRUE(model->couples_anew());
  EXPECT_EQ(model->discretization().version(), 0);
  const int apart = model->pattern().pairs();
  std::vector<double> u = test::at_rest(*model);
  for (std::size_t node = 0; node < static_cast<std::size_t>(model->mesh().nodes()); ++node)
    if (model->mesh().coordinates[3 * node + 2] > 10) u[3 * node + 2] = -19.5;
  model->update_couplings(u.data());
  EXPECT_EQ(model->discretization().version(), 1);
  double more = model->pattern().pairs() - apart;
  model->space().sum(&more, 1);
  EXPECT_GT(more, 0);
  model->update_couplings(u.data());
  EXPECT_EQ(model->discretization().version(), 1);
}

/// A factor scales energy and traction at its place.
TEST(SurfacePairTest, AFactorScalesTheLaw) {
  const Mesh mesh = test::two_blocks(0.3);
  SurfacePair pair = pair_of("upper_bottom", "lower_top");
  pair.factor = [](const std::array<double, 3>& x) { return x[0]; };
  const auto plain = test::model_of_bodies(mesh, faces), scaled = test::model_of_bodies(mesh, faces);
  add_pair(*plain, pair_of("upper_bottom", "lower_top"));
  add_pair(*scaled, pair);
  const std::vector<double> u = test::at_rest(*plain);
  const test::ReportAt of_plain(*plain, u.data()), of_scaled(*scaled, u.data());
  // The mean of x over the side is 1.
  EXPECT_NEAR(of_scaled.energy(Part::Interaction), of_plain.energy(Part::Interaction), 1e-14);
  EXPECT_NEAR(of_scaled.interaction_report().measure, 2, 1e-14);
}

}  // namespace
}  // namespace ixos
