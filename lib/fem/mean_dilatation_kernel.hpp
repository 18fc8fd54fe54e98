/// A cure of volumetric locking that derives from an energy: one mean dilatation for the whole element.
#pragma once
#include <cmath>

#include "fem/elastic_kernel.hpp"

namespace ixos {

/// The energy int W(F~) dV of the displacement alone, with F~ = (Jm/J)^(1/D) F and Jm = 1/V int J dV: where Jm = 1 the
/// law's bulk stiffness is silent, so that an element keeps one volumetric constraint instead of one a quadrature point
/// (Nagtegaal, Parks and Rice 1974; Simo, Taylor and Pister 1985). Jm is varied fully, so the force is the gradient of
/// that energy and the tangent is symmetric; the B-bar and F-bar methods that freeze it have no energy.
///
/// In plane strain F is the part in the plane and F~_33 = 1 stays: with the exponent 1/2 det F~ = Jm at every point, so
/// the pressure of laws like ours, a function of det F~ alone, is constant in the element. (The three-dimensional split
/// with the exponent 1/3 does as much, but leaves F~_33 /= 1 and so the material's plane strain.)
///
/// Of a linear law it is the limit of small strains, H~ = H + (mean(tr H) - tr H)/D I (Hughes 1980), exactly linear.
///
/// An element in a homogeneous state equals the ElasticKernel's. Jm couples the quadrature points, so time points
/// cannot share one B^T A B alone: each has a rank-two part besides. There is no discrete gradient.
template <class Element, class Material>
struct MeanDilatationKernel : ElasticKernel<Element, Material> {
  using Base = ElasticKernel<Element, Material>;
  static constexpr std::size_t D = Base::D;
  static constexpr std::size_t N = Base::N;
  static constexpr bool has_discrete_gradient = false;

  template <class T>
  using Nodal = typename Base::template Nodal<T>;
  template <class T>
  using Tangent = typename Base::template Tangent<T>;
  template <class T>
  using Geometry = typename Base::template Geometry<T>;
  template <class T>
  using Segment = typename Base::template Segment<T>;

  /// Stored energy [E0 L0^D].
  template <class T>
  static T energy(const Material& material, const Geometry<T>& geometry, const Nodal<T>& u) {
    const T mean = mean_dilatation(geometry, u);
    T sum(0.0);
    for (std::size_t q = 0; q < geometry.points.size(); ++q)
      sum += geometry.points[q].weight * material.energy(State<T>(gradient_at(geometry, q, u), mean).scaled);
    return sum;
  }

  /// See ElasticKernel::means(); of F~, so the second is Jm (of a linear law 1).
  template <class T>
  static std::array<T, 3> means(const Material& material, const Geometry<T>& geometry, const Nodal<T>& u) {
    const T mean = mean_dilatation(geometry, u);
    std::array<T, 3> sums{T(0.0), T(0.0), T(0.0)};
    for (std::size_t q = 0; q < geometry.points.size(); ++q)
      Base::add_means(material, State<T>(gradient_at(geometry, q, u), mean).scaled, geometry.points[q].weight, sums);
    const T reference = volume(geometry);
    for (T& sum : sums) sum = sum / reference;
    return sums;
  }

  /// Adds the rule's force to f. Returns the least J of the time points and of the segment's end, lane by lane; where
  /// it is positive so is Jm.
  template <class T>
  static T add_force(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment, const Rule& rule,
                     Nodal<T>& f) {
    T least_jacobian(1e300);
    std::vector<Mean<T>> means = dilatations(geometry, segment, rule, least_jacobian);
    for (std::size_t q = 0; q < geometry.points.size(); ++q) {
      const T& w = geometry.points[q].weight;
      const Nodal<T> dn = Base::shape_gradients(geometry, q);
      const Ends<T> ends(segment, dn);
      Small<T, D> local{};
      for (std::size_t k = 0; k < means.size(); ++k) {
        const State<T> s(ends.at(rule.points[k]), means[k].dilatation);
        Small<T, D> p;
        material.stress(s.scaled, p);
        const T pressure = s.product(p) * (1.0 / D);
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t j = 0; j < D; ++j)
            local[i][j] += rule.points[k].weight * (s.scale * p[i][j] - pressure * s.inverse[j][i]);
        means[k].pressure += w * pressure;
        s.add_volume_gradient(dn, w, means[k].gradient);
      }
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t j = 0; j < D; ++j) f[a][i] += w * local[i][j] * dn[a][j];
    }
    const T reference = volume(geometry);
    for (std::size_t k = 0; k < means.size(); ++k) {
      const T factor = rule.points[k].weight * means[k].pressure / means[k].volume(reference);
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t i = 0; i < D; ++i) f[a][i] += factor * means[k].gradient[a][i];
    }
    return least_jacobian;
  }

  /// Adds the rule's tangent dF/du_s to k. With theta = ln Jm the energy is sum_q w phi(F_q, theta), whence
  ///   d2E = sum_q w (dF:phi_FF:dF + 2 dF:phi_Ft dtheta + phi_tt dtheta^2) + S d2theta,  S = sum_q w phi_t.
  /// The parts in dF:dF go to the moduli of the points, S d2Jm/Jm too; the rest is m p^T + p m^T with m = dtheta/du.
  template <class T>
  static void add_tangent(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment,
                          const Rule& rule, Tangent<T>& k) {
    T least_jacobian(1e300);
    std::vector<Mean<T>> means = dilatations(geometry, segment, rule, least_jacobian);
    if constexpr (finite) add_pressures(material, geometry, segment, rule, means);
    const T reference = volume(geometry);
    for (std::size_t q = 0; q < geometry.points.size(); ++q) {
      const T& w = geometry.points[q].weight;
      const Nodal<T> dn = Base::shape_gradients(geometry, q);
      const Ends<T> ends(segment, dn);
      Small<T, D * D> sum{};
      for (std::size_t point = 0; point < means.size(); ++point) {
        Mean<T>& mean = means[point];
        const State<T> s(ends.at(rule.points[point]), mean.dilatation);
        const T sigma = mean.pressure / mean.volume(reference) * s.jacobian;
        const Moduli<T> moduli(material, s, sigma);
        const double factor = rule.points[point].weight * rule.points[point].to;
        for (std::size_t r = 0; r < D * D; ++r)
          for (std::size_t c = 0; c < D * D; ++c) sum[r][c] += factor * moduli.local[r][c];
        for (std::size_t a = 0; a < N; ++a)
          for (std::size_t i = 0; i < D; ++i)
            for (std::size_t j = 0; j < D; ++j) mean.coupling[a][i] += w * moduli.coupling[i][j] * dn[a][j];
        mean.second += w * moduli.second;
        s.add_volume_gradient(dn, w, mean.gradient);
      }
      for (auto& row : sum)
        for (T& value : row) value *= w;
      Base::template add_contraction<true>(dn, sum, k);
    }
    for (std::size_t point = 0; point < means.size(); ++point)
      means[point].add_to(rule.points[point].weight * rule.points[point].to, reference, k);
  }

 private:
  /// Small-strain laws can take any F; their J is 1.
  static constexpr bool finite = Material::can_invert;

  template <class T>
  using Ends = typename Base::template Ends<T>;

  template <class T>
  static T trace(const Small<T, D>& m) {
    T sum = m[0][0];
    for (std::size_t i = 1; i < D; ++i) sum += m[i][i];
    return sum;
  }

  /// J - 1; of a linear law its linear part.
  template <class T>
  static T dilatation(const Small<T, D>& h) {
    if constexpr (finite) return determinant_minus_one(h);
    return trace(h);
  }

  /// H~ at a point and what its variation needs; of a linear law all but H~ is that at rest.
  template <class T>
  struct State {
    State(const Small<T, D>& h, const T& mean_dilatation) : scaled(h), scale(1.0), jacobian(1.0), inverse{} {
      T change;  // of the diagonal
      if constexpr (finite) {
        Small<T, D> f = h;
        for (std::size_t i = 0; i < D; ++i) f[i][i] += 1.0;
        jacobian = determinant(f);
        inverse = ixos::inverse(f, jacobian);
        change = root_minus_one(T((mean_dilatation - dilatation(h)) / jacobian));
        scale = 1.0 + change;
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t j = 0; j < D; ++j) scaled[i][j] *= scale;
      } else {
        change = (mean_dilatation - dilatation(h)) * (1.0 / D);
        for (std::size_t i = 0; i < D; ++i) inverse[i][i] = T(1.0);
      }
      for (std::size_t i = 0; i < D; ++i) scaled[i][i] += change;
    }

    /// m:F~; of a linear law the trace.
    T product(const Small<T, D>& m) const {
      T sum = trace(m);
      if constexpr (finite)
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t j = 0; j < D; ++j) sum += m[i][j] * scaled[i][j];
      return sum;
    }

    /// Adds w dJ/du.
    void add_volume_gradient(const Nodal<T>& dn, const T& w, Nodal<T>& result) const {
      const T factor = w * jacobian;
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t i = 0; i < D; ++i) {
          T sum = dn[a][0] * inverse[0][i];
          for (std::size_t j = 1; j < D; ++j) sum += dn[a][j] * inverse[j][i];
          result[a][i] += factor * sum;
        }
    }

    Small<T, D> scaled;   ///< H~ = F~ - I
    T scale;              ///< (Jm/J)^(1/D)
    T jacobian;           ///< J
    Small<T, D> inverse;  ///< F^-1

   private:
    /// (1 + x)^(1/D) - 1 without cancellation.
    static T root_minus_one(const T& x) {
      using std::cbrt;
      using std::sqrt;
      if constexpr (D == 2) return x / (1.0 + sqrt(T(1.0 + x)));
      const T root = cbrt(T(1.0 + x));
      return x / (1.0 + root + root * root);
    }
  };

  /// What one time point sums over the quadrature points.
  template <class T>
  struct Mean {
    T dilatation{0.0};    ///< Jm - 1
    T pressure{0.0};      ///< S = int P~:F~/D dV
    T second{0.0};        ///< sum w phi_tt
    Nodal<T> gradient{};  ///< V dJm/du
    Nodal<T> coupling{};  ///< sum w phi_Ft dN

    /// The present volume; of a linear law the reference volume.
    T volume(const T& reference) const {
      if constexpr (finite) return reference * (1.0 + dilatation);
      return reference;
    }

    void add_to(double factor, const T& reference, Tangent<T>& k) const {
      Nodal<T> m, p;
      const T inverse_volume = 1.0 / volume(reference);
      T half = 0.5 * second;
      if constexpr (finite) half -= 0.5 * pressure;
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t i = 0; i < D; ++i) {
          m[a][i] = inverse_volume * gradient[a][i];
          p[a][i] = factor * (coupling[a][i] + half * m[a][i]);
        }
      for (std::size_t r = 0; r < N * D; ++r)
        for (std::size_t c = 0; c <= r; ++c) {
          const T value = m[r / D][r % D] * p[c / D][c % D] + p[r / D][r % D] * m[c / D][c % D];
          k[r][c] += value;
          if (c < r) k[c][r] += value;
        }
    }
  };

  /// Second derivatives at a point, with the law's moduli A, P = P~, B = A:F~, t = P:F~, G = F^-T, c = scale:
  ///   phi_FF = c^2 A - (Q (x) G + G (x) Q)/D + z/D G (x) G + t/D G x G,  phi_Ft = (Q - z G)/D,  phi_tt = z/D,
  /// Q = c (P + B), z = (F~:B + t)/D, (G x G)_iJkL = G_iL G_kJ; of a linear law without the terms in P. To phi_FF is
  /// added sigma (G (x) G - G x G), sigma = J S/(V Jm), of the second derivative of Jm.
  template <class T>
  struct Moduli {
    Moduli(const Material& material, const State<T>& s, const T& sigma) {
      Small<T, D> p;
      Small<T, D * D> a;
      material.stress_and_moduli(s.scaled, p, a);
      Small<T, D> q;
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) {
          const auto& row = a[i * D + j];
          T sum = row[0];
          for (std::size_t m = 1; m < D; ++m) sum += row[m * D + m];
          if constexpr (finite)
            for (std::size_t m = 0; m < D * D; ++m) sum += row[m] * s.scaled[m / D][m % D];
          q[i][j] = sum;
        }
      T t(0.0);
      T z = s.product(q) * (1.0 / D);
      if constexpr (finite) {
        t = s.product(p) * (1.0 / D);
        z += t;
        for (std::size_t i = 0; i < D; ++i)
          for (std::size_t j = 0; j < D; ++j) q[i][j] = s.scale * (p[i][j] + q[i][j]);
      }
      second = z * (1.0 / D);
      const T parallel = second + sigma, crossed = t - sigma, square = s.scale * s.scale;
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) coupling[i][j] = (q[i][j] - z * s.inverse[j][i]) * (1.0 / D);
      // -(Q (x) G + G (x) Q)/D + parallel G (x) G = G (x) R + R (x) G
      Small<T, D> r;
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) r[i][j] = 0.5 * parallel * s.inverse[j][i] - (1.0 / D) * q[i][j];
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j)
          for (std::size_t m = 0; m < D; ++m)
            for (std::size_t n = 0; n < D; ++n) {
              T value = square * a[i * D + j][m * D + n] + s.inverse[j][i] * r[m][n] + r[i][j] * s.inverse[n][m];
              if constexpr (finite) value += crossed * (s.inverse[n][i] * s.inverse[j][m]);
              local[i * D + j][m * D + n] = value;
            }
    }

    Small<T, D * D> local;
    Small<T, D> coupling;
    T second;
  };

  template <class T>
  static Small<T, D> gradient_at(const Geometry<T>& geometry, std::size_t q, const Nodal<T>& u) {
    return Base::gradient(u, Base::shape_gradients(geometry, q));
  }

  /// The reference volume.
  template <class T>
  static T volume(const Geometry<T>& geometry) {
    T sum(0.0);
    for (const auto& point : geometry.points) sum += point.weight;
    return sum;
  }

  /// Jm - 1.
  template <class T>
  static T mean_dilatation(const Geometry<T>& geometry, const Nodal<T>& u) {
    T sum(0.0);
    for (std::size_t q = 0; q < geometry.points.size(); ++q)
      sum += geometry.points[q].weight * dilatation(gradient_at(geometry, q, u));
    return sum / volume(geometry);
  }

  /// One Mean for each time point, with Jm - 1; lowers `least_jacobian` to the least J.
  template <class T>
  static std::vector<Mean<T>> dilatations(const Geometry<T>& geometry, const Segment<T>& segment, const Rule& rule,
                                          T& least_jacobian) {
    std::vector<Mean<T>> means(rule.points.size());
    for (std::size_t q = 0; q < geometry.points.size(); ++q) {
      const Ends<T> ends(segment, Base::shape_gradients(geometry, q));
      for (std::size_t k = 0; k < means.size(); ++k) {
        const T change = dilatation(ends.at(rule.points[k]));
        means[k].dilatation += geometry.points[q].weight * change;
        if constexpr (finite) least_jacobian = smaller(least_jacobian, T(1.0 + change));
      }
      if constexpr (finite) least_jacobian = smaller(least_jacobian, ends.jacobian());
    }
    const T reference = volume(geometry);
    for (Mean<T>& mean : means) mean.dilatation = mean.dilatation / reference;
    return means;
  }

  /// S of each time point.
  template <class T>
  static void add_pressures(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment,
                            const Rule& rule, std::vector<Mean<T>>& means) {
    for (std::size_t q = 0; q < geometry.points.size(); ++q) {
      const Ends<T> ends(segment, Base::shape_gradients(geometry, q));
      for (std::size_t k = 0; k < means.size(); ++k) {
        const State<T> s(ends.at(rule.points[k]), means[k].dilatation);
        Small<T, D> p;
        material.stress(s.scaled, p);
        means[k].pressure += geometry.points[q].weight * s.product(p) * (1.0 / D);
      }
    }
  }
};

}  // namespace ixos
