// The element kernels of bodies of revolution.
#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>
#include <vector>

#include "element/eigenvalue_count.hpp"
#include "element/elastic_kernel.hpp"
#include "element/element_nodes.hpp"
#include "element/enhanced_kernel.hpp"
#include "element/projected_dilatation_kernel.hpp"
#include "material/linear_elastic.hpp"
#include "material/neo_hooke.hpp"

namespace ixos {
namespace {

using test::ElasticKernel;

/// One ring whose section is a distorted unit square between the radii 1 and 2.
template <class Section, class Law, template <class, class> class KernelOf>
struct Ring : test::ElementNodes<Section> {
  using Kernel = KernelOf<Revolved<Section>, RevolvedLaw<Law>>;
  using Nodes = test::ElementNodes<Section>;
  using Nodes::D;
  using Nodes::N;
  using typename Nodes::Variable;
  template <class T>
  using Nodal = typename Nodes::template Nodal<T>;
  static constexpr std::size_t corners = 4;
  static constexpr bool has_discrete_gradient =
      std::is_same_v<Kernel, ElasticKernel<Revolved<Section>, RevolvedLaw<Law>>>;

  RevolvedLaw<Law> material{Law{lame_constants(1.0, 0.3)}};

  static const typename Kernel::Table& table() {
    static const typename Kernel::Table values;
    return values;
  }
  static Nodal<double> section(double distortion = 1) {
    const Nodal<double> distorted = Nodes::distorted(0.3);
    Nodal<double> x = Nodes::block({1.0, 1.0});
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d) x[a][d] += distortion * (distorted[a][d] - x[a][d]);
    for (std::size_t a = 0; a < places(); ++a) x[a][0] += 1.5;
    return x;
  }
  static std::size_t places() { return IsHermite<Section>::value ? corners : N; }
  /// u_r = stretch R, u_z = along Z.
  static Nodal<double> homogeneous(const Nodal<double>& x, double stretch, double along) {
    return Nodes::affine({{{stretch, 0.0}, {0.0, along}}}, x);
  }

  template <class T>
  T energy(const Nodal<T>& x, const Nodal<T>& u) const {
    return Kernel::energy(material, Kernel::geometry(table(), x), u);
  }
  template <class T>
  Nodal<T> force(const Nodal<T>& x, const Nodal<T>& from, const Nodal<T>& to, const Rule& rule) const {
    Nodal<T> f{};
    const typename Kernel::template Segment<T> segment{&from, nullptr, &to};
    Kernel::add_force(material, Kernel::geometry(table(), x), segment, rule, f);
    return f;
  }
};

template <class R>
class RevolvedKernelsTest : public testing::Test {};
using Rings = testing::Types<Ring<Quad4, NeoHooke, ElasticKernel>, Ring<Quad4, LinearElastic, ElasticKernel>,
                             Ring<Quad4C3, NeoHooke, ElasticKernel>, Ring<Quad4CH, NeoHooke, ElasticKernel>,
                             Ring<Quad9, NeoHooke, ElasticKernel>, Ring<Quad9, NeoHooke, DilatationKernel>,
                             Ring<Quad9, LinearElastic, DilatationKernel>, Ring<Quad9C4, NeoHooke, DilatationKernel>,
                             Ring<Quad4, NeoHooke, DilatationKernel>, Ring<Quad4, LinearElastic, DilatationKernel>,
                             Ring<Quad4C2, NeoHooke, DilatationKernel>, Ring<Quad4, NeoHooke, EnhancedKernel>,
                             Ring<Quad4, LinearElastic, EnhancedKernel>>;
TYPED_TEST_SUITE(RevolvedKernelsTest, Rings);

TYPED_TEST(RevolvedKernelsTest, WeightsSumToTheVolumeOfTheRing) {
  // The section is a unit square: the volume is pi (2^2 - 1^2).
  double volume = 0;
  const auto geometry = TypeParam::Kernel::geometry(TypeParam::table(), TypeParam::section(0));
  for (const auto& point : geometry.points) volume += point.weight;
  EXPECT_NEAR(volume, 3 * M_PI, 1e-13);
}

TYPED_TEST(RevolvedKernelsTest, HomogeneousStatesHaveTheEnergyAndTheForcesOfTheLaw) {
  // u_r = s R, u_z = t Z is homogeneous in space: every element represents it exactly, on any section.
  const TypeParam ring{};
  const double s = 0.1, t = -0.15;
  const auto x = TypeParam::section();
  const auto u = TypeParam::homogeneous(x, s, t);
  double volume = 0;
  for (const auto& point : TypeParam::Kernel::geometry(TypeParam::table(), x).points) volume += point.weight;
  const Small<double, 3> h{{{s, 0, 0}, {0, t, 0}, {0, 0, s}}};
  Small<double, 3> p;
  ring.material.stress(h, p);
  EXPECT_NEAR(ring.energy(x, u), volume * ring.material.energy(h), 1e-13 * volume);
  // Virtual work of the displacements R and Z.
  const auto f = ring.force(x, u, u, end_rule());
  const auto work = [&](const auto& v) {
    double sum = 0;
    for (std::size_t a = 0; a < TypeParam::N; ++a)
      for (std::size_t i = 0; i < 2; ++i) sum += f[a][i] * v[a][i];
    return sum;
  };
  EXPECT_NEAR(work(TypeParam::homogeneous(x, 1, 0)), volume * (p[0][0] + p[2][2]), 1e-12 * volume);
  EXPECT_NEAR(work(TypeParam::homogeneous(x, 0, 1)), volume * p[1][1], 1e-12 * volume);
}

TYPED_TEST(RevolvedKernelsTest, ForceIsTheGradientOfTheEnergy) {
  using Variable = typename TypeParam::Variable;
  const TypeParam ring{};
  const auto u = TypeParam::wave(0.06, 2.0);
  const auto x = TypeParam::section();
  const Variable energy = ring.energy(TypeParam::template constant<Variable>(x), TypeParam::seeded(u));
  const auto f = ring.force(x, u, u, end_rule());
  EXPECT_GT(energy.val(), 0);
  for (std::size_t r = 0; r < TypeParam::N * 2; ++r)
    EXPECT_NEAR(f[r / 2][r % 2], energy.dx(static_cast<int>(r)), 1e-12) << r;
}

TYPED_TEST(RevolvedKernelsTest, TangentIsTheDerivativeOfTheForce) {
  using Variable = typename TypeParam::Variable;
  const TypeParam ring{};
  const auto x = TypeParam::section(), from = TypeParam::wave(0.05, 1.0), to = TypeParam::wave(0.06, 2.0);
  std::vector<Rule> rules{end_rule(), gauss_rule(3, Path::Linear)};
  if (TypeParam::has_discrete_gradient) rules.push_back(discrete_gradient_rule());
  for (const Rule& rule : rules) {
    const auto f = ring.force(TypeParam::template constant<Variable>(x), TypeParam::template constant<Variable>(from),
                              TypeParam::seeded(to), rule);
    typename TypeParam::Kernel::template Tangent<double> k{};
    TypeParam::Kernel::add_tangent(ring.material, TypeParam::Kernel::geometry(TypeParam::table(), x),
                                   {&from, nullptr, &to}, rule, k);
    for (std::size_t r = 0; r < TypeParam::N * 2; ++r)
      for (std::size_t c = 0; c < TypeParam::N * 2; ++c)
        EXPECT_NEAR(k[r][c], f[r / 2][r % 2].dx(static_cast<int>(c)), 2e-11) << r << " " << c;
  }
}

// The motion along the axis is the only one that strains nothing.
TYPED_TEST(RevolvedKernelsTest, OneModeHasNoEnergy) {
  const TypeParam ring{};
  const typename TypeParam::template Nodal<double> rest{};
  for (const double distortion : {0.0, 1.0}) {
    typename TypeParam::Kernel::template Tangent<double> k{};
    TypeParam::Kernel::add_tangent(ring.material,
                                   TypeParam::Kernel::geometry(TypeParam::table(), TypeParam::section(distortion)),
                                   {nullptr, nullptr, &rest}, end_rule(), k);
    EXPECT_EQ(test::eigenvalues_below(k, -1e-9), 0);
    EXPECT_EQ(test::eigenvalues_below(k, 1e-9), 1);
  }
}

TYPED_TEST(RevolvedKernelsTest, AxialMotionCostsNothing) {
  const TypeParam ring{};
  auto u = TypeParam::wave(0.06, 2.0);
  const auto x = TypeParam::section();
  const double before = ring.energy(x, u);
  for (std::size_t a = 0; a < TypeParam::places(); ++a) u[a][1] += 7;
  EXPECT_NEAR(ring.energy(x, u), before, 1e-12 * std::abs(before));
}

TEST(RevolvedKernels, DiscreteGradientDoesTheWorkOfTheEnergy) {
  using R = Ring<Quad4, NeoHooke, ElasticKernel>;
  const R ring{};
  const auto x = R::section(), from = R::wave(0.05, 1.0), to = R::wave(0.06, 2.0);
  const auto f = ring.force(x, from, to, discrete_gradient_rule());
  double work = 0;
  for (std::size_t a = 0; a < R::N; ++a)
    for (std::size_t i = 0; i < 2; ++i) work += f[a][i] * (to[a][i] - from[a][i]);
  EXPECT_NEAR(work, ring.energy(x, to) - ring.energy(x, from), 1e-14);
}

TEST(RevolvedKernels, KeptTangentIsTheTangent) {
  using R = Ring<Quad4, NeoHooke, ElasticKernel>;
  const R ring{};
  const auto x = R::section(), to = R::wave(0.06, 2.0);
  const auto geometry = R::Kernel::geometry(R::table(), x);
  const std::size_t size = R::Kernel::kept_size<double>(ring.material, end_rule());
  ASSERT_GT(size, 0u);
  std::vector<double> kept(size * geometry.points.size());
  R::Nodal<double> f{};
  R::Kernel::Segment<double> segment{nullptr, nullptr, &to};
  R::Kernel::add_force(ring.material, geometry, segment, end_rule(), f, kept.data());
  R::Kernel::Tangent<double> k{}, again{};
  R::Kernel::add_tangent(ring.material, geometry, segment, end_rule(), k);
  R::Kernel::add_tangent(ring.material, geometry, segment, end_rule(), again, kept.data());
  for (std::size_t r = 0; r < 8; ++r)
    for (std::size_t c = 0; c < 8; ++c) EXPECT_NEAR(k[r][c], again[r][c], 1e-13);
}

}  // namespace
}  // namespace ixos
