/// A remedy for volumetric locking for quadratic cells that derives from an energy: a linear field of the volume
/// change.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "element/cell_kernel.hpp"
#include "element/kernel_law.hpp"
#include "element/linear_projection.hpp"
#include "element/mean_dilatation_kernel.hpp"
#include "element/mean_dilatation_point.hpp"
#include "element/point_gradients.hpp"
#include "fem/quadratic_contact_elements.hpp"
#include "material/meridian_moduli.hpp"
#include "material/volume_excess.hpp"

namespace ixos {

/// The energy int W(F~) dV of the displacement alone, with F~ = exp((Pi l - l)/D) F, l = ln J and Pi the projection on
/// linear functions of the reference position (LinearProjection). An element has 1 + D volumetric constraints. With
/// products of quadratic functions this is the pair of Crouzeix and Raviart (1973), which is stable and of second order
/// in the stress; an enriched side only adds displacements. One constraint, as in MeanDilatationKernel, would leave
/// quadratic elements modes without energy: F of a conformal map, such as u = ((x^2 - y^2)/2, xy), is a multiple of a
/// rotation, and the mean alone does not see the multiple where it varies.
///
/// l rather than J, for Pi J may be negative where all J are positive. With P~ = dW/dF~, s = exp((Pi l - l)/D) and the
/// mean Kirchhoff stress p = P~:F~/D, the stress is P = s P~ + (Pi p - p) F^-T, as Pi is symmetric in the integral.
///
/// Plane strain, rings and linear laws (l becomes tr H) are as in MeanDilatationKernel, and so are homogeneous states.
/// The weights of a ring include 2 pi R. The kernel has no discrete gradient.
template <class Element, class Material>
struct ProjectedDilatationKernel : CellKernel<Element> {
  using Base = CellKernel<Element>;
  using Law = Material;
  using Base::D;
  using Base::G;
  using Base::N;
  using typename Base::Space;
  static constexpr std::size_t C = Base::C;

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
    LinearProjection<T, D> projection;
  };

  /// See CellKernel::geometry().
  template <class T>
  static Geometry<T> geometry(const Table& table, const Nodal<T>& x) {
    const auto plain = Base::geometry(table, x);
    std::vector<std::array<T, D>> places(table.size());
    for (std::size_t q = 0; q < table.size(); ++q)
      for (std::size_t d = 0; d < D; ++d) {
        T sum = x[0][d] * table.value[q][0];
        for (std::size_t a = 1; a < N; ++a) sum += x[a][d] * table.value[q][a];
        places[q][d] = sum;
      }
    return {plain, LinearProjection<T, D>(plain.points, places)};
  }

  /// See EnhancedKernel::seen(). H is H~.
  template <class T>
  static T seen(const Material& material, const Geometry<T>& geometry, const Nodal<T>& u, std::vector<Small<T, G>>& h) {
    const Rule end = end_rule();
    const States<T> states(law_in<Space>(material).can_invert(), geometry, {nullptr, nullptr, &u}, end);
    h.resize(states.size);
    for (std::size_t q = 0; q < states.size; ++q) h[q] = states.at(q, 0).scaled;
    return T(1.0);
  }

  /// Returns the stored energy [E0 L0^D].
  template <class T>
  static T energy(const Material& material, const Geometry<T>& geometry, const Nodal<T>& u) {
    return energy_of<ProjectedDilatationKernel>(material, geometry, u);
  }

  /// Adds the rule's force to f. Returns the least J of the time points and of the segment's end, lane by lane.
  template <class T>
  static T add_force(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment, const Rule& rule,
                     Nodal<T>& f) {
    const auto& law = law_in<Space>(material);
    const States<T> states(law.can_invert(), geometry, segment, rule);
    T least_jacobian = states.least_jacobian;
    if (law.is_limited() && !rule.has_end())
      least_jacobian =
          smaller(least_jacobian, admissibility_of<ProjectedDilatationKernel>(material, geometry, *segment.to));
    const std::size_t size = states.size;
    std::vector<Small<T, G>> sums(size, Small<T, G>{}), inverses(size);
    std::vector<T> pressures(size), projected(size);
    for (std::size_t k = 0; k < rule.points.size(); ++k) {
      const double share = rule.points[k].weight;
      for_each_stress(law, states, k, [&](std::size_t q, const State<T>& s, const Small<T, G>& p, const T& admissible) {
        if (law.is_limited()) least_jacobian = smaller(least_jacobian, admissible);
        pressures[q] = s.product(p) * (1.0 / G);
        inverses[q] = s.inverse;
        const T factor = share * s.scale;
        for (std::size_t i = 0; i < G; ++i)
          for (std::size_t j = 0; j < G; ++j) sums[q][i][j] += factor * p[i][j];
      });
      geometry.projection.project(geometry.points, pressures.data(), projected.data());
      for (std::size_t q = 0; q < size; ++q) {
        const T factor = share * (projected[q] - pressures[q]);
        for (std::size_t i = 0; i < G; ++i)
          for (std::size_t j = 0; j < G; ++j) sums[q][i][j] += factor * inverses[q][j][i];
      }
    }
    PointScratch<D, T> scratch(size);
    add_forces(
        geometry, [&](std::size_t q) -> const Small<T, G>& { return sums[q]; }, scratch, f);
    return least_jacobian;
  }

  /// Adds the rule's tangent dF/du_s to k. With theta = Pi l the energy is sum_q w phi(F_q, theta_q), whence
  ///   d2E = sum_q w (dF:phi_FF:dF + 2 dF:phi_Ft dtheta + phi_tt dtheta^2 + Pi p d2l).
  /// The parts in dF:dF go to the moduli of the points. dtheta = sum_i psi_i m_i . du with m_i = sum_q w psi_i dl/du
  /// makes the rest sum_i (m_i p_i^T + p_i m_i^T).
  template <class T>
  static void add_tangent(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment,
                          const Rule& rule, Tangent<T>& k) {
    const auto& law = law_in<Space>(material);
    const States<T> states(law.can_invert(), geometry, segment, rule);
    const std::size_t size = states.size, count = rule.points.size();
    std::vector<T> pressures(count * size, T(0.0));
    if (states.finite) add_pressures(law, geometry, states, pressures);
    if (law.has_mixed_steps() && segment.iterate != nullptr)
      add_excess(material.lame.lambda, geometry, segment, states, pressures);
    std::vector<Small<T, G>> volumes(count * size), couplings(count * size);
    std::vector<Small<T, M>> seconds(count, Small<T, M>{});
    Base::add_tangent_of(
        geometry, 0, size, true,
        [&](std::size_t begin, std::size_t points, Small<T, C>* result) {
          std::array<Small<T, G * G>, contractions_at_once> sums;
          std::fill_n(sums.data(), points, Small<T, G * G>{});
          for (std::size_t point = 0; point < count; ++point) {
            std::array<State<T>, contractions_at_once> at;
            std::array<Small<T, G>, contractions_at_once> scaled, p;
            std::array<Small<T, G * G>, contractions_at_once> a;
            for (std::size_t i = 0; i < points; ++i) scaled[i] = (at[i] = states.at(begin + i, point)).scaled;
            law.stress_and_moduli(points, scaled.data(), p.data(), a.data());
            const double factor = rule.points[point].weight * rule.points[point].to;
            for (std::size_t i = 0; i < points; ++i) {
              const std::size_t q = begin + i, place = point * size + q;
              const Moduli<T> moduli(at[i], p[i], a[i], T(0.0), pressures[place]);
              for (std::size_t r = 0; r < G * G; ++r)
                for (std::size_t c = 0; c < G * G; ++c) sums[i][r][c] += factor * moduli.local[r][c];
              couplings[place] = moduli.coupling;
              for (std::size_t r = 0; r < G; ++r)
                for (std::size_t c = 0; c < G; ++c) volumes[place][r][c] = at[i].inverse[c][r];
              const std::array<T, M>& functions = geometry.projection.at(q);
              const T second = geometry.points[q].weight * moduli.second;
              for (std::size_t r = 0; r < M; ++r)
                for (std::size_t c = 0; c < M; ++c) seconds[point][r][c] += second * (functions[r] * functions[c]);
            }
          }
          for (std::size_t i = 0; i < points; ++i) copy_moduli(sums[i], result[i]);
        },
        k);
    PointScratch<D, T> scratch(size);
    for (std::size_t point = 0; point < count; ++point)
      add_coupling(geometry, &volumes[point * size], &couplings[point * size], seconds[point],
                   rule.points[point].weight * rule.points[point].to, scratch, k);
  }

 private:
  static constexpr std::size_t M = LinearProjection<double, D>::size;
  using AtPoint = MeanDilatationPoint<G>;
  template <class T>
  using State = typename AtPoint::template State<T>;
  template <class T>
  using Moduli = typename AtPoint::template Moduli<T>;

  /// F~ at the quadrature points and at the time points of a rule, which outlives it.
  template <class T>
  struct States {
    States(const States&) = delete;  // the ends point into it
    States& operator=(const States&) = delete;
    States(bool of_finite, const Geometry<T>& geometry, const Segment<T>& segment, const Rule& rule)
        : finite(of_finite),
          time_points(rule.points),
          size(geometry.points.size()),
          exponents(rule.points.size() * size),
          least_jacobian(1e300) {
      PointScratch<D, T> scratch(size);
      find_gradients(geometry, *segment.to, scratch, to);
      if (segment.from != nullptr) find_gradients(geometry, *segment.from, scratch, from);
      if (segment.velocity != nullptr) find_gradients(geometry, *segment.velocity, scratch, velocity);
      ends = {size, to.data(), from.empty() ? nullptr : from.data(), velocity.empty() ? nullptr : velocity.data()};
      if (finite)
        for (const Small<T, G>& h : to) least_jacobian = smaller(least_jacobian, determinant(deformation_gradient(h)));
      std::vector<T> logarithms(size);
      for (std::size_t k = 0; k < time_points.size(); ++k) {
        for (std::size_t q = 0; q < size; ++q) {
          const Small<T, G> h = ends.at(q, time_points[k]);
          if (finite) least_jacobian = smaller(least_jacobian, T(1.0 + AtPoint::dilatation(finite, h)));
          logarithms[q] = AtPoint::log_ratio(finite, h);
        }
        T* own = &exponents[k * size];
        geometry.projection.project(geometry.points, logarithms.data(), own);
        for (std::size_t q = 0; q < size; ++q) own[q] = (own[q] - logarithms[q]) * (1.0 / G);
      }
    }

    State<T> at(std::size_t q, std::size_t k) const {
      return State<T>::stretched(finite, ends.at(q, time_points[k]), exponents[k * size + q]);
    }

    bool finite;  ///< see MeanDilatationPoint
    const std::vector<RulePoint>& time_points;
    std::size_t size;  ///< number of quadrature points
    std::vector<Small<T, G>> to, from, velocity;
    PointEnds<T, G> ends;
    std::vector<T> exponents;  ///< (Pi l - l)/D, by time point and quadrature point
    T least_jacobian;          ///< of the time points and of the segment's end
  };

  /// Computes the displacement gradients at the points.
  template <class T>
  static void find_gradients(const Geometry<T>& geometry, const Nodal<T>& u, PointScratch<D, T>& scratch,
                             std::vector<Small<T, G>>& result) {
    PointGradients<Element>::template evaluate<Base::revolved>(*geometry.table, u, scratch.gradients.data(),
                                                               scratch.values.data());
    result.resize(geometry.points.size());
    for (std::size_t q = 0; q < result.size(); ++q) {
      const auto& point = geometry.points[q];
      const Small<T, D> in_plane = Base::product(scratch.gradients[q], point.inverse_jacobian);
      if constexpr (Base::revolved) {
        result[q] = {};
        for (std::size_t i = 0; i < D; ++i) std::copy_n(in_plane[i].begin(), D, result[q][i].begin());
        result[q][2][2] = scratch.values[q][0] * point.inverse_radius;
      } else {
        result[q] = in_plane;
      }
    }
  }

  /// Adds to f the nodal forces of the stresses that `stress`(point) returns.
  template <class T, class Stress>
  static void add_forces(const Geometry<T>& geometry, const Stress& stress, PointScratch<D, T>& scratch, Nodal<T>& f) {
    for (std::size_t q = 0; q < geometry.points.size(); ++q) {
      const auto& point = geometry.points[q];
      const Small<T, G> p = stress(q);
      scratch.gradients[q] = Base::in_element_coordinates(point, p);
      if constexpr (Base::revolved) {
        scratch.values[q][0] = point.weight * point.inverse_radius * p[2][2];
        scratch.values[q][1] = T(0.0);
      }
    }
    PointGradients<Element>::template integrate<Base::revolved>(*geometry.table, scratch.gradients.data(),
                                                                scratch.values.data(), f);
  }

  /// Calls visit(point, state, stress, admissibility) for the points of one time point.
  template <class Points, class T, class Visit>
  static void for_each_stress(const Points& law, const States<T>& states, std::size_t k, const Visit& visit) {
    constexpr std::size_t at_once = 8;
    for (std::size_t first = 0; first < states.size; first += at_once) {
      const std::size_t count = std::min(at_once, states.size - first);
      std::array<State<T>, at_once> at;
      std::array<Small<T, G>, at_once> scaled, p;
      std::array<T, at_once> admissible;
      for (std::size_t q = 0; q < count; ++q) scaled[q] = (at[q] = states.at(first + q, k)).scaled;
      law.stress(count, scaled.data(), p.data(), admissible.data());
      for (std::size_t q = 0; q < count; ++q) visit(first + q, at[q], p[q], admissible[q]);
    }
  }

  /// Computes Pi p, by time point and quadrature point.
  template <class Points, class T>
  static void add_pressures(const Points& law, const Geometry<T>& geometry, const States<T>& states,
                            std::vector<T>& result) {
    std::vector<T> pressures(states.size);
    for (std::size_t k = 0; k < states.time_points.size(); ++k) {
      for_each_stress(law, states, k, [&](std::size_t q, const State<T>& s, const Small<T, G>& p, const T&) {
        pressures[q] = s.product(p) * (1.0 / G);
      });
      geometry.projection.project(geometry.points, pressures.data(), &result[k * states.size]);
    }
  }

  /// Adds kappa Pi(volume_excess()), by time point and quadrature point.
  template <class T>
  static void add_excess(double kappa, const Geometry<T>& geometry, const Segment<T>& segment, const States<T>& states,
                         std::vector<T>& result) {
    PointScratch<D, T> scratch(states.size);
    std::vector<Small<T, G>> gradients;
    find_gradients(geometry, *segment.iterate, scratch, gradients);
    PointEnds<T, G> ends = states.ends;
    ends.iterate = gradients.data();
    ends.way = segment.way;
    std::vector<T> excess(states.size), projected(states.size);
    for (std::size_t k = 0; k < states.time_points.size(); ++k) {
      const RulePoint& point = states.time_points[k];
      for (std::size_t q = 0; q < states.size; ++q) excess[q] = kappa * volume_excess(ends, q, point);
      geometry.projection.project(geometry.points, excess.data(), projected.data());
      for (std::size_t q = 0; q < states.size; ++q) result[k * states.size + q] += projected[q];
    }
  }

  /// Adds factor sum_i (m_i p_i^T + p_i m_i^T) of one time point to k, where
  ///   p_i = sum_q w psi_i phi_Ft dF/du + 1/2 sum_j second_ij m_j.
  /// By point, `volumes` are F^-T and `couplings` phi_Ft; `second` is sum_q w phi_tt psi psi^T.
  template <class T>
  static void add_coupling(const Geometry<T>& geometry, const Small<T, G>* volumes, const Small<T, G>* couplings,
                           const Small<T, M>& second, double factor, PointScratch<D, T>& scratch, Tangent<T>& k) {
    std::array<Nodal<T>, M> m{}, p{};
    for (std::size_t i = 0; i < M; ++i) {
      const auto add_moment = [&](const Small<T, G>* values, Nodal<T>& result) {
        add_forces(
            geometry,
            [&](std::size_t q) {
              Small<T, G> scaled = values[q];
              for (auto& row : scaled)
                for (T& entry : row) entry *= geometry.projection.at(q)[i];
              return scaled;
            },
            scratch, result);
      };
      add_moment(volumes, m[i]);
      add_moment(couplings, p[i]);
    }
    for (std::size_t i = 0; i < M; ++i)
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t d = 0; d < D; ++d) {
          T sum(0.0);
          for (std::size_t j = 0; j < M; ++j) sum += second[i][j] * m[j][a][d];
          p[i][a][d] = factor * (p[i][a][d] + 0.5 * sum);
        }
    for (std::size_t r = 0; r < N * D; ++r)
      for (std::size_t c = 0; c <= r; ++c) {
        T value(0.0);
        for (std::size_t i = 0; i < M; ++i)
          value += m[i][r / D][r % D] * p[i][c / D][c % D] + p[i][r / D][r % D] * m[i][c / D][c % D];
        k[r][c] += value;
        if (c < r) k[c][r] += value;
      }
  }
};

/// The kernel of the formulation MeanDilatation: a linear field of the volume change in quadratic cells, a mean in
/// others.
template <class Element, class Material>
using DilatationKernel = std::conditional_t<is_quadratic_element<Element>, ProjectedDilatationKernel<Element, Material>,
                                            MeanDilatationKernel<Element, Material>>;

}  // namespace ixos
