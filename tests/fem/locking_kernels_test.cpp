// The cures of locking: derivatives of one energy, patch test, what they cure and what not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fem/contact_elements.hpp"
#include "fem/enhanced_kernel.hpp"
#include "fem/mean_dilatation_kernel.hpp"
#include "fem/reference_elements.hpp"
#include "material/linear_elastic.hpp"
#include "material/neo_hooke.hpp"
#include "support/automatic_differentiation.hpp"

namespace ixos {
namespace {

/// One element of a kernel, over any scalar type.
template <class ElementType, class KernelType>
struct Body {
  using Element = ElementType;
  using Kernel = KernelType;
  using Law = typename Kernel::Law;
  using Standard = ElasticKernel<Element, Law>;
  static constexpr std::size_t N = Kernel::N;
  static constexpr std::size_t D = Kernel::D;
  static constexpr int dofs = static_cast<int>(N * D);
  using Variable = test::Dual<dofs>;
  template <class T>
  using Nodal = Small<T, N, D>;
  template <class T>
  using Matrix = Small<T, N * D>;

  static const typename Kernel::Table& table() {
    static const typename Kernel::Table values;
    return values;
  }

  /// A block with these edges about the origin; derivative nodes of a Hermite side hold dX/dxi.
  static Nodal<double> block(const std::array<double, D>& edges) {
    const auto corner = corners<static_cast<int>(D)>();
    Nodal<double> x{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d) {
        if (a < corner.size())
          x[a][d] = 0.5 * corner[a][d] * edges[d];
        else if (std::is_same_v<Element, Quad4CH>)
          x[a][d] = d == 0 ? 0.5 * edges[0] : 0.0;
        else
          x[a][d] = edges[d] * (d == 0 ? -0.5 + static_cast<double>(a - 3) / static_cast<double>(N - 3) : -0.5);
      }
    return x;
  }

  static Nodal<double> wave(double amplitude, double phase) {
    Nodal<double> values{};
    for (auto& node : values)
      for (double& value : node) value = amplitude * std::sin(phase += 1.7);
    return values;
  }

  static Nodal<double> distorted() {
    std::array<double, D> edges;
    edges.fill(1.0);
    Nodal<double> x = block(edges);
    const Nodal<double> change = wave(0.1, 0.0);
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d) x[a][d] += change[a][d];
    return x;
  }

  static Nodal<double> affine(const Small<double, D>& h, const Nodal<double>& x) {
    Nodal<double> u{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) u[a][i] += h[i][j] * x[a][j];
    return u;
  }

  template <class T>
  static Nodal<T> constant(const Nodal<double>& values) {
    Nodal<T> result{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d) result[a][d] = T(values[a][d]);
    return result;
  }

  static Nodal<Variable> seeded(const Nodal<double>& values) {
    Nodal<Variable> result{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d)
        result[a][d] = test::variable<dofs>(static_cast<int>(a * D + d), values[a][d]);
    return result;
  }

  template <class T>
  T energy(const Nodal<T>& u) const {
    return Kernel::energy(law, Kernel::geometry(table(), constant<T>(x)), u);
  }

  /// Of a segment from `from` with velocity `velocity`.
  template <class K = Kernel, class T>
  Nodal<T> force(const Nodal<T>& u, const Rule& rule = end_rule()) const {
    const Nodal<T> start = constant<T>(from), rate = constant<T>(velocity);
    Nodal<T> f{};
    K::add_force(law, K::geometry(table(), constant<T>(x)), {&start, &rate, &u}, rule, f);
    return f;
  }

  template <class K = Kernel, class T>
  Matrix<T> tangent(const Nodal<T>& u, const Rule& rule = end_rule()) const {
    const Nodal<T> start = constant<T>(from), rate = constant<T>(velocity);
    Matrix<T> k{};
    K::add_tangent(law, K::geometry(table(), constant<T>(x)), {&start, &rate, &u}, rule, k);
    return k;
  }

  double least_jacobian(const Nodal<double>& u, const Rule& rule = end_rule()) const {
    Nodal<double> f{};
    return Kernel::add_force(law, Kernel::geometry(table(), x), {&from, &velocity, &u}, rule, f);
  }

  Law law{lame_constants(1.0, 0.3)};
  Nodal<double> x = distorted(), from = wave(0.06, 1.0), velocity = wave(0.06, 2.0), to = wave(0.1, 3.0);
};

template <class Element, class Law>
using Mean = Body<Element, MeanDilatationKernel<Element, Law>>;
template <class Element, class Law>
using Modes = Body<Element, EnhancedKernel<Element, Law>>;
template <class Element, class Law>
using Plain = Body<Element, ElasticKernel<Element, Law>>;

std::vector<Rule> rules() {
  return {end_rule(), gauss_rule(3, Path::Linear), gauss_rule(2, Path::Kinematic),
          point_rule({0.0, 1.0}, {0.5, 0.5}, Path::Kinematic)};
}

template <class B>
class LockingKernelsTest : public testing::Test {};
using Bodies =
    testing::Types<Mean<Quad4, NeoHooke>, Mean<Hex8, NeoHooke>, Mean<Quad4, LinearElastic>, Mean<Hex8, LinearElastic>,
                   Mean<Quad4C2, NeoHooke>, Mean<Quad4C3, NeoHooke>, Mean<Quad4CH, NeoHooke>, Modes<Quad4, NeoHooke>,
                   Modes<Hex8, NeoHooke>, Modes<Quad4, LinearElastic>, Modes<Hex8, LinearElastic>>;
TYPED_TEST_SUITE(LockingKernelsTest, Bodies);

TYPED_TEST(LockingKernelsTest, ForceIsTheGradientOfTheEnergy) {
  const TypeParam body{};
  const typename TypeParam::Variable energy = body.energy(TypeParam::seeded(body.to));
  const auto force = body.force(body.to);
  EXPECT_GT(energy.val(), 0.0);
  for (std::size_t r = 0; r < TypeParam::N * TypeParam::D; ++r)
    EXPECT_NEAR(force[r / TypeParam::D][r % TypeParam::D], energy.dx(static_cast<int>(r)), 1e-13) << r;
}

TYPED_TEST(LockingKernelsTest, TangentIsTheSymmetricDerivativeOfTheForce) {
  const TypeParam body{};
  for (const Rule& rule : rules()) {
    const auto force = body.force(TypeParam::seeded(body.to), rule);
    const auto tangent = body.tangent(body.to, rule);
    for (std::size_t r = 0; r < tangent.size(); ++r)
      for (std::size_t c = 0; c < tangent.size(); ++c) {
        const double derivative = force[r / TypeParam::D][r % TypeParam::D].dx(static_cast<int>(c));
        EXPECT_NEAR(tangent[r][c], derivative, 1e-12) << r << ' ' << c << ", " << rule.points.size() << " points";
        EXPECT_NEAR(tangent[r][c], tangent[c][r], 1e-14) << r << ' ' << c;
      }
  }
}

/// The derivative in `t` at 0, by differences of sixth order.
template <class F>
auto slope(const F& f, double h = 2e-3) {
  return (45 * (f(h) - f(-h)) - 9 * (f(2 * h) - f(-2 * h)) + (f(3 * h) - f(-3 * h))) / (60 * h);
}

// Automatic differentiation takes an iteration more for the enhanced modes; differences see what runs see.
TYPED_TEST(LockingKernelsTest, ForceAndTangentAreTheSlopesOfEnergyAndForceAsRunsSeeThem) {
  const TypeParam body{};
  const auto direction = TypeParam::wave(0.3, 5.0);
  const auto moved = [&](double t) {
    auto u = body.to;
    for (std::size_t a = 0; a < TypeParam::N; ++a)
      for (std::size_t d = 0; d < TypeParam::D; ++d) u[a][d] += t * direction[a][d];
    return u;
  };
  const auto power = [&](double t) {
    const auto f = body.force(moved(t));
    double sum = 0;
    for (std::size_t a = 0; a < TypeParam::N; ++a)
      for (std::size_t d = 0; d < TypeParam::D; ++d) sum += f[a][d] * direction[a][d];
    return sum;
  };
  EXPECT_NEAR(power(0), slope([&](double t) { return body.energy(moved(t)); }), 2e-10);
  const auto tangent = body.tangent(body.to);
  double quadratic = 0;
  for (std::size_t r = 0; r < tangent.size(); ++r)
    for (std::size_t c = 0; c < tangent.size(); ++c)
      quadratic +=
          direction[r / TypeParam::D][r % TypeParam::D] * tangent[r][c] * direction[c / TypeParam::D][c % TypeParam::D];
  EXPECT_NEAR(quadratic, slope(power), 2e-9);
}

TYPED_TEST(LockingKernelsTest, HomogeneousStatesOfADistortedElementAreThoseOfTheStandardKernel) {
  TypeParam body{};
  Small<double, TypeParam::D> h{};
  double phase = 0.2;
  for (auto& row : h)
    for (double& value : row) value = 0.2 * std::sin(phase += 1.3);
  const auto u = TypeParam::affine(h, body.x);
  const auto force = body.force(u), expected = body.template force<typename TypeParam::Standard>(u);
  for (std::size_t a = 0; a < TypeParam::N; ++a)
    for (std::size_t d = 0; d < TypeParam::D; ++d) EXPECT_NEAR(force[a][d], expected[a][d], 1e-14);
  const auto geometry = TypeParam::Standard::geometry(TypeParam::table(), body.x);
  EXPECT_NEAR(body.energy(u), TypeParam::Standard::energy(body.law, geometry, u), 1e-14);
  const auto means = TypeParam::Kernel::means(body.law, TypeParam::Kernel::geometry(TypeParam::table(), body.x), u);
  const auto standard = TypeParam::Standard::means(body.law, geometry, u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(means[i], standard[i], 1e-14) << i;
}

TYPED_TEST(LockingKernelsTest, SmallDisplacementsKeepTheirDigits) {
  const TypeParam body{};
  const double size = 1e-9;
  auto u = body.to;
  for (auto& node : u)
    for (double& value : node) value *= size;
  const auto tangent = body.tangent(typename TypeParam::template Nodal<double>{});
  const auto force = body.force(u);
  double quadratic = 0;
  for (std::size_t r = 0; r < tangent.size(); ++r) {
    double expected = 0;
    for (std::size_t c = 0; c < tangent.size(); ++c)
      expected += tangent[r][c] * body.to[c / TypeParam::D][c % TypeParam::D];
    quadratic += 0.5 * expected * body.to[r / TypeParam::D][r % TypeParam::D];
    EXPECT_NEAR(force[r / TypeParam::D][r % TypeParam::D] / size, expected, 1e-8);
  }
  EXPECT_NEAR(body.energy(u) / (size * size), quadratic, 1e-8 * quadratic);
}

TYPED_TEST(LockingKernelsTest, PacksEqualDoublesLaneByLane) {
  const Rule rule = gauss_rule(2, Path::Kinematic);
  using Nodal = typename TypeParam::template Nodal<Pack>;
  Nodal x{}, from{}, velocity{}, to{};
  std::vector<TypeParam> bodies(static_cast<std::size_t>(pack_width));
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    // From small strains to large ones, so that lanes take different numbers of iterations.
    const double phase = 0.9 * static_cast<double>(i);
    bodies[i].from = TypeParam::wave(0.008 * static_cast<double>(i), phase);
    bodies[i].velocity = TypeParam::wave(0.02, phase + 2);
    bodies[i].to = TypeParam::wave(0.008 * static_cast<double>(i), phase + 1);
    for (std::size_t a = 0; a < TypeParam::N; ++a)
      for (std::size_t d = 0; d < TypeParam::D; ++d) {
        x[a][d][i] = bodies[i].x[a][d];
        from[a][d][i] = bodies[i].from[a][d];
        velocity[a][d][i] = bodies[i].velocity[a][d];
        to[a][d][i] = bodies[i].to[a][d];
      }
  }
  const auto geometry = TypeParam::Kernel::geometry(TypeParam::table(), x);
  Nodal force{};
  typename TypeParam::template Matrix<Pack> tangent{};
  const auto law = bodies[0].law;
  const Pack jacobian = TypeParam::Kernel::add_force(law, geometry, {&from, &velocity, &to}, rule, force);
  TypeParam::Kernel::add_tangent(law, geometry, {&from, &velocity, &to}, rule, tangent);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    EXPECT_NEAR(lane(jacobian, i), bodies[i].least_jacobian(bodies[i].to, rule), 1e-13);
    const auto one_force = bodies[i].force(bodies[i].to, rule);
    const auto one_tangent = bodies[i].tangent(bodies[i].to, rule);
    for (std::size_t a = 0; a < TypeParam::N; ++a)
      for (std::size_t d = 0; d < TypeParam::D; ++d) EXPECT_NEAR(lane(force[a][d], i), one_force[a][d], 1e-13);
    for (std::size_t r = 0; r < tangent.size(); ++r)
      for (std::size_t c = 0; c < tangent.size(); ++c) EXPECT_NEAR(lane(tangent[r][c], i), one_tangent[r][c], 1e-12);
  }
}

template <class B>
void expect_no_response_to_rotation() {
  const double c = std::cos(2.0), s = std::sin(2.0);
  Small<double, B::D> rotation{};
  for (std::size_t d = 0; d < B::D; ++d) rotation[d][d] = 1.0;
  rotation[0][0] = rotation[B::D - 1][B::D - 1] = c;
  rotation[0][B::D - 1] = -s;
  rotation[B::D - 1][0] = s;
  const B body{};
  const auto turned = [&](const typename B::template Nodal<double>& u) {
    auto place = body.x;
    for (std::size_t a = 0; a < B::N; ++a)
      for (std::size_t d = 0; d < B::D; ++d) place[a][d] += u[a][d];
    auto result = B::affine(rotation, place);
    for (std::size_t a = 0; a < B::N; ++a)
      for (std::size_t d = 0; d < B::D; ++d) result[a][d] -= body.x[a][d];
    return result;
  };
  const auto rotated = turned({});
  EXPECT_NEAR(body.energy(rotated), 0.0, 1e-14);
  for (const auto& node : body.force(rotated))
    for (double value : node) EXPECT_NEAR(value, 0.0, 1e-14);
  EXPECT_NEAR(body.least_jacobian(rotated), 1.0, 1e-14);
  // A deformation and then the rotation: the forces turn along.
  const auto force = body.force(turned(body.to)), expected = B::affine(rotation, body.force(body.to));
  EXPECT_NEAR(body.energy(turned(body.to)), body.energy(body.to), 1e-14);
  for (std::size_t a = 0; a < B::N; ++a)
    for (std::size_t d = 0; d < B::D; ++d) EXPECT_NEAR(force[a][d], expected[a][d], 1e-14);
}

TEST(LockingTest, RotationsChangeNothing) {
  expect_no_response_to_rotation<Mean<Quad4, NeoHooke>>();
  expect_no_response_to_rotation<Mean<Hex8, NeoHooke>>();
  expect_no_response_to_rotation<Modes<Quad4, NeoHooke>>();
  expect_no_response_to_rotation<Modes<Hex8, NeoHooke>>();
}

/// Eigenvalues of a symmetric matrix in rising order, by Jacobi's rotations.
template <std::size_t M>
std::vector<double> eigenvalues(Small<double, M> k) {
  for (int sweep = 0; sweep < 60; ++sweep)
    for (std::size_t p = 0; p < M; ++p)
      for (std::size_t q = p + 1; q < M; ++q) {
        if (k[p][q] == 0) continue;
        const double theta = (k[q][q] - k[p][p]) / (2 * k[p][q]);
        const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::hypot(theta, 1.0));
        const double c = 1 / std::hypot(t, 1.0), s = t * c;
        for (std::size_t m = 0; m < M; ++m) {
          const double a = k[m][p], b = k[m][q];
          k[m][p] = c * a - s * b;
          k[m][q] = s * a + c * b;
        }
        for (std::size_t m = 0; m < M; ++m) {
          const double a = k[p][m], b = k[q][m];
          k[p][m] = c * a - s * b;
          k[q][m] = s * a + c * b;
        }
      }
  std::vector<double> values;
  for (std::size_t m = 0; m < M; ++m) values.push_back(k[m][m]);
  std::sort(values.begin(), values.end());
  return values;
}

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
  Counts counts;
  for (double value : eigenvalues(body.tangent(typename B::template Nodal<double>{}))) {
    if (std::abs(value) < 1e-8) ++counts.zero;
    if (value > 100) ++counts.stiff;
    EXPECT_GT(value, -1e-8);
  }
  return counts;
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
    // The mean dilatation cures the second, not the first.
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

template <class B>
void expect_refusal_of_inversion() {
  const B body{};
  Small<double, B::D> h{};
  h[0][0] = -2.0;  // a mirror
  EXPECT_LE(body.least_jacobian(B::affine(h, body.x)), 0.0);
  // Points before the end count, and the end that is no point.
  h[0][0] = -1.6;
  B halfway{};
  halfway.from = B::affine(h, body.x);
  EXPECT_NEAR(halfway.least_jacobian({}, point_rule({0.5, 1.0}, {0.5, 0.5})), 0.2, 1e-14);
  EXPECT_LE(halfway.least_jacobian(halfway.from, point_rule({0.5}, {1.0})), 0.0);
  // One corner pushed far inside.
  auto u = typename B::template Nodal<double>{};
  for (std::size_t d = 0; d < B::D; ++d) u[0][d] = -1.5 * body.x[0][d];
  EXPECT_LE(body.least_jacobian(u), 0.0);
}

TEST(LockingTest, InvertedElementsAreRefused) {
  expect_refusal_of_inversion<Mean<Quad4, NeoHooke>>();
  expect_refusal_of_inversion<Mean<Hex8, NeoHooke>>();
  expect_refusal_of_inversion<Modes<Quad4, NeoHooke>>();
  expect_refusal_of_inversion<Modes<Hex8, NeoHooke>>();
}

// Far from incompressible states the modes have no minimum: the element says so instead of giving some number.
TEST(LockingTest, EnhancedElementsThatFindNoMinimumAreRefused) {
  Modes<Hex8, NeoHooke> body{};
  EXPECT_GT(body.least_jacobian(body.to), 0.0);
  body.law = {lame_constants(1.0, 0.4999)};
  EXPECT_LE(body.least_jacobian(body.to), 0.0);
  EXPECT_TRUE(std::isnan(body.energy(body.to)));
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
