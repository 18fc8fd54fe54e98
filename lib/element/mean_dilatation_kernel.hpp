/// A cure of volumetric locking that derives from an energy: one mean dilatation for the whole of a linear element.
#pragma once
#include "element/elastic_kernel.hpp"
#include "element/mean_dilatation_point.hpp"

namespace ixos {

/// The energy int W(F~) dV of the displacement alone, with F~ = (Jm/J)^(1/D) F and Jm = 1/V int J dV. At Jm = 1 the
/// law's bulk stiffness has no effect, so an element has one volumetric constraint instead of one for each quadrature
/// point (Nagtegaal, Parks and Rice 1974; Simo, Taylor and Pister 1985). Jm is varied fully, so the force is the
/// gradient of that energy and the tangent is symmetric; the B-bar and F-bar methods that freeze it have no energy.
///
/// In plane strain F is the part in the plane and F~_33 = 1 stays: with the exponent 1/2 det F~ = Jm at every point, so
/// the pressure of laws like ours, a function of det F~ alone, is constant in the element. (The three-dimensional split
/// with the exponent 1/3 does as much, but leaves F~_33 /= 1 and so the material's plane strain.)
///
/// A ring has all three stretches: the exponent is 1/3.
///
/// For a linear law it is the limit of small strains, H~ = H + (mean(tr H) - tr H)/D I (Hughes 1980), exactly linear.
///
/// Quadratic elements need more constraints, see ProjectedDilatationKernel.
///
/// In a homogeneous state the element equals that of ElasticKernel. Jm couples the quadrature points, so time points
/// cannot share one B^T A B alone: each adds a rank-two part. The kernel has no discrete gradient.
template <class Element, class Material>
struct MeanDilatationKernel : ElasticKernel<Element, Material> {
  using Base = ElasticKernel<Element, Material>;
  static constexpr std::size_t D = Base::D;
  static constexpr std::size_t N = Base::N;
  static constexpr std::size_t G = Base::G;
  static constexpr bool has_discrete_gradient = false;
  static constexpr bool keeps_points = false;

  template <class T>
  using Nodal = typename Base::template Nodal<T>;
  template <class T>
  using Tangent = typename Base::template Tangent<T>;
  template <class T>
  using Geometry = typename Base::template Geometry<T>;
  template <class T>
  using Segment = typename Base::template Segment<T>;
  template <class T>
  using Gradients = typename Base::template Gradients<T>;

  /// Returns the stored energy [E0 L0^D].
  template <class T>
  static T energy(const Material& material, const Geometry<T>& geometry, const Nodal<T>& u) {
    const T mean = mean_dilatation(geometry, u);
    T sum(0.0);
    for (std::size_t q = 0; q < geometry.points.size(); ++q)
      sum += geometry.points[q].weight * material.energy(State<T>(gradient_at(geometry, q, u), mean).scaled);
    return sum;
  }

  /// See ElasticKernel::mean(). H is H~, so the mean J is Jm (1 for a linear law).
  template <class T, class Value>
  static auto mean(const Material& /*material*/, const Geometry<T>& geometry, const Nodal<T>& u, const Value& value) {
    const T mean = mean_dilatation(geometry, u);
    return mean_over_points(
        geometry.points, [&](std::size_t q) { return State<T>(gradient_at(geometry, q, u), mean).scaled; }, value);
  }

  /// Adds the rule's force to f. Returns the least J of the time points and of the segment's end, lane by lane; if it
  /// is positive, so is Jm.
  template <class T>
  static T add_force(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment, const Rule& rule,
                     Nodal<T>& f) {
    T least_jacobian(1e300);
    std::vector<Mean<T>> means = dilatations(geometry, segment, rule, least_jacobian);
    if constexpr (Material::has_limit)
      if (material.is_limited() && !rule.has_end())
        least_jacobian = smaller(least_jacobian, end_admissibility(material, geometry, segment));
    for (std::size_t q = 0; q < geometry.points.size(); ++q) {
      const T& w = geometry.points[q].weight;
      const Gradients<T> dn = Base::shape_gradients(geometry, q);
      const Ends<T> ends(segment, dn);
      Small<T, G> local{};
      for (std::size_t k = 0; k < means.size(); ++k) {
        const State<T> s(ends.at(rule.points[k]), means[k].dilatation);
        Small<T, G> p;
        const T jacobian = material.stress(s.scaled, p);
        if constexpr (Material::has_limit) least_jacobian = smaller(least_jacobian, jacobian);
        const T pressure = s.product(p) * (1.0 / G);
        for (std::size_t i = 0; i < G; ++i)
          for (std::size_t j = 0; j < G; ++j)
            local[i][j] += rule.points[k].weight * (s.scale * p[i][j] - pressure * s.inverse[j][i]);
        means[k].pressure += w * pressure;
        s.add_volume_gradient(dn, w, means[k].gradient);
      }
      add_nodal_forces(w, local, dn, f);
    }
    const T reference = Base::volume(geometry);
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
    const T reference = Base::volume(geometry);
    for (std::size_t q = 0; q < geometry.points.size(); ++q) {
      const T& w = geometry.points[q].weight;
      const Gradients<T> dn = Base::shape_gradients(geometry, q);
      const Ends<T> ends(segment, dn);
      Small<T, G * G> sum{};
      for (std::size_t point = 0; point < means.size(); ++point) {
        Mean<T>& mean = means[point];
        const State<T> s(ends.at(rule.points[point]), mean.dilatation);
        const T sigma = mean.pressure / mean.volume(reference) * s.jacobian;
        const Moduli<T> moduli(material, s, sigma);
        const double factor = rule.points[point].weight * rule.points[point].to;
        for (std::size_t r = 0; r < G * G; ++r)
          for (std::size_t c = 0; c < G * G; ++c) sum[r][c] += factor * moduli.local[r][c];
        add_nodal_forces(w, moduli.coupling, dn, mean.coupling);
        mean.second += w * moduli.second;
        s.add_volume_gradient(dn, w, mean.gradient);
      }
      for (auto& row : sum)
        for (T& value : row) value *= w;
      add_contraction<true>(dn, dn, sum, k);
    }
    for (std::size_t point = 0; point < means.size(); ++point)
      means[point].add_to(rule.points[point].weight * rule.points[point].to, reference, k);
  }

 private:
  using AtPoint = MeanDilatationPoint<Material, G>;
  static constexpr bool finite = AtPoint::finite;
  template <class T>
  using State = typename AtPoint::template State<T>;
  template <class T>
  using Moduli = typename AtPoint::template Moduli<T>;
  template <class T>
  using Ends = typename Base::template Ends<T>;

  /// The sums of one time point over the quadrature points.
  template <class T>
  struct Mean {
    T dilatation{0.0};    ///< Jm - 1
    T pressure{0.0};      ///< S = int P~:F~/D dV
    T second{0.0};        ///< sum w phi_tt
    Nodal<T> gradient{};  ///< V dJm/du
    Nodal<T> coupling{};  ///< sum w phi_Ft dN

    /// Returns the present volume; the reference volume for a linear law.
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

  template <class T>
  static Small<T, G> gradient_at(const Geometry<T>& geometry, std::size_t q, const Nodal<T>& u) {
    return Base::gradient(u, Base::shape_gradients(geometry, q));
  }

  /// Returns Jm - 1.
  template <class T>
  static T mean_dilatation(const Geometry<T>& geometry, const Nodal<T>& u) {
    T sum(0.0);
    for (std::size_t q = 0; q < geometry.points.size(); ++q)
      sum += geometry.points[q].weight * AtPoint::dilatation(gradient_at(geometry, q, u));
    return sum / Base::volume(geometry);
  }

  /// Returns the least admissibility of F~ at the end of the segment.
  template <class T>
  static T end_admissibility(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment) {
    const T mean = mean_dilatation(geometry, *segment.to);
    T least_admissibility(1e300);
    for (std::size_t q = 0; q < geometry.points.size(); ++q)
      least_admissibility = smaller(
          least_admissibility, material.admissibility(State<T>(gradient_at(geometry, q, *segment.to), mean).scaled));
    return least_admissibility;
  }

  /// Returns one Mean for each time point, with Jm - 1; lowers `least_jacobian` to the least J.
  template <class T>
  static std::vector<Mean<T>> dilatations(const Geometry<T>& geometry, const Segment<T>& segment, const Rule& rule,
                                          T& least_jacobian) {
    std::vector<Mean<T>> means(rule.points.size());
    for (std::size_t q = 0; q < geometry.points.size(); ++q) {
      const Ends<T> ends(segment, Base::shape_gradients(geometry, q));
      for (std::size_t k = 0; k < means.size(); ++k) {
        const T change = AtPoint::dilatation(ends.at(rule.points[k]));
        means[k].dilatation += geometry.points[q].weight * change;
        if constexpr (finite) least_jacobian = smaller(least_jacobian, T(1.0 + change));
      }
      if constexpr (finite) least_jacobian = smaller(least_jacobian, ends.jacobian());
    }
    const T reference = Base::volume(geometry);
    for (Mean<T>& mean : means) mean.dilatation = mean.dilatation / reference;
    return means;
  }

  /// Returns S of each time point.
  template <class T>
  static void add_pressures(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment,
                            const Rule& rule, std::vector<Mean<T>>& means) {
    for (std::size_t q = 0; q < geometry.points.size(); ++q) {
      const Ends<T> ends(segment, Base::shape_gradients(geometry, q));
      for (std::size_t k = 0; k < means.size(); ++k) {
        const State<T> s(ends.at(rule.points[k]), means[k].dilatation);
        Small<T, G> p;
        material.stress(s.scaled, p);
        means[k].pressure += geometry.points[q].weight * s.product(p) * (1.0 / G);
      }
    }
  }
};

}  // namespace ixos
