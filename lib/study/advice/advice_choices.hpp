/// The settings that an advice may change beside scheme, step, elements and mesh.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <vector>

#include "study/advice/advice_directions.hpp"

namespace ixos {

/// Returns the directions beside step and mesh that a complete scene has:
///
/// | direction | levels or choices |
/// |---|---|
/// | Newton tolerance | 1e-6, 1e-8 and the scene's own; beyond it a hundredth if the scene's own is above 1e-8 |
/// | surface points | 3, the scene's own, and twice as many |
/// | cutoff | half the scene's own, the scene's own, and twice as much; if there is one |
/// | material | Linear Elastic in place of Neo-Hooke or Saint Venant-Kirchhoff |
/// | damping | no Rayleigh damping; if there is some |
std::vector<AdviceDirection> advice_choices(const Teuchos::ParameterList& complete);

}  // namespace ixos
