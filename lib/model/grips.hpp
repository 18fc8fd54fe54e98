/// Grips by the names of node sets.
#pragma once
#include <string>
#include <vector>

#include "model/model.hpp"

namespace ixos {

/// The springs and dashpots of a grip. All nodes of the set share them equally, so that a stiffness K and the mean
/// displacement u of the nodes give the force K (w - u) if the other ends translate by w. Nodes that a contact element
/// added have none.
struct GripSupport {
  std::vector<double>
      stiffness{};  ///< of the whole grip by direction [E0 L0^(D-2), bodies of revolution E0 L0]; empty: no springs
  std::vector<double> damping{};  ///< likewise [E0 L0^(D-2) T0]; empty: no dashpots
};

/// Moves the nodes of a set as a rigid body. Derivative nodes turn with it. Throws InputError, on all ranks, if the
/// mesh has no such set, if a node moves differently by another condition, or if a grip of that name exists: then the
/// model has not changed. Throws std::logic_error after Model::close(). Collective.
void grip_rigidly(Model& model, const std::string& name, const std::string& node_set, const RigidMotion& motion);

/// Has a rigid body of the model carry the nodes of a set. Throws as grip_rigidly() does; also if a node is tied, or
/// some condition holds it.
void grip_by_body(Model& model, const std::string& name, const std::string& node_set, const std::string& body);

/// Holds the nodes of a set by springs and dashpots, whose other ends move as a rigid body. Throws as grip_rigidly()
/// does; also if a number is negative or not finite, if all are 0, if the radial one is not 0 on an axisymmetric
/// mesh, or if damping has no inertia to act on.
void grip_elastically(Model& model, const std::string& name, const std::string& node_set, const RigidMotion& motion,
                      const GripSupport& support);

/// Returns the force and the moment of the grip in a state: for a rigid grip from `reactions`, the nodal forces of
/// State::reaction; otherwise those of springs and dashpots at u, v, local arrays. Collective.
GripReaction grip_reaction(const Model& model, const Grip& grip, double time, const std::vector<double>& u,
                           const std::vector<double>& v, const std::vector<double>& reactions);

}  // namespace ixos
