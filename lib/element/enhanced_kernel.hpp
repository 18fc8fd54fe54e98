/// A remedy for shear locking in bending, and of most volumetric locking, that derives from an energy: enhanced modes.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

#include "base/ldl.hpp"
#include "base/scratch.hpp"
#include "element/cell_kernel.hpp"
#include "element/kernel_law.hpp"
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
struct EnhancedKernel : CellKernel<Element> {
  using Base = CellKernel<Element>;
  using Law = Material;
  using Base::D;
  using Base::G;
  using Base::N;
  using typename Base::Space;
  static constexpr std::size_t C = Base::C;
  static_assert(N == std::size_t{1} << D, "multilinear elements only");
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

  /// See CellKernel::geometry().
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

  /// Computes the displacement gradients that the law sees at the points, with the enhanced modes. Returns 1 in lanes
  /// where it sees some, else 0.
  template <class T>
  static T seen(const Material& material, const Geometry<T>& geometry, const Nodal<T>& u, std::vector<Small<T, G>>& h) {
    const Relaxed<T> state(material, geometry, u);
    h.assign(state.gradient.begin(), state.gradient.end());
    return state.found;
  }

  /// Returns the stored energy [E0 L0^D].
  template <class T>
  static T energy(const Material& material, const Geometry<T>& geometry, const Nodal<T>& u) {
    return energy_of<EnhancedKernel>(material, geometry, u);
  }

  /// Adds the rule's force to f. Returns the least J of the time points and of the segment's end, lane by lane; 0 in
  /// lanes in which the iteration for alpha failed.
  template <class T>
  static T add_force(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment, const Rule& rule,
                     Nodal<T>& f) {
    const auto& law = law_in<Space>(material);
    const std::size_t size = geometry.points.size();
    T least_jacobian(1e300);
    AtPoints<Small<T, G>> p(size);
    AtPoints<T> admissible(size);
    for (const RulePoint& point : rule.points) {
      const Relaxed<T> state(material, geometry, at(segment, point));
      law.stress(size, state.gradient.data(), p.data(), admissible.data());
      for (std::size_t q = 0; q < size; ++q) {
        least_jacobian = smaller(least_jacobian, admissible[q]);
        const T w = point.weight * geometry.points[q].weight;
        for (std::size_t i = 0; i < G; ++i)
          for (std::size_t j = 0; j < G; ++j) p[q][i][j] *= w;
        add_nodal_forces(p[q], Base::shape_gradients(geometry, q), f);
      }
      least_jacobian = select(state.found > 0.0, least_jacobian, smaller(least_jacobian, T(0.0)));
    }
    if (law.can_invert())
      for (std::size_t q = 0; q < size; ++q)
        least_jacobian =
            smaller(least_jacobian,
                    determinant(deformation_gradient(Base::gradient(*segment.to, Base::shape_gradients(geometry, q)))));
    if (law.is_limited() && !rule.has_end())
      least_jacobian = smaller(least_jacobian, admissibility_of<EnhancedKernel>(material, geometry, *segment.to));
    return least_jacobian;
  }

  /// Adds the rule's tangent dF/du_s to k: K_uu - K_ua K_aa^-1 K_au of each time point.
  template <class T>
  static void add_tangent(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment,
                          const Rule& rule, Tangent<T>& k) {
    const std::size_t size = geometry.points.size();
    AtPoints<Small<T, G>> p(size);
    AtPoints<Small<T, C>> all(size);
    for (const RulePoint& point : rule.points) {
      const Relaxed<T> state(material, geometry, at(segment, point));
      law_in<Space>(material).stress_and_space_moduli(size, state.gradient.data(), p.data(), all.data());
      const double factor = point.weight * point.to;
      Small<T, D * D> inner{};         // K_aa
      Small<T, N * D, D * D> mixed{};  // K_ua
      for (std::size_t q = 0; q < geometry.points.size(); ++q) {
        const Gradients<T> dn = Base::shape_gradients(geometry, q);
        const Small<T, D> modes = mode_gradients(geometry, q);
        Small<T, C>& moduli = all[q];
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
  /// Numbers at the quadrature points: two a direction as a rule.
  template <class T>
  using AtPoints = Scratch<T, N>;
  using StartLaw = std::conditional_t<Base::revolved, RevolvedLaw<NeoHooke>, NeoHooke>;

  /// The displacement gradients at the quadrature points, with the modes that minimise the energy.
  template <class T>
  struct Relaxed {
    Relaxed(const Material& material, const Geometry<T>& geometry, const Nodal<T>& u)
        : gradient(geometry.points.size()), found(0.0) {
      for (std::size_t q = 0; q < gradient.size(); ++q)
        gradient[q] = Base::gradient(u, Base::shape_gradients(geometry, q));
      const auto& law = law_in<Space>(material);
      if (law.is_limited()) start_within_limit(law, material.lame, geometry);
      // Derivatives carried by the scalar type lag one iteration behind the values.
      int more = std::is_same_v<T, double> || std::is_same_v<T, Pack> ? 0 : 1;
      T done(0.0);
      for (int iteration = 0; iteration < maximum_iterations; ++iteration) {
        iterate(law, geometry, done);
        if (least(done) > 0 && more-- == 0) break;
      }
    }

    AtPoints<Small<T, G>> gradient;
    T found;  ///< 1 if the iteration ended at a minimum, else 0

   private:
    /// Without modes a bent element may lie beyond the law's limit, where Newton's method fails. Such lanes start from
    /// the modes of the neo-Hookean law with the same constants, which has no limit.
    template <class Points>
    void start_within_limit(const Points& law, const Lame& lame, const Geometry<T>& geometry) {
      AtPoints<Small<T, G>> plain(gradient.size());
      std::copy_n(gradient.data(), gradient.size(), plain.data());
      T room(1e300);
      for (const Small<T, G>& h : plain) room = smaller(room, law.admissibility(h));
      if (least(room) > 0) return;
      const StartLaw start_law(NeoHooke{lame});
      const LawPoints<StartLaw, Space> start(start_law);
      T done(0.0);
      for (int iteration = 0; iteration < maximum_iterations && !(least(done) > 0); ++iteration)
        iterate(start, geometry, done);
      for (std::size_t q = 0; q < gradient.size(); ++q)
        for (std::size_t i = 0; i < G; ++i)
          for (std::size_t j = 0; j < G; ++j) gradient[q][i][j] = select(room > 0.0, plain[q][i][j], gradient[q][i][j]);
    }

    /// Takes one Newton step in the lanes that are not done; a lane is done when rounding would swallow its next step.
    template <class Points>
    void iterate(const Points& law, const Geometry<T>& geometry, T& done) {
      constexpr std::size_t at_once = 4;  // their moduli stay in the cache
      std::array<Small<T, G>, at_once> stress;
      std::array<Small<T, C>, at_once> moduli_of;
      std::array<T, D * D> step{};
      Small<T, D * D> tangent{};
      T size(0.0);  // of the gradients, squared
      for (std::size_t first = 0; first < gradient.size(); first += at_once) {
        const std::size_t count = std::min(at_once, gradient.size() - first);
        law.stress_and_space_moduli(count, gradient.data() + first, stress.data(), moduli_of.data());
        for (std::size_t k = 0; k < count; ++k) {
          const std::size_t q = first + k;
          const Small<T, D> modes = mode_gradients(geometry, q);
          const Small<T, G>& p = stress[k];
          Small<T, C>& moduli = moduli_of[k];
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
