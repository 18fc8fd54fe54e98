// Rotations and principal strains of deformations that are built from them.
#include "model/strain_extent.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "material/strain.hpp"
#include "mesh/generators/shapes.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

constexpr double pi = 3.14159265358979323846;

Small<double, 2> turn(double angle) {
  return {{{std::cos(angle), -std::sin(angle)}, {std::sin(angle), std::cos(angle)}}};
}

/// Rodrigues' matrix of a turn about a unit vector.
Small<double, 3> turn(double angle, const std::array<double, 3>& n) {
  const double c = std::cos(angle), s = std::sin(angle);
  Small<double, 3> r{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    for (std::size_t l = 0; l < 3; ++l) r[i][l] = (1 - c) * n[i] * n[l] + (i == l ? c : 0);
    r[i][j] -= s * n[k];
    r[i][k] += s * n[j];
  }
  return r;
}

template <std::size_t D>
Small<double, D> transposed(const Small<double, D>& m) {
  Small<double, D> result;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) result[i][j] = m[j][i];
  return result;
}

/// Returns H of F = R Q diag(1 + strains) Q^T.
template <std::size_t D>
Small<double, D> gradient(const Small<double, D>& r, const Small<double, D>& q, const std::array<double, D>& strains) {
  Small<double, D> stretch{};
  for (std::size_t i = 0; i < D; ++i) stretch[i][i] = 1 + strains[i];
  Small<double, D> h = product(r, product(q, product(stretch, transposed(q))));
  for (std::size_t i = 0; i < D; ++i) h[i][i] -= 1;
  return h;
}

TEST(StrainExtentTest, APlaneTurnAndItsStretches) {
  for (double angle : {0.0, 0.01, pi / 4, 2.0, -3.0}) {
    const StrainExtent found = strain_extent(gradient<2>(turn(angle), turn(0.7), {0.3, -0.2}));
    EXPECT_NEAR(found.rotation, std::abs(angle), 1e-14);
    EXPECT_NEAR(found.least, -0.2, 1e-14);
    EXPECT_NEAR(found.largest, 0.3, 1e-14);
  }
}

TEST(StrainExtentTest, ATurnInSpaceAndItsStretches) {
  const std::array<double, 3> axis{2.0 / 3, -1.0 / 3, 2.0 / 3}, other{0.6, 0, 0.8};
  for (double angle : {0.0, 1e-6, pi / 4, 3.0}) {
    const StrainExtent found = strain_extent(gradient<3>(turn(angle, axis), turn(1.1, other), {0.1, -0.4, 0.5}));
    EXPECT_NEAR(found.rotation, angle, 1e-13);
    EXPECT_NEAR(found.least, -0.4, 1e-14);
    EXPECT_NEAR(found.largest, 0.5, 1e-14);
  }
}

// With 1 + x - 1 in the place of x, 1e-12 would have four digits.
TEST(StrainExtentTest, SmallStrainsKeepTheirDigits) {
  Small<double, 2> h{};
  h[0][0] = 1e-12;
  h[1][1] = -3e-12;
  EXPECT_NEAR(strain_extent(h).largest, 1e-12, 1e-20);
  EXPECT_NEAR(strain_extent(h).least, -3e-12, 1e-20);
}

std::unique_ptr<Model> plate(bool axisymmetric) {
  BoxShape shape;
  shape.lengths = {3, 2, 0};
  shape.divisions = {4, 3, 1};
  Mesh mesh = box(shape);
  mesh.axisymmetric = axisymmetric;
  return test::model_of(mesh, test::elastic(linear_elastic, 0.2), Inertia::Consistent);
}

/// Returns u = H X by local node.
template <std::size_t D>
std::vector<double> affine(const Model& model, const Small<double, D>& h) {
  std::vector<double> u = test::at_rest(model);
  for (std::size_t k = 0; k < u.size(); k += D)
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) u[k + i] += h[i][j] * model.mesh().coordinates[k + j];
  return u;
}

/// Returns the extremes over all ranks.
StrainExtent extent_of(const Model& model, const std::vector<double>& u) {
  const StrainExtent own = strain_extent(model.mesh(), u);
  const DofSpace& space = model.space();
  return {space.maximum(own.rotation), space.minimum(own.least), space.maximum(own.largest)};
}

TEST(StrainExtentTest, AUniformFieldHasItsOwnEverywhere) {
  const auto model = plate(false);
  const StrainExtent found = extent_of(*model, affine(*model, gradient<2>(turn(pi / 4), turn(0.4), {0.02, -0.01})));
  EXPECT_NEAR(found.rotation, pi / 4, 1e-13);
  EXPECT_NEAR(found.least, -0.01, 1e-13);
  EXPECT_NEAR(found.largest, 0.02, 1e-13);
  const StrainExtent none = extent_of(*model, test::at_rest(*model));
  EXPECT_EQ(none.rotation, 0);
  EXPECT_EQ(none.least, 0);
  EXPECT_EQ(none.largest, 0);
}

// The last column, 0.75 wide, becomes longer by 0.15: a fifth. The others stay as they are.
TEST(StrainExtentTest, TheLargestPointCounts) {
  const auto model = plate(false);
  std::vector<double> u = test::at_rest(*model);
  for (std::size_t k = 0; k < u.size(); k += 2) u[k] = model->mesh().coordinates[k] >= 2.999 ? 0.15 : 0;
  const StrainExtent found = extent_of(*model, u);
  EXPECT_NEAR(found.largest, 0.2, 1e-13);
  EXPECT_NEAR(found.rotation, 0, 1e-14);
}

// With u_r = 0.3 everywhere, the hoop strain 0.3/R is the only one. The first column of cells is 0.75 wide.
TEST(StrainExtentTest, RingsHaveHoopStrains) {
  const auto model = plate(true);
  std::vector<double> u = test::at_rest(*model);
  for (std::size_t k = 0; k < u.size(); k += 2) u[k] = 0.3;
  const double radius = 0.375 * (1 - 1 / std::sqrt(3.0));  // of the first Gauss point
  EXPECT_NEAR(extent_of(*model, u).largest, 0.3 / radius, 1e-12);
}

TEST(StrainExtentTest, EnrichedAndSpatialCellsHoldAffineFields) {
  for (int dimension : {2, 3})
    for (ContactElement element : {ContactElement::Q1C1, ContactElement::Q1C4, ContactElement::Q1CH}) {
      const auto model = test::box_with_contact(dimension, element);
      std::vector<double> u(model->mesh().coordinates);
      for (double& value : u) value *= 0.25;  // derivative nodes share in it
      const StrainExtent found = extent_of(*model, u);
      EXPECT_NEAR(found.largest, 0.25, 1e-13) << dimension;
      EXPECT_NEAR(found.rotation, 0, 1e-13) << dimension;
      EXPECT_NEAR(found.least, 0, 1e-13) << dimension;
    }
}

TEST(StrainExtentTest, AFieldThatIsNotFiniteIsNotSmall) {
  const auto model = plate(false);
  std::vector<double> u = test::at_rest(*model);
  for (double& value : u) value = std::numeric_limits<double>::quiet_NaN();
  const StrainExtent found = strain_extent(model->mesh(), u);
  EXPECT_TRUE(std::isnan(found.largest));
  EXPECT_TRUE(std::isnan(found.rotation));
}

}  // namespace
}  // namespace ixos
