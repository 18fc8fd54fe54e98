/// A law at many quadrature points, over any scalar type.
#pragma once
#include <cstddef>
#include <new>
#include <stdexcept>
#include <type_traits>

#include "base/pack.hpp"
#include "material/points.hpp"
#include "material/strain.hpp"
#include "material/volume_excess.hpp"
#include "rule/straight_points.hpp"

namespace ixos {

/// Traits of a struct of member templates, each with a default.
template <class Law, class = void>
struct CanInvert : std::true_type {};
template <class Law>
struct CanInvert<Law, std::void_t<decltype(Law::can_invert)>> : std::bool_constant<Law::can_invert> {};
/// Whether the bulk stiffness resists a change of J, as mixed steps suppose.
template <class Law, class = void>
struct HasMixedSteps : CanInvert<Law> {};
template <class Law>
struct HasMixedSteps<Law, std::void_t<decltype(Law::has_mixed_steps)>> : std::bool_constant<Law::has_mixed_steps> {};
template <class Law, class = void>
struct HasLimit : std::false_type {};
template <class Law>
struct HasLimit<Law, std::void_t<decltype(Law::has_limit)>> : std::bool_constant<Law::has_limit> {};
template <class Law, class = void>
struct HasSpatialTangent : std::false_type {};
template <class Law>
struct HasSpatialTangent<Law, std::void_t<decltype(Law::has_spatial_tangent)>>
    : std::bool_constant<Law::has_spatial_tangent> {};
template <class Law, class = void>
struct KeepsState : std::false_type {};
template <class Law>
struct KeepsState<Law, std::void_t<decltype(Law::keeps_state)>> : std::bool_constant<Law::keeps_state> {};
/// Whether a law has a Path, which sums over points of a straight path at once (see NeoHookePath).
template <class Law, class = void>
struct HasPath : std::false_type {};
template <class Law>
struct HasPath<Law, std::void_t<typename Law::template Path<2, double>>> : std::true_type {};

/// The loops of a law over the points of a pack of cells. They are the boundary between elements and laws: what calls
/// them knows no law, and they know no element. See PointLaw for what each function computes.
template <class Law, class Space>
class LawPoints {
  static constexpr std::size_t G = Space::G, C = Space::C;
  static constexpr bool keeps_state = KeepsState<Law>::value;
  static constexpr bool has_path = HasPath<Law>::value && !Space::is_ring;
  /// In three dimensions it takes longer to write and read the sums than to compute them again.
  static constexpr bool keeps_sums = has_path && keeps_state && G == 2;
  static constexpr bool spatial_tangent = HasSpatialTangent<Law>::value && !Space::is_ring;

 public:
  /// The law must outlive it.
  explicit LawPoints(const Law& law) : law_(law) {}

  static constexpr bool can_invert() { return CanInvert<Law>::value; }
  static constexpr bool has_mixed_steps() { return HasMixedSteps<Law>::value; }
  static constexpr bool is_limited() { return HasLimit<Law>::value; }
  static constexpr bool has_spatial_tangent() { return spatial_tangent; }

  template <class T>
  [[gnu::always_inline]] T admissibility(const Small<T, G>& h) const {
    if constexpr (HasLimit<Law>::value)
      return law_.admissibility(h);
    else if constexpr (CanInvert<Law>::value)
      return determinant(deformation_gradient(h));
    else
      return T(1.0);
  }

  /// Returns how many T a point keeps of a force by that rule; 0 if none.
  template <class T>
  static std::size_t kept_size(const Rule& rule) {
    if constexpr (keeps_state) {
      if (rule.mean != Mean::Points) return 0;
      if (sums_along_path(rule)) return sums_size<T>();
      return rule.points.size() * (sizeof(Kept<T>) / sizeof(T));
    }
    return 0;
  }

  template <class T>
  T stress(const PointEnds<T, G>& ends, const Rule& rule, Small<T, G>* p, T* kept) const {
    if (sums_along_path(rule)) return path_stress(ends, rule, p, kept);
    T least(1e300);
    if (is_end(rule)) {
      for (std::size_t q = 0; q < ends.size; ++q) least = smaller(least, point_stress(ends.to[q], p[q], kept, q));
      return least;
    }
    const std::size_t count = rule.points.size();
    const bool checks_end = can_invert() && !rule.has_end();
    for (std::size_t q = 0; q < ends.size; ++q) {
      Small<T, G> sum{};
      for (std::size_t k = 0; k < count; ++k) {
        Small<T, G> here;
        least = smaller(least, point_stress(ends.at(q, rule.points[k]), here, kept, q * count + k));
        add(rule.points[k].weight, here, sum);
      }
      if (rule.mean == Mean::DiscreteGradient) add_discrete_gradient(ends, q, sum);
      p[q] = sum;
      if (checks_end) least = smaller(least, admissibility(ends.to[q]));
    }
    return least;
  }

  template <class T>
  void moduli(const PointEnds<T, G>& ends, const Rule& rule, Small<T, C>* a) const {
    const bool along_path = sums_along_path(rule);
    for (std::size_t q = 0; q < ends.size; ++q) {
      if (along_path && path_moduli(ends, q, rule, a[q])) continue;
      if (rule.mean == Mean::Points && rule.points.size() == 1) {
        const RulePoint& point = rule.points[0];
        Small<T, G> p;
        in_space(ends.at(q, point), p, a[q]);
        if (const double share = point.weight * point.to; share != 1) scale(share, a[q]);
        continue;
      }
      a[q] = {};
      for (const RulePoint& point : rule.points) {
        Small<T, G> p;
        Small<T, C> here;
        in_space(ends.at(q, point), p, here);
        add(point.weight * point.to, here, a[q]);
      }
      if (rule.mean == Mean::DiscreteGradient) discrete_gradient_moduli(ends, q, a[q]);
    }
    if (has_mixed_steps() && ends.iterate != nullptr)
      for (std::size_t q = 0; q < ends.size; ++q) add_volume_excess<Space>(ends, q, rule, law_.lame.lambda, a[q]);
  }

  template <class T>
  bool kept_moduli([[maybe_unused]] std::size_t size, [[maybe_unused]] const T* kept, [[maybe_unused]] const Rule& rule,
                   [[maybe_unused]] Small<T, C>* a) const {
    if constexpr (keeps_sums) {
      if (sums_along_path(rule)) {
        for (std::size_t q = 0; q < size; ++q)
          if (!sums_of(kept, q).is_near) return false;
        for (std::size_t q = 0; q < size; ++q) Path<T>::moduli(law_, sums_of(kept, q), T(1.0), a[q]);
        return true;
      }
    }
    if constexpr (keeps_state) {
      const std::size_t count = rule.points.size();
      for (std::size_t q = 0; q < size; ++q) {
        a[q] = {};
        for (std::size_t k = 0; k < count; ++k)
          law_.add_moduli(kept_of(kept, q * count + k), T(rule.points[k].weight * rule.points[k].to), a[q]);
      }
    }
    return keeps_state;
  }

  template <class T>
  void spatial([[maybe_unused]] const PointEnds<T, G>& ends, [[maybe_unused]] const RulePoint& point,
               [[maybe_unused]] SpatialState<T, G>* states) const {
    if constexpr (spatial_tangent) {
      for (std::size_t q = 0; q < ends.size; ++q)
        states[q].moduli = law_.spatial_tangent(ends.at(q, point), states[q].inverse);
      if (has_mixed_steps() && ends.iterate != nullptr)
        for (std::size_t q = 0; q < ends.size; ++q)
          states[q].moduli.c -= law_.lame.lambda * volume_excess(ends, q, point);
    } else {
      throw std::logic_error("the elastic law has no spatial tangent");
    }
  }
  template <class T>
  void kept_spatial([[maybe_unused]] std::size_t size, [[maybe_unused]] const T* kept,
                    [[maybe_unused]] SpatialState<T, G>* states) const {
    if constexpr (spatial_tangent && keeps_state) {
      for (std::size_t q = 0; q < size; ++q) {
        const auto& state = kept_of(kept, q);
        states[q] = {state.g, law_.spatial_tangent(state)};
      }
    } else {
      throw std::logic_error("the elastic law keeps no spatial tangent");
    }
  }

  template <class T>
  void energy(std::size_t size, const Small<T, G>* h, T* w) const {
    for (std::size_t q = 0; q < size; ++q) w[q] = law_.energy(h[q]);
  }
  template <class T>
  void stress(std::size_t size, const Small<T, G>* h, Small<T, G>* p, T* admissible) const {
    for (std::size_t q = 0; q < size; ++q) admissible[q] = law_.stress(h[q], p[q]);
  }
  template <class T>
  void stress_and_moduli(std::size_t size, const Small<T, G>* h, Small<T, G>* p, Small<T, G * G>* a) const {
    for (std::size_t q = 0; q < size; ++q) law_.stress_and_moduli(h[q], p[q], a[q]);
  }
  /// Does the same with the C components that moduli connect.
  template <class T>
  void stress_and_space_moduli(std::size_t size, const Small<T, G>* h, Small<T, G>* p, Small<T, C>* a) const {
    for (std::size_t q = 0; q < size; ++q) in_space(h[q], p[q], a[q]);
  }

 private:
  // Dependent on T: laws need not have these.
  template <class T, class Own = Law>
  using Path = typename Own::template Path<G, T>;
  template <class T, class Own = Law>
  using Kept = typename Own::template Kept<G, T>;

  static bool sums_along_path(const Rule& rule) {
    return has_path && rule.mean == Mean::Points && has_straight_points(rule);
  }
  /// Returns whether the rule is the force at the end of the segment.
  static bool is_end(const Rule& rule) {
    if (rule.mean != Mean::Points || rule.points.size() != 1) return false;
    const RulePoint& point = rule.points[0];
    return point.to == 1 && point.weight == 1 && point.from == 0 && point.velocity == 0;
  }
  template <class T>
  static std::size_t sums_size() {
    if constexpr (keeps_sums)
      return (sizeof(typename Path<T>::Sums) + sizeof(T) - 1) / sizeof(T);
    else
      return 0;
  }
  template <class T>
  static const auto& kept_of(const T* kept, std::size_t place) {
    return std::launder(reinterpret_cast<const Kept<T>*>(kept))[place];
  }
  template <class T>
  static const auto& sums_of(const T* kept, std::size_t q) {
    return *std::launder(reinterpret_cast<const typename Path<T>::Sums*>(kept + q * sums_size<T>()));
  }

  template <class T, std::size_t size>
  [[gnu::always_inline]] static void add(double factor, const Small<T, size>& m, Small<T, size>& sum) {
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j) sum[i][j] += factor * m[i][j];
  }
  template <class T, std::size_t size>
  [[gnu::always_inline]] static void scale(double factor, Small<T, size>& m) {
    for (auto& row : m)
      for (T& value : row) value *= factor;
  }

  /// Computes the stress of one state, and keeps it at a place unless `kept` is null.
  template <class T>
  [[gnu::always_inline]] T point_stress(const Small<T, G>& h, Small<T, G>& p, [[maybe_unused]] T* kept,
                                        [[maybe_unused]] std::size_t place) const {
    if constexpr (keeps_state) {
      if (kept != nullptr) return law_.stress(h, p, *new (reinterpret_cast<Kept<T>*>(kept) + place) Kept<T>);
    }
    return law_.stress(h, p);
  }
  template <class T>
  [[gnu::always_inline]] void in_space(const Small<T, G>& h, Small<T, G>& p, Small<T, C>& a) const {
    law_.stress_and_moduli(h, p, a);
  }

  template <class T>
  void add_discrete_gradient([[maybe_unused]] const PointEnds<T, G>& ends, [[maybe_unused]] std::size_t q,
                             [[maybe_unused]] Small<T, G>& sum) const {
    if constexpr (Law::has_discrete_gradient)
      law_.discrete_gradient(ends.from[q], ends.to[q], sum);
    else
      throw std::logic_error("the elastic law has no discrete gradient");
  }
  template <class T>
  void discrete_gradient_moduli([[maybe_unused]] const PointEnds<T, G>& ends, [[maybe_unused]] std::size_t q,
                                [[maybe_unused]] Small<T, C>& a) const {
    if constexpr (Law::has_discrete_gradient)
      law_.discrete_gradient_moduli(ends.from[q], ends.to[q], a);
    else
      throw std::logic_error("the elastic law has no discrete gradient");
  }

  template <class T>
  T path_stress([[maybe_unused]] const PointEnds<T, G>& ends, [[maybe_unused]] const Rule& rule,
                [[maybe_unused]] Small<T, G>* p, [[maybe_unused]] T* kept) const {
    T least(1e300);
    if constexpr (has_path) {
      const bool checks_end = can_invert() && !rule.has_end();
      for (std::size_t q = 0; q < ends.size; ++q) {
        Path<T> path(law_, ends.from[q], ends.to[q]);
        T on_path = least;
        if constexpr (keeps_sums) {
          if (kept != nullptr) {
            for (const RulePoint& point : rule.points)
              on_path = smaller(on_path, path.template add_stress<true>(point.weight, point.to));
            new (kept + q * sums_size<T>()) typename Path<T>::Sums(path.sums());
          } else {
            on_path = along(path, rule, on_path);
          }
        } else {
          on_path = along(path, rule, on_path);
        }
        if (path.is_near()) {
          p[q] = path.stress(T(1.0));
          least = on_path;
        } else {
          p[q] = {};
          for (const RulePoint& point : rule.points) {
            Small<T, G> here;
            least = smaller(least, law_.stress(ends.at(q, point), here));
            add(point.weight, here, p[q]);
          }
        }
        if (checks_end) least = smaller(least, admissibility(ends.to[q]));
      }
    }
    return least;
  }
  template <class P, class T>
  [[gnu::always_inline]] static T along(P& path, const Rule& rule, T least) {
    for (const RulePoint& point : rule.points)
      least = smaller(least, path.template add_stress<false>(point.weight, point.to));
    return least;
  }
  /// Returns false if the points must be evaluated one by one.
  template <class T>
  bool path_moduli([[maybe_unused]] const PointEnds<T, G>& ends, [[maybe_unused]] std::size_t q,
                   [[maybe_unused]] const Rule& rule, [[maybe_unused]] Small<T, C>& a) const {
    if constexpr (has_path) {
      Path<T> path(law_, ends.from[q], ends.to[q]);
      for (const RulePoint& point : rule.points) path.add_moduli(point.weight * point.to, point.to);
      if (!path.is_near()) return false;
      path.moduli(T(1.0), a);
    }
    return has_path;
  }

  const Law& law_;
};

}  // namespace ixos
