/// The elastic tangent of an element (or a pack of elements) applied without forming its matrix.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "element/elastic_kernel.hpp"
#include "element/point_gradients.hpp"

namespace ixos {

/// The layout of the data that ElasticAction keeps, the same for all elements of D dimensions: lambda times the weight
/// of each time point (those of the rule, and one for the undeformed body if that counts), and whether a mass is
/// included.
template <std::size_t D>
struct ElasticLayout {
  static constexpr std::size_t metric_size = D * (D + 1) / 2;
  static constexpr std::size_t time_point_size = D * D + 1;

  ElasticLayout() = default;
  template <class Material>
  ElasticLayout(const Material& material, const Rule& rule, double rest, double inertia) : has_mass(inertia != 0) {
    for (const RulePoint& time : rule.points) volume_moduli.push_back(material.lame.lambda * time.weight * time.to);
    if (rest != 0) volume_moduli.push_back(material.lame.lambda * rest);
  }
  std::size_t point_size() const { return metric_size + volume_moduli.size() * time_point_size + (has_mass ? 1 : 0); }

  std::vector<double> volume_moduli;
  bool has_mass = false;
};

/// K u from data kept at the quadrature points. With G = dxi/dx at a time point of the rule (J0^-1 F^-1, times the root
/// of the quadrature weight), the spatial tangent (see SpatialTangent) acts on g = du/dxi as
///
///   t = g M + sum over time points of (c (h + h^T) + lambda tr(h) I) G^T,  h = g G,
///
/// where the metric M = sum of G tau G^T, tau = mu b - c I the Kirchhoff stress, is summed over the time points:
/// D (D + 1)/2 numbers a point and D^2 + 1 for each time point, 16 in three dimensions for one; and the point's mass
/// times a factor, so that W u = (K + factor M) u costs little more than K u. Data of an element: points x
/// point_size().
/// The data may be kept in single precision, because the speed of the product is limited by memory. The product is then
/// that of a tangent with errors of 1e-7 in its entries. That tangent is still symmetric, and a rotation still
/// costs no energy in it, as h + h^T is summed in double precision. The type of `data` selects the precision. With T in
/// single precision, too, a rotation costs 1e-7 of the energy of a strain of its size.
template <class Element, class Material>
struct ElasticAction {
  using Kernel = ElasticKernel<Element, Material>;
  static constexpr std::size_t D = Kernel::D;
  static constexpr std::size_t N = Kernel::N;
  using Layout = ElasticLayout<D>;
  static constexpr std::size_t metric_size = Layout::metric_size;
  static constexpr std::size_t time_point_size = Layout::time_point_size;
  /// The action of the same data on another element's nodes.
  template <class Other>
  using On = ElasticAction<Other, Material>;
  template <class T>
  using Nodal = typename Kernel::template Nodal<T>;

  template <class T>
  using Scratch = PointScratch<D, T>;

  /// Fills `data` for the rule's tangent at the segment, plus `rest` times the tangent of the undeformed body, plus
  /// `inertia` (a factor times the density) times the mass of unit density.
  template <class T, class Kept>
  static void linearize(const Material& material, const typename Kernel::template Geometry<T>& geometry,
                        const typename Kernel::template Segment<T>& segment, const Rule& rule, double rest,
                        double inertia, Kept* data) {
    using std::sqrt;
    for (std::size_t q = 0; q < geometry.points.size(); ++q) {
      const auto& point = geometry.points[q];
      const Small<T, D>& to_reference = point.inverse_jacobian;
      const T root = sqrt(point.weight);
      const auto dn = Kernel::shape_gradients(geometry, q);
      const typename Kernel::template Ends<T> ends(segment, dn);
      Small<T, D> metric{};
      Kept* time_point = data + metric_size;
      const auto add = [&](const Small<T, D>& h, double weight) {
        Small<T, D> inverse_deformation, gradient;
        SpatialTangent<T> moduli = material.spatial_tangent(h, inverse_deformation);
        moduli.scale(weight);
        for (std::size_t d = 0; d < D; ++d)
          for (std::size_t i = 0; i < D; ++i) {
            T sum = to_reference[d][0] * inverse_deformation[0][i];
            for (std::size_t j = 1; j < D; ++j) sum += to_reference[d][j] * inverse_deformation[j][i];
            gradient[d][i] = root * sum;
            *time_point++ = narrow<Kept>(gradient[d][i]);
          }
        *time_point++ = narrow<Kept>(moduli.c);
        for (std::size_t d = 0; d < D; ++d)
          for (std::size_t e = d; e < D; ++e)
            for (std::size_t j = 0; j < D; ++j)
              metric[d][e] += moduli.mu * point.weight * to_reference[d][j] * to_reference[e][j] -
                              moduli.c * gradient[d][j] * gradient[e][j];
      };
      for (const RulePoint& time : rule.points) add(ends.at(time), time.weight * time.to);
      if (rest != 0) add({}, rest);
      for (std::size_t d = 0; d < D; ++d)
        for (std::size_t e = d; e < D; ++e) *data++ = narrow<Kept>(metric[d][e]);
      data = time_point;
      if (inertia != 0) *data++ = narrow<Kept>(T(inertia * point.weight));
    }
  }

  /// Adds W u to f.
  template <class T, class Kept>
  static void add_product(const ShapeTable<Element>& table, const Layout& layout, const Kept* data, const Nodal<T>& u,
                          Scratch<T>& scratch, Nodal<T>& f) {
    if (layout.has_mass)
      add_product<true>(table, layout, data, u, scratch, f);
    else
      add_product<false>(table, layout, data, u, scratch, f);
  }

  /// Adds the diagonal of K to d, without that of the mass.
  template <class T, class Kept>
  static void add_diagonal(const ShapeTable<Element>& table, const Layout& layout, const Kept* data,
                           Nodal<T>& diagonal) {
    for (std::size_t q = 0; q < table.size(); ++q) {
      for (std::size_t a = 0; a < N; ++a) {
        const auto& dn = table.gradient[q][a];
        T along(0.0);
        for (std::size_t d = 0; d < D; ++d)
          for (std::size_t e = 0; e < D; ++e) along += (dn[d] * dn[e]) * widen<T>(data[metric_index(d, e)]);
        for (std::size_t p = 0; p < layout.volume_moduli.size(); ++p) {
          const Kept* point = data + metric_size + p * time_point_size;
          const T c = widen<T>(point[D * D]);
          Small<T, 1, D> current{};
          T square(0.0);
          for (std::size_t i = 0; i < D; ++i) {
            for (std::size_t d = 0; d < D; ++d) current[0][i] += dn[d] * widen<T>(point[d * D + i]);
            square += current[0][i] * current[0][i];
          }
          for (std::size_t i = 0; i < D; ++i)
            diagonal[a][i] += c * square + (c + layout.volume_moduli[p]) * current[0][i] * current[0][i];
        }
        for (std::size_t i = 0; i < D; ++i) diagonal[a][i] += along;
      }
      data += layout.point_size();
    }
  }

 private:
  template <bool HasMass, class T, class Kept>
  static void add_product(const ShapeTable<Element>& table, const Layout& layout, const Kept* data, const Nodal<T>& u,
                          Scratch<T>& scratch, Nodal<T>& f) {
    Small<T, D>* gradients = scratch.gradients.data();
    std::array<T, D>* values = HasMass ? scratch.values.data() : nullptr;
    PointGradients<Element>::template evaluate<HasMass>(table, u, gradients, values);
    if constexpr (HasMass) scratch.complete_values();
    const std::size_t point_size = layout.point_size();
    for (std::size_t q = 0; q < table.size(); ++q, data += point_size) {
      if constexpr (D == 3) prefetch(data + table.size() * point_size, point_size);
      multiply_point<HasMass>(layout.volume_moduli, data, gradients[q], HasMass ? values + q : nullptr);
    }
    PointGradients<Element>::template integrate<HasMass>(table, gradients, values, f);
  }

  // These functions are inlined: as calls for each point, through memory, they would halve the speed.

  /// Returns the position of an entry in the upper triangle, stored row by row.
  static constexpr std::size_t metric_index(std::size_t d, std::size_t e) {
    return d > e ? metric_index(e, d) : d * D - d * (d + 1) / 2 + e;
  }

  template <class T, class Kept>
  [[gnu::always_inline]] static void multiply_metric(const Kept* data, const Small<T, D>& g, Small<T, D>& t) {
    Small<T, D> metric;
    for (std::size_t d = 0; d < D; ++d)
      for (std::size_t e = d; e < D; ++e) metric[d][e] = metric[e][d] = widen<T>(*data++);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t d = 0; d < D; ++d) {
        t[i][d] = g[i][0] * metric[0][d];
        for (std::size_t e = 1; e < D; ++e) t[i][d] += g[i][e] * metric[e][d];
      }
  }

  template <class T, class Kept>
  [[gnu::always_inline]] static void add_time_point(const Kept* data, double lambda, const Small<T, D>& g,
                                                    Small<T, D>& t) {
    Small<T, D> gradient, h, s;
    for (std::size_t d = 0; d < D; ++d)
      for (std::size_t i = 0; i < D; ++i) gradient[d][i] = widen<T>(*data++);
    const T c = widen<T>(*data);
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) {
        h[i][j] = g[i][0] * gradient[0][j];
        for (std::size_t d = 1; d < D; ++d) h[i][j] += g[i][d] * gradient[d][j];
      }
    T trace = h[0][0];
    for (std::size_t d = 1; d < D; ++d) trace += h[d][d];
    trace = lambda * trace;
    for (std::size_t i = 0; i < D; ++i) {
      s[i][i] = (c + c) * h[i][i] + trace;
      for (std::size_t j = i + 1; j < D; ++j) s[i][j] = s[j][i] = c * (h[i][j] + h[j][i]);
    }
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t d = 0; d < D; ++d) {
        T sum = s[i][0] * gradient[d][0];
        for (std::size_t j = 1; j < D; ++j) sum += s[i][j] * gradient[d][j];
        t[i][d] += sum;
      }
  }

  template <bool HasMass, class T, class Kept>
  [[gnu::always_inline]] static void multiply_point(const std::vector<double>& volume_moduli, const Kept* data,
                                                    Small<T, D>& gradient, std::array<T, D>* value) {
    const Small<T, D> g = gradient;
    Small<T, D> t;
    multiply_metric(data, g, t);
    data += metric_size;
    // A rule has at least one point. With that one in the loop, a product with a single point takes 15 % longer.
    add_time_point(data, volume_moduli[0], g, t);
    data += time_point_size;
    for (std::size_t p = 1; p < volume_moduli.size(); ++p, data += time_point_size)
      add_time_point(data, volume_moduli[p], g, t);
    gradient = t;
    if constexpr (HasMass)
      for (T& v : *value) v *= widen<T>(*data);
  }
};

}  // namespace ixos
