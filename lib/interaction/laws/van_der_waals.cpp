#include "interaction/van_der_waals.hpp"

#include <fmt/format.h>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"

namespace ixos {
namespace {

enum class Constants { Ratios, Hamaker, Adhesion };

struct Parameters {
  Constants constants = Constants::Ratios;
  double gamma_length = 2.5, gamma_energy = 25;
  double hamaker = 0, length = 0, work = 0, strength = 0;
};

/// Returns the law with A_H = 2 pi^2 r0^3 W0 (Israelachvili 2011, table 13.1, for the attraction -A_H/(12 pi r^2)).
VanDerWaals from_hamaker(double hamaker, double length) {
  return {1 / length, 2 * M_PI * M_PI * length * length * length / hamaker};
}

/// Returns the law with that depth of the potential, W = 15^(1/3) pi/(8 gamma_W gamma_L), and largest attraction,
/// s0 = 2 sqrt(5) pi/(9 gamma_W).
VanDerWaals from_adhesion(double work, double strength) {
  const double gamma_energy = 2 * std::sqrt(5.0) * M_PI / (9 * strength);
  return {std::cbrt(15.0) * M_PI / (8 * gamma_energy * work), gamma_energy};
}

VanDerWaals make(const Parameters& p) {
  if (p.constants == Constants::Hamaker) return from_hamaker(p.hamaker, p.length);
  if (p.constants == Constants::Adhesion) return from_adhesion(p.work, p.strength);
  return {p.gamma_length, p.gamma_energy};
}

const char* names(Constants constants) {
  if (constants == Constants::Hamaker) return "Hamaker Constant and Length Scale";
  return constants == Constants::Adhesion ? "Work of Adhesion and Strength" : "Gamma L and Gamma W";
}

}  // namespace

LawEntry van_der_waals_law() {
  Options<Parameters> options;
  options
      .choose_one("Constants", &Parameters::constants,
                  {{"Ratios", Constants::Ratios}, {"Hamaker", Constants::Hamaker}, {"Adhesion", Constants::Adhesion}},
                  {{"Ratios", {"Gamma L", "Gamma W"}},
                   {"Hamaker", {"Hamaker Constant", "Length Scale"}},
                   {"Adhesion", {"Work of Adhesion", "Strength"}}},
                  "Van der Waals: the two constants that a scene gives. Ratios: Gamma L and Gamma W. Hamaker: Hamaker "
                  "Constant and Length Scale. Adhesion: Work of Adhesion and Strength.")
      .add("Gamma L", &Parameters::gamma_length,
           "Van der Waals: ratio L0/r0, where r0 is the length scale of the law [-].", greater_than(0))
      .add("Gamma W", &Parameters::gamma_energy,
           "Van der Waals: ratio E0/W0, where W0 is the energy density scale of the law [-].", greater_than(0))
      .require("Hamaker Constant", &Parameters::hamaker,
               "Van der Waals: Hamaker's constant A_H = 2 pi^2 r0^3 W0 [E0 L0^3].", greater_than(0))
      .require("Length Scale", &Parameters::length,
               "Van der Waals: length scale r0 of the law [L0]. No traction acts at a gap of 15^(-1/6) r0 = 0.637 r0.",
               greater_than(0))
      .require("Work of Adhesion", &Parameters::work, "Van der Waals: depth W of the potential [E0 L0].",
               greater_than(0))
      .require("Strength", &Parameters::strength, "Van der Waals: largest attraction s0 [E0].", greater_than(0));
  return {"Van der Waals",
          "Van der Waals integrates the Lennard-Jones potential over the half-space: at a gap r the traction is T(r) = "
          "c1/r^9 - c2/r^3.",
          "Sauer and Wriggers 2009",
          options.list(),
          [options](const SceneNode& node) {
            const Parameters p = options.read(node);
            const VanDerWaals law = make(p);
            if (!std::isfinite(law.c1()) || !(law.c1() > 0) || !std::isfinite(law.c2()) || !(law.c2() > 0))
              node.refuse("", fmt::format("{} are too extreme: c1 = {} and c2 = {} must be positive and finite",
                                          names(p.constants), law.c1(), law.c2()));
            return gap_law(law);
          },
          true};
}

}  // namespace ixos
