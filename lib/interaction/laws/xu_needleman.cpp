#include <cmath>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/law_parameters.hpp"
#include "interaction/mean_functions.hpp"

namespace ixos {
namespace {

/// psi = -W (1 + s) e^-s with s = (r - r_e)/d (Xu and Needleman 1994, its normal part). Defined for every gap. The
/// scalar T is double or Pack.
class XuNeedleman {
 public:
  static constexpr bool has_range = false;
  static constexpr GapDomain domain = GapDomain::All;

  /// Work of adhesion W [E0 L0], characteristic length d [L0], gap of the minimum r_e [L0].
  XuNeedleman(double work, double length, double gap) : work_(work), length_(length), gap_(gap) {}

  template <class T>
  T energy(const T& r) const {
    return lanewise(r, [this](double gap) {
      const double s = scaled(gap);
      return -work_ * (1 + s) * std::exp(-s);
    });
  }
  template <class T>
  T traction(const T& r) const {
    return lanewise(r, [this](double gap) {
      const double s = scaled(gap);
      return -work_ / length_ * s * std::exp(-s);
    });
  }
  template <class T>
  T stiffness(const T& r) const {
    return lanewise(r, [this](double gap) {
      const double s = scaled(gap);
      return work_ / (length_ * length_) * (1 - s) * std::exp(-s);
    });
  }
  template <class T>
  T mean_traction(const T& r0, const T& r1) const {
    return lanewise(r0, r1, [this](double a, double b) {
      const double s = scaled(a), v = (b - a) / length_;
      return -work_ / length_ * std::exp(-s) * (s * mean_exponential(-v) + v * exponential_moment_1(v));
    });
  }
  template <class T>
  T mean_stiffness(const T& r0, const T& r1) const {
    return lanewise(r0, r1, [this](double a, double b) {
      const double s = scaled(a), v = (b - a) / length_;
      return work_ / (length_ * length_) * std::exp(-s) *
             ((1 - s) * exponential_moment_1(v) - v * exponential_moment_2(v));
    });
  }
  template <class T>
  T mean_potential(const T& r0, const T& r1) const {
    return lanewise(r0, r1, [this](double a, double b) {
      const double s = scaled(a), v = (b - a) / length_;
      return work_ * std::exp(-s) * ((1 + s) * entire_exponential_integral(v) + std::expm1(-v));
    });
  }
  template <class T>
  T magnitude(const T& r) const {
    return lanewise(r, [this](double gap) {
      const double s = scaled(gap);
      return work_ / length_ * std::exp(-s) * (std::abs(s) + (1 + std::abs(s)) * std::abs(gap) / length_);
    });
  }

  bool repels() const { return true; }
  double equilibrium_gap() const { return gap_; }
  double adhesion_gap() const { return gap_ + length_; }

 private:
  double scaled(double gap) const { return (gap - gap_) / length_; }
  double work_, length_, gap_;
};

enum class Constants { Adhesion, Length };

struct Parameters {
  Constants constants = Constants::Adhesion;
  double work = default_work, strength = default_strength, length = 0, gap = default_gap;
};

}  // namespace

LawEntry xu_needleman_law() {
  Options<Parameters> options;
  options
      .choose_one("Constants", &Parameters::constants,
                  {{"Adhesion", Constants::Adhesion}, {"Length", Constants::Length}},
                  {{"Adhesion", {"Strength"}}, {"Length", {"Characteristic Length"}}},
                  "The constant that a scene gives beside Work of Adhesion. Adhesion: Strength. Length: Characteristic "
                  "Length.")
      .add("Work of Adhesion", &Parameters::work, "Depth W of the potential [E0 L0].", greater_than(0))
      .add("Strength", &Parameters::strength, "Largest attraction s0 [E0]. The characteristic length is d = W/(e s0).",
           greater_than(0))
      .require("Characteristic Length", &Parameters::length,
               "Distance d from the equilibrium gap to the gap of largest attraction [L0].", greater_than(0))
      .add("Equilibrium Gap", &Parameters::gap, "Gap r_e at which no traction acts [L0].", greater_than(0));
  return {"Xu-Needleman",
          "psi(r) = -W (1 + s) exp(-s), s = (r - r_e)/d: the universal binding law. Its finite repulsion allows "
          "penetration.",
          "Xu and Needleman 1994", options.list(), [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            const bool adhesion = p.constants == Constants::Adhesion;
            const double length = adhesion ? p.work / (M_E * p.strength) : p.length;
            check_derived(
                node, adhesion ? "Work of Adhesion and Strength" : "Work of Adhesion and Characteristic Length",
                {{"characteristic length", length}, {"stiffness at the equilibrium gap", p.work / (length * length)}});
            return gap_law(XuNeedleman(p.work, length, p.gap));
          }};
}

}  // namespace ixos
