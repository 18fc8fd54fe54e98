/// The part of kernels that follows from an element alone: geometry, displacement gradients, forces and tangents of
/// what laws give.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "element/displacement_gradient.hpp"
#include "element/node_pairs.hpp"
#include "element/point_gradients.hpp"
#include "fem/shape_table.hpp"
#include "material/points.hpp"
#include "rule/rule.hpp"

namespace ixos {

/// The space in which an element's bodies deform.
template <class Element>
using SpaceOf = std::conditional_t<IsRevolved<Element>::value, RingSpace,
                                   std::conditional_t<Element::dimension == 2, PlaneSpace, SolidSpace>>;

/// Isoparametric displacement element. T is double, Pack, or an AD type. Nodal arrays are [node][component]; a tangent
/// is [node D + component][node D + component]. A Revolved element is a ring: forces and energies are those of the
/// whole ring. The kernel knows no law.
template <class Element>
struct CellKernel {
  using Shape = Element;
  using Space = SpaceOf<Element>;
  static constexpr std::size_t D = Element::dimension;
  static constexpr std::size_t N = Element::nodes;
  /// Displacement gradients are G x G, of which moduli connect C components.
  static constexpr std::size_t G = Space::G;
  static constexpr std::size_t C = Space::C;
  static constexpr bool revolved = IsRevolved<Element>::value;
  using Table = ShapeTable<Element>;

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
  /// The ends of the segment: u_from and h v_from may be null if the rule does not use them, and so may the iterate.
  template <class T>
  struct Segment {
    const Nodal<T>* from;
    const Nodal<T>* velocity;
    const Nodal<T>* to;
    const Nodal<T>* iterate = nullptr;
    double way = 1;  ///< see ixos::Segment
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

  /// Returns the reference volume.
  template <class T>
  static T volume(const Geometry<T>& geometry) {
    T sum(0.0);
    for (const Point<T>& point : geometry.points) sum += point.weight;
    return sum;
  }

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

  /// Points that the functions below take at once: all of an element with the default number, at most 32, so that their
  /// gradients stay in the nearest caches.
  static constexpr std::size_t batch = [] {
    std::size_t count = 1;
    if constexpr (HasRule<Element>::value)
      count = Element::most_points;
    else
      for (const int along : Element::default_points) count *= static_cast<std::size_t>(along);
    return std::min<std::size_t>(std::max<std::size_t>(count, 4), 32);
  }();

  /// Calls visit(first, count) for the points in batches.
  template <class T, class Visit>
  [[gnu::always_inline]] static void for_each_batch(const Geometry<T>& geometry, const Visit& visit) {
    const std::size_t size = geometry.points.size();
    for (std::size_t first = 0; first < size; first += batch) visit(first, std::min(batch, size - first));
  }

  // These two are compiled once a cell type, for all that calls them.

  /// Computes the displacement gradients of the points of a batch.
  template <class T>
  [[gnu::noinline]] static void gradients(const Geometry<T>& geometry, std::size_t first, std::size_t count,
                                          const Nodal<T>& u, Small<T, G>* h) {
    if constexpr (is_factorised) {
      if (count == geometry.points.size()) {
        PointGradients<Element>::template evaluate<false>(*geometry.table, u, h,
                                                          static_cast<std::array<T, D>*>(nullptr));
        for (std::size_t q = 0; q < count; ++q) h[q] = product(h[q], geometry.points[q].inverse_jacobian);
        return;
      }
    }
    for (std::size_t q = 0; q < count; ++q) h[q] = gradient(u, shape_gradients(geometry, first + q));
  }

  /// Adds the nodal forces of stresses at the points of a batch, which it spoils: f_ai += weight P_iJ dN_a/dX_J.
  template <class T>
  [[gnu::noinline]] static void add_forces(const Geometry<T>& geometry, std::size_t first, std::size_t count,
                                           Small<T, G>* p, Nodal<T>& f) {
    if constexpr (is_factorised) {
      if (count == geometry.points.size()) {
        for (std::size_t q = 0; q < count; ++q) p[q] = in_element_coordinates(geometry.points[q], p[q]);
        PointGradients<Element>::template integrate<false>(*geometry.table, p,
                                                           static_cast<const std::array<T, D>*>(nullptr), f);
        return;
      }
    }
    for (std::size_t q = 0; q < count; ++q) {
      const T& weight = geometry.points[first + q].weight;
      for (auto& row : p[q])
        for (T& value : row) value *= weight;
      add_nodal_forces(p[q], shape_gradients(geometry, first + q), f);
    }
  }

  /// The displacement gradients at the ends of a segment, at the points of a batch.
  template <class T>
  class Ends {
   public:
    Ends(const Geometry<T>& geometry, std::size_t first, std::size_t count, const Segment<T>& segment)
        : count_(count),
          has_from_(segment.from != nullptr),
          has_velocity_(segment.velocity != nullptr),
          has_iterate_(segment.iterate != nullptr),
          way_(segment.way) {
      gradients(geometry, first, count, *segment.to, to_.data());
      if (has_from_) gradients(geometry, first, count, *segment.from, from_.data());
      if (has_velocity_) gradients(geometry, first, count, *segment.velocity, velocity_.data());
      if (has_iterate_) gradients(geometry, first, count, *segment.iterate, iterate_.data());
    }
    PointEnds<T, G> points() const {
      return {count_,
              to_.data(),
              has_from_ ? from_.data() : nullptr,
              has_velocity_ ? velocity_.data() : nullptr,
              has_iterate_ ? iterate_.data() : nullptr,
              way_};
    }

   private:
    std::size_t count_;
    bool has_from_, has_velocity_, has_iterate_;
    double way_;
    std::array<Small<T, G>, batch> to_, from_, velocity_, iterate_;
  };

  /// Adds the tangent of the points of a batch from `first` on: `moduli`(point, count, A) computes the moduli of some
  /// of them, counted from the first of the batch. `symmetric`: they are.
  template <class T, class Moduli>
  [[gnu::always_inline]] static void add_tangent_of(const Geometry<T>& geometry, std::size_t first, std::size_t size,
                                                    bool symmetric, const Moduli& moduli, Tangent<T>& k) {
    for (std::size_t begin = 0; begin < size; begin += contractions_at_once) {
      const std::size_t count = std::min(contractions_at_once, size - begin);
      std::array<Small<T, C>, contractions_at_once> a;
      moduli(begin, count, a.data());
      for (std::size_t q = 0; q < count; ++q)
        for (auto& row : a[q])
          for (T& value : row) value *= geometry.points[first + begin + q].weight;
      if (!symmetric) {
        for (std::size_t q = 0; q < count; ++q) {
          const Gradients<T> dn = shape_gradients(geometry, first + begin + q);
          add_contraction<false>(dn, dn, a[q], k);
        }
      } else if constexpr (D == 3) {
        std::array<ModuliPoint<T, N, D>, contractions_at_once> points;
        for (std::size_t q = 0; q < count; ++q) points[q] = {shape_gradients(geometry, first + begin + q), a[q]};
        add_contractions(points, count, k);
      } else {
        for (std::size_t q = 0; q < count; ++q) {
          const Gradients<T> dn = shape_gradients(geometry, first + begin + q);
          add_contraction<true>(dn, dn, a[q], k);
        }
      }
    }
  }

  /// Adds the tangent of the points of a batch by their moduli in the deformed body, times a factor. In three
  /// dimensions, with one time point, this is twice as fast as by those in the undeformed body.
  template <class T, class States>
  [[gnu::always_inline]] static void add_spatial_tangent(const Geometry<T>& geometry, std::size_t first,
                                                         std::size_t size, double factor, const States& states,
                                                         Tangent<T>& k) {
    for (std::size_t begin = 0; begin < size; begin += points_at_once) {
      const std::size_t count = std::min(points_at_once, size - begin);
      std::array<SpatialState<T, G>, points_at_once> here;
      states(begin, count, here.data());
      std::array<SpatialPoint<T, N, D>, points_at_once> linearized;
      for (std::size_t q = 0; q < count; ++q) {
        SpatialPoint<T, N, D>& result = linearized[q];
        result.reference = shape_gradients(geometry, first + begin + q);
        result.moduli = here[q].moduli;
        result.moduli.scale(geometry.points[first + begin + q].weight * factor);
        const Small<T, G>& inverse = here[q].inverse;
        for (std::size_t a = 0; a < N; ++a)
          for (std::size_t c = 0; c < D; ++c) {
            result.current[a][c] = result.reference[a][0] * inverse[0][c];
            for (std::size_t j = 1; j < D; ++j) result.current[a][c] += result.reference[a][j] * inverse[j][c];
          }
      }
      add_products(linearized, count, k);
    }
  }

 protected:
  /// Returns gradients by X from those by the element's coordinates.
  template <class T>
  static Small<T, D> product(const Small<T, D>& g, const Small<T, D>& inverse) {
    Small<T, D> h;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        h[i][j] = g[i][0] * inverse[0][j];
        for (std::size_t d = 1; d < D; ++d) h[i][j] += g[i][d] * inverse[d][j];
      }
    return h;
  }
  /// Returns weight P dxi/dX^T, for integrals with gradients by the element's coordinates; of a ring without the hoop.
  template <class T>
  static Small<T, D> in_element_coordinates(const Point<T>& point, const Small<T, G>& p) {
    Small<T, D> t;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t d = 0; d < D; ++d) {
        T sum = p[i][0] * point.inverse_jacobian[d][0];
        for (std::size_t j = 1; j < D; ++j) sum += p[i][j] * point.inverse_jacobian[d][j];
        t[i][d] = point.weight * sum;
      }
    return t;
  }

 private:
  /// Whether gradients of all points together take less than those of single points: not for cells of few nodes.
  static constexpr bool is_factorised = !revolved && (D == 3 || N > 6);
};

}  // namespace ixos
