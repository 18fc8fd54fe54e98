#include <fmt/format.h>

#include <cmath>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/law_parameters.hpp"
#include "interaction/mean_functions.hpp"

namespace ixos {
namespace {

/// psi = W (m q^n - n q^m)/(n - m) with q = r_e/r and real exponents n > m > 0 (Mie 1903, for the energy of two
/// surfaces). The scalar T is double or Pack.
class Mie {
 public:
  static constexpr bool has_range = false;
  static constexpr GapDomain domain = GapDomain::Positive;

  /// Work of adhesion W [E0 L0], gap of the minimum r_e [L0].
  Mie(double n, double m, double work, double gap) : n_(n), m_(m), work_(work), gap_(gap) {}

  template <class T>
  T energy(const T& r) const {
    return lanewise(r, [this](double gap) {
      const double l = std::log(gap_ / gap), q = std::exp(m_ * l);
      return work_ * q * (m_ / (n_ - m_) * std::expm1((n_ - m_) * l) - 1);
    });
  }
  template <class T>
  T traction(const T& r) const {
    return lanewise(r, [this](double gap) {
      const double l = std::log(gap_ / gap);
      return factor() * std::exp(m_ * l) * std::expm1((n_ - m_) * l) / gap;
    });
  }
  template <class T>
  T stiffness(const T& r) const {
    return lanewise(r, [this](double gap) {
      const double l = std::log(gap_ / gap);
      return factor() * ((n_ + 1) * std::exp(n_ * l) - (m_ + 1) * std::exp(m_ * l)) / (gap * gap);
    });
  }
  template <class T>
  T mean_traction(const T& r0, const T& r1) const {
    return lanewise(r0, r1, [this](double a, double b) { return mean(a, b); });
  }
  template <class T>
  T mean_stiffness(const T& r0, const T& r1) const {
    return lanewise(r0, r1, [this](double a, double b) {
      const double l = std::log(gap_ / a), x = (b - a) / a;
      return factor() *
             ((n_ + 1) * std::exp(n_ * l) * power_moment(n_, x) - (m_ + 1) * std::exp(m_ * l) * power_moment(m_, x)) /
             (a * a);
    });
  }
  /// By quadrature: there is no closed form.
  template <class T>
  T mean_potential(const T& r0, const T& r1) const {
    return lanewise(r0, r1, [this](double a, double b) {
      return mean_potential_by_quadrature(a, b, [this](double from, double to) { return mean(from, to); });
    });
  }
  template <class T>
  T magnitude(const T& r) const {
    return lanewise(r, [this](double gap) {
      const double l = std::log(gap_ / gap);
      return factor() * ((n_ + 2) * std::exp(n_ * l) + (m_ + 2) * std::exp(m_ * l)) / gap;
    });
  }

  bool repels() const { return true; }
  double equilibrium_gap() const { return gap_; }
  double adhesion_gap() const { return gap_ * std::pow((n_ + 1) / (m_ + 1), 1 / (n_ - m_)); }

 private:
  double factor() const { return n_ * m_ / (n_ - m_) * work_; }
  double mean(double a, double b) const {
    const double l = std::log(gap_ / a), x = (b - a) / a;
    return factor() * (std::exp(n_ * l) * mean_power(n_, x) - std::exp(m_ * l) * mean_power(m_, x)) / a;
  }

  double n_, m_, work_, gap_;
};

enum class Constants { Adhesion, Gap, Hamaker };

struct Parameters {
  Constants constants = Constants::Adhesion;
  double n = 8, m = 2;
  double work = default_work, strength = default_strength, gap = 0, hamaker = 0;
};

/// Returns s0 r_e/W.
double strength_ratio(double n, double m) {
  const double l = std::log((m + 1) / (n + 1)) / (n - m);  // ln(r_e/r_p) at the peak r_p
  return -n * m / (n - m) * std::exp((m + 1) * l) * std::expm1((n - m) * l);
}

Mie make(const Parameters& p, const SceneNode& node) {
  if (!(p.n > p.m))
    node.refuse("Repulsive Exponent", fmt::format("{} must be greater than the Attractive Exponent, {}", p.n, p.m));
  double work = p.work, gap = p.gap;
  std::string names = "Work of Adhesion and Equilibrium Gap";
  if (p.constants == Constants::Adhesion) {
    names = "Work of Adhesion and Strength";
    gap = strength_ratio(p.n, p.m) * work / p.strength;
  }
  if (p.constants == Constants::Hamaker) {
    names = "Hamaker Constant and Equilibrium Gap";
    work = p.hamaker * (p.n - 2) / (12 * M_PI * p.n * gap * gap);
  }
  check_derived(node, names,
                {{"equilibrium gap", gap},
                 {"work of adhesion", work},
                 {"stiffness at the equilibrium gap", p.n * p.m * work / (gap * gap)}});
  return {p.n, p.m, work, gap};
}

}  // namespace

LawEntry mie_law() {
  Options<Parameters> options;
  options
      .add(
          "Repulsive Exponent", &Parameters::n,
          "Exponent n of the repulsive part of the energy, greater than m [-]. With n = 8 and m = 2 the law is Van der "
          "Waals.",
          greater_than(0))
      .add("Attractive Exponent", &Parameters::m, "Exponent m of the attractive part of the energy [-].",
           greater_than(0))
      .choose_one("Constants", &Parameters::constants,
                  {{"Adhesion", Constants::Adhesion}, {"Gap", Constants::Gap}, {"Hamaker", Constants::Hamaker}},
                  {{"Adhesion", {"Work of Adhesion", "Strength", "Attractive Exponent"}},
                   {"Gap", {"Work of Adhesion", "Equilibrium Gap", "Attractive Exponent"}},
                   {"Hamaker", {"Hamaker Constant", "Equilibrium Gap"}}},
                  "The constants that a scene gives beside n. Adhesion: Work of Adhesion, Strength and m. Gap: Work of "
                  "Adhesion, Equilibrium Gap and m. Hamaker: Hamaker Constant and Equilibrium Gap; m is 2.")
      .add("Work of Adhesion", &Parameters::work, "Depth W of the potential [E0 L0].", greater_than(0))
      .add("Strength", &Parameters::strength, "Largest attraction s0 [E0].", greater_than(0))
      .require("Equilibrium Gap", &Parameters::gap, "Gap r_e at which no traction acts [L0].", greater_than(0))
      .require("Hamaker Constant", &Parameters::hamaker,
               "Hamaker's constant A_H [E0 L0^3]: far away psi tends to -A_H/(12 pi r^2).", greater_than(0));
  return {"Mie", "psi(r) = W (m q^n - n q^m)/(n - m), q = r_e/r: repulsion and attraction by two powers of the gap.",
          "Mie 1903", options.list(),
          [options](const SceneNode& node) { return gap_law(make(options.read(node), node)); }};
}

}  // namespace ixos
