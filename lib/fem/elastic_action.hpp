/// The elastic tangent of an element (or a pack of elements) applied without forming its matrix.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "fem/elastic_kernel.hpp"
#include "fem/point_gradients.hpp"

namespace ixos {

/// K u from data kept at the quadrature points. With G = dxi/dx at a time point of the rule (J0^-1 F^-1, times the root
/// of the quadrature weight), the spatial tangent (see SpatialTangent) acts on g = du/dxi as
///
///   t = g M + sum over time points of (c S^T + lambda tr(S) I) G,  S = G g,
///
/// where the metric M = sum of mu w J0^-1 J0^-T does not know the deformation: D (D + 1)/2 numbers a point and D^2 + 1
/// for each time point, 16 in three dimensions for one. Data of an element: points x packs_per_point, T each.
template <class Element, class Material>
struct ElasticAction {
  using Kernel = ElasticKernel<Element, Material>;
  static constexpr std::size_t D = Kernel::D;
  static constexpr std::size_t N = Kernel::N;
  static constexpr std::size_t metric_size = D * (D + 1) / 2;
  static constexpr std::size_t time_point_size = D * D + 1;
  template <class T>
  using Nodal = typename Kernel::template Nodal<T>;

  static std::size_t size(std::size_t points, std::size_t time_points) {
    return points * (metric_size + time_points * time_point_size);
  }

  /// Fills `data` for the rule's tangent at the segment, plus `rest` times the tangent of the undeformed body. The time
  /// points are those of the rule, and one for the rest if `rest` is not 0.
  template <class T>
  static void linearize(const Material& material, const typename Kernel::template Geometry<T>& geometry,
                        const typename Kernel::template Segment<T>& segment, const Rule& rule, double rest, T* data) {
    using std::sqrt;
    for (std::size_t q = 0; q < geometry.points.size(); ++q) {
      const auto& point = geometry.points[q];
      const Small<T, D>& to_reference = point.inverse_jacobian;
      T* metric = data;
      data += metric_size;
      const T root = sqrt(point.weight);
      const auto dn = Kernel::shape_gradients(geometry, q);
      const typename Kernel::template Ends<T> ends(segment, dn);
      double mu = 0;
      const auto add = [&](const Small<T, D>& h, double weight) {
        Small<T, D> inverse_deformation;
        const SpatialTangent<T> moduli = material.spatial_tangent(h, inverse_deformation);
        for (std::size_t d = 0; d < D; ++d)
          for (std::size_t i = 0; i < D; ++i) {
            T sum = to_reference[d][0] * inverse_deformation[0][i];
            for (std::size_t j = 1; j < D; ++j) sum += to_reference[d][j] * inverse_deformation[j][i];
            *data++ = root * sum;
          }
        *data++ = weight * moduli.c;
        mu += weight * material.lame.mu;
      };
      for (const RulePoint& time : rule.points) add(ends.at(time), time.weight * time.to);
      if (rest != 0) add({}, rest);
      for (std::size_t d = 0; d < D; ++d)
        for (std::size_t e = d; e < D; ++e) {
          T sum = to_reference[d][0] * to_reference[e][0];
          for (std::size_t j = 1; j < D; ++j) sum += to_reference[d][j] * to_reference[e][j];
          *metric++ = mu * point.weight * sum;
        }
    }
  }

  /// lambda times the weights of the time points that linearize() was given.
  static std::vector<double> volume_moduli(const Material& material, const Rule& rule, double rest) {
    std::vector<double> moduli;
    for (const RulePoint& time : rule.points) moduli.push_back(material.lame.lambda * time.weight * time.to);
    if (rest != 0) moduli.push_back(material.lame.lambda * rest);
    return moduli;
  }

  /// f += K u. `gradients`: scratch for as many points as the table has.
  template <class T>
  static void add_product(const ShapeTable<Element>& table, const std::vector<double>& volume_moduli, const T* data,
                          const Nodal<T>& u, Small<T, D>* gradients, Nodal<T>& f) {
    PointGradients<Element>::evaluate(table, u, gradients);
    constexpr std::size_t usual = 1 << D;
    if (table.size() == usual && volume_moduli.size() == 1)
      multiply_points<usual, 1>(volume_moduli, data, gradients);
    else if (table.size() == usual && volume_moduli.size() == 2)
      multiply_points<usual, 2>(volume_moduli, data, gradients);
    else
      for (std::size_t q = 0; q < table.size(); ++q) {
        const Small<T, D> g = gradients[q];
        multiply_metric(data, g, gradients[q]);
        data += metric_size;
        for (const double lambda : volume_moduli) {
          add_time_point(data, lambda, g, gradients[q]);
          data += time_point_size;
        }
      }
    PointGradients<Element>::integrate(table, gradients, f);
  }

  /// d += the diagonal of K.
  template <class T>
  static void add_diagonal(const ShapeTable<Element>& table, const std::vector<double>& volume_moduli, const T* data,
                           Nodal<T>& diagonal) {
    for (std::size_t q = 0; q < table.size(); ++q) {
      for (std::size_t a = 0; a < N; ++a) {
        const auto& dn = table.gradient[q][a];
        T along(0.0);
        for (std::size_t d = 0; d < D; ++d)
          for (std::size_t e = 0; e < D; ++e) along += (dn[d] * dn[e]) * data[metric_index(d, e)];
        for (std::size_t p = 0; p < volume_moduli.size(); ++p) {
          const T* point = data + metric_size + p * time_point_size;
          for (std::size_t i = 0; i < D; ++i) {
            T current = dn[0] * point[i];
            for (std::size_t d = 1; d < D; ++d) current += dn[d] * point[d * D + i];
            diagonal[a][i] += (point[D * D] + volume_moduli[p]) * current * current;
          }
        }
        for (std::size_t i = 0; i < D; ++i) diagonal[a][i] += along;
      }
      data += metric_size + volume_moduli.size() * time_point_size;
    }
  }

 private:
  // The compiler would call these for each point, through memory: half the speed.

  /// Of the upper triangle, row by row.
  static constexpr std::size_t metric_index(std::size_t d, std::size_t e) {
    return d > e ? metric_index(e, d) : d * D - d * (d + 1) / 2 + e;
  }

  template <class T>
  [[gnu::always_inline]] static void multiply_metric(const T* data, const Small<T, D>& g, Small<T, D>& t) {
    Small<T, D> metric;
    for (std::size_t d = 0; d < D; ++d)
      for (std::size_t e = d; e < D; ++e) metric[d][e] = metric[e][d] = *data++;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t d = 0; d < D; ++d) {
        t[i][d] = g[i][0] * metric[0][d];
        for (std::size_t e = 1; e < D; ++e) t[i][d] += g[i][e] * metric[e][d];
      }
  }

  template <class T>
  [[gnu::always_inline]] static void add_time_point(const T* data, double lambda, const Small<T, D>& g,
                                                    Small<T, D>& t) {
    const T& c = data[D * D];
    Small<T, D> s;
    for (std::size_t d = 0; d < D; ++d)
      for (std::size_t e = 0; e < D; ++e) {
        s[d][e] = data[d * D] * g[0][e];
        for (std::size_t i = 1; i < D; ++i) s[d][e] += data[d * D + i] * g[i][e];
      }
    T trace = s[0][0];
    for (std::size_t d = 1; d < D; ++d) trace += s[d][d];
    trace *= lambda;
    for (std::size_t d = 0; d < D; ++d) {
      for (std::size_t e = 0; e < D; ++e) s[d][e] *= c;
      s[d][d] += trace;
    }
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t d = 0; d < D; ++d) {
        T sum = s[d][0] * data[i];
        for (std::size_t e = 1; e < D; ++e) sum += s[d][e] * data[e * D + i];
        t[i][d] += sum;
      }
  }

  /// The same for numbers of points and time points that the compiler knows.
  template <std::size_t Points, std::size_t TimePoints, class T>
  [[gnu::always_inline]] static void multiply_points(const std::vector<double>& volume_moduli, const T* data,
                                                     Small<T, D>* gradients) {
#pragma GCC unroll 8
    for (std::size_t q = 0; q < Points; ++q) {
      const T* point = data + q * (metric_size + TimePoints * time_point_size);
      const Small<T, D> g = gradients[q];
      multiply_metric(point, g, gradients[q]);
      for (std::size_t p = 0; p < TimePoints; ++p)
        add_time_point(point + metric_size + p * time_point_size, volume_moduli[p], g, gradients[q]);
    }
  }
};

}  // namespace ixos
