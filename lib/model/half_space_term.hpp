/// Interaction of a surface with a rigid flat wall.
#pragma once
#include <memory>
#include <vector>

#include "interaction/half_space.hpp"
#include "interaction/van_der_waals.hpp"
#include "mesh/local_mesh.hpp"
#include "model/pattern.hpp"
#include "model/term.hpp"

namespace ixos {

struct SurfaceOptions {
  int points = 0;       ///< Gauss points a direction on each side; 0: 5, but 8 on sides of order 3 or more
  double cutoff = 0;    ///< range of the interaction [L0]; 0: none (see CutOff)
  double margin = 0.8;  ///< kappa: a Newton step keeps r_new >= kappa min(r, equilibrium gap)
};

/// Returns the terms for the sides of one side set before `wall`, one for each element type and choice of tied edges
/// among them, and at least one.
std::vector<std::unique_ptr<Term>> make_half_space_terms(const LocalMesh& mesh, const std::vector<LocalSide>& sides,
                                                         const Pattern& pattern, const VanDerWaals& law,
                                                         const HalfSpace& wall, const SurfaceOptions& options);

}  // namespace ixos
