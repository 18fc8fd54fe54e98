/// Energy, force and tangent of one element (or one pack of elements), over any scalar type.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "element/cell_means.hpp"
#include "element/displacement_gradient.hpp"
#include "element/node_pairs.hpp"
#include "fem/shape_table.hpp"
#include "rule/rule.hpp"
#include "rule/straight_points.hpp"

namespace ixos {

/// Whether a law has a Path, which sums over points of a straight path at once (see NeoHookePath).
template <class Law, class = void>
struct HasPath : std::false_type {};
template <class Law>
struct HasPath<Law, std::void_t<typename Law::template Path<2, double>>> : std::true_type {};

/// Isoparametric displacement element with a hyperelastic material. T is double, Pack, or an AD type. Nodal arrays are
/// [node][component]; the tangent is [node D + component][node D + component].
///
/// A Revolved element is a ring, its material a RevolvedLaw. Forces and energies are those of the whole ring.
///
/// On every path that a rule knows, the displacement gradient at a time point is a fixed combination of those of the
/// segment's ends, so time points are looped inside the quadrature point: one gather, one B^T A B and one scatter serve
/// any number of them.
template <class Element, class Material>
struct ElasticKernel {
  static constexpr std::size_t D = Element::dimension;
  static constexpr std::size_t N = Element::nodes;
  /// Displacement gradients are G x G, of which moduli connect C components.
  static constexpr std::size_t G = GradientTraits<Element>::G;
  static constexpr std::size_t C = GradientTraits<Element>::C;
  static constexpr bool revolved = IsRevolved<Element>::value;
  using Shape = Element;
  using Law = Material;
  using Table = ShapeTable<Element>;
  /// Whether the kernel knows Mean::DiscreteGradient.
  static constexpr bool has_discrete_gradient = true;
  /// Whether add_force() can keep what add_kept_tangent() needs.
  static constexpr bool keeps_points = Material::keeps_state;
  /// Whether the law sums over points of a straight path at once. Rings are evaluated point by point.
  static constexpr bool has_path = HasPath<Material>::value && !revolved;

  template <class T>
  using Nodal = Small<T, N, D>;
  template <class T>
  using Tangent = Small<T, N * D>;
  /// The shape functions' contribution to a displacement gradient at a point, by node.
  template <class T>
  using Gradients = typename GradientTraits<Element>::template Gradients<T, N>;

  template <class T>
  using Point = typename GradientTraits<Element>::template Point<T>;
  /// The element's points; the table must outlive it.
  template <class T>
  struct Geometry {
    const Table* table;
    std::vector<Point<T>> points;
  };

  /// The ends of the segment: u_from and h v_from may be null if the rule does not use them.
  template <class T>
  struct Segment {
    const Nodal<T>* from;
    const Nodal<T>* velocity;
    const Nodal<T>* to;
  };

  /// Computes the geometry from nodal coordinates X [L0]. The caller checks that all weights are positive.
  template <class T>
  static Geometry<T> geometry(const Table& table, const Nodal<T>& x) {
    Geometry<T> result{&table, std::vector<Point<T>>(table.size())};
    for (std::size_t q = 0; q < table.size(); ++q) {
      const Small<T, D> jacobian = gradient(x, table.gradient[q]);
      const T det = determinant(jacobian);
      result.points[q].inverse_jacobian = inverse(jacobian, det);
      result.points[q].weight = det * table.weight[q];
      if constexpr (revolved) {
        const T around = circumference(x, table.value[q]);
        result.points[q].weight *= around;
        result.points[q].inverse_radius = circumference(1.0) / around;
      }
    }
    return result;
  }

  /// Returns the stored energy [E0 L0^D].
  template <class T>
  static T energy(const Material& material, const Geometry<T>& geometry, const Nodal<T>& u) {
    T sum(0.0);
    for (std::size_t q = 0; q < geometry.points.size(); ++q)
      sum += geometry.points[q].weight * material.energy(gradient(u, shape_gradients(geometry, q)));
    return sum;
  }

  /// Returns the mean over the reference volume of value(H), an array of numbers, see cell_means.hpp.
  template <class T, class Value>
  static auto mean(const Material& /*material*/, const Geometry<T>& geometry, const Nodal<T>& u, const Value& value) {
    return mean_over_points(
        geometry.points, [&](std::size_t q) { return gradient(u, shape_gradients(geometry, q)); }, value);
  }

  /// Returns whether the law sums over the points of the rule at once. Then nothing is kept.
  static bool sums_along_path(const Rule& rule) {
    return has_path && rule.mean == Mean::Points && has_straight_points(rule);
  }

  /// Adds the rule's force to f. Returns the least J of the time points and of the segment's end, lane
  /// by lane.
  template <class T>
  static T add_force(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment, const Rule& rule,
                     Nodal<T>& f) {
    if (sums_along_path(rule)) return add_path_force<T, char>(material, geometry, segment, rule, f, nullptr);
    return add_force_with(material, geometry, segment, rule, f,
                          [&](std::size_t, const Small<T, G>& h, Small<T, G>& p) { return material.stress(h, p); });
  }

  /// Does the same, and keeps what the tangent at that place needs: kept[point x rule.points.size() + time point]. Only
  /// if keeps_points.
  template <class T, class Kept>
  static T add_force(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment, const Rule& rule,
                     Nodal<T>& f, Kept* kept) {
    return add_force_with(
        material, geometry, segment, rule, f,
        [&](std::size_t k, const Small<T, G>& h, Small<T, G>& p) { return material.stress(h, p, kept[k]); });
  }

  /// Adds the rule's tangent dF/du_s to k.
  template <class T>
  static void add_tangent(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment,
                          const Rule& rule, Tangent<T>& k) {
    // With one time point in three dimensions the spatial form is twice as fast. Several time points share the
    // contraction of their mean moduli.
    if constexpr (D == 3 && Material::has_spatial_tangent)
      if (rule.points.size() == 1 && rule.mean == Mean::Points)
        return add_spatial_tangent(geometry, rule.points[0], k,
                                   [&](std::size_t, const Nodal<T>& dn, Small<T, D>& inverse) {
                                     return material.spatial_tangent(Ends<T>(segment, dn).at(rule.points[0]), inverse);
                                   });
    if (sums_along_path(rule)) return add_path_tangent(material, geometry, segment, rule, k);
    const auto moduli = [&](std::size_t q, const Gradients<T>& dn, Small<T, C>& sum) {
      const Ends<T> ends(segment, dn);
      sum = {};
      add_point_moduli(material, ends, rule, sum);
      if (rule.mean == Mean::DiscreteGradient) material.discrete_gradient_moduli(ends.from, ends.to, sum);
      for (std::size_t r = 0; r < C; ++r)
        for (std::size_t c = 0; c < C; ++c) sum[r][c] *= geometry.points[q].weight;
    };
    if (rule.is_gradient()) return add_symmetric_tangent(geometry, moduli, k);
    for (std::size_t q = 0; q < geometry.points.size(); ++q) {
      const Gradients<T> dn = shape_gradients(geometry, q);
      Small<T, C> sum;
      moduli(q, dn, sum);
      add_contraction<false>(dn, dn, sum, k);
    }
  }

  /// Adds the tangent at the place of the add_force() that kept `kept`. Only if keeps_points; neither for discrete
  /// gradients nor if sums_along_path().
  template <class T, class Kept>
  static void add_kept_tangent(const Material& material, const Geometry<T>& geometry, const Rule& rule,
                               const Kept* kept, Tangent<T>& k) {
    if constexpr (D == 3 && Material::has_spatial_tangent)
      if (rule.points.size() == 1)
        return add_spatial_tangent(geometry, rule.points[0], k,
                                   [&](std::size_t q, const Nodal<T>&, Small<T, D>& inverse) {
                                     inverse = kept[q].g;
                                     return material.spatial_tangent(kept[q]);
                                   });
    add_symmetric_tangent(
        geometry,
        [&](std::size_t q, const Gradients<T>&, Small<T, C>& sum) {
          sum = {};
          for (std::size_t i = 0; i < rule.points.size(); ++i)
            material.add_moduli(kept[q * rule.points.size() + i],
                                T(geometry.points[q].weight * (rule.points[i].weight * rule.points[i].to)), sum);
        },
        k);
  }

  /// Does what add_force() does, if sums_along_path(), and keeps sums[point] for the tangent at that place.
  template <class T, class Sums>
  static T add_force_and_sums(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment,
                              const Rule& rule, Nodal<T>& f, Sums* sums) {
    return add_path_force(material, geometry, segment, rule, f, sums);
  }
  /// Adds that tangent. Returns false, with nothing added, if the points of the rule must be evaluated one by one.
  template <class T, class Sums>
  static bool add_summed_tangent(const Material& material, const Geometry<T>& geometry, const Sums* sums,
                                 Tangent<T>& k) {
    for (std::size_t q = 0; q < geometry.points.size(); ++q)
      if (!sums[q].is_near) return false;
    add_symmetric_tangent(
        geometry,
        [&](std::size_t q, const Gradients<T>&, Small<T, C>& sum) {
          Material::template Path<G, T>::moduli(material, sums[q], geometry.points[q].weight, sum);
        },
        k);
    return true;
  }

  /// Displacement gradients at the ends of the segment.
  template <class T>
  struct Ends {
    Ends(const Segment<T>& segment, const Gradients<T>& dn) : to(gradient(*segment.to, dn)) {
      has_from = segment.from != nullptr;
      has_velocity = segment.velocity != nullptr;
      if (has_from) from = gradient(*segment.from, dn);
      if (has_velocity) velocity = gradient(*segment.velocity, dn);
    }

    /// `start` and `rate` may be null.
    Ends(const Small<T, G>& end, const Small<T, G>* start, const Small<T, G>* rate)
        : to(end), has_from(start != nullptr), has_velocity(rate != nullptr) {
      if (has_from) from = *start;
      if (has_velocity) velocity = *rate;
    }

    Small<T, G> at(const RulePoint& point) const {
      Small<T, G> h;
      for (std::size_t i = 0; i < G; ++i)
        for (std::size_t j = 0; j < G; ++j) {
          h[i][j] = point.to * to[i][j];
          if (has_from) h[i][j] += point.from * from[i][j];
          if (has_velocity) h[i][j] += point.velocity * velocity[i][j];
        }
      return h;
    }

    /// Returns J at the end of the segment.
    T jacobian() const {
      Small<T, G> f = to;
      for (std::size_t i = 0; i < G; ++i) f[i][i] += 1.0;
      return determinant(f);
    }

    Small<T, G> to, from, velocity;
    bool has_from, has_velocity;
  };

  /// Returns dN_a/dX_J at point q, and N_a/R of a ring.
  template <class T>
  static Gradients<T> shape_gradients(const Geometry<T>& geometry, std::size_t q) {
    const auto& reference = geometry.table->gradient[q];
    const Point<T>& point = geometry.points[q];
    Nodal<T> dn{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t j = 0; j < D; ++j)
        for (std::size_t d = 0; d < D; ++d) dn[a][j] += reference[a][d] * point.inverse_jacobian[d][j];
    if constexpr (revolved) {
      Gradients<T> result{dn, {}};
      for (std::size_t a = 0; a < N; ++a) result.hoop[a] = geometry.table->value[q][a] * point.inverse_radius;
      return result;
    } else {
      return dn;
    }
  }

  /// Returns H_iJ = sum_a u_ai dN_a/dX_J; given reference gradients dN_a/dxi_d, the derivative by xi.
  template <class T, class S>
  static Small<T, D> gradient(const Nodal<T>& u, const Small<S, N, D>& dn) {
    Small<T, D> h{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) h[i][j] += u[a][i] * dn[a][j];
    return h;
  }
  template <class T>
  static Small<T, 3> gradient(const Nodal<T>& u, const RevolvedGradients<T, N>& dn) {
    return displacement_gradient(u, dn);
  }

 protected:
  /// Returns the reference volume.
  template <class T>
  static T volume(const Geometry<T>& geometry) {
    T sum(0.0);
    for (const Point<T>& point : geometry.points) sum += point.weight;
    return sum;
  }

  /// Calls moduli(point, dN/dX, sum), which computes symmetric moduli times the weight, and adds their tangent.
  template <class T, class Moduli>
  [[gnu::always_inline]] static void add_symmetric_tangent(const Geometry<T>& geometry, const Moduli& moduli,
                                                           Tangent<T>& k) {
    if constexpr (D == 3) {
      for (std::size_t q = 0; q < geometry.points.size(); q += contractions_at_once) {
        const std::size_t count = std::min(contractions_at_once, geometry.points.size() - q);
        std::array<ModuliPoint<T, N, D>, contractions_at_once> points;
        for (std::size_t i = 0; i < count; ++i) {
          points[i].gradients = shape_gradients(geometry, q + i);
          moduli(q + i, points[i].gradients, points[i].moduli);
        }
        add_contractions(points, count, k);
      }
    } else {
      for (std::size_t q = 0; q < geometry.points.size(); ++q) {
        const Gradients<T> dn = shape_gradients(geometry, q);
        Small<T, C> sum;
        moduli(q, dn, sum);
        add_contraction<true>(dn, dn, sum, k);
      }
    }
  }

 private:
  /// `stress`(index of the point and time point, H, P) computes P and returns J.
  template <class T, class Stress>
  [[gnu::always_inline]] static T add_force_with(const Material& material, const Geometry<T>& geometry,
                                                 const Segment<T>& segment, const Rule& rule, Nodal<T>& f,
                                                 const Stress& stress) {
    T least_jacobian(1e300);
    for (std::size_t q = 0; q < geometry.points.size(); ++q) {
      const Gradients<T> dn = shape_gradients(geometry, q);
      const Ends<T> ends(segment, dn);
      Small<T, G> mean{};
      for (std::size_t k = 0; k < rule.points.size(); ++k) {
        const RulePoint& point = rule.points[k];
        Small<T, G> p;
        least_jacobian = lesser(least_jacobian, stress(q * rule.points.size() + k, ends.at(point), p));
        for (std::size_t i = 0; i < G; ++i)
          for (std::size_t j = 0; j < G; ++j) mean[i][j] += point.weight * p[i][j];
      }
      if (rule.mean == Mean::DiscreteGradient) material.discrete_gradient(ends.from, ends.to, mean);
      if constexpr (Material::can_invert) least_jacobian = lesser(least_jacobian, admissibility(material, ends.to));
      for (std::size_t i = 0; i < G; ++i)
        for (std::size_t j = 0; j < G; ++j) mean[i][j] *= geometry.points[q].weight;
      add_nodal_forces(mean, dn, f);
    }
    return least_jacobian;
  }

  /// Adds the force if sums_along_path(). `sums`: see add_force_and_sums(), or null.
  template <class T, class Sums>
  static T add_path_force(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment,
                          const Rule& rule, Nodal<T>& f, Sums* sums) {
    T least_jacobian(1e300);
    for (std::size_t q = 0; q < geometry.points.size(); ++q) {
      const Gradients<T> dn = shape_gradients(geometry, q);
      const Ends<T> ends(segment, dn);
      const T& weight = geometry.points[q].weight;
      Small<T, G> sum;
      if (!sum_stresses(material, ends, rule, weight, sum, least_jacobian, sums != nullptr ? sums + q : nullptr)) {
        sum = {};
        for (const RulePoint& point : rule.points) {
          Small<T, G> p;
          least_jacobian = lesser(least_jacobian, material.stress(ends.at(point), p));
          const T share = point.weight * weight;
          for (std::size_t i = 0; i < G; ++i)
            for (std::size_t j = 0; j < G; ++j) sum[i][j] += share * p[i][j];
        }
      }
      if constexpr (Material::can_invert) least_jacobian = lesser(least_jacobian, admissibility(material, ends.to));
      add_nodal_forces(sum, dn, f);
    }
    return least_jacobian;
  }

  /// Returns the smaller of two numbers. A call among the time points would spill all registers of vectors.
  template <class T>
  [[gnu::always_inline]] static T lesser(const T& a, const T& b) {
    if constexpr (std::is_same_v<T, Pack>)
      return std::experimental::min(a, b);
    else
      return smaller(a, b);
  }

  /// Adds the moduli of the time points by the end of the segment.
  template <class T>
  [[gnu::always_inline]] static void add_point_moduli(const Material& material, const Ends<T>& ends, const Rule& rule,
                                                      Small<T, C>& sum) {
    for (const RulePoint& point : rule.points) {
      Small<T, G> p;
      Small<T, C> moduli;
      material.stress_and_moduli(ends.at(point), p, moduli);
      const double share = point.weight * point.to;
      for (std::size_t r = 0; r < C; ++r)
        for (std::size_t c = 0; c < C; ++c) sum[r][c] += share * moduli[r][c];
    }
  }

  /// Adds the tangent if sums_along_path().
  template <class T>
  static void add_path_tangent(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment,
                               const Rule& rule, Tangent<T>& k) {
    add_symmetric_tangent(
        geometry,
        [&](std::size_t q, const Gradients<T>& dn, Small<T, C>& sum) {
          const Ends<T> ends(segment, dn);
          const T& weight = geometry.points[q].weight;
          if (sum_moduli(material, ends, rule, weight, sum)) return;
          sum = {};
          add_point_moduli(material, ends, rule, sum);
          for (std::size_t r = 0; r < C; ++r)
            for (std::size_t c = 0; c < C; ++c) sum[r][c] *= weight;
        },
        k);
  }

  /// Sets `sum` to the sum of the rule's stresses, times a factor, lowers `least_jacobian`, and keeps `kept` unless it
  /// is null. Returns false, with nothing but `kept` done, if the points must be evaluated one by one. Only if
  /// sums_along_path().
  template <class T, class Sums>
  [[gnu::always_inline]] static bool sum_stresses(const Material& material, const Ends<T>& ends, const Rule& rule,
                                                  const T& factor, Small<T, G>& sum, T& least_jacobian, Sums* kept) {
    constexpr bool keeps = !std::is_same_v<Sums, char>;
    if constexpr (has_path) {
      typename Material::template Path<G, T> path(material, ends.from, ends.to);
      T least = least_jacobian;
      for (const RulePoint& point : rule.points)
        least = lesser(least, path.template add_stress<keeps>(point.weight, point.to));
      if constexpr (keeps) *kept = path.sums();
      if (!path.is_near()) return false;
      sum = path.stress(factor);
      least_jacobian = least;
    }
    return has_path;
  }
  /// Does the same with the moduli by the end of the segment.
  template <class T>
  [[gnu::always_inline]] static bool sum_moduli(const Material& material, const Ends<T>& ends, const Rule& rule,
                                                const T& factor, Small<T, C>& sum) {
    if constexpr (has_path) {
      typename Material::template Path<G, T> path(material, ends.from, ends.to);
      for (const RulePoint& point : rule.points) path.add_moduli(point.weight * point.to, point.to);
      if (!path.is_near()) return false;
      path.moduli(factor, sum);
    }
    return has_path;
  }

  /// `linearize`(point, dN/dX, F^-1) sets F^-1 and returns the moduli in the deformed body.
  template <class T, class Linearize>
  [[gnu::always_inline]] static void add_spatial_tangent(const Geometry<T>& geometry, const RulePoint& point,
                                                         Tangent<T>& k, const Linearize& linearize) {
    for (std::size_t q = 0; q < geometry.points.size(); q += points_at_once) {
      const std::size_t count = std::min(points_at_once, geometry.points.size() - q);
      std::array<SpatialPoint<T, N, D>, points_at_once> linearized;
      for (std::size_t i = 0; i < count; ++i) {
        SpatialPoint<T, N, D>& result = linearized[i];
        result.reference = shape_gradients(geometry, q + i);
        Small<T, D> inverse;
        result.moduli = linearize(q + i, result.reference, inverse);
        result.moduli.scale(geometry.points[q + i].weight * (point.weight * point.to));
        for (std::size_t a = 0; a < N; ++a)
          for (std::size_t c = 0; c < D; ++c) {
            result.current[a][c] = result.reference[a][0] * inverse[0][c];
            for (std::size_t j = 1; j < D; ++j) result.current[a][c] += result.reference[a][j] * inverse[j][c];
          }
      }
      add_products(linearized, count, k);
    }
  }
};

}  // namespace ixos
