/// Velocities at the initial time.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "parameters/scene_node.hpp"

namespace ixos {

/// The motion with which blocks start: v = velocity + gradient (X - origin).
struct InitialMotion {
  std::string path;                 ///< of its list
  std::vector<std::string> blocks;  ///< empty: all blocks that no other motion names
  std::array<double, 3> velocity{};
  std::array<std::array<double, 3>, 3> gradient{};  ///< the spin included
  std::optional<std::array<double, 3>> origin{};    ///< none: the centre of mass of the blocks

  bool has_gradient() const { return gradient != std::array<std::array<double, 3>, 3>{}; }
};

/// Adds the parameters of the list "Initial Conditions" to a valid list.
void declare_initial_conditions(Teuchos::ParameterList& list);

/// Returns the motions of the validated list "Initial Conditions": first that of all blocks, then those of its
/// sublists. Throws InputError with the list path if an array has not the length that the dimension requires, if a list
/// names no block, one twice, or one that another list names, or if a motion takes an axisymmetric body off its axis.
std::vector<InitialMotion> initial_motions(const SceneNode& initial, int dimension, bool axisymmetric);

/// Returns the velocities of all local nodes at the initial time, ghosts included. Throws InputError, with the list
/// path and on all ranks alike, if a block does not exist, or if blocks share nodes but no velocity there. Collective.
std::vector<double> initial_velocities(const std::vector<InitialMotion>& motions, const Model& model,
                                       const std::vector<Material>& materials);

}  // namespace ixos
