#include <cmath>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/law_parameters.hpp"

namespace ixos {
namespace {

/// psi = -e/(2 z) with z = r + t: two conductors at a constant voltage, with the energy of the battery. The scalar T is
/// any.
class Electrostatic {
 public:
  static constexpr bool has_range = false;
  static constexpr GapDomain domain = GapDomain::Positive;

  /// Force constant e = permittivity times squared voltage [E0 L0^2], thickness of the insulation over its relative
  /// permittivity t > 0 [L0].
  Electrostatic(double constant, double insulation) : e_(constant), t_(insulation) {}

  template <class T>
  T energy(const T& r) const {
    return -0.5 * e_ / (r + t_);
  }
  template <class T>
  T traction(const T& r) const {
    const T z = r + t_;
    return -0.5 * e_ / (z * z);
  }
  template <class T>
  T stiffness(const T& r) const {
    const T z = r + t_;
    return -e_ / (z * z * z);
  }
  template <class T>
  T mean_traction(const T& r0, const T& r1) const {
    return -0.5 * e_ / ((r0 + t_) * (r1 + t_));
  }
  template <class T>
  T mean_stiffness(const T& r0, const T& r1) const {
    const T z = r1 + t_;
    return -0.5 * e_ / ((r0 + t_) * z * z);
  }
  template <class T>
  T mean_potential(const T& r0, const T& r1) const {
    using std::log1p;
    const T z = r0 + t_;
    return 0.5 * e_ / z * log1p(T((r1 - r0) / z));
  }
  template <class T>
  T magnitude(const T& r) const {
    const T z = r + t_;
    return 1.5 * e_ / (z * z);
  }

  bool repels() const { return false; }
  double equilibrium_gap() const { return t_; }
  double adhesion_gap() const { return 0; }

 private:
  double e_, t_;
};

enum class Constants { Voltage, Force };

struct Parameters {
  Constants constants = Constants::Voltage;
  double voltage = 0, permittivity = 0, constant = 0, insulation = 0;
};

}  // namespace

LawEntry electrostatic_law() {
  Options<Parameters> options;
  options
      .choose_one("Constants", &Parameters::constants, {{"Voltage", Constants::Voltage}, {"Force", Constants::Force}},
                  {{"Voltage", {"Voltage", "Permittivity"}}, {"Force", {"Force Constant"}}},
                  "The constants that a scene gives. Voltage: Voltage and Permittivity. Force: Force Constant.")
      .require("Voltage", &Parameters::voltage, "Constant voltage V between the surface and the obstacle [V].",
               greater_than(0))
      .require("Permittivity", &Parameters::permittivity,
               "Permittivity of the gap [E0 L0^2/V^2]: 8.8541878128e-12 F/m for vacuum and air, "
               "in the default units 4.4270939e-3.",
               greater_than(0))
      .require("Force Constant", &Parameters::constant, "Permittivity times the squared voltage, e [E0 L0^2].",
               greater_than(0))
      .require("Insulation", &Parameters::insulation,
               "Thickness of the insulation between the conductors over its relative permittivity [L0]. It bounds the "
               "attraction.",
               greater_than(0));
  return {"Electrostatic",
          "psi(r) = -e/(2 z), z = r + t: attraction of conductors under a constant voltage, insulated by t. It only "
          "attracts: another interaction of the side set has to repel before the gap closes.",
          "Senturia 2001", options.list(), [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            const bool voltage = p.constants == Constants::Voltage;
            const double e = voltage ? p.permittivity * p.voltage * p.voltage : p.constant, t = p.insulation;
            check_derived(node, voltage ? "Voltage, Permittivity and Insulation" : "Force Constant and Insulation",
                          {{"force constant", e}, {"largest stiffness", e / (t * t * t)}});
            return gap_law(Electrostatic(e, t));
          }};
}

}  // namespace ixos
