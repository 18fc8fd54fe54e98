/// Prescribed displacements and loads by the names of sets and blocks.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "histories/time_function.hpp"
#include "model/model.hpp"

namespace ixos {

/// Each function throws InputError, on all ranks, if the mesh has no such set or block, or a vector does not have as
/// many components as the mesh has dimensions: then the model has not changed. After Model::close() each throws
/// std::logic_error. All ranks call each with the same arguments; prescribe() is collective. `history` gives the factor
/// in time; see histories/time_function.hpp for ready-made ones and for function_of_time().

/// Returns the components that "all", "x", "xy" ... names, from 0. Throws InputError.
std::vector<int> components_of(const std::string& components, int dimension);

/// Prescribes components of the displacement of all nodes of a set: u_i(t) = motion(t) [L0], or zero without a motion.
/// Throws InputError if another condition prescribes another motion for one of these degrees of freedom.
void prescribe(Model& model, const std::string& node_set, const std::string& components,
               const std::shared_ptr<const TimeFunction>& motion = nullptr);

/// Keeps the nodes of a set in their plane: n . u = 0 for the normal n of the plane in which they are at rest, of any
/// direction. Throws InputError if they are in no plane (see fitted_normal()), if another condition moves a node across
/// it, and on an axisymmetric mesh unless the plane is across the axis. Collective.
void hold_in_plane(Model& model, const std::string& node_set);

/// Adds a dead traction on a side set: `vector` per reference area [E0].
void add_traction(Model& model, const std::string& side_set, const std::vector<double>& vector,
                  std::shared_ptr<const TimeFunction> history);

/// Adds a force on each node of a set [E0 L0^(D-1)]; of an axisymmetric mesh, the force on the node's whole ring. Nodes
/// that a contact element added do not count.
void add_point_force(Model& model, const std::string& node_set, const std::vector<double>& vector,
                     std::shared_ptr<const TimeFunction> history);

/// Adds a force per reference volume [E0/L0] in a block, or in all blocks if its name is empty.
void add_body_force(Model& model, const std::string& block, const std::vector<double>& vector,
                    std::shared_ptr<const TimeFunction> history);

/// Adds an acceleration [L0/T0^2] that acts on the mass of a block, or of all blocks if its name is empty.
/// Throws InputError if the mesh is axisymmetric and the first component not 0. Collective.
void add_gravity(Model& model, const std::string& block, const std::vector<double>& vector,
                 std::shared_ptr<const TimeFunction> history);

}  // namespace ixos
