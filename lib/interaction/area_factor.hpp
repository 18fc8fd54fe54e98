/// Curvature of an obstacle in the energy of a law between flat surfaces.
#pragma once
#include <memory>

namespace ixos {

class GapLaw;

/// The ratio a(g) of two areas of surfaces parallel to an obstacle: half way to the body, and at the body, at gap g.
/// With it, psi refers to the area half way. For a sphere of radius R it is (1 + g/2R)^2/(1 + g/R)^2. It reduces the
/// error of a half-space's law before a sphere from order g/R to order (g/R)^2 where the surfaces are parallel.
struct AreaFactor {
  double radius = 0;  ///< R [L0], negative in a cavity
  int power = 2;      ///< 2 for a sphere, 1 for a cylinder
};

/// Documentation of the parameter "Area Factor".
inline constexpr char area_factor_text[] =
    "Whether the law's energy is multiplied by the ratio of the areas half way to the obstacle and at the body: for a "
    "sphere (1 + g/2R)^2/(1 + g/R)^2 at gap g, for a cylinder the root of it, in a cavity with -R in place of R.";

/// Returns the law with the energy psi a and the traction T a - psi a' in place of psi and T. Its mean traction is
/// exact. It has no potential of the mean, and keeps the law's equilibrium gap and adhesion gap: the factor moves both
/// by a share of about g/R. Throws InputError if the radius is zero or the law has a
/// history.
std::shared_ptr<const GapLaw> with_area_factor(std::shared_ptr<const GapLaw> law, const AreaFactor& factor);

}  // namespace ixos
