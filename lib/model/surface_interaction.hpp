/// The interaction of a surface of the body with an obstacle.
#pragma once
#include <memory>
#include <string>

#include "interaction/gap_law.hpp"
#include "interaction/obstacle.hpp"
#include "model/model.hpp"

namespace ixos {

struct SurfaceInteraction {
  std::string side_set;                      ///< the surface
  std::shared_ptr<const GapLaw> law;         ///< see make_gap_law()
  std::shared_ptr<const Obstacle> obstacle;  ///< see make_obstacle(), flat_wall()
  double cutoff = 0;                         ///< gap beyond which nothing acts [L0]; 0: none
  int points = 0;                            ///< Gauss points a direction on each side; 0: as SurfaceOptions
  double margin = 0.8;                       ///< in (0, 1), see SurfaceOptions
  std::string name = "interaction";
};

/// Throws InputError if a cutoff [L0] is neither 0 nor beyond the law's largest attraction.
void check_cutoff(const GapLaw& law, double cutoff);

/// Adds the interaction to the model. Throws InputError, on all ranks, if the side set does not exist, law or obstacle
/// are missing, a number is out of range, or the surface at rest is in or below an obstacle whose law needs positive
/// gaps; std::logic_error after Model::close(). Collective.
void add_interaction(Model& model, const SurfaceInteraction& interaction);

}  // namespace ixos
