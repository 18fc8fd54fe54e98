// The remedies for locking: which volumetric constraints and bending modes each frees, and which hourglasses stay.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "element/eigenvalue_count.hpp"
#include "element/locking_body.hpp"

namespace ixos {
namespace {

using test::Mean;
using test::Modes;
using test::Plain;

struct Counts {
  int zero = 0, stiff = 0;
};

/// Zero eigenvalues of the stiffness at rest, and those that grow with the bulk modulus.
template <class B>
Counts modes_at_rest(bool distorted) {
  B body{};
  body.law = {lame_constants(1.0, 0.499995)};  // lambda = 1e5 mu
  std::array<double, B::D> edges;
  for (std::size_t d = 0; d < B::D; ++d) edges[d] = 1.0 + 0.2 * static_cast<double>(d);
  if (!distorted) body.x = B::block(edges);
  const auto stiffness = body.tangent(typename B::template Nodal<double>{});
  EXPECT_EQ(test::eigenvalues_below(stiffness, -1e-8), 0);
  return {test::eigenvalues_below(stiffness, 1e-8),
          static_cast<int>(stiffness.size()) - test::eigenvalues_below(stiffness, 100)};
}

TEST(LockingTest, NumberOfVolumetricConstraints) {
  const auto expect = [](const Counts& counts, int zero, int stiff) {
    EXPECT_EQ(counts.zero, zero);
    EXPECT_EQ(counts.stiff, stiff);
  };
  for (bool distorted : {false, true}) {
    expect(modes_at_rest<Mean<Quad4, NeoHooke>>(distorted), 3, 1);
    expect(modes_at_rest<Mean<Hex8, NeoHooke>>(distorted), 6, 1);
    expect(modes_at_rest<Mean<Quad4, LinearElastic>>(distorted), 3, 1);
    expect(modes_at_rest<Mean<Quad4C2, NeoHooke>>(distorted), 3, 1);
    expect(modes_at_rest<Mean<Quad4C4, NeoHooke>>(distorted), 3, 1);
    expect(modes_at_rest<Mean<Quad4CH, NeoHooke>>(distorted), 3, 1);
    expect(modes_at_rest<Mean<Hex8C2, NeoHooke>>(distorted), 6, 1);
    // A mean alone would leave the conformal maps of quadratic cells without energy, two in the plane, three in space.
    expect(modes_at_rest<Mean<Quad9, NeoHooke>>(distorted), 3, 3);
    expect(modes_at_rest<Mean<Quad9, LinearElastic>>(distorted), 3, 3);
    expect(modes_at_rest<Mean<Hex27, NeoHooke>>(distorted), 6, 4);
    expect(modes_at_rest<Mean<Quad9C4, NeoHooke>>(distorted), 3, 3);
    expect(modes_at_rest<Mean<Hex27C4, NeoHooke>>(distorted), 6, 4);
    expect(modes_at_rest<Modes<Quad4, NeoHooke>>(distorted), 3, 1);
  }
  expect(modes_at_rest<Plain<Quad4, NeoHooke>>(false), 3, 3);
  expect(modes_at_rest<Plain<Hex8, NeoHooke>>(false), 6, 7);
  expect(modes_at_rest<Modes<Hex8, NeoHooke>>(false), 6, 4);
}

/// Energy of a block bent in its first two directions to a small curvature kappa, over kappa^2; the nodes are where the
/// theory of beams puts them.
template <class B>
double bending_energy(const std::array<double, B::D>& edges, double nu) {
  B body{};
  body.law = {lame_constants(1.0, nu)};
  body.x = B::block(edges);
  const double kappa = 1e-6;
  typename B::template Nodal<double> u{};
  for (std::size_t a = 0; a < B::N; ++a) {
    const auto& x = body.x[a];
    u[a][0] = kappa * x[0] * x[1];
    if constexpr (B::D == 3) u[a][2] = -nu * kappa * x[1] * x[2];
  }
  return body.energy(u) / (kappa * kappa);
}

TEST(LockingTest, EnhancedQuadrilateralsBendAsPlateStrips) {
  const double length = 5, height = 0.4;
  for (double nu : {0.0, 0.3, 0.499}) {
    const double moment = height * height * height / 12, exact = length * moment / (2 * (1 - nu * nu));
    EXPECT_NEAR((bending_energy<Modes<Quad4, NeoHooke>>({length, height}, nu)), exact, 1e-5 * exact);
    EXPECT_NEAR((bending_energy<Modes<Quad4, LinearElastic>>({length, height}, nu)), exact, 1e-10 * exact);
    // The standard element shears instead, and may not contract where it is stretched.
    const double slender = length * length / (height * height);
    const double parasitic = (1 - nu) * (1 - nu) / (1 - 2 * nu) + (1 - nu) / 2 * slender;
    EXPECT_NEAR((bending_energy<Plain<Quad4, LinearElastic>>({length, height}, nu)), exact * parasitic,
                1e-10 * exact * parasitic);
    // The mean dilatation mends the second, not the first.
    const double mean = (1 - nu) / 2 * (1 + slender);
    EXPECT_NEAR((bending_energy<Mean<Quad4, LinearElastic>>({length, height}, nu)), exact * mean, 1e-10 * exact * mean);
  }
}

TEST(LockingTest, EnhancedHexahedraBendAsBeams) {
  const double length = 5, height = 0.4, width = 0.7;
  for (double nu : {0.0, 0.3, 0.499}) {
    const double exact = length * width * height * height * height / 24;
    EXPECT_NEAR((bending_energy<Modes<Hex8, LinearElastic>>({length, height, width}, nu)), exact, 1e-10 * exact);
    EXPECT_NEAR((bending_energy<Modes<Hex8, NeoHooke>>({length, height, width}, nu)), exact, 1e-5 * exact);
    EXPECT_GT((bending_energy<Plain<Hex8, LinearElastic>>({length, height, width}, nu)), 30 * exact);
  }
}

/// The least stiffness of the hourglass patterns of a cube that is stretched along its last axis, its sides free.
template <class B>
double hourglass_stiffness(double stretch) {
  B body{};
  std::array<double, B::D> edges;
  edges.fill(1.0);
  body.x = B::block(edges);
  double low = 0.2, high = 5;  // of the sides
  Small<double, B::D> h{};
  for (int bisection = 0; bisection < 60; ++bisection) {
    const double side = 0.5 * (low + high);
    for (std::size_t d = 0; d < B::D; ++d) h[d][d] = (d + 1 == B::D ? stretch : side) - 1;
    Small<double, B::D> p{};
    body.law.stress(h, p);
    (p[0][0] > 0 ? high : low) = side;
  }
  const auto k = body.tangent(B::affine(h, body.x));
  const auto corner = corners<static_cast<int>(B::D)>();
  double least = 1e300;
  for (std::size_t i = 0; i < B::D; ++i) {
    double sum = 0;  // of the pattern xi eta
    for (std::size_t a = 0; a < B::N; ++a)
      for (std::size_t b = 0; b < B::N; ++b)
        sum += corner[a][0] * corner[a][B::D - 1] * corner[b][0] * corner[b][B::D - 1] * k[a * B::D + i][b * B::D + i];
    least = std::min(least, sum);
  }
  return least;
}

// Known (Wriggers and Reese 1996), and a reason not to use enhanced elements under strong compression.
TEST(LockingTest, EnhancedElementsBuckleIntoHourglassesUnderStrongCompression) {
  EXPECT_GT((hourglass_stiffness<Modes<Quad4, NeoHooke>>(0.7)), 0.0);
  EXPECT_LT((hourglass_stiffness<Modes<Quad4, NeoHooke>>(0.55)), 0.0);
  EXPECT_GT((hourglass_stiffness<Modes<Hex8, NeoHooke>>(0.7)), 0.0);
  EXPECT_LT((hourglass_stiffness<Modes<Hex8, NeoHooke>>(0.55)), 0.0);
  for (double stretch : {0.1, 0.55, 4.0}) {
    EXPECT_GT((hourglass_stiffness<Mean<Quad4, NeoHooke>>(stretch)), 0.0) << stretch;
    EXPECT_GT((hourglass_stiffness<Mean<Hex8, NeoHooke>>(stretch)), 0.0) << stretch;
  }
}

}  // namespace
}  // namespace ixos
