/// Elastic constants.
#pragma once

namespace ixos {

/// Lame's constants [E0].
struct Lame {
  double mu;
  double lambda;
};

/// From Young's modulus E > 0 [E0] and Poisson's ratio nu in (-1, 0.5): mu = E/(2 (1 + nu)), lambda = E nu/((1 + nu)
/// (1 - 2 nu)). The caller has checked the range.
constexpr Lame lame_constants(double youngs_modulus, double poissons_ratio) {
  return {youngs_modulus / (2 * (1 + poissons_ratio)),
          youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio))};
}

}  // namespace ixos
