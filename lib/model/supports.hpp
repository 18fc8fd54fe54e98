/// Springs and dashpots of parts of a model.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "term/support/springs.hpp"

namespace ixos {

/// The terms that hold a part; each may be null.
struct Supports {
  std::unique_ptr<Springs> springs{};
  std::unique_ptr<Dashpots> dashpots{};
};

/// Returns springs and dashpots of a stiffness and a damping by direction, null if empty or 0 throughout, and adds the
/// loads of their driven ends to the model, one for each function of the motion: all ranks add the same ones. `ends`
/// makes the ends for coefficients by direction, `part` is the subject of messages: "the grip". Throws InputError, and
/// the model has not changed, if the numbers are not as many as the mesh has dimensions, one is negative or not finite,
/// the radial one of an axisymmetric mesh is not 0, or if damping has no inertia to act on.
Supports make_supports(Model& model, const std::string& part, const std::vector<double>& stiffness,
                       const std::vector<double>& damping, const RigidMotion& motion,
                       const std::function<DrivenEnds(const std::vector<double>&)>& ends);

}  // namespace ixos
