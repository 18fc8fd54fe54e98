/// A remedy for volumetric locking that derives from an energy: one mean dilatation for the whole of a linear element.
#pragma once
#include "element/cell_kernel.hpp"
#include "element/kernel_law.hpp"
#include "element/mean_dilatation_point.hpp"
#include "material/meridian_moduli.hpp"
#include "material/volume_excess.hpp"

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
/// In a homogeneous state the element equals the standard one. Jm couples the quadrature points, so time points
/// cannot share one B^T A B alone: each adds a rank-two part. The kernel has no discrete gradient.
template <class Element, class Material>
struct MeanDilatationKernel : CellKernel<Element> {
  using Base = CellKernel<Element>;
  using Law = Material;
  using Base::batch;
  using Base::D;
  using Base::G;
  using Base::N;
  using typename Base::Space;
  static constexpr std::size_t C = Base::C;

  template <class T>
  using Nodal = typename Base::template Nodal<T>;
  template <class T>
  using Tangent = typename Base::template Tangent<T>;
  template <class T>
  using Geometry = typename Base::template Geometry<T>;
  template <class T>
  using Segment = typename Base::template Segment<T>;

  /// See EnhancedKernel::seen(). H is H~, so the mean J is Jm (1 for a linear law).
  template <class T>
  static T seen(const Material& material, const Geometry<T>& geometry, const Nodal<T>& u, std::vector<Small<T, G>>& h) {
    const bool finite = law_in<Space>(material).can_invert();
    h.resize(geometry.points.size());
    T sum(0.0);
    Base::for_each_batch(geometry, [&](std::size_t first, std::size_t count) {
      Base::gradients(geometry, first, count, u, &h[first]);
      for (std::size_t q = first; q < first + count; ++q)
        sum += geometry.points[q].weight * AtPoint::dilatation(finite, h[q]);
    });
    const T mean = sum / Base::volume(geometry);
    for (Small<T, G>& own : h) own = State<T>(finite, own, mean).scaled;
    return T(1.0);
  }

  /// Returns the stored energy [E0 L0^D].
  template <class T>
  static T energy(const Material& material, const Geometry<T>& geometry, const Nodal<T>& u) {
    return energy_of<MeanDilatationKernel>(material, geometry, u);
  }

  /// Adds the rule's force to f. Returns the least J of the time points and of the segment's end, lane by lane; if it
  /// is positive, so is Jm.
  template <class T>
  static T add_force(const Material& material, const Geometry<T>& geometry, const Segment<T>& segment, const Rule& rule,
                     Nodal<T>& f) {
    const auto& law = law_in<Space>(material);
    const bool finite = law.can_invert();
    T least_jacobian(1e300);
    std::vector<Mean<T>> means = dilatations(finite, geometry, segment, rule, least_jacobian);
    if (law.is_limited() && !rule.has_end())
      least_jacobian = smaller(least_jacobian, admissibility_of<MeanDilatationKernel>(material, geometry, *segment.to));
    Base::for_each_batch(geometry, [&](std::size_t first, std::size_t count) {
      const typename Base::template Ends<T> ends(geometry, first, count, segment);
      std::array<Small<T, G>, batch> local;
      std::fill_n(local.data(), count, Small<T, G>{});
      for (std::size_t k = 0; k < means.size(); ++k) {
        const Batch<T> at(finite, ends.points(), rule.points[k], means[k].dilatation);
        std::array<Small<T, G>, batch> p, volumes;
        std::array<T, batch> admissible;
        law.stress(count, at.scaled.data(), p.data(), admissible.data());
        for (std::size_t q = 0; q < count; ++q) {
          const State<T>& s = at.states[q];
          if (law.is_limited()) least_jacobian = smaller(least_jacobian, admissible[q]);
          const T pressure = s.product(p[q]) * (1.0 / G);
          for (std::size_t i = 0; i < G; ++i)
            for (std::size_t j = 0; j < G; ++j)
              local[q][i][j] += rule.points[k].weight * (s.scale * p[q][i][j] - pressure * s.inverse[j][i]);
          means[k].pressure += geometry.points[first + q].weight * pressure;
          volumes[q] = s.cofactors();
        }
        Base::add_forces(geometry, first, count, volumes.data(), means[k].gradient);
      }
      Base::add_forces(geometry, first, count, local.data(), f);
    });
    const T reference = Base::volume(geometry);
    for (std::size_t k = 0; k < means.size(); ++k) {
      const T factor = rule.points[k].weight * means[k].pressure / means[k].volume(finite, reference);
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
    const auto& law = law_in<Space>(material);
    const bool finite = law.can_invert();
    T least_jacobian(1e300);
    std::vector<Mean<T>> means = dilatations(finite, geometry, segment, rule, least_jacobian);
    if (finite) add_pressures(law, geometry, segment, rule, means);
    if (law.has_mixed_steps() && segment.iterate != nullptr)
      find_excess(material.lame.lambda, geometry, segment, rule, means);
    const T reference = Base::volume(geometry);
    Base::for_each_batch(geometry, [&](std::size_t first, std::size_t count) {
      const typename Base::template Ends<T> ends(geometry, first, count, segment);
      std::array<Small<T, G * G>, batch> sums;
      std::fill_n(sums.data(), count, Small<T, G * G>{});
      for (std::size_t point = 0; point < means.size(); ++point) {
        Mean<T>& mean = means[point];
        const Batch<T> at(finite, ends.points(), rule.points[point], mean.dilatation);
        std::array<Small<T, G>, batch> p, volumes, couplings;
        std::array<Small<T, G * G>, batch> a;
        law.stress_and_moduli(count, at.scaled.data(), p.data(), a.data());
        const double factor = rule.points[point].weight * rule.points[point].to;
        for (std::size_t q = 0; q < count; ++q) {
          const State<T>& s = at.states[q];
          const T sigma = (mean.pressure + mean.excess) / mean.volume(finite, reference) * s.jacobian;
          const Moduli<T> moduli(s, p[q], a[q], sigma, sigma);
          for (std::size_t r = 0; r < G * G; ++r)
            for (std::size_t c = 0; c < G * G; ++c) sums[q][r][c] += factor * moduli.local[r][c];
          couplings[q] = moduli.coupling;
          volumes[q] = s.cofactors();
          mean.second += geometry.points[first + q].weight * moduli.second;
        }
        Base::add_forces(geometry, first, count, couplings.data(), mean.coupling);
        Base::add_forces(geometry, first, count, volumes.data(), mean.gradient);
      }
      Base::add_tangent_of(
          geometry, first, count, true,
          [&](std::size_t begin, std::size_t n, Small<T, C>* own) {
            for (std::size_t q = 0; q < n; ++q) copy_moduli(sums[begin + q], own[q]);
          },
          k);
    });
    for (std::size_t point = 0; point < means.size(); ++point)
      means[point].add_to(finite, rule.points[point].weight * rule.points[point].to, reference, k);
  }

 private:
  using AtPoint = MeanDilatationPoint<G>;
  template <class T>
  using State = typename AtPoint::template State<T>;
  template <class T>
  using Moduli = typename AtPoint::template Moduli<T>;

  /// F~ at the points of a batch, at one time point.
  template <class T>
  struct Batch {
    Batch(bool finite, const PointEnds<T, G>& ends, const RulePoint& point, const T& mean_dilatation) {
      for (std::size_t q = 0; q < ends.size; ++q) {
        states[q] = State<T>(finite, ends.at(q, point), mean_dilatation);
        scaled[q] = states[q].scaled;
      }
    }
    std::array<State<T>, batch> states;
    std::array<Small<T, G>, batch> scaled;
  };

  /// The mean dilatation at one time point, and its pressure.
  template <class T>
  struct Mean {
    T dilatation{0.0};    ///< Jm - 1
    T pressure{0.0};      ///< S = int P~:F~/D dV
    T excess{0.0};        ///< V kappa (linearised Jm - Jm)/Jm, see volume_excess()
    T second{0.0};        ///< sum w phi_tt
    Nodal<T> gradient{};  ///< V dJm/du
    Nodal<T> coupling{};  ///< sum w phi_Ft dN

    /// Returns the present volume; the reference volume for a linear law.
    T volume(bool finite, const T& reference) const { return finite ? reference * (1.0 + dilatation) : reference; }

    void add_to(bool finite, double factor, const T& reference, Tangent<T>& k) const {
      Nodal<T> m, p;
      const T inverse_volume = 1.0 / volume(finite, reference);
      const T half = 0.5 * (second - pressure);  // a linear law has no pressure
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

  /// Returns one Mean for each time point, with Jm - 1; lowers `least_jacobian` to the least J.
  template <class T>
  static std::vector<Mean<T>> dilatations(bool finite, const Geometry<T>& geometry, const Segment<T>& segment,
                                          const Rule& rule, T& least_jacobian) {
    std::vector<Mean<T>> means(rule.points.size());
    Base::for_each_batch(geometry, [&](std::size_t first, std::size_t count) {
      const typename Base::template Ends<T> ends(geometry, first, count, segment);
      const PointEnds<T, G> points = ends.points();
      for (std::size_t q = 0; q < count; ++q) {
        for (std::size_t k = 0; k < means.size(); ++k) {
          const T change = AtPoint::dilatation(finite, points.at(q, rule.points[k]));
          means[k].dilatation += geometry.points[first + q].weight * change;
          if (finite) least_jacobian = smaller(least_jacobian, T(1.0 + change));
        }
        if (finite) least_jacobian = smaller(least_jacobian, determinant(deformation_gradient(points.to[q])));
      }
    });
    const T reference = Base::volume(geometry);
    for (Mean<T>& mean : means) mean.dilatation = mean.dilatation / reference;
    return means;
  }

  /// Sets the excess of each time point.
  template <class T>
  static void find_excess(double kappa, const Geometry<T>& geometry, const Segment<T>& segment, const Rule& rule,
                          std::vector<Mean<T>>& means) {
    Base::for_each_batch(geometry, [&](std::size_t first, std::size_t count) {
      const typename Base::template Ends<T> ends(geometry, first, count, segment);
      const PointEnds<T, G> points = ends.points();
      for (std::size_t k = 0; k < means.size(); ++k)
        for (std::size_t q = 0; q < count; ++q) {
          const Small<T, G> before = points.iterate_at(q, rule.points[k]), here = points.at(q, rule.points[k]);
          const Small<T, G> f = deformation_gradient(before);
          const T ratio = determinant(f);
          const Small<T, G> g = inverse(f, ratio);
          T linear = AtPoint::dilatation(true, before) - AtPoint::dilatation(true, here);
          for (std::size_t i = 0; i < G; ++i)
            for (std::size_t j = 0; j < G; ++j) linear += segment.way * ratio * g[j][i] * (here[i][j] - before[i][j]);
          means[k].excess += geometry.points[first + q].weight * kappa * linear;
        }
    });
    for (Mean<T>& mean : means) mean.excess = mean.excess / (1.0 + mean.dilatation);
  }

  /// Returns S of each time point.
  template <class Points, class T>
  static void add_pressures(const Points& law, const Geometry<T>& geometry, const Segment<T>& segment, const Rule& rule,
                            std::vector<Mean<T>>& means) {
    const bool finite = law.can_invert();
    Base::for_each_batch(geometry, [&](std::size_t first, std::size_t count) {
      const typename Base::template Ends<T> ends(geometry, first, count, segment);
      for (std::size_t k = 0; k < means.size(); ++k) {
        const Batch<T> at(finite, ends.points(), rule.points[k], means[k].dilatation);
        std::array<Small<T, G>, batch> p;
        std::array<T, batch> admissible;
        law.stress(count, at.scaled.data(), p.data(), admissible.data());
        for (std::size_t q = 0; q < count; ++q)
          means[k].pressure += geometry.points[first + q].weight * at.states[q].product(p[q]) * (1.0 / G);
      }
    });
  }
};

}  // namespace ixos
