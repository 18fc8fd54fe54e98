// The sum over all pairs of area elements of two surfaces.
#include "term/pair/dense_pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/curve_patches.hpp"
#include "geometry/face_patches.hpp"
#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/van_der_waals.hpp"
#include "support/two_bodies.hpp"

namespace ixos {
namespace {

const GapLaw& law() {
  static const std::shared_ptr<const GapLaw> law = gap_law(VanDerWaals(2.5, 25));
  return *law;
}

/// The kernel in space by the law's traction.
double in_space(double r) { return -law().traction(r)[0] / (2 * M_PI * r); }

/// The kernel in the plane: that in space along a line at the distance r, by Simpson's rule in t, z = r sinh t.
double in_plane(double r) {
  const int n = 8000;
  const double end = 14, h = 2 * end / n;
  double sum = 0;
  for (int k = 0; k <= n; ++k) {
    const double t = -end + h * k, weight = k == 0 || k == n ? 1 : k % 2 == 1 ? 4 : 2;
    sum += weight * h / 3 * in_space(r * std::cosh(t)) * r * std::cosh(t);
  }
  return sum;
}

template <std::size_t D>
SurfacePatches<D> one_patch(SurfacePatch<D> patch) {
  patch.neighbours.fill(-1);
  SurfacePatches<D> surface;
  for (std::size_t k = 0; k < patch.count; ++k) surface.nodes.push_back(static_cast<int>(k));
  surface.patches = {patch};
  surface.owned = {1};
  surface.sides = {{0, 0, 0}};
  return surface;
}

template <std::size_t D>
DensePairs<D> pairs_of(const PairSurfaces<D>& surfaces, int points) {
  return DensePairs<D>(surfaces, PairKernel<D>(law().powers()), points);
}

/// With one point on each, the energy of two flat sides is (a1 . a2) W(r) of their middles, a the normals times the
/// length or area.
TEST(DensePairsTest, TheEnergyOfTwoPointsIsThatOfTheKernel) {
  const SurfacePatches<2> side = one_patch(straight_patch(0, 1));
  const PairSurfaces<2> sides{side, side};
  const PairPlaces<2> segments{{{0, 0}, {0.4, 0.1}}, {{0.9, 0.7}, {0.2, 0.5}}};
  // The bodies are on the left: normals are the directions, turned clockwise.
  const Vec<2> n1{0.1, -0.4}, n2{-0.2, 0.7}, d{0.35, 0.55};
  EXPECT_NEAR(pairs_of(sides, 1).energy(segments, {1}), inner(n1, n2) * in_plane(length(d)), 1e-12);

  const SurfacePatches<3> face = one_patch(bilinear_patch({0, 1, 2, 3}));
  const PairSurfaces<3> faces{face, face};
  const PairPlaces<3> squares{{{0, 0, 0}, {0.5, 0, 0}, {0.5, 0.4, 0}, {0, 0.4, 0}},
                              {{0, 0.3, 0.6}, {0, 0.7, 0.9}, {0.5, 0.7, 0.9}, {0.5, 0.3, 0.6}}};
  const Vec<3> a1{0, 0, 0.2}, a2{0, 0.15, -0.2}, e{0, 0.3, 0.75};  // sides (0, 0.4, 0.3) and (0.5, 0, 0)
  EXPECT_NEAR(pairs_of(faces, 1).energy(squares, {1}), inner(a1, a2) * in_space(length(e)), 1e-15);
}

/// Two bodies' surfaces with a smooth displacement.
template <std::size_t D>
struct Bodies {
  PairSurfaces<D> surfaces;
  PairPlaces<D> places;

  explicit Bodies(const Mesh& mesh, const char* first, const char* second) {
    const LocalMesh local = localize(mesh, partition_nodes(mesh, 1), 0, 1, {first, second});
    const auto patches = [&](const char* set) {
      return surface_patches<D>(local, local.whole_side_sets.at(set), Smoothing::CatmullRom, set);
    };
    surfaces = {patches(first), patches(second)};
    places = {combined_places<D>(surfaces.secondary.nodes, local.coordinates, 1, {}),
              combined_places<D>(surfaces.primary.nodes, local.coordinates, 1, {})};
    for (auto* surface : {&places.secondary, &places.primary})
      for (Vec<D>& x : *surface)
        for (std::size_t i = 0; i < D; ++i) x[i] += 0.02 * std::sin(3 * x[(i + 1) % D] + static_cast<double>(i));
  }
  std::size_t size() const { return D * (places.secondary.size() + places.primary.size()); }
  /// The places after a way of all nodes, component by component, of which the k-th one moves by sin(k + 1).
  PairPlaces<D> moved(double step) const {
    PairPlaces<D> result = places;
    std::size_t k = 0;
    for (auto* surface : {&result.secondary, &result.primary})
      for (Vec<D>& x : *surface)
        for (std::size_t i = 0; i < D; ++i) x[i] += step * way(k++);
    return result;
  }
  static double way(std::size_t k) { return std::sin(static_cast<double>(k) + 1); }
};

/// Derivatives by differences of fourth order in steps of h, whose errors are h^4.
template <std::size_t D>
void expect_derivatives(const Bodies<D>& bodies) {
  const DensePairs<D> pairs = pairs_of(bodies.surfaces, 2);
  const std::vector<char> all(bodies.surfaces.secondary.patches.size(), 1);
  const double h = 5e-5;
  const auto difference = [&](const auto& of) { return (8 * (of(h) - of(-h)) - (of(2 * h) - of(-2 * h))) / (12 * h); };
  const auto flat = [&](double step) {
    std::vector<double> result;
    for (const Vec<D>& g : pairs.gradient(bodies.moved(step), all)) result.insert(result.end(), g.begin(), g.end());
    return result;
  };
  const std::vector<double> gradient = flat(0);
  double work = 0;
  for (std::size_t k = 0; k < gradient.size(); ++k) work += gradient[k] * Bodies<D>::way(k);
  EXPECT_NEAR(difference([&](double step) { return pairs.energy(bodies.moved(step), all); }), work,
              1e-9 * std::abs(work));
  EXPECT_GT(std::abs(work), 1e-4);

  std::vector<double> matrix(bodies.size() * bodies.size(), 0.0);
  pairs.add_hessian(bodies.places, all, Tangent::Exact, 2, matrix);
  const std::vector<double> p1 = flat(h), m1 = flat(-h), p2 = flat(2 * h), m2 = flat(-2 * h);
  double largest = 0, error = 0;
  for (std::size_t r = 0; r < bodies.size(); ++r) {
    double sum = 0;
    for (std::size_t c = 0; c < bodies.size(); ++c) {
      sum += matrix[r * bodies.size() + c] * Bodies<D>::way(c);
      EXPECT_NEAR(matrix[r * bodies.size() + c], matrix[c * bodies.size() + r], 1e-12);
    }
    const double by_differences = 2 * (8 * (p1[r] - m1[r]) - (p2[r] - m2[r])) / (12 * h);
    largest = std::max(largest, std::abs(sum));
    error = std::max(error, std::abs(sum - by_differences));
  }
  EXPECT_GT(largest, 1e-3);
  EXPECT_LT(error, 1e-9 * largest);
}

TEST(DensePairsTest, GradientAndHessianAreDerivatives) {
  expect_derivatives(Bodies<2>(test::two_disks(3, {5, 3.6}), "a_surface", "b_surface"));
  expect_derivatives(Bodies<3>(test::two_boxes(0.4), "upper_bottom", "lower_top"));
}

/// Patches that do not act add nothing, and the rest is a sum over patches. The force is that of a common motion.
TEST(DensePairsTest, EachPatchAddsItsShare) {
  const Bodies<2> bodies(test::two_disks(3, {5, 3.6}), "a_surface", "b_surface");
  const DensePairs<2> pairs = pairs_of(bodies.surfaces, 3);
  const std::size_t patches = bodies.surfaces.secondary.patches.size();
  std::vector<char> odd(patches), even(patches), all(patches, 1);
  for (std::size_t k = 0; k < patches; ++k) (k % 2 == 1 ? odd : even)[k] = 1;
  const double whole = pairs.energy(bodies.places, all), one = pairs.energy(bodies.places, odd);
  EXPECT_NEAR(one + pairs.energy(bodies.places, even), whole, 1e-14 * std::abs(whole));
  EXPECT_GT(std::abs(one), 1e-2 * std::abs(whole));
  EXPECT_LT(std::abs(one), 0.99 * std::abs(whole));
  Vec<2> sum{};
  const std::vector<Vec<2>> gradient = pairs.gradient(bodies.places, odd);
  for (std::size_t n = 0; n < bodies.places.secondary.size(); ++n) sum = sum - gradient[n];
  const Vec<2> force = pairs.force(bodies.places, odd);
  EXPECT_LT(length(force - sum), 1e-13 * length(force));
}

}  // namespace
}  // namespace ixos
