/// A cure of shear locking in bending, and of most volumetric locking, that derives from an energy: enhanced modes.
#pragma once
#include <limits>
#include <type_traits>

#include "base/ldl.hpp"
#include "element/elastic_kernel.hpp"
#include "material/revolved_law.hpp"

namespace ixos {

/// The energy of the displacement alone W(u) = min over alpha of int W(grad u + sum_d alpha_d (x) g_d) dV, with D^2
/// enhanced (incompatible) modes, the gradients of (1 - xi_d^2)/2 with the Jacobian of the centre,
///   g_d = -xi_d det J0/det J J0^-T e_d
/// (Wilson's modes as corrected by Taylor, Beresford and Wilson 1976; Simo and Rifai 1990; Q1/E4 and Q1/E9 of Simo and
/// Armero 1992). int g_d dV = 0, so that homogeneous states have alpha = 0: the patch test. alpha_d are vectors in
/// space, so the energy is objective. In a ring, g_d has also the factor R0/R, R0 constant, and there is no mode of the
/// hoop strain.
///
/// alpha is computed anew at each evaluation, by Newton's method to roundoff, from 0 if the law admits that: the kernel
/// has no state, and checkpoints need none. The force, the partial derivative at that alpha, is the gradient of W(u);
/// the tangent is condensed. If the iteration fails, or alpha is not a minimum (condensation would be indefinite), the
/// displacement is inadmissible: the least J is at most 0, the energy NaN.
///
/// Known weaknesses: a square or cube squeezed to 0.6 to 0.7 of its height buckles into an hourglass (Wriggers and
/// Reese 1996). If the law is nearly incompressible and u far from incompressible, the iteration for alpha fails:
/// beyond nu = 0.499 Newton's iteration for u may break down at finite strains. Hexahedra keep four volumetric
/// constraints instead of one, see MeanDilatationKernel. One quadrature point does not see the modes: two a direction
/// are needed at least. At the end of a segment, J is also that of the displacement without modes; a law's limit is
/// checked with the modes.
template <class Element, class Material>
struct EnhancedKernel : ElasticKernel<Element, Material> {
  using Base = ElasticKernel<Element, Material>;
  static constexpr std::size_t D = Base::D;
  static constexpr std::size_t N = Base::N;
  static constexpr std::size_t G = Base::G;
  static constexpr std::size_t C = Base::C;
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
  using Gradients = typename Base::template Gradients<T>;

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
        geometry.points, [&](std::size_t q) -> const Small<T, G>& { return state.gradient[q]; }, value);
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
        const Gradients<T> dn = Base::shape_gradients(geometry, q);
        Small<T, G> p;
        least_jacobian = smaller(least_jacobian, material.stress(state.gradient[q], p));
        const T w = point.weight * geometry.points[q].weight;
        for (std::size_t i = 0; i < G; ++i)
          for (std::size_t j = 0; j < G; ++j) p[i][j] *= w;
        add_nodal_forces(p, dn, f);
      }
      least_jacobian = select(state.found > 0.0, least_jacobian, smaller(least_jacobian, T(0.0)));
    }
    if constexpr (Material::can_invert)
      for (std::size_t q = 0; q < geometry.points.size(); ++q) {
        const typename Base::template Ends<T> ends(segment, Base::shape_gradients(geometry, q));
        least_jacobian = smaller(least_jacobian, ends.jacobian());
      }
    if constexpr (Material::has_limit)
      if (material.is_limited() && !rule.has_end())
        least_jacobian = smaller(least_jacobian, end_admissibility(material, geometry, segment));
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
        const Gradients<T> dn = Base::shape_gradients(geometry, q);
        const Small<T, D> modes = mode_gradients(geometry, q);
        Small<T, G> p;
        Small<T, C> moduli;
        material.stress_and_moduli(state.gradient[q], p, moduli);
        const T w = factor * geometry.points[q].weight;
        for (auto& row : moduli)
          for (T& value : row) value *= w;
        add_contraction<true>(dn, dn, moduli, k);
        add_contraction<true>(as_nodes(modes), as_nodes(modes), moduli, inner);
        add_contraction<false>(dn, as_nodes(modes), moduli, mixed);
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
  using StartLaw = std::conditional_t<Base::revolved, RevolvedLaw<NeoHooke>, NeoHooke>;

  /// The displacement gradients at the quadrature points, with the modes that minimise the energy.
  template <class T>
  struct Relaxed {
    Relaxed(const Material& material, const Geometry<T>& geometry, const Nodal<T>& u)
        : gradient(geometry.points.size()), found(0.0) {
      for (std::size_t q = 0; q < gradient.size(); ++q)
        gradient[q] = Base::gradient(u, Base::shape_gradients(geometry, q));
      if constexpr (Material::has_limit)
        if (material.is_limited()) start_within_limit(material, geometry);
      // Derivatives carried by the scalar type lag one iteration behind the values.
      int more = std::is_same_v<T, double> || std::is_same_v<T, Pack> ? 0 : 1;
      T done(0.0);
      for (int iteration = 0; iteration < maximum_iterations; ++iteration) {
        iterate(material, geometry, done);
        if (least(done) > 0 && more-- == 0) break;
      }
    }

    std::vector<Small<T, G>> gradient;
    T found;  ///< 1 if the iteration ended at a minimum, else 0

   private:
    /// Without modes a bent element may lie beyond the law's limit, where Newton's method fails. Such lanes start from
    /// the modes of the neo-Hookean law with the same constants, which has no limit.
    void start_within_limit(const Material& material, const Geometry<T>& geometry) {
      const std::vector<Small<T, G>> plain = gradient;
      T room(1e300);
      for (const Small<T, G>& h : plain) room = smaller(room, material.admissibility(h));
      if (least(room) > 0) return;
      const StartLaw start(NeoHooke{material.lame});
      T done(0.0);
      for (int iteration = 0; iteration < maximum_iterations && !(least(done) > 0); ++iteration)
        iterate(start, geometry, done);
      for (std::size_t q = 0; q < gradient.size(); ++q)
        for (std::size_t i = 0; i < G; ++i)
          for (std::size_t j = 0; j < G; ++j) gradient[q][i][j] = select(room > 0.0, plain[q][i][j], gradient[q][i][j]);
    }

    /// Takes one Newton step in the lanes that are not done; a lane is done when rounding would swallow its next step.
    template <class Law>
    void iterate(const Law& material, const Geometry<T>& geometry, T& done) {
      std::array<T, D * D> step{};
      Small<T, D * D> tangent{};
      T size(0.0);  // of the gradients, squared
      for (std::size_t q = 0; q < gradient.size(); ++q) {
        const Small<T, D> modes = mode_gradients(geometry, q);
        Small<T, G> p;
        Small<T, C> moduli;
        material.stress_and_moduli(gradient[q], p, moduli);
        const T& w = geometry.points[q].weight;
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t j = 0; j < D; ++j) {
            const T weighted = w * p[i][j];
            for (std::size_t d = 0; d < D; ++d) step[d * D + i] -= weighted * modes[d][j];
            size += gradient[q][i][j] * gradient[q][i][j];
          }
        if constexpr (Base::revolved) size += gradient[q][2][2] * gradient[q][2][2];
        for (auto& row : moduli)
          for (T& value : row) value *= w;
        add_contraction<true>(as_nodes(modes), as_nodes(modes), moduli, tangent);
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

  /// Returns the least admissibility at the end of the segment, modes included; 0 in lanes in which the iteration for
  /// alpha failed.
  template <class T>
  static T end_admissibility(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment) {
    const Relaxed<T> state(material, geometry, *segment.to);
    T result(1e300);
    for (const Small<T, G>& h : state.gradient) result = smaller(result, material.admissibility(h));
    return select(state.found > 0.0, result, smaller(result, T(0.0)));
  }

  /// Returns the modes as shape gradients of nodes, in a ring without hoop strain.
  template <class T>
  [[gnu::always_inline]] static decltype(auto) as_nodes(const Small<T, D>& modes) {
    if constexpr (Base::revolved)
      return RevolvedGradients<T, D>{modes, {}};
    else
      return (modes);
  }

  /// Returns g_d at point q, [d][J].
  template <class T>
  static Small<T, D> mode_gradients(const Geometry<T>& geometry, std::size_t q) {
    // weight = table weight times det J, and 2 pi R of a ring.
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
