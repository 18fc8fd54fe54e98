/// Grips of a scene.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "scene/read/motions.hpp"

namespace ixos {

enum class GripType { Rigid, Springs };

/// One list of "Grips".
struct GripOptions : MotionOptions {
  GripType type = GripType::Rigid;
  std::string node_set{};
  std::string rigid_body{};
  std::vector<double> stiffness{};
  std::vector<double> damping{};
};

/// Adds the parameters of a grip to a valid list.
void declare_grip(Teuchos::ParameterList& list);

GripOptions read_grip(const SceneNode& node);

/// Adds the grips of the list "Grips" to the model. `bodies`: the list "Rigid Bodies". Throws InputError with the list
/// path, on all ranks alike. Collective.
void add_grips(const SceneNode& grips, const SceneNode& bodies, const Histories& histories, Model& model);

/// Returns a line for each grip: the set, what moves it and what holds it.
std::string grips_in_words(const SceneNode& grips);

}  // namespace ixos
