/// The named points of a scene.
#pragma once
#include <string>
#include <vector>

#include "discretization/material_point.hpp"
#include "model/model.hpp"
#include "state/state.hpp"

#include "parameters/scene_node.hpp"

namespace ixos {

/// A named point, and its place in the reference configuration.
struct Probe {
  std::string name;
  std::vector<double> place;  ///< [L0]
  MaterialPoint point;
};

/// Returns the points of the list "Output/Probes". Throws InputError with the list path if a point lies outside the
/// body. Collective.
std::vector<Probe> find_probes(const SceneNode& list, const Model& model);

/// Returns a component of displacement ("ux", "uy", "uz"), velocity ("vx", ...) or present place ("x", "y", "z").
/// Collective.
double probe_value(const Probe& probe, const std::string& quantity, const Model& model, const State& state);

}  // namespace ixos
