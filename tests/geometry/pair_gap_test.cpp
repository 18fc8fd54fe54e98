// Derivatives of the gap between two surfaces.
#include "geometry/pair_gap.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/curve_patches.hpp"
#include "geometry/face_patches.hpp"
#include "support/automatic_differentiation.hpp"

namespace ixos {
namespace {

/// A point with weights of four nodes before one patch; the last numbers of x are the patch's nodes.
template <std::size_t D>
struct Pair {
  SurfacePatch<D> patch;
  typename SurfacePatch<D>::Weights weights{-0.07, 0.55, 0.6, -0.08};
  std::vector<Vec<D>> x;  ///< of the point's four nodes, then of the patch's by number

  Vec<D> place() const {
    Vec<D> p{};
    for (std::size_t a = 0; a < 4; ++a) p = p + weights[a] * x[a];
    return p;
  }
  struct Found {
    SurfaceProjection<D> projection;
    PairGap<D> gap;
  };
  Found find() const {
    const std::vector<SurfacePatch<D>> all{patch};
    const std::vector<Vec<D>> nodes(x.begin() + 4, x.end());
    const PlacedSurface<D> placed(all, nodes);
    const SurfaceProjection<D> projection = placed.nearest(place());
    return {projection, PairGap<D>(weights, 4, patch, projection)};
  }
  /// Returns the place in x of a node of the gap.
  std::size_t number(std::size_t node) const {
    return node < 4 ? node : 4 + static_cast<std::size_t>(patch.nodes[node - 4]);
  }
};

SurfacePatch<2> without_neighbours(SurfacePatch<2> patch) {
  patch.neighbours.fill(-1);
  return patch;
}

std::vector<Pair<2>> plane_pairs() {
  const std::vector<Vec<2>> x{{-1, 1.1}, {0.1, 1.0}, {1, 0.9}, {2, 1.2}, {0, 0.1}, {1.1, 0}, {-1, -0.2}, {2.2, 0.3}};
  std::vector<Pair<2>> all(5);
  for (Pair<2>& pair : all) pair.x = x;
  all[0].patch = without_neighbours(straight_patch(0, 1));
  all[1].patch = without_neighbours(smooth_patch({2, 0, 1, 3}, {1, 1.1, 1.3}));
  all[2].patch = without_neighbours(smooth_patch({-1, 0, 1, 3}, {0, 1.1, 1.3}));
  all[3].patch = without_neighbours(straight_patch(0, 1));  // beyond its end
  for (std::size_t a = 0; a < 4; ++a) all[3].x[a][0] += 1.5;
  all[4] = all[1];  // on the other side, where the curve is hollow
  for (std::size_t a = 0; a < 4; ++a) all[4].x[a][1] -= 1.6;
  return all;
}

/// Before a bilinear patch: its inside, a side, a corner; and before a quadratic one of random weights.
std::vector<Pair<3>> space_pairs() {
  const std::vector<Vec<3>> x{{0.1, 0.2, 0.9}, {0.6, 0.3, 1.0}, {0.4, 0.7, 1.1}, {0.2, 0.9, 0.8},
                              {0, 0, 0.1},     {1.1, 0.1, 0},   {1, 1.2, 0.2},   {-0.1, 1, 0}};
  std::vector<Pair<3>> all(5);
  for (Pair<3>& pair : all) {
    pair.x = x;
    pair.patch = bilinear_patch({0, 1, 2, 3});
    pair.patch.neighbours.fill(-1);
  }
  for (std::size_t a = 0; a < 4; ++a) {
    all[1].x[a][0] += 1.2;  // a side
    all[2].x[a][0] -= 1.1;  // a corner
    all[2].x[a][1] -= 1.3;
    all[3].x[a][2] -= 1.7;  // behind
  }
  std::array<CornerDerivatives, 4> derivatives;
  const std::array<std::array<double, 2>, 4> signs{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
  for (std::size_t c = 0; c < 4; ++c) {
    const int own = static_cast<int>(c), first = c % 2 == 0 ? own + 1 : own - 1, second = 3 - own;
    derivatives[c].first.add(own, -signs[c][0]);
    derivatives[c].first.add(first, signs[c][0] * 1.2);
    derivatives[c].first.add(second, -signs[c][0] * 0.2);
    derivatives[c].second.add(own, -signs[c][1]);
    derivatives[c].second.add(second, signs[c][1]);
    derivatives[c].mixed.add(own, 0.3);
    derivatives[c].mixed.add((own + 2) % 4, -0.3);
  }
  all[4].patch = bicubic_patch({0, 1, 2, 3}, derivatives, {1, 1});
  all[4].patch.neighbours.fill(-1);
  return all;
}

template <std::size_t D>
void expect_derivatives(const std::vector<Pair<D>>& pairs) {
  for (const Pair<D>& pair : pairs) {
    const auto [projection, gap] = pair.find();
    bool free = false;
    for (const bool fixed : projection.fixed) free = free || !fixed;
    EXPECT_EQ(gap.is_round(), !free);
    const auto gradient = gap.gradient();
    const std::size_t size = D * gap.nodes();
    std::vector<double> second(size * size, 0.0), both(size * size, 0.0);
    gap.add(0, 1, second.data());
    gap.add(2, 0, both.data());
    const double h = 1e-5;
    for (std::size_t r = 0; r < size; ++r) {
      Pair<D> ahead = pair, behind = pair;
      ahead.x[pair.number(r / D)][r % D] += h;
      behind.x[pair.number(r / D)][r % D] -= h;
      const auto up = ahead.find(), down = behind.find();
      EXPECT_NEAR((up.projection.gap - down.projection.gap) / (2 * h), gradient[r], 1e-9);
      const auto at_up = up.gap.gradient(), at_down = down.gap.gradient();
      for (std::size_t c = 0; c < size; ++c) {
        EXPECT_NEAR((at_up[c] - at_down[c]) / (2 * h), second[r * size + c], 1e-8) << r << " " << c;
        EXPECT_NEAR(both[r * size + c], 2 * gradient[r] * gradient[c], 1e-15);
      }
    }
  }
}

TEST(PairGapTest, DerivativesInThePlaneAgreeWithDifferences) { expect_derivatives(plane_pairs()); }
TEST(PairGapTest, DerivativesInSpaceAgreeWithDifferences) { expect_derivatives(space_pairs()); }

/// A number with a derivative, whose derivative has one, too.
using Twice = Sacado::Fad::Exp::GeneralFad<Sacado::Fad::Exp::StaticFixedStorage<test::Dual<1>, 1>>;

/// Returns t^k, or its first or second derivative.
Twice power(const Twice& t, int k, int derivative) {
  Twice result = derivative == 0 ? 1.0 : derivative == 1 ? k : k * (k - 1);
  for (int i = derivative; i < k; ++i) result = result * t;
  return result;
}

/// The gap with its derivatives: the closest point's free parameters solve x_,k . (p - y) = 0 by Newton's method in
/// numbers with derivatives, from the closest point on, so that each step makes derivatives of one more order exact.
/// `x`: component by component, as Pair::x.
template <std::size_t D>
Twice differentiated_gap(const Pair<D>& pair, const SurfaceProjection<D>& projection, const std::vector<Twice>& x) {
  const SurfacePatch<D>& patch = pair.patch;
  std::array<Twice, D - 1> xi;
  for (std::size_t k = 0; k + 1 < D; ++k) xi[k] = projection.xi[k];
  // The derivative of the patch's place, of these orders in the parameters.
  const auto place = [&](std::array<int, 2> orders) {
    std::array<Twice, D> sum;
    sum.fill(0.0);
    const int n = patch.degree + 1;
    for (std::size_t a = 0; a < patch.count; ++a) {
      typename SurfacePatch<D>::Points unit{};
      unit[a][0] = 1;
      const PlacedPatch<D> function = patch.placed(unit);  // its weight
      Twice weight = 0.0;
      for (std::size_t j = 0; j < patch.powers(); ++j) {
        const int first = static_cast<int>(j) % n, second = static_cast<int>(j) / n;
        Twice term = function.coefficients[j][0] * power(xi[0], first, orders[0]);
        if (D == 3) term = term * power(xi[D - 2], second, orders[1]);
        weight = weight + term;
      }
      for (std::size_t i = 0; i < D; ++i) sum[i] = sum[i] + weight * x[D * pair.number(4 + a) + i];
    }
    return sum;
  };
  const auto dot = [](const std::array<Twice, D>& a, const std::array<Twice, D>& b) {
    Twice sum = 0.0;
    for (std::size_t i = 0; i < D; ++i) sum = sum + a[i] * b[i];
    return sum;
  };
  const auto from_projection = [&] {
    std::array<Twice, D> r = place({0, 0});
    for (std::size_t i = 0; i < D; ++i) {
      Twice point = 0.0;
      for (std::size_t a = 0; a < 4; ++a) point = point + pair.weights[a] * x[D * a + i];
      r[i] = point - r[i];
    }
    return r;
  };
  std::vector<std::size_t> free;
  for (std::size_t k = 0; k + 1 < D; ++k)
    if (!projection.fixed[k]) free.push_back(k);
  for (int iteration = 0; iteration < 4; ++iteration) {
    const std::array<Twice, D> r = from_projection();
    std::array<std::array<Twice, 2>, 2> a;
    std::array<Twice, 2> b;
    const auto orders = [](std::size_t k) { return std::array<int, 2>{k == 0 ? 1 : 0, k == 1 ? 1 : 0}; };
    for (std::size_t k = 0; k < free.size(); ++k) {
      const auto own = orders(free[k]);
      b[k] = dot(place(own), r);
      for (std::size_t l = 0; l < free.size(); ++l) {
        const auto other = orders(free[l]);
        a[k][l] = dot(place(own), place(other)) - dot(place({own[0] + other[0], own[1] + other[1]}), r);
      }
    }
    if (free.size() == 1) xi[free[0]] = xi[free[0]] + b[0] / a[0][0];
    if (free.size() == 2) {
      const Twice det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
      xi[0] = xi[0] + (a[1][1] * b[0] - a[0][1] * b[1]) / det;
      xi[D - 2] = xi[D - 2] + (a[0][0] * b[1] - a[1][0] * b[0]) / det;
    }
  }
  const std::array<Twice, D> r = from_projection();
  const Twice distance = sqrt(dot(r, r));
  return projection.gap < 0 ? Twice(-distance) : distance;
}

template <std::size_t D>
void expect_automatic_derivatives(const std::vector<Pair<D>>& pairs) {
  for (const Pair<D>& pair : pairs) {
    const auto [projection, gap] = pair.find();
    const auto gradient = gap.gradient();
    const std::size_t size = D * gap.nodes();
    std::vector<double> second(size * size, 0.0);
    gap.add(0, 1, second.data());
    const auto number = [&](std::size_t k) { return D * pair.number(k / D) + k % D; };
    for (std::size_t r = 0; r < size; ++r)
      for (std::size_t c = 0; c < size; ++c) {
        std::vector<Twice> x;
        for (const Vec<D>& place : pair.x)
          for (const double component : place) x.emplace_back(component);
        const double at_r = x[number(r)].val().val();
        // The inner derivative is that by r, the outer one that by c.
        x[number(r)] = Twice(test::variable<1>(0, at_r));
        const test::Dual<1> value = x[number(c)].val();
        x[number(c)] = Twice(1, 0, value);
        const Twice g = differentiated_gap(pair, projection, x);
        EXPECT_NEAR(g.val().val(), projection.gap, 1e-14);
        EXPECT_NEAR(g.val().dx(0), gradient[r], 1e-13);
        EXPECT_NEAR(g.dx(0).dx(0), second[r * size + c], 2e-9) << r << " " << c;
      }
  }
}

TEST(PairGapTest, DerivativesInThePlaneAreThoseOfAutomaticDifferentiation) {
  expect_automatic_derivatives(plane_pairs());
}
TEST(PairGapTest, DerivativesInSpaceAreThoseOfAutomaticDifferentiation) { expect_automatic_derivatives(space_pairs()); }

TEST(PairGapTest, TheCasesInSpaceHaveProjectionsInsideOnASideAndAtACorner) {
  const std::vector<Pair<3>> pairs = space_pairs();
  std::vector<int> fixed;
  for (const Pair<3>& pair : pairs) {
    const SurfaceProjection<3> projection = pair.find().projection;
    fixed.push_back(projection.fixed[0] + projection.fixed[1]);
  }
  EXPECT_EQ(fixed, (std::vector<int>{0, 1, 2, 0, 0}));
  EXPECT_LT(pairs[3].find().projection.gap, 0);
}

template <std::size_t D>
void expect_no_net_force(const std::vector<Pair<D>>& pairs) {
  for (const Pair<D>& pair : pairs) {
    const PairGap<D> gap = pair.find().gap;
    const auto g = gap.gradient();
    Vec<D> force{};
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        double moment = 0;
        for (std::size_t a = 0; a < gap.nodes(); ++a) {
          const Vec<D>& x = pair.x[pair.number(a)];
          moment += x[i] * g[D * a + j] - x[j] * g[D * a + i];
        }
        EXPECT_NEAR(moment, 0, 1e-13);
      }
    for (std::size_t a = 0; a < gap.nodes(); ++a)
      for (std::size_t i = 0; i < D; ++i) force[i] += g[D * a + i];
    EXPECT_NEAR(length(force), 0, 1e-14);
  }
}

TEST(PairGapTest, NeitherNetForceNorNetMoment) {
  expect_no_net_force(plane_pairs());
  expect_no_net_force(space_pairs());
}

}  // namespace
}  // namespace ixos
