// A linear field of the volume change in quadratic cells: closed forms of energies, and what an element must not see.
#include "element/projected_dilatation_kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "element/locking_body.hpp"

namespace ixos {
namespace {

using test::Mean;

constexpr Lame lame = lame_constants(1.0, 0.3);

TEST(DilatationKernelTest, QuadraticElementsHaveALinearField) {
  EXPECT_TRUE((std::is_same_v<DilatationKernel<Quad9, NeoHooke>, ProjectedDilatationKernel<Quad9, NeoHooke>>));
  EXPECT_TRUE((std::is_same_v<DilatationKernel<Hex27C4, NeoHooke>, ProjectedDilatationKernel<Hex27C4, NeoHooke>>));
  EXPECT_TRUE((std::is_same_v<DilatationKernel<Quad4C4, NeoHooke>, MeanDilatationKernel<Quad4C4, NeoHooke>>));
  using Ring = Revolved<Quad9>;
  EXPECT_TRUE((std::is_same_v<DilatationKernel<Ring, RevolvedLaw<NeoHooke>>,
                              ProjectedDilatationKernel<Ring, RevolvedLaw<NeoHooke>>>));
}

/// A unit square or cube about the origin, with nodal displacements field(X).
template <class B, class Field>
typename B::template Nodal<double> nodal(const B& body, const Field& field) {
  typename B::template Nodal<double> u{};
  for (std::size_t a = 0; a < B::N; ++a) u[a] = field(body.x[a]);
  return u;
}
template <class B>
B unit_block() {
  B body{};
  std::array<double, B::D> edges;
  edges.fill(1.0);
  body.x = B::block(edges);
  return body;
}

// u = ((x^2 - y^2)/2, xy): eps = x I, W = 2 (mu + lambda) x^2, and the integral of x^2 is 1/12.
TEST(ProjectedDilatationKernelTest, ConformalMapsOfThePlaneHaveTheirEnergy) {
  const auto square = unit_block<Mean<Quad9, LinearElastic>>();
  const double exact = (lame.mu + lame.lambda) / 6;
  const auto first = nodal(square, [](const auto& x) {
    return std::array{0.5 * (x[0] * x[0] - x[1] * x[1]), x[0] * x[1]};
  });
  const auto second = nodal(square, [](const auto& x) {
    return std::array{x[0] * x[1], 0.5 * (x[1] * x[1] - x[0] * x[0])};
  });
  EXPECT_NEAR(square.energy(first), exact, 1e-14);
  EXPECT_NEAR(square.energy(second), exact, 1e-14);
}

// u = 2 x X - |X|^2 e_x: eps = 2 x I, W = (12 mu + 18 lambda) x^2.
TEST(ProjectedDilatationKernelTest, ConformalMapsOfSpaceHaveTheirEnergy) {
  const auto cube = unit_block<Mean<Hex27, LinearElastic>>();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto u = nodal(cube, [&](const auto& x) {
      std::array<double, 3> value{};
      for (std::size_t i = 0; i < 3; ++i) {
        value[i] += 2 * x[axis] * x[i];
        value[axis] -= x[i] * x[i];
      }
      return value;
    });
    EXPECT_NEAR(cube.energy(u), lame.mu + 1.5 * lame.lambda, 1e-13) << axis;
  }
}

// u = (x^2 y, 0): tr H = 2xy has no linear part, so eps~ = ((xy, x^2/2), (x^2/2, -xy)), W = mu (2 x^2 y^2 + x^4/2).
TEST(ProjectedDilatationKernelTest, AVolumeChangeWithoutALinearPartIsIsochoric) {
  for (const double nu : {0.3, 0.4999}) {
    auto square = unit_block<Mean<Quad9, LinearElastic>>();
    square.law = {lame_constants(1.0, nu)};
    const auto u = nodal(square, [](const auto& x) { return std::array{x[0] * x[0] * x[1], 0.0}; });
    EXPECT_NEAR(square.energy(u), square.law.lame.mu * (1.0 / 72 + 1.0 / 160), 1e-14) << nu;
  }
}

// H is linear, and so is tr H: nothing is left to project.
template <class B>
void expect_standard_energy_of_quadratic_fields() {
  const auto block = unit_block<B>();
  const auto u = nodal(block, [](const auto& x) {
    std::array<double, B::D> value{};
    for (std::size_t i = 0; i < B::D; ++i)
      for (std::size_t j = 0; j < B::D; ++j)
        for (std::size_t k = 0; k < B::D; ++k)
          value[i] += std::sin(1.0 + 2.0 * static_cast<double>(i + 2 * j + 3 * k)) * x[j] * x[k];
    return value;
  });
  const auto force = block.force(u), expected = block.template force<typename B::Standard>(u);
  for (std::size_t a = 0; a < B::N; ++a)
    for (std::size_t i = 0; i < B::D; ++i) EXPECT_NEAR(force[a][i], expected[a][i], 1e-13) << a << ' ' << i;
  const auto geometry = B::Standard::geometry(B::table(), block.x);
  EXPECT_NEAR(block.energy(u), B::Standard::energy(block.law, geometry, u), 1e-13);
}

TEST(ProjectedDilatationKernelTest, QuadraticFieldsHaveTheEnergyOfTheStandardElement) {
  expect_standard_energy_of_quadratic_fields<Mean<Quad9, LinearElastic>>();
  expect_standard_energy_of_quadratic_fields<Mean<Hex27, LinearElastic>>();
  expect_standard_energy_of_quadratic_fields<Mean<Quad9C4, LinearElastic>>();
}

/// The body after an isometry of space that the element's own numbering follows: `from`[d] is the axis that becomes
/// axis d, with that sign, in space and in the reference element. Mirrors in space alone would invert the element.
template <class B>
struct Moved {
  std::array<std::size_t, B::D> from;
  std::array<double, B::D> sign;

  /// Returns the node whose place in the reference element becomes that of node `a`.
  std::size_t node_before(std::size_t a) const {
    const auto place = [](std::size_t node) {
      std::array<double, B::D> result;
      for (std::size_t d = 0; d < B::D; ++d) result[d] = LagrangeEdge<2>::node(B::Element::factors(node)[d]);
      return result;
    };
    for (std::size_t b = 0; b < B::N; ++b)
      if (vector(place(b)) == place(a)) return b;
    ADD_FAILURE() << "no such node";
    return 0;
  }
  std::array<double, B::D> vector(const std::array<double, B::D>& v) const {
    std::array<double, B::D> result;
    for (std::size_t d = 0; d < B::D; ++d) result[d] = sign[d] * v[from[d]];
    return result;
  }
};

/// Expects the same energy, and forces that move along: `in_space` whether the isometry acts in space, too, or turns
/// the numbering only.
template <class B>
void expect_the_same_element(const Moved<B>& moved, bool in_space) {
  const B body{};
  B other{};
  auto to = body.to;
  for (std::size_t a = 0; a < B::N; ++a) {
    const std::size_t b = moved.node_before(a);
    other.x[a] = in_space ? moved.vector(body.x[b]) : body.x[b];
    to[a] = in_space ? moved.vector(body.to[b]) : body.to[b];
  }
  EXPECT_NEAR(other.energy(to), body.energy(body.to), 1e-14);
  const auto force = other.force(to), before = body.force(body.to);
  for (std::size_t a = 0; a < B::N; ++a) {
    const std::size_t b = moved.node_before(a);
    const auto expected = in_space ? moved.vector(before[b]) : before[b];
    for (std::size_t d = 0; d < B::D; ++d) EXPECT_NEAR(force[a][d], expected[d], 1e-13) << a << ' ' << d;
  }
}

TEST(ProjectedDilatationKernelTest, NeitherMirrorsNorTheOrderOfTheNodesMatter) {
  using Square = Mean<Quad9, NeoHooke>;
  using Cube = Mean<Hex27, NeoHooke>;
  const Moved<Square> quarter{{1, 0}, {-1, 1}}, mirror{{0, 1}, {-1, 1}};
  expect_the_same_element(quarter, false);
  expect_the_same_element(quarter, true);
  expect_the_same_element(mirror, true);
  const Moved<Cube> third{{2, 0, 1}, {1, 1, 1}}, reflection{{0, 1, 2}, {1, 1, -1}};
  expect_the_same_element(third, false);
  expect_the_same_element(third, true);
  expect_the_same_element(reflection, true);
}

// Every length by 1000: the energy by 1000^D.
TEST(ProjectedDilatationKernelTest, SizesScale) {
  using B = Mean<Hex27, NeoHooke>;
  const B body{};
  B large{};
  auto to = body.to;
  for (std::size_t a = 0; a < B::N; ++a)
    for (std::size_t d = 0; d < 3; ++d) {
      large.x[a][d] = 1000 * body.x[a][d];
      to[a][d] = 1000 * body.to[a][d];
    }
  EXPECT_NEAR(large.energy(to) / body.energy(body.to), 1e9, 1e-3);
}

}  // namespace
}  // namespace ixos
