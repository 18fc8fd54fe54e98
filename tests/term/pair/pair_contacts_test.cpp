// Closest points that a search begins at earlier ones.
#include "term/pair/pair_contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "interaction/van_der_waals.hpp"
#include "mesh/facing_nodes.hpp"
#include "mesh/partition.hpp"
#include "support/two_bodies.hpp"
#include "term/pair/pair_points.hpp"

namespace ixos {
namespace {

/// The points of one body's surface before the other's, which turns, sways and comes nearer.
template <std::size_t D>
struct Points {
  LocalMesh mesh;
  std::shared_ptr<const GapLaw> law;
  std::unique_ptr<PairPoints<D>> points;

  Points(const Mesh& bodies, const std::string& first, const std::string& second, double cutoff)
      : mesh(localize(bodies, partition_nodes(bodies, 1), 0, 1, {first, second})), law(gap_law(VanDerWaals(2.5, 25))) {
    if (cutoff > 0) law = law->cut_off(cutoff);
    const auto surface = [&](const std::string& set) {
      return surface_patches<D>(mesh, mesh.whole_side_sets.at(set), Smoothing::CatmullRom, set);
    };
    points =
        std::make_unique<PairPoints<D>>(mesh, PairSurfaces<D>{surface(first), surface(second)}, law, PairOptions{});
  }
  PairPlaces<D> places(double t) const {
    std::vector<double> u(mesh.coordinates.size());
    for (std::size_t k = 0; k < u.size(); k += D) {
      u[k] = t * (0.3 * mesh.coordinates[k + 1] + 0.02 * std::sin(3 * mesh.coordinates[k + D - 1]));
      u[k + 1] = -t * 0.1 * mesh.coordinates[k] * std::abs(mesh.coordinates[k]);
    }
    return points->places(u.data());
  }
  std::shared_ptr<const PairTimes<D>> at(const std::vector<double>& times) const {
    std::vector<PairPlaces<D>> all;
    all.reserve(times.size());
    for (const double t : times) all.push_back(places(t));
    return points->contacts(all, PairPoints<D>::Share::Forces);
  }
};

/// Each place's closest points, found after others, are those of a first search at this place alone.
template <std::size_t D>
void expect_same_projections(const Mesh& bodies, const std::string& first, const std::string& second, double cutoff) {
  Points<D> together(bodies, first, second, cutoff);
  together.points->begin_step();
  int projections = 0, clearances = 0;
  for (const double start : {0.0, 0.01, 0.011, 0.2, 0.19}) {  // as Newton's iteration may come back
    std::vector<double> times;
    times.reserve(5);
    for (int k = 0; k < 5; ++k) times.push_back(start + 0.001 * k * (k + 1));
    const auto found = together.at(times);
    for (std::size_t k = 0; k < times.size(); ++k) {
      const Points<D> alone(bodies, first, second, cutoff);
      const auto single = alone.at({times[k]});
      for (const PairContact<D>& contact : single->front().all) {
        const PairContact<D>* const same = (*found)[k].find(contact.patch, contact.point);
        ASSERT_TRUE(same != nullptr || contact.projection.patch < 0);
        if (same == nullptr) continue;
        ASSERT_EQ(same->projection.patch < 0, contact.projection.patch < 0);
        clearances += same->projection.clearance > 0 ? 1 : 0;
        if (contact.projection.patch < 0) continue;
        ++projections;
        EXPECT_NEAR(same->projection.gap, contact.projection.gap, 1e-13);
        EXPECT_LT(length(same->projection.normal - contact.projection.normal), 1e-11);
        EXPECT_NEAR(same->traction, contact.traction, 1e-11 * (1 + std::abs(contact.traction)));
      }
    }
  }
  EXPECT_GT(projections, 400);
  EXPECT_GT(clearances, projections / 10);
}

TEST(PairContactsSerialTest, ProjectionsDoNotDependOnEarlierOnes) {
  for (const double cutoff : {0.0, 1.5}) {
    expect_same_projections<2>(test::two_disks(3, {5, 3.6}), "a_surface", "b_surface", cutoff);
    expect_same_projections<2>(test::two_blocks(0.3), "upper_bottom", "lower_top", cutoff);
    expect_same_projections<3>(test::two_balls(2, {2.4, 2, 2.9}), "a_surface", "b_surface", cutoff);
    expect_same_projections<3>(test::two_boxes(0.3), "upper_bottom", "lower_top", cutoff);
  }
}

/// As bodies approach little by little, lists of neighbours are used up and replaced. No point in range lacks its
/// closest point.
TEST(PairContactsSerialTest, NoClosestPointIsLostAsListsAreReplaced) {
  const Mesh bodies = test::two_disks(3, {7.6, 0}, 16, 2);
  Points<2> together(bodies, "a_surface", "b_surface", 1.0);
  together.points->begin_step();
  const auto places = [](const Points<2>& of, double t) {
    std::vector<double> u(of.mesh.coordinates.size(), 0.0);
    for (std::size_t k = 0; k < u.size(); k += 2) u[k] = of.mesh.coordinates[k] > 3.8 ? -t : 0;
    return of.points->places(u.data());
  };
  int projections = 0;
  for (int i = 0; i < 300; ++i) {
    const double t = 0.004 * i;
    const auto found =
        together.points->contacts({places(together, t), places(together, t + 0.003)}, PairPoints<2>::Share::Forces);
    const Points<2> alone(bodies, "a_surface", "b_surface", 1.0);
    const auto single = alone.points->contacts({places(alone, t)}, PairPoints<2>::Share::Forces);
    for (const PairContact<2>& contact : single->front().all) {
      if (contact.projection.patch < 0) continue;
      const PairContact<2>* const same = found->front().find(contact.patch, contact.point);
      ASSERT_TRUE(same != nullptr && same->projection.patch >= 0) << t << ' ' << contact.projection.gap;
      EXPECT_NEAR(same->projection.gap, contact.projection.gap, 1e-13);
      ++projections;
    }
  }
  EXPECT_GT(projections, 1000);
}

/// Places that are no numbers have no closest points to begin at, and say so.
TEST(PairContactsSerialTest, AfterPlacesThatAreNoNumbersASearchBeginsAnew) {
  Points<2> disks(test::two_disks(3, {5, 3.6}), "a_surface", "b_surface", 1.5);
  disks.points->begin_step();
  const double gap = disks.at({0.01, 0.02})->back().least_gap;
  disks.points->begin_step();
  EXPECT_TRUE(std::isnan(disks.at({0.01, std::nan("")})->back().all.front().projection.gap));
  EXPECT_NEAR(disks.at({0.01, 0.02})->back().least_gap, gap, 1e-14);
}

/// Bodies that lie on each other along their length: each of two ranks looks at half of the points and those near
/// the cut, and misses none that acts on it.
TEST(PairContactsTest, RanksShareThePoints) {
  const Comm comm = test::world();
  const Mesh mesh = test::two_blocks(0.3, 40, 40);
  const FacingNodes facing = facing_nodes(mesh, "upper_bottom", "lower_top", 0.3);
  const std::vector<int> owner =
      partition_nodes(mesh, comm->getSize(), node_work(mesh, {}, 500, facing.sides), facing.pairs);
  const LocalMesh local = localize(mesh, owner, comm->getRank(), comm->getSize(), {"upper_bottom", "lower_top"});
  const auto surface = [&](const std::string& set) {
    return surface_patches<2>(local, local.whole_side_sets.at(set), Smoothing::CatmullRom, set);
  };
  for (const double cutoff : {0.0, 1.5}) {
    std::shared_ptr<const GapLaw> law = gap_law(VanDerWaals(2.5, 25));
    if (cutoff > 0) law = law->cut_off(cutoff);
    const PairPoints<2> points(local, {surface("upper_bottom"), surface("lower_top")}, law, {});
    const std::vector<double> rest(local.coordinates.size(), 0.0);
    const auto all = points.contacts({points.places(rest.data())}, PairPoints<2>::Share::All);
    const auto own = points.contacts({points.places(rest.data())}, PairPoints<2>::Share::Forces);
    const std::size_t count = all->front().all.size(), looked = own->front().all.size();
    EXPECT_EQ(count, 200U);
    EXPECT_LE(looked, comm->getSize() == 1 ? count : count * 3 / 4);
    for (const PairContact<2>& contact : all->front().all) {
      bool acts = false;
      for (const int node : points.nodes_of(contact)) acts = acts || node < local.owned_nodes;
      if (acts) {
        EXPECT_NE(own->front().find(contact.patch, contact.point), nullptr);
      }
    }
  }
}

}  // namespace
}  // namespace ixos
