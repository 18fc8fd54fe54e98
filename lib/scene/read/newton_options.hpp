/// Settings of Newton's method: the list "Nonlinear Solver" of a scene.
#pragma once
#include <Teuchos_ParameterList.hpp>

#include "parameters/scene_node.hpp"
#include "solve/newton/newton.hpp"

namespace ixos {

/// Adds the parameters of NewtonOptions to a valid list.
void declare_newton(Teuchos::ParameterList& list);

/// Returns the options of the validated list "Nonlinear Solver".
NewtonOptions read_newton(const SceneNode& nonlinear_solver);

}  // namespace ixos
