/// The elastic tangent at quadrature points, applied without a matrix: of laws with a spatial tangent.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/pack.hpp"
#include "element/displacement_gradient.hpp"
#include "element/prefetch.hpp"
#include "material/lame.hpp"
#include "material/points.hpp"
#include "rule/rule.hpp"

namespace ixos {

/// K u from data kept at the quadrature points, whatever the cells' type. With G = dxi/dx at a time point of the rule
/// (J0^-1 F^-1, times the root of the quadrature weight), the spatial tangent (see SpatialTangent) of g = du/dxi is
///
///   t = g M + sum over time points of (c (h + h^T) + lambda tr(h) I) G^T,  h = g G,
///
/// where the metric M = sum of G tau G^T, tau = mu b - c I the Kirchhoff stress, is summed over the time points:
/// D (D + 1)/2 numbers a point and D^2 + 1 for each time point, 16 in three dimensions for one; and the point's mass
/// times a factor, so that W u = (K + factor M) u costs little more than K u.
/// The data may be kept in single precision, because the speed of the product is limited by memory. The product is then
/// that of a tangent with errors of 1e-7 in its entries. That tangent is still symmetric, and a rotation still
/// costs no energy in it, as h + h^T is summed in double precision. The type of `data` selects the precision. With T in
/// single precision, too, a rotation costs 1e-7 of the energy of a strain of its size.
template <std::size_t D>
class SpatialProduct {
  static constexpr std::size_t metric_size = D * (D + 1) / 2;
  static constexpr std::size_t time_point_size = D * D + 1;

 public:
  static constexpr std::size_t most = 32;  ///< points that keep() takes at once

  /// For the rule's tangent, plus `rest` times the tangent of the undeformed body, plus `inertia` (a factor times the
  /// density) times the mass of unit density.
  SpatialProduct(const Lame& lame, Rule rule, double rest, double inertia)
      : rule_(std::move(rule)), rest_(rest), inertia_(inertia) {
    for (const RulePoint& time : rule_.points) volume_moduli_.push_back(lame.lambda * time.weight * time.to);
    if (rest != 0) volume_moduli_.push_back(lame.lambda * rest);
  }

  bool has_mass() const { return inertia_ != 0; }
  /// Returns how many numbers a point has.
  std::size_t point_size() const {
    return metric_size + volume_moduli_.size() * time_point_size + (has_mass() ? 1 : 0);
  }

  /// Fills in the data of some points, not more than `most`. `law`: LawPoints or a PointLaw.
  template <class Points, class T, class Kept>
  void keep(const Points& law, const PointEnds<T, D>& ends, const SpacePoint<T, D>* points, Kept* data) const {
    std::array<SpatialState<T, D>, most> states;
    std::array<Small<T, D>, most> metrics;
    std::fill_n(metrics.data(), ends.size, Small<T, D>{});
    std::size_t place = metric_size;
    const auto add = [&](double weight) {
      for (std::size_t q = 0; q < ends.size; ++q)
        add_state(points[q], states[q], weight, metrics[q], data + q * point_size() + place);
      place += time_point_size;
    };
    for (const RulePoint& time : rule_.points) {
      law.spatial(ends, time, states.data());
      add(time.weight * time.to);
    }
    if (rest_ != 0) {
      const Small<T, D> undeformed{};  // at rest all points are alike
      law.spatial(PointEnds<T, D>{1, &undeformed, nullptr, nullptr}, end_rule().points[0], states.data());
      std::fill_n(states.data() + 1, ends.size - 1, states[0]);
      add(rest_);
    }
    for (std::size_t q = 0; q < ends.size; ++q) {
      Kept* own = data + q * point_size();
      if (has_mass()) own[place] = narrow<Kept>(T(inertia_ * points[q].weight));
      for (std::size_t d = 0; d < D; ++d)
        for (std::size_t e = d; e < D; ++e) *own++ = narrow<Kept>(metrics[q][d][e]);
    }
  }

  /// Replaces g = du/dxi by t at `size` points, whose data are those of a cell; multiplies values by the mass unless
  /// they are null.
  template <class T, class Kept>
  [[gnu::noinline]] void multiply(std::size_t size, const Kept* data, Small<T, D>* gradients,
                                  std::array<T, D>* values) const {
    const std::size_t count = point_size();
    for (std::size_t q = 0; q < size; ++q, data += count) {
      if constexpr (D == 3) prefetch(data + size * count, count);
      const Small<T, D> g = gradients[q];
      Small<T, D> t;
      multiply_metric(data, g, t);
      const Kept* time_point = data + metric_size;
      // A rule has at least one point. With that one in the loop, a product with a single point takes 15 % longer.
      add_time_point(time_point, volume_moduli_[0], g, t);
      time_point += time_point_size;
      for (std::size_t p = 1; p < volume_moduli_.size(); ++p, time_point += time_point_size)
        add_time_point(time_point, volume_moduli_[p], g, t);
      gradients[q] = t;
      if (values != nullptr)
        for (T& v : values[q]) v *= widen<T>(*time_point);
    }
  }

  /// Returns B_i[d D + e] of a point, with which node a adds sum dN_a/dxi_d dN_a/dxi_e B_i[d D + e] to the diagonal of
  /// K in direction i.
  template <class T, class Kept>
  Small<T, D, D * D> diagonal(const Kept* data) const {
    Small<T, D, D * D> b;
    for (std::size_t d = 0; d < D; ++d)
      for (std::size_t e = 0; e < D; ++e)
        for (std::size_t i = 0; i < D; ++i) b[i][d * D + e] = widen<T>(data[metric_index(d, e)]);
    for (std::size_t p = 0; p < volume_moduli_.size(); ++p) {
      const Kept* point = data + metric_size + p * time_point_size;
      const T c = widen<T>(point[D * D]);
      for (std::size_t d = 0; d < D; ++d)
        for (std::size_t e = 0; e < D; ++e) {
          T along(0.0);
          for (std::size_t i = 0; i < D; ++i) along += widen<T>(point[d * D + i]) * widen<T>(point[e * D + i]);
          for (std::size_t i = 0; i < D; ++i)
            b[i][d * D + e] +=
                c * along + (c + volume_moduli_[p]) * widen<T>(point[d * D + i]) * widen<T>(point[e * D + i]);
        }
    }
    return b;
  }

 private:
  /// Writes the data of a point at a time point, and adds to its metric.
  template <class T, class Kept>
  static void add_state(const SpacePoint<T, D>& point, const SpatialState<T, D>& state, double weight,
                        Small<T, D>& metric, Kept* data) {
    using std::sqrt;
    const Small<T, D>& to_reference = point.inverse_jacobian;
    const T root = sqrt(point.weight);
    SpatialTangent<T> moduli = state.moduli;
    moduli.scale(weight);
    Small<T, D> gradient;
    for (std::size_t d = 0; d < D; ++d)
      for (std::size_t i = 0; i < D; ++i) {
        T sum = to_reference[d][0] * state.inverse[0][i];
        for (std::size_t j = 1; j < D; ++j) sum += to_reference[d][j] * state.inverse[j][i];
        gradient[d][i] = root * sum;
        *data++ = narrow<Kept>(gradient[d][i]);
      }
    *data = narrow<Kept>(moduli.c);
    for (std::size_t d = 0; d < D; ++d)
      for (std::size_t e = d; e < D; ++e)
        for (std::size_t j = 0; j < D; ++j)
          metric[d][e] += moduli.mu * point.weight * to_reference[d][j] * to_reference[e][j] -
                          moduli.c * gradient[d][j] * gradient[e][j];
  }

  /// Returns the position of an entry in the upper triangle, stored row by row.
  static constexpr std::size_t metric_index(std::size_t d, std::size_t e) {
    return d > e ? metric_index(e, d) : d * D - d * (d + 1) / 2 + e;
  }

  // These functions are inlined: as calls for each point, through memory, they would halve the speed.
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

  Rule rule_;
  double rest_ = 0, inertia_ = 0;
  std::vector<double> volume_moduli_;  ///< lambda times the weight of each time point, and of the undeformed body
};

}  // namespace ixos
