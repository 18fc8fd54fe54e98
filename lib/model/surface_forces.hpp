/// Settings that all interactions of a surface have, with an obstacle or with another surface.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interaction/friction.hpp"
#include "model/refusal.hpp"

namespace ixos {

class GapLaw;

/// The law over a surface.
struct SurfaceForces {
  std::string side_set;               ///< the surface over which the law is integrated
  std::shared_ptr<const GapLaw> law;  ///< see make_gap_law()
  double cutoff = 0;                  ///< gap beyond which nothing acts [L0]; 0: none
  int points = 0;                     ///< Gauss points a direction on each side; 0: 5, or 8 on sides beyond order 2
  double margin = 0.8;                ///< in (0, 1), see SurfaceOptions and PairOptions
  std::string name = "interaction";
  /// Factor of the law's energy by the place of the undeformed surface, at least 0; null: 1. Equal on all ranks.
  std::function<double(const std::array<double, 3>&)> factor{};
  /// Factor likewise by local node of the model's mesh, ghosts included, linear (bilinear) between the corners of the
  /// surface's sides; empty: 1. Numbers at nodes that contact elements added do not count.
  std::vector<double> nodal_factor{};
  Friction friction{};  ///< along the obstacle or the other surface, scaled by the factor like the law; None: none
};

/// Returns the law up to its cutoff, if it has one.
std::shared_ptr<const GapLaw> acting_law(const SurfaceForces& forces);

/// Returns what is not allowed of the settings that all interactions have; nothing if all are allowed: a law that is
/// missing, numbers out of range, a cutoff that is neither 0 nor beyond the law's adhesion gap, or within the range of
/// a law with a history, and friction whose traction would jump within a step.
std::optional<Refusal> refusal_of_forces(const SurfaceForces& forces);

}  // namespace ixos
