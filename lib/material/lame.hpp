/// Elastic constants, and the laws that have no others.
#pragma once
#include <memory>

namespace ixos {

class ElasticLaw;

/// Lame's constants [E0].
struct Lame {
  double mu;
  double lambda;
};

/// Returns E = mu (3 lambda + 2 mu)/(lambda + mu).
constexpr double youngs_modulus(const Lame& lame) {
  return lame.mu * (3 * lame.lambda + 2 * lame.mu) / (lame.lambda + lame.mu);
}

/// Returns Poisson's ratio lambda/(2 (lambda + mu)).
constexpr double poissons_ratio(const Lame& lame) { return lame.lambda / (2 * (lame.lambda + lame.mu)); }
/// A body with a larger Poisson's ratio is nearly incompressible: Standard cells lock under any strain that is not
/// uniform, and Newton's method takes mixed steps.
constexpr double nearly_incompressible = 0.45;

/// Returns Lame's constants from Young's modulus E > 0 [E0] and Poisson's ratio nu in (-1, 0.5): mu = E/(2 (1 + nu)),
/// lambda = E nu/((1 + nu) (1 - 2 nu)). The caller has checked the range.
constexpr Lame lame_constants(double young, double poissons_ratio) {
  return {young / (2 * (1 + poissons_ratio)),
          young * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio))};
}

/// Return the laws that have no other constants.
std::shared_ptr<const ElasticLaw> neo_hooke(const Lame& lame);
std::shared_ptr<const ElasticLaw> linear_elastic(const Lame& lame);

}  // namespace ixos
