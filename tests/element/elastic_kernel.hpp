/// Energy, force and tangent of one element (or one pack of elements), over any scalar type: CellKernel and LawPoints,
/// put together as the term of standard elements does it.
#pragma once
#include <cstddef>
#include <type_traits>
#include <vector>

#include "element/cell_kernel.hpp"
#include "element/kernel_law.hpp"

namespace ixos::test {

/// A CellKernel with a hyperelastic material. `Material` is a law, a struct of member templates, or AnyLaw, which the
/// library's terms have.
///
/// On every path that a rule knows, the displacement gradient at a time point is a fixed combination of those of the
/// segment's ends, so time points are looped inside the quadrature point: one gather, one B^T A B and one scatter serve
/// any number of them.
template <class Element, class Material>
struct ElasticKernel : CellKernel<Element> {
  using Base = CellKernel<Element>;
  using Law = Material;
  using Base::batch;
  using Base::D;
  using Base::G;
  using typename Base::Space;
  static constexpr std::size_t C = Base::C;
  /// Whether the kernel knows Mean::DiscreteGradient.
  static constexpr bool has_discrete_gradient = true;

  template <class T>
  using Nodal = typename Base::template Nodal<T>;
  template <class T>
  using Tangent = typename Base::template Tangent<T>;
  template <class T>
  using Geometry = typename Base::template Geometry<T>;
  template <class T>
  using Segment = typename Base::template Segment<T>;

  /// Computes the displacement gradients that the law sees at the points. Returns 1 in lanes where it sees some, else
  /// 0.
  template <class T>
  static T seen(const Material&, const Geometry<T>& geometry, const Nodal<T>& u, std::vector<Small<T, G>>& h) {
    h.resize(geometry.points.size());
    Base::for_each_batch(
        geometry, [&](std::size_t first, std::size_t count) { Base::gradients(geometry, first, count, u, &h[first]); });
    return T(1.0);
  }

  /// Returns the stored energy [E0 L0^D].
  template <class T>
  static T energy(const Material& material, const Geometry<T>& geometry, const Nodal<T>& u) {
    return energy_of<ElasticKernel>(material, geometry, u);
  }

  /// Adds the rule's force to f. Returns the least J of the time points and of the segment's end, lane by lane. `kept`:
  /// null, or kept_size() numbers for each point.
  template <class T>
  static T add_force(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment, const Rule& rule,
                     Nodal<T>& f, T* kept = nullptr) {
    const auto& law = law_in<Space>(material);
    const std::size_t size = kept == nullptr ? 0 : kept_size<T>(material, rule);
    T least_jacobian(1e300);
    Base::for_each_batch(geometry, [&](std::size_t first, std::size_t count) {
      const typename Base::template Ends<T> ends(geometry, first, count, segment);
      std::array<Small<T, G>, batch> p;
      least_jacobian =
          smaller(least_jacobian, law.stress(ends.points(), rule, p.data(), size == 0 ? nullptr : kept + first * size));
      Base::add_forces(geometry, first, count, p.data(), f);
    });
    return least_jacobian;
  }

  /// Returns how many numbers a point keeps of a force by that rule; 0 if none.
  template <class T>
  static std::size_t kept_size(const Material& material, const Rule& rule) {
    const auto& law = law_in<Space>(material);
    if constexpr (std::is_same_v<decltype(law), const PointLaw<Space>&>)
      return law.kept_size(rule);
    else
      return law.template kept_size<T>(rule);
  }

  /// Adds the rule's tangent dF/du_s to k. `kept`: null, or what add_force() kept at that place.
  template <class T>
  static void add_tangent(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment,
                          const Rule& rule, Tangent<T>& k, const T* kept = nullptr) {
    const auto& law = law_in<Space>(material);
    const std::size_t size = kept == nullptr ? 0 : kept_size<T>(material, rule);
    Base::for_each_batch(geometry, [&](std::size_t first, std::size_t count) {
      const T* const own = size == 0 ? nullptr : kept + first * size;
      if (own != nullptr && add_kept_tangent(law, geometry, first, count, rule, own, size, k)) return;
      const typename Base::template Ends<T> ends(geometry, first, count, segment);
      const auto points = ends.points();
      if constexpr (D == 3)
        if (is_spatial(law, rule)) {
          const RulePoint& point = rule.points[0];
          return Base::add_spatial_tangent(
              geometry, first, count, point.weight * point.to,
              [&](std::size_t begin, std::size_t n, SpatialState<T, G>* states) {
                law.spatial(points.part(begin, n), point, states);
              },
              k);
        }
      Base::add_tangent_of(
          geometry, first, count, rule.is_gradient(),
          [&](std::size_t begin, std::size_t n, Small<T, C>* a) { law.moduli(points.part(begin, n), rule, a); }, k);
    });
  }

 private:
  template <class Points>
  static bool is_spatial(const Points& law, const Rule& rule) {
    return law.has_spatial_tangent() && rule.points.size() == 1 && rule.mean == Mean::Points;
  }

  /// Adds the tangent of a batch from what its points kept. Returns false, with nothing added, if that does not do.
  template <class Points, class T>
  static bool add_kept_tangent(const Points& law, const Geometry<T>& geometry, std::size_t first, std::size_t count,
                               const Rule& rule, const T* kept, std::size_t size, Tangent<T>& k) {
    if constexpr (D == 3)
      if (is_spatial(law, rule)) {
        Base::add_spatial_tangent(
            geometry, first, count, rule.points[0].weight * rule.points[0].to,
            [&](std::size_t begin, std::size_t n, SpatialState<T, G>* states) {
              law.kept_spatial(n, kept + begin * size, states);
            },
            k);
        return true;
      }
    std::array<Small<T, C>, batch> a;
    if (!law.kept_moduli(count, kept, rule, a.data())) return false;
    Base::add_tangent_of(
        geometry, first, count, true,
        [&](std::size_t begin, std::size_t n, Small<T, C>* own) { std::copy_n(a.data() + begin, n, own); }, k);
    return true;
  }
};

}  // namespace ixos::test
