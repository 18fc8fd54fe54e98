/// Springs and dashpots of rigid bodies.
#pragma once
#include <string>

#include "model/grips.hpp"

namespace ixos {

/// Holds the centre of a rigid body of the model by springs and dashpots whose other ends translate: k (w - T) +
/// c (w' - T') in each direction. `base`: w, which does not turn. Directions in which the body is held have none.
/// Throws InputError, on all ranks, as grip_elastically() does.
void support_body(Model& model, const std::string& body, const RigidMotion& base, const GripSupport& support);

}  // namespace ixos
