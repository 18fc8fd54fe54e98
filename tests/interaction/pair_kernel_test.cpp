// The energy of two area elements.
#include "interaction/pair_kernel.hpp"

#include <gtest/gtest.h>

#include "fem/quadrature.hpp"
#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"

namespace ixos {
namespace {

std::vector<std::shared_ptr<const GapLaw>> laws_of_pairs() {
  return {make_gap_law("Van der Waals"), make_gap_law("Van der Waals", {{"Gamma L", 1.0}, {"Gamma W", 3.0}})};
}

/// Between two half-spaces, whose normals are opposite, the energy is that of the law: with s = 1/(1 + x^2) the point
/// at x times the gap beside the closest point has the distance g/sqrt(s), and W is a polynomial of s, in the plane of
/// its root.
TEST(PairKernelTest, HalfSpacesHaveTheLaw) {
  const Quadrature gauss = gauss_legendre_unit(20);
  for (const auto& law : laws_of_pairs()) {
    const PairKernel<2> plane(law->powers());
    const PairKernel<3> space(law->powers());
    for (const double gap : {0.2, 0.25, 0.5, 2.0}) {
      double in_space = 0, in_plane = 0;
      for (std::size_t q = 0; q < gauss.points.size(); ++q) {
        const double s = gauss.points[q];
        in_space -= gauss.weights[q] * M_PI * gap * gap / (s * s) * space.at(gap * gap / s).value;
        // x = tan(pi/2 t): the integrand is a polynomial of cos(pi t).
        const double t = M_PI / 2 * s, c = std::cos(t);
        in_plane -= gauss.weights[q] * M_PI * gap / (c * c) * plane.at(gap * gap / (c * c)).value;
      }
      const double scale = law->magnitude(gap)[0] * gap;
      EXPECT_NEAR(in_space, law->energy(gap)[0], 1e-13 * scale) << gap;
      EXPECT_NEAR(in_plane, law->energy(gap)[0], 1e-13 * scale) << gap;
    }
  }
}

/// In space -lap W is the pair potential of 12-6 molecules whose half-spaces have the law.
TEST(PairKernelTest, ItsLaplacianIsThePairPotential) {
  const auto law = make_gap_law("Van der Waals");
  const double c1 = law->powers()[0].factor, c2 = -law->powers()[1].factor;
  const PairKernel<3> kernel(law->powers());
  for (const double r : {0.2, 0.3, 1.0}) {
    const auto w = kernel.at(r * r);
    const double potential = 45 * c1 / M_PI * std::pow(r, -12) - 6 * c2 / M_PI * std::pow(r, -6);
    EXPECT_NEAR(-(3 * w.slope + r * r * w.bend), potential, 1e-13 * 45 * c1 / M_PI * std::pow(r, -12) + 1e-13);
  }
}

/// The powers sum to the traction. Other laws, and laws that end, have none.
TEST(PairKernelTest, PowersAreTheTraction) {
  for (const auto& law : laws_of_pairs()) {
    for (const double r : {0.2, 0.3, 1.0}) {
      double sum = 0;
      for (const GapPower& power : law->powers()) sum += power.factor * std::pow(r, -power.exponent);
      EXPECT_NEAR(sum, law->traction(r)[0], 1e-14 * law->magnitude(r)[0]);
    }
    EXPECT_TRUE(law->cut_off(2)->powers().empty());
  }
  for (const char* name : {"Morse", "Mie", "Log Barrier"}) EXPECT_TRUE(make_gap_law(name)->powers().empty()) << name;
}

TEST(PairKernelTest, SlopesAreDerivativesAndPacksAgree) {
  for (const auto& law : laws_of_pairs()) {
    const PairKernel<2> kernel(law->powers());
    for (const double r : {0.22, 0.4, 1.5}) {
      const double h = 1e-5 * r;
      const auto w = kernel.at(r * r), up = kernel.at((r + h) * (r + h)), down = kernel.at((r - h) * (r - h));
      EXPECT_NEAR((up.value - down.value) / (2 * h) / r, w.slope, 1e-7 * std::abs(w.slope));
      EXPECT_NEAR((up.slope - down.slope) / (2 * h) / r, w.bend, 1e-7 * std::abs(w.bend));
      const auto packed = kernel.at(Pack(r * r));
      EXPECT_NEAR(packed.value[0], w.value, 1e-14 * std::abs(w.value) + 1e-16);
      EXPECT_NEAR(packed.bend[pack_width - 1], w.bend, 1e-14 * std::abs(w.bend));
    }
  }
}

}  // namespace
}  // namespace ixos
