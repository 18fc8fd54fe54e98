/// Prescribed motion of tied nodes.
#pragma once
#include <string>

#include "model/model.hpp"

namespace ixos {

/// Throws InputError, on all ranks, if a tied node of the set follows a node that is not in it: the motion of the one
/// would be prescribed, but not that of the other. A tied node whose masters move rigidly moves with them, so no
/// condition is added for it. Collective.
void refuse_half_tied(const Model& model, const std::string& node_set);

}  // namespace ixos
