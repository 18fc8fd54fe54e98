#include "term/wall/point_laws.hpp"

#include <gtest/gtest.h>

#include "interaction/damage_law.hpp"
#include "interaction/van_der_waals.hpp"
#include "state/history.hpp"
#include "term/box_part.hpp"
#include "term/wall/surface_terms.hpp"

namespace ixos {
namespace {

const DamageLaw law(0.5, 0.05, 0.8);

TEST(PointLawsTest, ALawWithoutAHistoryKeepsNothing) {
  const LocalMesh mesh = test::box_part(2, ContactElement::Q1C1);
  const auto whole = gap_law(VanDerWaals(2.5, 25));
  const PointLaws laws(mesh, mesh.side_sets[mesh.side_set("bottom")], std::vector<std::array<double, 3>>(3), whole);
  EXPECT_FALSE(laws.has_history());
  EXPECT_TRUE(laws.history().points.empty());
  const PointLaws::Kept kept = laws.in(nullptr, 0);
  EXPECT_EQ(kept.at(0, 2).history, nullptr);
  EXPECT_EQ(kept.of(7).law, whole.get());
}

TEST(PointLawsTest, EachPointHasAHistory) {
  const LocalMesh mesh = test::box_part(2, ContactElement::Q1C1);
  const std::vector<LocalSide>& sides = mesh.side_sets[mesh.side_set("bottom")];
  if (sides.empty()) return;  // on this rank
  const PointLaws laws(mesh, sides, std::vector<std::array<double, 3>>(2), gap_law(law));
  TermHistories histories({laws.history()});
  PointData& kept = histories.of(0).points.front().values;
  EXPECT_EQ(double(laws.in(&histories, 0).at(0, 0).traction(0.05)[0]),
            double(law.at(law.first(0.0)).traction(0.05)[0]));
  laws.begin(kept(0, 1), 0.2);
  EXPECT_NEAR(laws.accept(kept(0, 1), 0.3)[0], law.dissipated(0.2, 0.3)[0], 1e-17);
  EXPECT_EQ(laws.accept(kept(0, 1), 0.25)[0], 0);
  EXPECT_EQ(double(laws.in(&histories, 0).at(0, 1).traction(0.05)[0]), double(law.at(0.3).traction(0.05)[0]));
  EXPECT_EQ(double(laws.in(&histories, 0).at(0, 1).traction(0.05)[0]), double(law.at(0.3).traction(0.05)[0]));
  EXPECT_EQ(double(laws.in(&histories, 0).at(0, 0).traction(0.05)[0]),
            double(law.at(law.first(0.0)).traction(0.05)[0]));
  EXPECT_THROW(laws.in(nullptr, 0), std::logic_error);
}

// A set may hold enriched sides beside plain ones, and a rank sides of one kind or of none.
TEST(PointLawsTest, AllRanksMakeTheSameTerms) {
  const LocalMesh mesh = test::box_part(2, ContactElement::Q1C2);
  const Pattern pattern(mesh);
  SurfaceOptions options;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) options.kinds.push_back({static_cast<int>(b), 0});
  ASSERT_EQ(options.kinds.size(), 2U);
  const auto terms = make_surface_terms(mesh, {}, pattern, gap_law(law), flat_wall({}), options);
  EXPECT_EQ(terms.size(), 2U);
  for (const auto& term : terms) EXPECT_TRUE(term->has_history() && term->has_state() && term->dissipates());
  EXPECT_FALSE(make_surface_terms(mesh, {}, pattern, gap_law(VanDerWaals(2.5, 25)), flat_wall({}), options)
                   .front()
                   ->has_state());
}

}  // namespace
}  // namespace ixos
