// The patches that the matrix of a pair couples.
#include "term/pair/pair_coupling.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/snapshot.hpp"
#include "interaction/catalogue.hpp"
#include "interaction/van_der_waals.hpp"
#include "support/two_bodies.hpp"

namespace ixos {
namespace {

/// Two disks of radius 3 whose centres are `distance` apart.
struct Disks {
  LocalMesh mesh;
  std::unique_ptr<PairPoints<2>> points;

  explicit Disks(double distance, const std::shared_ptr<const GapLaw>& law = gap_law(VanDerWaals(2.5, 25)))
      : mesh(whole(test::two_disks(3, {distance, 0}, 8, 2))) {
    const auto surface = [&](const char* set) {
      return surface_patches<2>(mesh, mesh.whole_side_sets.at(set), Smoothing::CatmullRom, set);
    };
    points = std::make_unique<PairPoints<2>>(mesh, PairSurfaces<2>{surface("a_surface"), surface("b_surface")}, law,
                                             PairOptions{});
  }
  static LocalMesh whole(const Mesh& mesh) {
    return localize(mesh, partition_nodes(mesh, 1), 0, 1, {"a_surface", "b_surface"});
  }
  /// The surfaces after the second disk has moved.
  PairPoints<2>::Places moved(double x, double y, bool both = false) const {
    std::vector<double> u(mesh.coordinates.size(), 0.0);
    for (std::size_t k = 0; k < u.size(); k += 2)
      if (both || mesh.coordinates[k] > 3.01) {
        u[k] = x;
        u[k + 1] = y;
      }
    return points->places(u.data());
  }
};

TEST(PairCouplingSerialTest, TheReachIsThatOfTheStiffness) {
  const auto law = gap_law(VanDerWaals(2.5, 25));
  const double reach = reach_of_stiffness(*law);
  // d2psi/dr2 is 6 c2/r^4 at the equilibrium gap, -3 c2/r^4 far away.
  EXPECT_NEAR(reach, law->equilibrium_gap() * std::pow(0.5e3, 0.25), 0.06 * reach);
  EXPECT_LE(reach_of_stiffness(*law->cut_off(0.3)), 0.3);
}

TEST(PairCouplingSerialTest, CouplesWhatIsNearAndSearchesWhenItIsDue) {
  const Disks disks(12);
  PairCoupling<2> coupling(*disks.points);
  EXPECT_FALSE(coupling.update(disks.moved(0, 0)));  // nothing is near
  EXPECT_EQ(coupling.searches(), 1);
  EXPECT_FALSE(coupling.update(disks.moved(-0.01, 0)));
  EXPECT_FALSE(coupling.update(disks.moved(100, 50, true))) << "a common motion";
  EXPECT_EQ(coupling.searches(), 1);
  EXPECT_TRUE(coupling.update(disks.moved(-5.7, 0)));
  EXPECT_EQ(coupling.searches(), 2);
  const std::vector<std::vector<int>> stencils = coupling.stencils();
  ASSERT_FALSE(stencils.empty());
  for (const std::vector<int>& stencil : stencils) {
    EXPECT_EQ(stencil.size(), 8U);  // four nodes of each curve
    double nearest = HUGE_VAL;
    for (const int a : stencil)
      for (const int b : stencil) {
        const Vec<2> xa = reference_place<2>(disks.mesh, a), xb = reference_place<2>(disks.mesh, b);
        if (xa[0] < 3.01 && xb[0] > 3.01) nearest = std::min(nearest, length(xb - Vec<2>{5.7, 0} - xa));
      }
    EXPECT_LT(nearest, 3 * coupling.reach() + 2);
  }
  EXPECT_LT(stencils.size(), 32U * 32U);
  EXPECT_FALSE(coupling.update(disks.moved(-5.7, 0.1))) << "within the skin";
  EXPECT_EQ(coupling.searches(), 2);
  EXPECT_TRUE(coupling.update(disks.moved(-5.7, 5))) << "other patches face each other";
}

TEST(PairCouplingSerialTest, CoversTheBlocksOfItsPairs) {
  const Disks disks(6.3);
  PairCoupling<2> coupling(*disks.points);
  ASSERT_TRUE(coupling.update(disks.moved(0, 0)));
  const std::vector<std::vector<int>> stencils = coupling.stencils();
  const auto& secondary = disks.points->secondary().patches;
  const auto& primary = disks.points->primary().patches;
  std::size_t covered = 0, last = primary.size();
  for (std::size_t s = 0; s < secondary.size(); ++s)
    for (std::size_t p = 0; p < primary.size(); ++p) {
      PairBlock block;
      block.secondary = s;
      block.primary = static_cast<int>(p);
      const auto own = disks.points->nodes_of(s, block.primary);
      const std::vector<int> nodes(own.begin(), own.end());
      const bool coupled = std::find(stencils.begin(), stencils.end(), nodes) != stencils.end();
      EXPECT_EQ(coupling.covers(block), coupled);
      covered += coupled ? 1 : 0;
      if (coupled && last < primary.size()) {  // with those of a primary patch before
        block.next = static_cast<int>(last);
        EXPECT_FALSE(coupling.covers(block)) << "not joined";
      }
      last = coupled ? p : primary.size();
    }
  EXPECT_GT(covered, 4U);
  EXPECT_LT(covered, secondary.size() * primary.size() / 2);
  coupling.join();
  ASSERT_TRUE(coupling.update(disks.moved(0, 0)));
  PairBlock block{0, 0, {}, {}};
  while (!coupling.covers(block)) ++block.secondary;
  for (block.next = 0; block.next < static_cast<int>(primary.size()); ++block.next)
    EXPECT_EQ(coupling.covers(block), coupling.covers({block.secondary, block.next, {}, {}}));
}

TEST(PairCouplingSerialTest, WhatItKeepsComesBack) {
  const Disks disks(12);
  PairCoupling<2> coupling(*disks.points), other(*disks.points);
  coupling.update(disks.moved(-5.7, 0));
  PairCoupling<2>* own = &coupling;
  Snapshot snapshot([&](Record& record) { own->transfer(record); });
  snapshot.save();
  own = &other;
  snapshot.restore();
  EXPECT_TRUE(other.update(disks.moved(-5.7, 0))) << "the matrices do not couple the loaded pairs yet";
  EXPECT_EQ(other.stencils(), coupling.stencils());
  EXPECT_FALSE(other.update(disks.moved(-5.7, 0)));
  coupling.begin_anew();
  EXPECT_FALSE(coupling.update(disks.moved(-5.7, 0))) << "the same pairs";
  EXPECT_EQ(coupling.searches(), 2);
}

// A search may be due in the record's state, before the next step. The matrices of the record belong to its pairs.
TEST(PairCouplingSerialTest, TheFirstUpdateAfterARecordDoesNotSearch) {
  const Disks disks(12);
  PairCoupling<2> coupling(*disks.points);
  coupling.update(disks.moved(0, 0));
  Snapshot snapshot([&](Record& record) { coupling.transfer(record); });
  snapshot.save();
  snapshot.restore();
  EXPECT_FALSE(coupling.update(disks.moved(-5.7, 0)));
  EXPECT_EQ(coupling.searches(), 1);
  EXPECT_TRUE(coupling.update(disks.moved(-5.7, 0)));
  EXPECT_EQ(coupling.searches(), 2);
}

}  // namespace
}  // namespace ixos
