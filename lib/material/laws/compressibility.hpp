/// The parameters that laws of rubber share.
#pragma once
#include "material/lame.hpp"
#include "material/volumetric_energy.hpp"
#include "parameters/options.hpp"
#include "parameters/range_validator.hpp"

namespace ixos {

/// Poisson's ratio at small strains [-] and the form of the volumetric energy, beside constants that give the shear
/// modulus mu > 0 [E0].
struct Compressibility {
  double poisson = 0.2;
  VolumetricEnergy::Form form = VolumetricEnergy::Form::Logarithm;

  /// Returns mu and lambda = 2 mu nu/(1 - 2 nu).
  Lame lame(double mu) const { return {mu, 2 * mu * poisson / (1 - 2 * poisson)}; }
  /// Returns U with K = 2 mu (1 + nu)/(3 (1 - 2 nu)).
  VolumetricEnergy volumetric(double mu) const { return {2 * mu * (1 + poisson) / (3 * (1 - 2 * poisson)), form}; }
};

/// Adds them to the options of a law, a struct derived from Compressibility.
template <class Parameters>
Options<Parameters>& add_compressibility(Options<Parameters>& options) {
  return options
      .add(
          "Poisson's Ratio", &Parameters::poisson,
          "Poisson's ratio nu at small strains [-]. The bulk modulus is K = 2 mu (1 + nu)/(3 (1 - 2 nu)), mu the shear "
          "modulus at small strains.",
          greater_and_less_than(-1, 0.5))
      .choose("Volumetric Energy", &Parameters::form,
              {{"Logarithm", VolumetricEnergy::Form::Logarithm}, {"Convex", VolumetricEnergy::Form::Convex}},
              "Energy of a change of volume. Logarithm: K/2 (ln J)^2, whose tension decreases beyond J = 2.7. Convex: "
              "K/4 (J^2 - 1 - 2 ln J).");
}

}  // namespace ixos
