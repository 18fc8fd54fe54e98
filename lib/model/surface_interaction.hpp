/// The interaction of a surface of the body with an obstacle.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "histories/rigid_motion.hpp"
#include "model/model.hpp"
#include "model/surface_forces.hpp"

namespace ixos {

class Obstacle;

/// The law before an obstacle.
struct SurfaceInteraction : SurfaceForces {
  std::shared_ptr<const Obstacle> obstacle;  ///< see make_obstacle(), flat_wall()
  std::optional<RigidMotion> motion{};       ///< of the obstacle, whose parameters are those of the place before it
  double initial_time = 0;   ///< at which the surface at rest must be outside a moved obstacle [T0]; NaN: never
  std::string rigid_body{};  ///< of the model, which carries the obstacle; empty: none
};

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
