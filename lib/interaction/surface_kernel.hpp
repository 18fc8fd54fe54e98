/// Energy, force and tangent of one side (or a pack of sides) under a law of the gap, over any scalar type.
#pragma once
#include <array>
#include <cstddef>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "fem/shape_table.hpp"
#include "interaction/law_history.hpp"
#include "rule/rule.hpp"

namespace ixos {

/// Before a flat wall the gap at a quadrature point is sum_a N_a g_a of the nodal gaps g_a, and the force is along the
/// wall's normal, so all quantities are scalar. Nodal arrays are gaps at the side's N nodes; f_a and k_ab multiply n
/// and n n^T. `Law` is a law without a history, or the LawOfBatch of one with a history.
template <class Side, class Law>
struct SurfaceKernel {
  static constexpr std::size_t N = Side::nodes;
  using Table = ShapeTable<Side>;
  template <class T>
  using Nodal = std::array<T, N>;

  /// Ends of the segment as nodal gaps; `from` and `velocity` (its change along the normal) may be null.
  template <class T>
  struct Segment {
    const Nodal<T>* from;
    const Nodal<T>* velocity;
    const Nodal<T>* to;
  };

  template <class T>
  static T interpolate(const std::array<double, N>& shape, const Nodal<T>& nodal) {
    T sum = shape[0] * nodal[0];
    for (std::size_t a = 1; a < N; ++a) sum += shape[a] * nodal[a];
    return sum;
  }

  /// Returns the energy [E0 L0^D]; `measure[q]` is the quadrature weight times reference length or area [L0^(D-1)].
  template <class T>
  static T energy(const Law& law, const Table& quadrature, const T* measure, const Nodal<T>& gap) {
    T sum(0.0);
    for (std::size_t q = 0; q < quadrature.size(); ++q)
      sum += measure[q] * law_at(law, q).energy(interpolate(quadrature.value[q], gap));
    return sum;
  }

  /// Adds dPi/du along the normal to f. Returns the least gap of the time points and of the end.
  template <class T>
  static T add_force(const Law& law, const Table& quadrature, const T* measure, const Segment<T>& segment,
                     const Rule& rule, Nodal<T>& f) {
    T least_gap(1e300);
    for (std::size_t q = 0; q < quadrature.size(); ++q) {
      const auto& shape = quadrature.value[q];
      const Ends<T> ends(segment, shape);
      if (out_of_range(law, ends)) continue;
      const auto& here = law_at(law, q);
      T mean(0.0);
      for (const RulePoint& point : rule.points) {
        const T r = ends.at(point);
        least_gap = smaller(least_gap, r);
        mean += point.weight * here.traction(r);
      }
      if (rule.mean != Mean::Points) mean += here.mean_traction(ends.from, ends.to);
      least_gap = smaller(least_gap, ends.to);
      for (std::size_t a = 0; a < N; ++a) f[a] -= shape[a] * (measure[q] * mean);
    }
    return least_gap;
  }

  /// Adds the derivative of the force to k; `convex` leaves out negative stiffnesses.
  template <class T>
  static void add_tangent(const Law& law, const Table& quadrature, const T* measure, const Segment<T>& segment,
                          const Rule& rule, bool convex, Small<T, N>& k) {
    for (std::size_t q = 0; q < quadrature.size(); ++q) {
      const auto& shape = quadrature.value[q];
      const Ends<T> ends(segment, shape);
      if (out_of_range(law, ends)) continue;
      const auto& here = law_at(law, q);
      T mean(0.0);
      for (const RulePoint& point : rule.points) {
        const T stiffness = here.stiffness(ends.at(point));
        mean += (point.weight * point.to) * (convex ? select(stiffness > 0.0, stiffness, T(0.0)) : stiffness);
      }
      if (rule.mean != Mean::Points) {
        const T stiffness = here.mean_stiffness(ends.from, ends.to);
        mean += convex ? select(stiffness > 0.0, stiffness, T(0.0)) : stiffness;
      }
      mean *= measure[q];
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t b = 0; b < N; ++b) k[a][b] += (shape[a] * shape[b]) * mean;
    }
  }

  /// Returns the largest s <= 1 with r + s p dr >= margin min(r, near) at the end of the segment and, if the path is
  /// not linear, at every time point (a linear path between two points before a flat wall never leaves their segment).
  /// `change` holds nodal gap changes dr; p = du(xi)/du_s.
  template <class T>
  static T admissible_step(const Table& quadrature, const Segment<T>& segment, const Rule& rule, const Nodal<T>& change,
                           double margin, double near) {
    T step(1.0);
    const auto restrict_to = [&](const T& r, const T& dr) {
      const T room = r - margin * smaller(r, T(near));
      // If dr < 0: s <= room/-dr. Otherwise the divisor is 1 and the quotient is discarded.
      step = smaller(step, select(dr < 0.0, T(room / (select(dr < 0.0, T(-dr), T(1.0)))), T(1.0)));
    };
    for (std::size_t q = 0; q < quadrature.size(); ++q) {
      const auto& shape = quadrature.value[q];
      const Ends<T> ends(segment, shape);
      const T dr = interpolate(shape, change);
      restrict_to(ends.to, dr);
      if (segment.velocity == nullptr) continue;
      for (const RulePoint& point : rule.points) restrict_to(ends.at(point), T(point.to * dr));
    }
    return select(step > 0.0, step, T(0.0));
  }

 private:
  /// Gaps at one quadrature point at the ends of the segment.
  template <class T>
  struct Ends {
    Ends(const Segment<T>& segment, const std::array<double, N>& shape)
        : to(interpolate(shape, *segment.to)),
          has_from(segment.from != nullptr),
          has_velocity(segment.velocity != nullptr) {
      if (has_from) from = interpolate(shape, *segment.from);
      if (has_velocity) velocity = interpolate(shape, *segment.velocity);
    }
    T at(const RulePoint& point) const {
      T r = point.to * to;
      if (has_from) r += point.from * from;
      if (has_velocity) r += point.velocity * velocity;
      return r;
    }
    T to, from, velocity;
    bool has_from, has_velocity;
  };

  /// Returns whether no force acts at this point in any lane: on a straight path no time point is nearer than the ends.
  template <class T>
  static bool out_of_range(const Law& law, const Ends<T>& ends) {
    if constexpr (Law::has_range) {
      if (ends.has_velocity) return false;
      const T nearest = ends.has_from ? T(smaller(ends.from, ends.to)) : ends.to;
      return least(nearest) >= law.range();
    } else {
      return false;
    }
  }
};

}  // namespace ixos
