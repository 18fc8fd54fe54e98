/// The valid parameters of a scene.
#pragma once
#include <Teuchos_ParameterList.hpp>

namespace ixos {

/// Returns every list and parameter of a scene with its default, range and documentation (units in brackets). The
/// checks, the effective scene and the documentation are all made from this.
const Teuchos::ParameterList& scene_parameters();

}  // namespace ixos
