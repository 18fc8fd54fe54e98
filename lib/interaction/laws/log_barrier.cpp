#include <cmath>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/law_parameters.hpp"
#include "interaction/mean_functions.hpp"

namespace ixos {
namespace {

/// psi = -k (r - h)^2 ln(r/h) (Li et al. 2020) at every positive gap. Beyond h it attracts. The scalar T is double or
/// Pack.
class EndlessBarrier {
 public:
  static constexpr GapDomain domain = GapDomain::Positive;

  /// Stiffness k [E0/L0], range h [L0].
  EndlessBarrier(double stiffness, double range) : stiffness_(stiffness), range_(range) {}

  template <class T>
  T energy(const T& r) const {
    return lanewise(r, [this](double gap) {
      const double x = past(gap);
      return -stiffness_ * range_ * range_ * x * x * std::log1p(x);
    });
  }
  template <class T>
  T traction(const T& r) const {
    return lanewise(r, [this](double gap) {
      const double x = past(gap);
      return stiffness_ * range_ * (2 * x * std::log1p(x) + x * x / (1 + x));
    });
  }
  template <class T>
  T stiffness(const T& r) const {
    return lanewise(r, [this](double gap) {
      const double x = past(gap), share = x / (1 + x);
      return stiffness_ * (share * share - 4 * share - 2 * std::log1p(x));
    });
  }
  template <class T>
  T mean_traction(const T& r0, const T& r1) const {
    return lanewise(r0, r1, [this](double a, double b) { return mean(a, b); });
  }
  template <class T>
  T mean_stiffness(const T& r0, const T& r1) const {
    return lanewise(r0, r1, [this](double a, double b) {
      const double x0 = past(a), x1 = past(b), start = 1 + x0, way = (b - a) / a;
      return stiffness_ *
             (x1 * x1 * power_moment(0, way) / (start * start) - 2 * x1 * mean_power(0, way) / start - std::log1p(x0));
    });
  }
  /// By quadrature: the closed form needs dilogarithms.
  template <class T>
  T mean_potential(const T& r0, const T& r1) const {
    return lanewise(r0, r1, [this](double a, double b) {
      return mean_potential_by_quadrature(a, b, [this](double from, double to) { return mean(from, to); });
    });
  }
  template <class T>
  T magnitude(const T& r) const {
    using std::abs;
    return abs(traction(r)) + abs(T(stiffness(r) * r));
  }

  bool repels() const { return true; }
  double equilibrium_gap() const { return range_; }
  double adhesion_gap() const { return range_; }

 private:
  /// Returns r/h - 1.
  double past(double gap) const { return (gap - range_) / range_; }
  double mean(double a, double b) const {
    const double x0 = past(a), x1 = past(b);
    return stiffness_ * range_ * (x1 * x1 * mean_power(0, (b - a) / a) / (1 + x0) + (x0 + x1) * std::log1p(x0));
  }

  double stiffness_, range_;
};

/// The barrier ends at h, where its energy and its traction are 0: the cutoff shifts nothing. The type tells it from a
/// law whose cutoff a scene has chosen.
class LogBarrier : public CutOff<EndlessBarrier> {
 public:
  using CutOff<EndlessBarrier>::CutOff;
};

struct Parameters {
  double stiffness = 10, range = 0.25;
};

}  // namespace

LawEntry log_barrier_law() {
  Options<Parameters> options;
  options.add("Stiffness", &Parameters::stiffness, "Factor k of the barrier [E0/L0].", greater_than(0))
      .add("Range", &Parameters::range, "Gap h below which the surface is pushed away [L0].", greater_than(0));
  return {"Log Barrier",
          "psi(r) = -k (r - h)^2 ln(r/h) below the gap h. It only repels, without limit as the gap closes.",
          "Li et al. 2020", options.list(), [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            check_derived(node, "Stiffness and Range", {{"energy k h^2", p.stiffness * p.range * p.range}});
            return gap_law(LogBarrier(EndlessBarrier(p.stiffness, p.range), p.range));
          }};
}

}  // namespace ixos
