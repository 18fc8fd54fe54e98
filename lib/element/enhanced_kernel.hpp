/// A cure of shear locking in bending, and of most volumetric locking, that derives from an energy: enhanced modes.
#pragma once
#include <limits>
#include <type_traits>

#include "base/ldl.hpp"
#include "element/elastic_kernel.hpp"

namespace ixos {

/// The energy of the displacement alone W(u) = min over alpha of int W(grad u + sum_d alpha_d (x) g_d) dV, with D^2
/// enhanced (incompatible) modes, the gradients of (1 - xi_d^2)/2 with the Jacobian of the centre,
///   g_d = -xi_d det J0/det J J0^-T e_d
/// (Wilson's modes as corrected by Taylor, Beresford and Wilson 1976; Simo and Rifai 1990; Q1/E4 and Q1/E9 of Simo and
/// Armero 1992). int g_d dV = 0, so that homogeneous states have alpha = 0: the patch test. alpha_d are vectors in
/// space, so the energy is objective.
///
/// alpha is computed anew at each evaluation, by Newton's method from 0 to roundoff: the kernel has no state, and
/// checkpoints need none. The force, the partial derivative at that alpha, is the gradient of W(u); the tangent is
/// condensed. If the iteration fails, or alpha is not a minimum (condensation would be indefinite), the displacement is
/// inadmissible: the least J is at most 0, the energy NaN.
///
/// Known weaknesses: a square or cube squeezed to 0.6 to 0.7 of its height buckles into an hourglass (Wriggers and
/// Reese 1996). If the law is nearly incompressible and u far from incompressible, the iteration for alpha fails:
/// beyond nu = 0.499 Newton's iteration for u may break down at finite strains. Hexahedra keep four volumetric
/// constraints instead of one, see MeanDilatationKernel. One quadrature point does not see the modes: two a direction
/// are needed at least. If the end of a segment is no time point, J there is that of the displacement without modes.
template <class Element, class Material>
struct EnhancedKernel : ElasticKernel<Element, Material> {
  using Base = ElasticKernel<Element, Material>;
  static constexpr std::size_t D = Base::D;
  static constexpr std::size_t N = Base::N;
  static_assert(N == std::size_t{1} << D, "multilinear elements only");
  static constexpr bool has_discrete_gradient = false;
  static constexpr bool keeps_points = false;
  /// Newton iterations for alpha; it takes 2 to 5 at moderate pressures.
  static constexpr int maximum_iterations = 20;

  using Table = typename Base::Table;
  template <class T>
  using Nodal = typename Base::template Nodal<T>;
  template <class T>
  using Tangent = typename Base::template Tangent<T>;
  template <class T>
  using Segment = typename Base::template Segment<T>;

  template <class T>
  struct Geometry : Base::template Geometry<T> {
    Small<T, D> center;  ///< det J0 J0^-1, [d][J]
  };

  /// See ElasticKernel::geometry().
  template <class T>
  static Geometry<T> geometry(const Table& table, const Nodal<T>& x) {
    std::array<double, N> value;
    std::array<std::array<double, D>, N> slope;
    Element::evaluate({}, value, slope);
    const Small<T, D> jacobian = Base::gradient(x, slope);
    const T det = determinant(jacobian);
    Geometry<T> result{Base::geometry(table, x), inverse(jacobian, det)};
    for (auto& row : result.center)
      for (T& entry : row) entry *= det;
    return result;
  }

  /// Returns the stored energy [E0 L0^D].
  template <class T>
  static T energy(const Material& material, const Geometry<T>& geometry, const Nodal<T>& u) {
    const Relaxed<T> state(material, geometry, u);
    T sum(0.0);
    for (std::size_t q = 0; q < geometry.points.size(); ++q)
      sum += geometry.points[q].weight * material.energy(state.gradient[q]);
    return select(state.found > 0.0, sum, T(std::numeric_limits<double>::quiet_NaN()));
  }

  /// See ElasticKernel::mean(). H includes the enhanced modes.
  template <class T, class Value>
  static auto mean(const Material& material, const Geometry<T>& geometry, const Nodal<T>& u, const Value& value) {
    const Relaxed<T> state(material, geometry, u);
    return mean_over_points(
        geometry.points, [&](std::size_t q) -> const Small<T, D>& { return state.gradient[q]; }, value);
  }

  /// Adds the rule's force to f. Returns the least J of the time points and of the segment's end, lane by lane; 0 in
  /// lanes in which the iteration for alpha failed.
  template <class T>
  static T add_force(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment, const Rule& rule,
                     Nodal<T>& f) {
    T least_jacobian(1e300);
    for (const RulePoint& point : rule.points) {
      const Relaxed<T> state(material, geometry, at(segment, point));
      for (std::size_t q = 0; q < geometry.points.size(); ++q) {
        const Nodal<T> dn = Base::shape_gradients(geometry, q);
        Small<T, D> p;
        least_jacobian = smaller(least_jacobian, material.stress(state.gradient[q], p));
        const T w = point.weight * geometry.points[q].weight;
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t j = 0; j < D; ++j) p[i][j] *= w;
        for (std::size_t a = 0; a < N; ++a)
          for (std::size_t i = 0; i < D; ++i)
            for (std::size_t j = 0; j < D; ++j) f[a][i] += p[i][j] * dn[a][j];
      }
      least_jacobian = select(state.found > 0.0, least_jacobian, smaller(least_jacobian, T(0.0)));
    }
    if constexpr (Material::can_invert)
      for (std::size_t q = 0; q < geometry.points.size(); ++q) {
        const typename Base::template Ends<T> ends(segment, Base::shape_gradients(geometry, q));
        least_jacobian = smaller(least_jacobian, ends.jacobian());
      }
    return least_jacobian;
  }

  /// Adds the rule's tangent dF/du_s to k: K_uu - K_ua K_aa^-1 K_au of each time point.
  template <class T>
  static void add_tangent(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment,
                          const Rule& rule, Tangent<T>& k) {
    for (const RulePoint& point : rule.points) {
      const Relaxed<T> state(material, geometry, at(segment, point));
      const double factor = point.weight * point.to;
      Small<T, D * D> inner{};         // K_aa
      Small<T, N * D, D * D> mixed{};  // K_ua
      for (std::size_t q = 0; q < geometry.points.size(); ++q) {
        const Nodal<T> dn = Base::shape_gradients(geometry, q);
        const Small<T, D> modes = mode_gradients(geometry, q);
        Small<T, D> p;
        Small<T, D * D> moduli;
        material.stress_and_moduli(state.gradient[q], p, moduli);
        const T w = factor * geometry.points[q].weight;
        for (auto& row : moduli)
          for (T& value : row) value *= w;
        add_contraction<true>(dn, dn, moduli, k);
        add_contraction<true>(modes, modes, moduli, inner);
        add_contraction<false>(dn, modes, moduli, mixed);
      }
      // Both blocks carry the factor, so one factor of it remains.
      const Ldl<T, D * D> ldl(inner);
      for (auto& row : mixed) ldl.forward(row);
      for (std::size_t r = 0; r < N * D; ++r) {
        std::array<T, D* D> scaled = mixed[r];
        for (std::size_t m = 0; m < D * D; ++m) scaled[m] *= ldl.inverse_pivot(m);
        for (std::size_t c = 0; c <= r; ++c) {
          T value = scaled[0] * mixed[c][0];
          for (std::size_t m = 1; m < D * D; ++m) value += scaled[m] * mixed[c][m];
          k[r][c] -= value;
          if (c < r) k[c][r] -= value;
        }
      }
    }
  }

 private:
  /// The displacement gradients at the quadrature points, with the modes that minimise the energy.
  template <class T>
  struct Relaxed {
    Relaxed(const Material& material, const Geometry<T>& geometry, const Nodal<T>& u)
        : gradient(geometry.points.size()), found(0.0) {
      for (std::size_t q = 0; q < gradient.size(); ++q)
        gradient[q] = Base::gradient(u, Base::shape_gradients(geometry, q));
      // Derivatives carried by the scalar type lag one iteration behind the values.
      int more = std::is_same_v<T, double> || std::is_same_v<T, Pack> ? 0 : 1;
      T done(0.0);
      for (int iteration = 0; iteration < maximum_iterations; ++iteration) {
        iterate(material, geometry, done);
        if (least(done) > 0 && more-- == 0) break;
      }
    }

    std::vector<Small<T, D>> gradient;
    T found;  ///< 1 if the iteration ended at a minimum, else 0

   private:
    /// Takes one Newton step in the lanes that are not done; a lane is done when rounding would swallow its next step.
    void iterate(const Material& material, const Geometry<T>& geometry, T& done) {
      std::array<T, D * D> step{};
      Small<T, D * D> tangent{};
      T size(0.0);  // of the gradients, squared
      for (std::size_t q = 0; q < gradient.size(); ++q) {
        const Small<T, D> modes = mode_gradients(geometry, q);
        Small<T, D> p;
        Small<T, D * D> moduli;
        material.stress_and_moduli(gradient[q], p, moduli);
        const T& w = geometry.points[q].weight;
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t j = 0; j < D; ++j) {
            const T weighted = w * p[i][j];
            for (std::size_t d = 0; d < D; ++d) step[d * D + i] -= weighted * modes[d][j];
            size += gradient[q][i][j] * gradient[q][i][j];
          }
        for (auto& row : moduli)
          for (T& value : row) value *= w;
        add_contraction<true>(modes, modes, moduli, tangent);
      }
      const Ldl<T, D * D> ldl(tangent);
      ldl.solve(step);
      constexpr bool plain = std::is_same_v<T, double> || std::is_same_v<T, Pack>;
      if constexpr (plain)
        for (T& value : step) value = select(done > 0.0, T(0.0), value);
      T change(0.0);  // of the gradients, squared
      for (std::size_t q = 0; q < gradient.size(); ++q) {
        const Small<T, D> modes = mode_gradients(geometry, q);
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t j = 0; j < D; ++j) {
            T value = step[i] * modes[0][j];
            for (std::size_t d = 1; d < D; ++d) value += step[d * D + i] * modes[d][j];
            gradient[q][i][j] += value;
            change += value * value;
          }
      }
      // Newton's next step would be C change, C of the order of 10, against rounding of 1e-16 sqrt(size).
      const auto small = change * change <= 1e-36 * size || change <= 1e-20 * size;
      const T minimum = select(ldl.least_pivot() > 0.0, T(1.0), T(0.0));
      found = select(done > 0.0, found, select(small, minimum, T(0.0)));
      done = select(small, T(1.0), done);
    }
  };

  /// Returns g_d at point q, [d][J].
  template <class T>
  static Small<T, D> mode_gradients(const Geometry<T>& geometry, std::size_t q) {
    // weight = table weight times det J.
    const T inverse_det = geometry.table->weight[q] / geometry.points[q].weight;
    Small<T, D> modes = geometry.center;
    for (std::size_t d = 0; d < D; ++d)
      for (std::size_t j = 0; j < D; ++j) modes[d][j] *= -geometry.table->point[q][d] * inverse_det;
    return modes;
  }

  /// Returns the displacement at a time point.
  template <class T>
  static Nodal<T> at(const Segment<T>& segment, const RulePoint& point) {
    Nodal<T> u = *segment.to;
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t i = 0; i < D; ++i) {
        u[a][i] *= point.to;
        if (segment.from != nullptr) u[a][i] += point.from * (*segment.from)[a][i];
        if (segment.velocity != nullptr) u[a][i] += point.velocity * (*segment.velocity)[a][i];
      }
    return u;
  }
};

}  // namespace ixos
