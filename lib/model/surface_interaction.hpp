/// The interaction of a surface of the body with an obstacle.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "histories/rigid_motion.hpp"
#include "interaction/friction_law.hpp"
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
  /// Factor of the law's energy by the place of the undeformed surface, at least 0; null: 1. Equal on all ranks.
  std::function<double(const std::array<double, 3>&)> factor{};
  std::optional<RigidMotion> motion{};  ///< of the obstacle, whose parameters are those of the place before the motion
  double initial_time = 0;              ///< at which the surface at rest must be outside a moved obstacle [T0]
  /// Factor likewise by local node of the model's mesh, ghosts included, linear (bilinear) between the corners of the
  /// surface's sides; empty: 1. Numbers at nodes that contact elements added do not count.
  std::vector<double> nodal_factor{};
  Friction friction{};  ///< along the obstacle, scaled by the factor like the law; type None: none
};

/// Throws InputError if a cutoff [L0] is neither 0 nor beyond the law's adhesion gap, or beyond the range of a law with
/// a history.
void check_cutoff(const GapLaw& law, double cutoff);

/// Returns the law as it acts on a body of that dimension before that obstacle: cut off if the cutoff [L0] is not 0,
/// and with the obstacle's area factor. Throws InputError if it acts beyond the obstacle's reach.
std::shared_ptr<const GapLaw> law_before(const Obstacle& obstacle, const std::shared_ptr<const GapLaw>& law,
                                         double cutoff, int body_dimension);

/// Adds the interaction to the model. Throws InputError, on all ranks, if the side set does not exist, law or obstacle
/// are missing, a number is out of range, a factor is negative or not finite somewhere, the mesh is axisymmetric and
/// the obstacle not coaxial or moved other than along y, the motion has another dimension than the mesh, the law acts
/// beyond the obstacle's reach, the friction has a number out of range or a threshold from a law with a history, or the
/// surface at rest is in or below an obstacle whose law needs positive gaps;
/// std::logic_error after Model::close(). Collective.
void add_interaction(Model& model, const SurfaceInteraction& interaction);

}  // namespace ixos
