#include "interaction/side_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/small_matrix.hpp"
#include "fem/reference_elements.hpp"
#include "fem/shape_table.hpp"
#include "interaction/van_der_waals.hpp"
#include "support/automatic_differentiation.hpp"

namespace ixos {
namespace {

/// Gaps at the points of a side from those at its nodes, and nodal forces from tractions, over any scalar type.
template <class Side>
struct SideKernel {
  static constexpr std::size_t N = Side::nodes;
  using Table = ShapeTable<Side>;
  template <class T>
  using Nodal = std::array<T, N>;
  template <class T>
  struct Segment {
    const Nodal<T>* from;
    const Nodal<T>* velocity;
    const Nodal<T>* to;
  };

  template <class T>
  struct Gaps {
    Gaps(const Table& quadrature, const Segment<T>& segment) {
      for (const auto& shape : quadrature.value) {
        to.push_back(interpolate(shape, *segment.to));
        from.push_back(interpolate(shape, *segment.from));
        if (segment.velocity != nullptr) velocity.push_back(interpolate(shape, *segment.velocity));
      }
    }
    GapEnds<T> ends() const {
      return {to.size(), to.data(), from.data(), velocity.empty() ? nullptr : velocity.data()};
    }
    std::vector<T> to, from, velocity;
  };

  template <class T>
  static T interpolate(const std::array<double, N>& shape, const Nodal<T>& nodal) {
    T sum(0.0);
    for (std::size_t a = 0; a < N; ++a) sum += shape[a] * nodal[a];
    return sum;
  }

  template <class Law, class T>
  static T energy(const Law& law, const Table& quadrature, const T* measure, const Nodal<T>& gap) {
    T sum(0.0);
    for (std::size_t q = 0; q < quadrature.size(); ++q)
      sum += measure[q] * law.energy(interpolate(quadrature.value[q], gap));
    return sum;
  }

  template <class Law, class T>
  static T add_force(const Law& law, const Table& quadrature, const T* measure, const Segment<T>& segment,
                     const Rule& rule, Nodal<T>& f) {
    std::vector<T> tractions(quadrature.size());
    T least_gap(1e300);
    rule_tractions(law, Gaps<T>(quadrature, segment).ends(), rule, tractions.data(), least_gap);
    for (std::size_t q = 0; q < quadrature.size(); ++q)
      for (std::size_t a = 0; a < N; ++a) f[a] -= quadrature.value[q][a] * (measure[q] * tractions[q]);
    return least_gap;
  }

  template <class Law, class T>
  static void add_tangent(const Law& law, const Table& quadrature, const T* measure, const Segment<T>& segment,
                          const Rule& rule, bool convex, Small<T, N>& k) {
    std::vector<T> stiffnesses(quadrature.size());
    rule_stiffnesses(law, Gaps<T>(quadrature, segment).ends(), rule, convex, stiffnesses.data());
    for (std::size_t q = 0; q < quadrature.size(); ++q) {
      const auto& shape = quadrature.value[q];
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t b = 0; b < N; ++b) k[a][b] += (shape[a] * shape[b]) * (measure[q] * stiffnesses[q]);
    }
  }

  template <class T>
  static T largest_step(const Table& quadrature, const Segment<T>& segment, const Rule& rule, const Nodal<T>& change,
                        double margin, double near) {
    std::vector<T> changes;
    for (const auto& shape : quadrature.value) changes.push_back(interpolate(shape, change));
    return admissible_step(Gaps<T>(quadrature, segment).ends(), changes.data(), rule, margin, near);
  }
};

/// One side before a wall: an edge (D = 2) or a face (D = 3) of the given length or area.
template <std::size_t Dim>
struct Surface {
  static constexpr std::size_t D = Dim;
  using Kernel = SideKernel<Multilinear<static_cast<int>(D) - 1>>;
  static constexpr std::size_t N = Kernel::N;
  using Variable = test::Dual<static_cast<int>(N)>;
  template <class T>
  using Nodal = std::array<T, N>;
  template <class T>
  struct Motion {
    Nodal<T> from, velocity, to;
  };

  explicit Surface(int points) : quadrature(element_rule<Multilinear<static_cast<int>(D) - 1>>(points)) {}

  static Nodal<double> constant(double value) {
    Nodal<double> result{};
    result.fill(value);
    return result;
  }

  static Nodal<double> wave(double mean, double amplitude, double phase) {
    Nodal<double> result{};
    for (double& value : result) value = mean + amplitude * std::sin(phase += 1.7);
    return result;
  }

  /// Gaps about the equilibrium, repulsive and attractive.
  static Motion<double> motion() { return {wave(0.27, 0.03, 0.0), wave(0.0, 0.04, 1.0), wave(0.26, 0.03, 2.0)}; }

  static Motion<double> still(const Nodal<double>& gap) { return {gap, constant(0.0), gap}; }

  static Motion<Variable> seeded(const Motion<double>& m) {
    Motion<Variable> result{};
    for (std::size_t a = 0; a < N; ++a) {
      result.from[a] = Variable(m.from[a]);
      result.velocity[a] = Variable(m.velocity[a]);
      result.to[a] = test::variable<static_cast<int>(N)>(static_cast<int>(a), m.to[a]);
    }
    return result;
  }

  template <class T>
  std::vector<T> measure() const {
    std::vector<T> result;
    for (double weight : quadrature.weight) result.push_back(T(weight * size / (D == 2 ? 2 : 4)));
    return result;
  }

  template <class T>
  T energy(const Nodal<T>& gap) const {
    const std::vector<T> weights = measure<T>();
    return Kernel::energy(law, quadrature, weights.data(), gap);
  }

  template <class T>
  Nodal<T> force(const Motion<T>& m, const Rule& rule) const {
    const typename Kernel::template Segment<T> segment{&m.from, &m.velocity, &m.to};
    const std::vector<T> weights = measure<T>();
    Nodal<T> f{};
    Kernel::add_force(law, quadrature, weights.data(), segment, rule, f);
    return f;
  }

  Small<double, N> tangent(const Motion<double>& m, const Rule& rule) const {
    const typename Kernel::template Segment<double> segment{&m.from, &m.velocity, &m.to};
    const std::vector<double> weights = measure<double>();
    Small<double, N> k{};
    Kernel::add_tangent(law, quadrature, weights.data(), segment, rule, false, k);
    return k;
  }

  VanDerWaals law{2.5, 25.0};
  double size = 0.7;
  typename Kernel::Table quadrature;
};

template <class S>
class SidePointsTest : public testing::Test {};
using Surfaces = testing::Types<Surface<2>, Surface<3>>;
TYPED_TEST_SUITE(SidePointsTest, Surfaces);

TYPED_TEST(SidePointsTest, ForceIsTheGradientOfTheEnergy) {
  const TypeParam surface(3);
  const auto m = TypeParam::motion();
  const typename TypeParam::Variable energy = surface.energy(TypeParam::seeded(m).to);
  const auto force = surface.force(m, end_rule());
  for (std::size_t a = 0; a < TypeParam::N; ++a) EXPECT_NEAR(force[a], energy.dx(static_cast<int>(a)), 1e-13);
}

TYPED_TEST(SidePointsTest, TangentIsTheDerivativeOfTheForce) {
  const TypeParam surface(3);
  const auto m = TypeParam::motion();
  for (const Rule& rule : {end_rule(), exact_rule(), gauss_rule(3), gauss_rule(3, Path::Kinematic),
                           point_rule({0.0, 0.5, 1.0}, {0.25, 0.5, 0.25}, Path::Kinematic)}) {
    const auto force = surface.force(TypeParam::seeded(m), rule);
    const auto tangent = surface.tangent(m, rule);
    for (std::size_t a = 0; a < TypeParam::N; ++a)
      for (std::size_t b = 0; b < TypeParam::N; ++b)
        EXPECT_NEAR(tangent[a][b], force[a].dx(static_cast<int>(b)), 1e-12) << a << ' ' << b;
  }
}

TYPED_TEST(SidePointsTest, UniformGapGivesTheTractionTimesTheMeasure) {
  const TypeParam surface(2);
  for (double r : {0.2, 0.25, 0.3, 1.0}) {
    const auto gap = TypeParam::constant(r);
    EXPECT_NEAR(surface.energy(gap), surface.law.energy(r) * surface.size, 1e-15);
    // f is the derivative of the energy, against the traction.
    const auto force = surface.force(TypeParam::still(gap), end_rule());
    for (double f : force)
      EXPECT_NEAR(f, -surface.law.traction(r) * surface.size / static_cast<double>(TypeParam::N), 1e-14);
  }
}

TYPED_TEST(SidePointsTest, TiltedSideConvergesToTheIntegralOfTheTraction) {
  // The integral of T = -psi' over gaps that grow evenly from r0 to r1. The pole r = 0 lies 11 half lengths from the
  // middle: a Gauss point gains a factor of up to (11 + sqrt(120))^2 = 482, a pole of order nine takes some of it back.
  const double r0 = 0.25, r1 = 0.3;
  auto gap = TypeParam::constant(r0);
  for (std::size_t a = 0; a < TypeParam::N; ++a)
    if (corners<static_cast<int>(TypeParam::D) - 1>()[a][0] > 0) gap[a] = r1;
  std::vector<double> error;
  for (int n : {1, 2, 4, 8}) {
    const TypeParam surface(n);
    double sum = 0;
    for (double f : surface.force(TypeParam::still(gap), end_rule())) sum += f;
    const double mean = (surface.law.energy(r0) - surface.law.energy(r1)) / (r1 - r0);
    error.push_back(std::abs(sum + mean * surface.size));
  }
  EXPECT_LT(error[1], 0.1 * error[0]);
  EXPECT_LT(error[2], 1e-3 * error[1]);
  EXPECT_LT(error[3], 1e-14);
  EXPECT_GT(error[2], 1e-14);
}

TYPED_TEST(SidePointsTest, WorkOnTheLinearPathIsTheChangeOfTheEnergy) {
  const TypeParam surface(3);
  auto m = TypeParam::motion();
  for (std::size_t a = 0; a < TypeParam::N; ++a) m.to[a] = a % 2 == 0 ? m.from[a] * 1.2 : m.from[a] / 1.2;
  const auto gap_error = [&](const Rule& rule) {
    const auto force = surface.force(m, rule);
    double work = 0;
    for (std::size_t a = 0; a < TypeParam::N; ++a) work += force[a] * (m.to[a] - m.from[a]);
    return std::abs(work - (surface.energy(m.to) - surface.energy(m.from)));
  };
  EXPECT_LT(gap_error(gauss_rule(16)), 1e-12);
  EXPECT_LT(gap_error(exact_rule()), 1e-14);
  // It is the quadrature in time that does it, not the smallness of the step.
  EXPECT_GT(gap_error(gauss_rule(1)), 1e-9);
  EXPECT_GT(gap_error(end_rule()), 1e-6);
}

TYPED_TEST(SidePointsTest, LeastGapIsThatOfTheTimePointsAndTheEnd) {
  const TypeParam surface(2);
  const auto high = TypeParam::constant(0.4), low = TypeParam::constant(0.2), none = TypeParam::constant(0.0);
  const auto least_gap = [&](const auto& from, const auto& to, const Rule& rule) {
    const typename TypeParam::Kernel::template Segment<double> segment{&from, &none, &to};
    const std::vector<double> weights = surface.template measure<double>();
    auto f = none;
    return TypeParam::Kernel::add_force(surface.law, surface.quadrature, weights.data(), segment, rule, f);
  };
  EXPECT_NEAR(least_gap(high, low, end_rule()), 0.2, 1e-15);
  EXPECT_NEAR(least_gap(high, low, point_rule({0.5}, {1.0})), 0.2, 1e-15);
  EXPECT_NEAR(least_gap(low, high, end_rule()), 0.4, 1e-15);
  EXPECT_NEAR(least_gap(low, high, point_rule({0.5, 1.0}, {0.5, 0.5})), 0.3, 1e-15);
}

constexpr double margin = 0.8;
constexpr double near = 0.25;

/// The largest admissible step at the end `to` of a segment; with a velocity the path is kinematic.
template <class S, class Nodal>
double admissible(const S& surface, const Nodal& to, const Nodal& change, const Nodal* velocity = nullptr,
                  const Rule& rule = end_rule()) {
  const typename S::Kernel::template Segment<double> segment{&to, velocity, &to};
  return S::Kernel::largest_step(surface.quadrature, segment, rule, change, margin, near);
}

TYPED_TEST(SidePointsTest, AdmissibleStepIsTheLargestThatKeepsTheMargin) {
  const TypeParam surface(3);
  for (double mean : {0.2, 0.25, 0.35, 1.0})
    for (double phase : {0.0, 0.5, 3.0}) {
      const auto to = TypeParam::wave(mean, 0.1, phase), change = TypeParam::wave(-2.0, 1.5, phase + 4);
      const double step = admissible(surface, to, change);
      ASSERT_GT(step, 0.0);
      ASSERT_LT(step, 1.0);
      double least_room = 1.0;
      for (const auto& shape : surface.quadrature.value) {
        double r = 0, dr = 0;
        for (std::size_t a = 0; a < TypeParam::N; ++a) {
          r += shape[a] * to[a];
          dr += shape[a] * change[a];
        }
        least_room = std::min(least_room, r + step * dr - margin * std::min(r, near));
      }
      EXPECT_NEAR(least_room, 0.0, 1e-14) << mean << ' ' << phase;
    }
}

TYPED_TEST(SidePointsTest, RecedingAndSmallStepsAreWhole) {
  const TypeParam surface(3);
  const auto to = TypeParam::constant(0.3);
  EXPECT_EQ(admissible(surface, to, TypeParam::constant(5.0)), 1.0);
  EXPECT_EQ(admissible(surface, to, TypeParam::constant(0.0)), 1.0);
  EXPECT_EQ(admissible(surface, to, TypeParam::constant(-0.09)), 1.0);
  EXPECT_NEAR(admissible(surface, to, TypeParam::constant(-0.11)), 0.1 / 0.11, 1e-14);
}

TYPED_TEST(SidePointsTest, OneApproachingNodeIsStoppedAtTheNearestQuadraturePoint) {
  const TypeParam surface(2);
  auto change = TypeParam::constant(0.0);
  change[1] = -1.0;
  // The node's shape function at the nearest of 2 Gauss points a direction.
  const double shape = std::pow((1 + 1 / std::sqrt(3.0)) / 2, static_cast<double>(TypeParam::D) - 1);
  EXPECT_NEAR(admissible(surface, TypeParam::constant(0.3), change), (0.3 - margin * near) / shape, 1e-14);
  EXPECT_NEAR(admissible(surface, TypeParam::constant(0.2), change), 0.2 * (1 - margin) / shape, 1e-14);
}

TYPED_TEST(SidePointsTest, KinematicPathsAreCheckedAtTheirTimePoints) {
  const TypeParam surface(2);
  // From 1 to 1 with h v = -2.8: 0.3 half-way, where a change of -1 at the end moves the gap by -1/4.
  const auto one = TypeParam::constant(1.0), change = TypeParam::constant(-1.0), velocity = TypeParam::constant(-2.8);
  const Rule rule = point_rule({0.5, 1.0}, {0.5, 0.5}, Path::Kinematic);
  EXPECT_NEAR(admissible(surface, one, change), 1 - margin * near, 1e-14);
  EXPECT_NEAR(admissible(surface, one, change, &velocity, rule), (0.3 - margin * near) * 4, 1e-14);
  // Without a dip the end decides.
  const auto rest = TypeParam::constant(0.0);
  EXPECT_NEAR(admissible(surface, one, change, &rest, rule), 1 - margin * near, 1e-14);
}

}  // namespace
}  // namespace ixos
