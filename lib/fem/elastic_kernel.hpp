/// Energy, force and tangent of one element (or one pack of elements), over any scalar type.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "fem/rule.hpp"
#include "fem/shape_table.hpp"
#include "material/spatial_tangent.hpp"

namespace ixos {

/// Isoparametric displacement element with a hyperelastic material. T is double, Pack, or an AD type. Nodal arrays are
/// [node][component]; the tangent is [node D + component][node D + component].
///
/// On every path that a rule knows, the displacement gradient at a time point is a fixed combination of those of the
/// segment's ends, so time points are looped inside the quadrature point: one gather, one B^T A B and one scatter serve
/// any number of them.
template <class Element, class Material>
struct ElasticKernel {
  static constexpr std::size_t D = Element::dimension;
  static constexpr std::size_t N = Element::nodes;
  using Shape = Element;
  using Law = Material;
  using Table = ShapeTable<Element>;
  /// Does the kernel know Mean::DiscreteGradient?
  static constexpr bool has_discrete_gradient = true;

  template <class T>
  using Nodal = Small<T, N, D>;
  template <class T>
  using Tangent = Small<T, N * D>;

  /// At one quadrature point: dxi_d/dX_J, and quadrature weight times reference volume [L0^D].
  template <class T>
  struct Point {
    Small<T, D> inverse_jacobian;
    T weight;
  };
  /// The element's points; the table must outlive it.
  template <class T>
  struct Geometry {
    const Table* table;
    std::vector<Point<T>> points;
  };

  /// The ends of the segment: u_from and h v_from may be null where the rule does not use them.
  template <class T>
  struct Segment {
    const Nodal<T>* from;
    const Nodal<T>* velocity;
    const Nodal<T>* to;
  };

  /// Geometry from nodal coordinates X [L0]. The caller checks that all weights are positive.
  template <class T>
  static Geometry<T> geometry(const Table& table, const Nodal<T>& x) {
    Geometry<T> result{&table, std::vector<Point<T>>(table.size())};
    for (std::size_t q = 0; q < table.size(); ++q) {
      Small<T, D> jacobian{};
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t d = 0; d < D; ++d) jacobian[i][d] += x[a][i] * table.gradient[q][a][d];
      const T det = determinant(jacobian);
      result.points[q].inverse_jacobian = inverse(jacobian, det);
      result.points[q].weight = det * table.weight[q];
    }
    return result;
  }

  /// Stored energy [E0 L0^D].
  template <class T>
  static T energy(const Material& material, const Geometry<T>& geometry, const Nodal<T>& u) {
    T sum(0.0);
    for (std::size_t q = 0; q < geometry.points.size(); ++q)
      sum += geometry.points[q].weight * material.energy(gradient(u, shape_gradients(geometry, q)));
    return sum;
  }

  /// Means over the reference volume: tr(sigma) [E0], J, W [E0], in this order. tr(sigma) = P:F/J, and in plane strain
  /// the stress out of the plane.
  template <class T>
  static std::array<T, 3> means(const Material& material, const Geometry<T>& geometry, const Nodal<T>& u) {
    std::array<T, 3> sums{T(0.0), T(0.0), T(0.0)};
    T volume(0.0);
    for (std::size_t q = 0; q < geometry.points.size(); ++q) {
      const T& w = geometry.points[q].weight;
      add_means(material, gradient(u, shape_gradients(geometry, q)), w, sums);
      volume += w;
    }
    for (T& sum : sums) sum = sum / volume;
    return sums;
  }

  /// Adds the rule's force to f. Returns the least J of the time points and of the segment's end, lane
  /// by lane.
  template <class T>
  static T add_force(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment, const Rule& rule,
                     Nodal<T>& f) {
    T least_jacobian(1e300);
    for (std::size_t q = 0; q < geometry.points.size(); ++q) {
      const Nodal<T> dn = shape_gradients(geometry, q);
      const Ends<T> ends(segment, dn);
      Small<T, D> mean{};
      for (const RulePoint& point : rule.points) {
        Small<T, D> p;
        least_jacobian = smaller(least_jacobian, material.stress(ends.at(point), p));
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t j = 0; j < D; ++j) mean[i][j] += point.weight * p[i][j];
      }
      if (rule.mean == Mean::DiscreteGradient) material.discrete_gradient(ends.from, ends.to, mean);
      if constexpr (Material::can_invert) least_jacobian = smaller(least_jacobian, ends.jacobian());
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) mean[i][j] *= geometry.points[q].weight;
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t j = 0; j < D; ++j) f[a][i] += mean[i][j] * dn[a][j];
    }
    return least_jacobian;
  }

  /// Adds the rule's tangent dF/du_s to k.
  template <class T>
  static void add_tangent(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment,
                          const Rule& rule, Tangent<T>& k) {
    // One time point in three dimensions: the spatial form is twice as fast. Several share the contraction of their
    // mean moduli.
    if (has_spatial_tangent(rule))
      return for_each_node_pair(material, geometry, segment, rule,
                                [&k](std::size_t a, std::size_t b, const auto& block) {
                                  for (std::size_t i = 0; i < D; ++i)
                                    for (std::size_t j = 0; j < D; ++j) k[a * D + i][b * D + j] += block[i][j];
                                });
    for (std::size_t q = 0; q < geometry.points.size(); ++q) {
      const Nodal<T> dn = shape_gradients(geometry, q);
      const Ends<T> ends(segment, dn);
      Small<T, D * D> mean{};
      for (const RulePoint& point : rule.points) {
        Small<T, D> p;
        Small<T, D * D> moduli;
        material.stress_and_moduli(ends.at(point), p, moduli);
        const double weight = point.weight * point.to;
        for (std::size_t r = 0; r < D * D; ++r)
          for (std::size_t c = 0; c < D * D; ++c) mean[r][c] += weight * moduli[r][c];
      }
      if (rule.mean == Mean::DiscreteGradient) material.discrete_gradient_moduli(ends.from, ends.to, mean);
      for (std::size_t r = 0; r < D * D; ++r)
        for (std::size_t c = 0; c < D * D; ++c) mean[r][c] *= geometry.points[q].weight;
      if (rule.is_gradient())
        add_contraction<true>(dn, mean, k);
      else
        add_contraction<false>(dn, mean, k);
    }
  }

  /// Does for_each_node_pair() know the rule's tangent?
  static bool has_spatial_tangent(const Rule& rule) {
    return D == 3 && rule.points.size() == 1 && rule.mean == Mean::Points;
  }

  /// sink(a, b, block) adds a part of the rule's tangent, rows of node a and columns of node b: nodes' blocks go to the
  /// matrix as they are made.
  template <class T, class Sink>
  static void for_each_node_pair(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment,
                                 const Rule& rule, const Sink& sink) {
    for (std::size_t q = 0; q < geometry.points.size(); q += chunk) {
      const std::size_t count = std::min(chunk, geometry.points.size() - q);
      std::array<Linearized<T>, chunk> linearized;
      for (std::size_t i = 0; i < count; ++i)
        linearize(material, geometry, segment, rule.points[0], q + i, linearized[i]);
      add_products(linearized, count, sink);
    }
  }

  /// Displacement gradients at the ends of the segment.
  template <class T>
  struct Ends {
    Ends(const Segment<T>& segment, const Nodal<T>& dn) : to(gradient(*segment.to, dn)) {
      has_from = segment.from != nullptr;
      has_velocity = segment.velocity != nullptr;
      if (has_from) from = gradient(*segment.from, dn);
      if (has_velocity) velocity = gradient(*segment.velocity, dn);
    }

    Small<T, D> at(const RulePoint& point) const {
      Small<T, D> h;
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) {
          h[i][j] = point.to * to[i][j];
          if (has_from) h[i][j] += point.from * from[i][j];
          if (has_velocity) h[i][j] += point.velocity * velocity[i][j];
        }
      return h;
    }

    /// J at the end of the segment.
    T jacobian() const {
      Small<T, D> f = to;
      for (std::size_t i = 0; i < D; ++i) f[i][i] += 1.0;
      return determinant(f);
    }

    Small<T, D> to, from, velocity;
    bool has_from, has_velocity;
  };

  /// dN_a/dX_J at point q.
  template <class T>
  static Nodal<T> shape_gradients(const Geometry<T>& geometry, std::size_t q) {
    const auto& reference = geometry.table->gradient[q];
    const Point<T>& point = geometry.points[q];
    Nodal<T> dn{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t j = 0; j < D; ++j)
        for (std::size_t d = 0; d < D; ++d) dn[a][j] += reference[a][d] * point.inverse_jacobian[d][j];
    return dn;
  }

  /// H_iJ = sum_a u_ai dN_a/dX_J.
  template <class T>
  static Small<T, D> gradient(const Nodal<T>& u, const Nodal<T>& dn) {
    Small<T, D> h{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) h[i][j] += u[a][i] * dn[a][j];
    return h;
  }

 protected:
  /// Adds weight times the values of means() at a point with displacement gradient h.
  template <class T>
  static void add_means(const Material& material, const Small<T, D>& h, const T& weight, std::array<T, 3>& sums) {
    Small<T, D> p;
    const T jacobian = material.stress(h, p);
    T trace(0.0);
    for (std::size_t i = 0; i < D; ++i) {
      trace += p[i][i];
      for (std::size_t j = 0; j < D; ++j) trace += p[i][j] * h[i][j];
    }
    trace = trace / jacobian;
    if constexpr (D == 2) trace += material.out_of_plane_stress(h);
    sums[0] += weight * trace;
    sums[1] += weight * jacobian;
    sums[2] += weight * material.energy(h);
  }

  /// Points that add_products() takes at once: their gradients stay in the nearest cache.
  static constexpr std::size_t chunk = 8;

  /// The tangent at one quadrature and time point: shape gradients in the reference and in the deformed body, and the
  /// material's coefficients times the weights.
  template <class T>
  struct Linearized {
    Nodal<T> reference, current;
    SpatialTangent<T> moduli;
  };

  template <class T>
  [[gnu::always_inline]] static void linearize(const Material& material, const Geometry<T>& geometry,
                                               const Segment<T>& segment, const RulePoint& point, std::size_t q,
                                               Linearized<T>& result) {
    result.reference = shape_gradients(geometry, q);
    const Ends<T> ends(segment, result.reference);
    Small<T, D> inverse_deformation;
    result.moduli = material.spatial_tangent(ends.at(point), inverse_deformation);
    result.moduli.scale(geometry.points[q].weight * (point.weight * point.to));
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t i = 0; i < D; ++i) {
        result.current[a][i] = result.reference[a][0] * inverse_deformation[0][i];
        for (std::size_t j = 1; j < D; ++j) result.current[a][i] += result.reference[a][j] * inverse_deformation[j][i];
      }
  }

  /// k_ai,bk = sum over points of mu (n_a . n_b) delta_ik + c g_bi g_ak + lambda g_ai g_bk, see SpatialTangent; n and
  /// g are the shape gradients in the reference and the deformed body. Node pairs are the outer loop, so that sums stay
  /// in registers; one triangle is computed and mirrored.
  template <class T, class Sink>
  static void add_products(const std::array<Linearized<T>, chunk>& points, std::size_t count, const Sink& sink) {
    for (std::size_t b = 0; b < N; ++b) {
      std::array<std::array<T, D>, chunk> n, c, l;
      for (std::size_t q = 0; q < count; ++q)
        for (std::size_t i = 0; i < D; ++i) {
          n[q][i] = points[q].moduli.mu * points[q].reference[b][i];
          c[q][i] = points[q].moduli.c * points[q].current[b][i];
          l[q][i] = points[q].moduli.lambda * points[q].current[b][i];
        }
      for (std::size_t a = 0; a <= b; ++a) {
        Small<T, D> sum{};
        T along(0.0);
        for (std::size_t q = 0; q < count; ++q) {
          const auto& reference = points[q].reference[a];
          const auto& current = points[q].current[a];
          for (std::size_t i = 0; i < D; ++i) {
            along += reference[i] * n[q][i];
            for (std::size_t j = 0; j < D; ++j) sum[i][j] += c[q][i] * current[j] + current[i] * l[q][j];
          }
        }
        for (std::size_t i = 0; i < D; ++i) sum[i][i] += along;
        sink(a, b, sum);
        if (a == b) continue;
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t j = 0; j < i; ++j) std::swap(sum[i][j], sum[j][i]);
        sink(b, a, sum);
      }
    }
  }

  /// k_ai,bk += dN_a,J A_iJkL dN_b,L; of symmetric moduli the upper triangle of node pairs is computed and mirrored.
  template <bool symmetric, class T, std::size_t M>
  static void add_contraction(const Small<T, M, D>& dn, const Small<T, D * D>& moduli, Small<T, M * D>& k) {
    for (std::size_t b = 0; b < M; ++b) {
      Small<T, D * D, D> right{};  // A_iJkL dN_b,L
      for (std::size_t r = 0; r < D * D; ++r)
        for (std::size_t c = 0; c < D; ++c)
          for (std::size_t l = 0; l < D; ++l) right[r][c] += moduli[r][c * D + l] * dn[b][l];
      for (std::size_t a = 0; a < (symmetric ? b + 1 : M); ++a)
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t c = 0; c < D; ++c) {
            T sum = dn[a][0] * right[i * D][c];
            for (std::size_t j = 1; j < D; ++j) sum += dn[a][j] * right[i * D + j][c];
            k[a * D + i][b * D + c] += sum;
            if (symmetric && a != b) k[b * D + c][a * D + i] += sum;
          }
    }
  }
};

}  // namespace ixos
