/// One element in a finite motion, and what its force and its tangent must be.
#pragma once
#include <gtest/gtest.h>

#include <vector>

#include "element/elastic_kernel.hpp"
#include "element/element_nodes.hpp"
#include "support/displacement_gradients.hpp"

namespace ixos::test {

/// One element of a material in a finite motion, over any scalar type.
template <class Element, class Material>
struct Body : test::ElementNodes<Element> {
  using Kernel = ElasticKernel<Element, Material>;
  using Nodes = test::ElementNodes<Element>;
  using Nodes::D;
  using Nodes::N;
  using typename Nodes::Variable;
  /// Nodes that are points: a Hermite side's others are derivatives, and the forces on them moments.
  static constexpr std::size_t places = IsHermite<Element>::value ? std::size_t{1} << D : N;
  template <class T>
  using Nodal = typename Nodes::template Nodal<T>;
  template <class T>
  struct Motion {
    Nodal<T> x, from, velocity, to;
  };

  Material material{lame_constants(1.0, 0.2)};

  static const typename Kernel::Table& table() {
    static const typename Kernel::Table values;
    return values;
  }

  static int dof(std::size_t a, std::size_t d) { return static_cast<int>(a * D + d); }

  /// A distorted unit square or cube; the phase varies shape and motion.
  static Motion<double> motion(double phase) {
    return {Nodes::distorted(phase), Nodes::wave(0.06, phase + 1), Nodes::wave(0.06, phase + 2),
            Nodes::wave(0.1, phase + 3)};
  }

  /// The motion with the end of the segment as independent variables.
  static Motion<Variable> seeded(const Motion<double>& m) {
    return {Nodes::template constant<Variable>(m.x), Nodes::template constant<Variable>(m.from),
            Nodes::template constant<Variable>(m.velocity), Nodes::seeded(m.to)};
  }

  template <class T>
  T energy(const Motion<T>& m) const {
    return Kernel::energy(material, Kernel::geometry(table(), m.x), m.to);
  }

  template <class T>
  Nodal<T> force(const Motion<T>& m, const Rule& rule) const {
    const typename Kernel::template Segment<T> segment{&m.from, &m.velocity, &m.to};
    Nodal<T> f{};
    Kernel::add_force(material, Kernel::geometry(table(), m.x), segment, rule, f);
    return f;
  }

  double least_jacobian(const Motion<double>& m, const Rule& rule) const {
    const typename Kernel::template Segment<double> segment{&m.from, &m.velocity, &m.to};
    Nodal<double> f{};
    return Kernel::add_force(material, Kernel::geometry(table(), m.x), segment, rule, f);
  }

  template <class T>
  Small<T, N * D> tangent(const Motion<T>& m, const Rule& rule) const {
    const typename Kernel::template Segment<T> segment{&m.from, &m.velocity, &m.to};
    Small<T, N * D> k{};
    Kernel::add_tangent(material, Kernel::geometry(table(), m.x), segment, rule, k);
    return k;
  }
};

inline std::vector<Rule> rules() {
  std::vector<Rule> result{end_rule()};
  for (Path path : {Path::Linear, Path::Kinematic}) {
    result.push_back(point_rule({0.0, 1.0}, {0.5, 0.5}, path));
    result.push_back(gauss_rule(4, path));
  }
  return result;
}

/// The force is the derivative of the energy, by automatic differentiation.
template <class B>
void expect_force_is_gradient() {
  const B body{};
  const auto m = B::motion(0.0);
  const typename B::Variable energy = body.energy(B::seeded(m));
  const auto force = body.force(m, end_rule());
  EXPECT_GT(energy.val(), 0.0);
  for (std::size_t a = 0; a < B::N; ++a)
    for (std::size_t d = 0; d < B::D; ++d) EXPECT_NEAR(force[a][d], energy.dx(B::dof(a, d)), 1e-13) << a << ' ' << d;
}

/// The tangent is the derivative of the force, and symmetric.
template <class B>
void expect_tangent_is_derivative() {
  const B body{};
  const auto m = B::motion(0.0);
  for (const Rule& rule : rules()) {
    const auto force = body.force(B::seeded(m), rule);
    const auto tangent = body.tangent(m, rule);
    for (std::size_t r = 0; r < tangent.size(); ++r)
      for (std::size_t c = 0; c < tangent.size(); ++c) {
        const double derivative = force[r / B::D][r % B::D].dx(static_cast<int>(c));
        EXPECT_NEAR(tangent[r][c], derivative, 1e-13) << r << ' ' << c << ", " << rule.points.size() << " points";
        EXPECT_NEAR(tangent[r][c], tangent[c][r], 1e-14) << r << ' ' << c;
      }
  }
}

/// The discrete gradient does the work of the energy, and its tangent is its derivative.
template <class B>
void expect_discrete_gradient() {
  const B body{};
  const auto m = B::motion(0.0);
  const Rule rule = discrete_gradient_rule();
  const auto force = body.force(m, rule);
  double work = 0;
  for (std::size_t a = 0; a < B::N; ++a)
    for (std::size_t d = 0; d < B::D; ++d) work += force[a][d] * (m.to[a][d] - m.from[a][d]);
  auto start = m;
  start.to = m.from;
  EXPECT_NEAR(work, body.energy(m) - body.energy(start), 1e-13);
  const auto derivative = body.force(B::seeded(m), rule);
  const auto tangent = body.tangent(m, rule);
  for (std::size_t r = 0; r < tangent.size(); ++r)
    for (std::size_t c = 0; c < tangent.size(); ++c)
      EXPECT_NEAR(tangent[r][c], derivative[r / B::D][r % B::D].dx(static_cast<int>(c)), 1e-13);
}

}  // namespace ixos::test
