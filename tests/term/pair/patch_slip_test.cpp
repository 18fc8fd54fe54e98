// The slip of a point before one patch: rotations, derivatives, work, and other parameters of the patch.
#include "term/pair/patch_slip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "base/vector3.hpp"
#include "geometry/curve_patches.hpp"
#include "geometry/face_patches.hpp"

namespace ixos {
namespace {

constexpr std::size_t own = 4;  ///< nodes of the point

/// A point with weights of four nodes before one patch of the other four.
template <std::size_t D>
struct Spot {
  SurfacePatch<D> patch;
  typename SurfacePatch<D>::Weights weights{0.1, 0.55, 0.4, -0.05};
  std::vector<Vec<D>> x;  ///< of the point's nodes, then of the patch's by number
  std::vector<int> nodes{0, 1, 2, 3};
  SurfaceProjection<D> projection;
  PatchSlip<D> slip;

  Spot(const SurfacePatch<D>& of_projection, std::vector<Vec<D>> places) : patch(of_projection), x(std::move(places)) {
    patch.neighbours.fill(-1);
    Vec<D> place{};
    for (std::size_t a = 0; a < own; ++a) place = place + weights[a] * x[a];
    const std::vector<SurfacePatch<D>> all{patch};
    const std::vector<Vec<D>> others(x.begin() + own, x.end());
    projection = PlacedSurface<D>(all, others).nearest(place);
    for (std::size_t a = 0; a < patch.count; ++a) nodes.push_back(static_cast<int>(own) + patch.nodes[a]);
    slip.set(weights, own, place, patch, projection);
  }
  std::size_t dofs() const { return D * x.size(); }
  /// Returns the nodal forces of a traction after these displacements.
  std::vector<double> force(const Vec<D>& traction, const std::vector<double>& u, SlipKind kind) const {
    std::vector<double> f(dofs(), 0.0);
    slip.add_force(nodes, 1, slip.force(traction, slip.motion(nodes, u.data()), kind), f.data());
    return f;
  }
  Vec<D> slip_of(const std::vector<double>& u) const { return slip.slip(slip.motion(nodes, u.data())); }
  /// Returns a vector of the plane of the slip.
  Vec<D> traction() const {
    Vec<D> result{};
    for (std::size_t i = 0; i < D; ++i) result[i] = slip.plane()[i][0] - 0.4 * slip.plane()[i][D - 1];
    return result;
  }
};

std::vector<double> noise(std::size_t count, double size) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-size, size);
  std::vector<double> u(count);
  for (double& value : u) value = number(random);
  return u;
}

const std::vector<Vec<3>> places{{0.1, 0.2, 0.9}, {0.6, 0.3, 1.0}, {0.4, 0.7, 1.1}, {0.2, 0.9, 0.8},
                                 {0, 0, 0.1},     {1.1, 0.1, 0},   {1, 1.2, 0.2},   {-0.1, 1, 0}};

/// Places with the point's nodes moved: before the inside, a side, and a corner of the patch, and behind it.
std::vector<std::vector<Vec<3>>> around() {
  std::vector<std::vector<Vec<3>>> all;
  for (const Vec<3>& way : {Vec<3>{0, 0, 0}, Vec<3>{1.2, 0, 0}, Vec<3>{-1.1, -1.3, 0}, Vec<3>{0, 0, -1.7}}) {
    all.push_back(places);
    for (std::size_t a = 0; a < own; ++a) all.back()[a] = places[a] + way;
  }
  return all;
}
std::vector<Spot<3>> spots() {
  std::vector<Spot<3>> all;
  for (const auto& x : around()) all.emplace_back(bilinear_patch({0, 1, 2, 3}), x);
  return all;
}

/// Returns v turned by an angle about an oblique axis.
Vec<3> turned(const Vec<3>& v, double angle) {
  const Vec<3> axis = 1 / std::sqrt(0.98) * Vec<3>{0.3, 0.5, 0.8};
  return std::cos(angle) * v + std::sin(angle) * cross(axis, v) + (1 - std::cos(angle)) * inner(axis, v) * axis;
}

TEST(PatchSlipTest, TheSpotsAreInsideAndAtKinks) {
  const std::vector<Spot<3>> all = spots();
  EXPECT_FALSE(all[0].projection.fixed[0] || all[0].projection.fixed[1]);
  EXPECT_NE(all[1].projection.fixed[0], all[1].projection.fixed[1]);
  EXPECT_TRUE(all[2].projection.fixed[0] && all[2].projection.fixed[1]);
  EXPECT_LT(all[3].projection.gap, 0);
}

TEST(PatchSlipTest, NoRotationOfBothIsASlip) {
  for (const Spot<3>& spot : spots())
    for (const double angle : {1e-3, 0.1, 1.0, 3.0}) {
      std::vector<double> u(spot.dofs());
      for (std::size_t k = 0; k < u.size(); ++k)
        u[k] = turned(spot.x[k / 3], angle)[k % 3] - spot.x[k / 3][k % 3] + 0.2 * static_cast<double>(k % 3);
      EXPECT_LT(length(spot.slip_of(u)), 1e-14);
      const std::vector<double> before = spot.force(spot.traction(), std::vector<double>(u.size(), 0.0), SlipKind::At),
                                after = spot.force(spot.traction(), u, SlipKind::At);
      for (std::size_t a = 0; a < u.size(); a += 3) {
        const Vec<3> expected = turned({before[a], before[a + 1], before[a + 2]}, angle);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(after[a + i], expected[i], 1e-14);
      }
    }
  const Spot<2> flat(straight_patch(0, 1), {{0.1, 0.5}, {0.6, 0.4}, {0.4, 0.6}, {0.2, 0.5}, {0, 0.1}, {1.1, 0}});
  for (const double angle : {0.1, 3.0}) {
    std::vector<double> u;
    for (const Vec<2>& x : flat.x) {
      u.push_back(std::cos(angle) * x[0] - std::sin(angle) * x[1] - x[0]);
      u.push_back(std::sin(angle) * x[0] + std::cos(angle) * x[1] - x[1]);
    }
    EXPECT_LT(length(flat.slip_of(u)), 1e-14);
  }
}

/// P (dr - w x r), with the mean rotation w of the patch.
TEST(PatchSlipTest, ASmallSlipIsThatBesideTheRotationOfThePatch) {
  for (const Spot<3>& spot : spots()) {
    const std::vector<double> u = noise(spot.dofs(), 1e-7);
    const auto shape = spot.patch.shape(spot.projection.xi);
    Vec<3> place{}, dr{};
    std::array<Vec<3>, 2> dx{};
    const auto at = [&](std::size_t node) { return Vec<3>{u[3 * node], u[3 * node + 1], u[3 * node + 2]}; };
    for (std::size_t a = 0; a < own; ++a) {
      place = place + spot.weights[a] * spot.x[a];
      dr = dr + spot.weights[a] * at(a);
    }
    for (std::size_t a = 0; a < own; ++a) {
      const auto node = static_cast<std::size_t>(spot.nodes[own + a]);
      dr = dr - shape.value[a] * at(node);
      for (std::size_t k = 0; k < 2; ++k) dx[k] = dx[k] + shape.slopes[k][a] * at(node);
    }
    const Vec<3> m = PlacedPatch<3>::normal(spot.projection.frame), r = place - spot.projection.frame.place;
    const Vec<3>&x = spot.projection.frame.tangents[0], &y = spot.projection.frame.tangents[1];
    const double area = inner(m, cross(x, y));
    // The dual vectors are y x m and m x x over the area.
    const std::array<Vec<3>, 2> c{1 / area * cross(m, cross(y, m)), 1 / area * cross(m, cross(m, x))};
    Vec<3> w{};
    for (std::size_t k = 0; k < 2; ++k) w = w + inner(c[k], dx[k]) / 2 * m - inner(m, dx[k]) * c[k];
    const Vec<3> free = dr - cross(w, r), found = spot.slip_of(u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], inner(spot.slip.plane()[i], free), 1e-12);
    EXPECT_GT(length(found), 1e-9);
  }
}

TEST(PatchSlipTest, AStretchOfThePatchIsNoSlip) {
  for (const Spot<3>& spot : spots()) {
    const Vec<3> m = PlacedPatch<3>::normal(spot.projection.frame);
    for (const double size : {1e-4, 1e-5}) {
      // The patch's places relative to the closest point grow along its tangent plane; the point does not move.
      std::vector<double> u(spot.dofs(), 0.0);
      for (std::size_t k = 3 * own; k < u.size(); ++k) {
        const Vec<3> way = spot.x[k / 3] - spot.projection.frame.place;
        u[k] = size * (way[k % 3] - inner(m, way) * m[k % 3]);
      }
      EXPECT_LT(length(spot.slip_of(u)), 4 * size * size);
    }
  }
}

/// With the traction T + eps q, a function of the slip.
TEST(PatchSlipTest, ModuliAreTheDerivativesOfTheForce) {
  constexpr double eps = 2.5, h = 1e-5;
  for (const Spot<3>& spot : spots())
    for (const SlipKind kind : {SlipKind::At, SlipKind::Mean}) {
      const auto respond = [&](const Vec<9>& change) {
        SlipResponse<double, 3> response;
        response.traction = spot.traction() + eps * spot.slip.slip(change);
        for (std::size_t i = 0; i < 3; ++i) response.stiffness[i] = eps * spot.slip.plane()[i];
        return response;
      };
      const std::vector<double> start = noise(9, 0.2);
      Vec<9> change;
      std::copy(start.begin(), start.end(), change.begin());
      const auto moduli = spot.slip.moduli(respond(change), change, kind, Tangent::Exact);
      double asymmetry = 0;
      for (std::size_t c = 0; c < 9; ++c) {
        Vec<9> ahead = change, behind = change;
        ahead[c] += h;
        behind[c] -= h;
        const Vec<9> difference = spot.slip.force(respond(ahead).traction, ahead, kind) -
                                  spot.slip.force(respond(behind).traction, behind, kind);
        for (std::size_t r = 0; r < 9; ++r) {
          EXPECT_NEAR(moduli[r][c], difference[r] / (2 * h), 1e-8);
          asymmetry = std::max(asymmetry, std::abs(moduli[r][c] - moduli[c][r]));
        }
      }
      if (kind == SlipKind::At) {
        EXPECT_LT(asymmetry, 1e-13);
      }
    }
}

TEST(PatchSlipTest, ForcesAreDerivativesAndTheirMeanDoesTheWork) {
  for (const Spot<3>& spot : spots()) {
    const std::vector<double> u = noise(spot.dofs(), 0.3), way = noise(spot.dofs() + 1, 1);
    const Vec<3> traction = spot.traction();
    const std::vector<double> mean = spot.force(traction, u, SlipKind::Mean),
                              here = spot.force(traction, u, SlipKind::At);
    double work = 0, slope = 0;
    std::vector<double> ahead = u, behind = u;
    for (std::size_t k = 0; k < u.size(); ++k) {
      work += mean[k] * u[k];
      slope += here[k] * way[k + 1];
      ahead[k] += 1e-5 * way[k + 1];
      behind[k] -= 1e-5 * way[k + 1];
    }
    EXPECT_NEAR(work, inner(traction, spot.slip_of(u)), 1e-14);
    EXPECT_NEAR(slope, inner(traction, spot.slip_of(ahead) - spot.slip_of(behind)) / 2e-5, 1e-8);
    EXPECT_GT(std::abs(slope), 1e-3);
  }
}

/// The matrix of nodes is that of the vectors: its product is the difference of nodal forces.
TEST(PatchSlipTest, StiffnessIsTheDerivativeByTheNodes) {
  constexpr double eps = 2.5, h = 1e-5;
  for (const Spot<3>& spot : spots()) {
    const auto force = [&](const std::vector<double>& u) {
      return spot.force(spot.traction() + eps * spot.slip_of(u), u, SlipKind::At);
    };
    const std::vector<double> u = noise(spot.dofs(), 0.1), noisy = noise(spot.dofs() + 1, 1);
    std::vector<double> ahead = u, behind = u, k(spot.dofs() * spot.dofs(), 0.0);
    for (std::size_t i = 0; i < u.size(); ++i) {
      ahead[i] += h * noisy[i + 1];
      behind[i] -= h * noisy[i + 1];
    }
    SlipResponse<double, 3> response;
    response.traction = spot.traction() + eps * spot.slip_of(u);
    for (std::size_t i = 0; i < 3; ++i) response.stiffness[i] = eps * spot.slip.plane()[i];
    const Vec<9> change = spot.slip.motion(spot.nodes, u.data());
    spot.slip.add_stiffness(1, spot.slip.moduli(response, change, SlipKind::At, Tangent::Exact), k);
    const std::vector<double> f1 = force(ahead), f0 = force(behind);
    // Rows are by the order of `nodes`.
    for (std::size_t r = 0; r < u.size(); ++r) {
      double sum = 0;
      for (std::size_t c = 0; c < u.size(); ++c)
        sum += k[r * u.size() + c] * noisy[1 + 3 * static_cast<std::size_t>(spot.nodes[c / 3]) + c % 3];
      const std::size_t row = 3 * static_cast<std::size_t>(spot.nodes[r / 3]) + r % 3;
      EXPECT_NEAR(sum, (f1[row] - f0[row]) / (2 * h), 1e-7);
    }
  }
}

/// The corner at which the patch begins changes nothing, and a mirror image has the mirrored slip.
TEST(PatchSlipTest, TheOrderOfTheNodesChangesNothing) {
  for (const auto& x : around()) {
    const Spot<3> first(bilinear_patch({0, 1, 2, 3}), x);
    const std::vector<double> u = noise(first.dofs(), 0.3);
    const Vec<3> traction = first.traction();
    for (int turn = 1; turn < 4; ++turn) {
      const Spot<3> other(bilinear_patch({turn, (turn + 1) % 4, (turn + 2) % 4, (turn + 3) % 4}), x);
      const Vec<3> difference = other.slip_of(u) - first.slip_of(u);
      EXPECT_LT(length(difference), 1e-12);
      for (const SlipKind kind : {SlipKind::At, SlipKind::Mean}) {
        const std::vector<double> f = first.force(traction, u, kind), g = other.force(traction, u, kind);
        for (std::size_t k = 0; k < f.size(); ++k) EXPECT_NEAR(g[k], f[k], 1e-12);
      }
    }
    std::vector<Vec<3>> mirrored = x;
    std::vector<double> v = u;
    for (Vec<3>& place : mirrored) place[0] = -place[0];
    for (std::size_t k = 0; k < v.size(); k += 3) v[k] = -v[k];
    const Spot<3> image(bilinear_patch({1, 0, 3, 2}), mirrored);
    const Vec<3> slip = first.slip_of(u), other = image.slip_of(v);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(other[i], i == 0 ? -slip[i] : slip[i], 1e-12);
  }
}

}  // namespace
}  // namespace ixos
