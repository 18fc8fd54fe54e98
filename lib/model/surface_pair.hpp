/// The interaction of the surfaces of two bodies.
#pragma once
#include <optional>
#include <string>

#include "geometry/patch_points.hpp"
#include "geometry/surface_patches.hpp"
#include "model/model.hpp"
#include "model/surface_forces.hpp"

namespace ixos {

/// How often a pair is integrated: once over the secondary surface; or over both, each with half of the law's energy,
/// which treats both bodies alike; or over both with the whole law, each surface without the reaction of the other, as
/// in Gautam and Sauer (2014), which conserves neither energy nor momentum; or by all pairs of points of both, without
/// a gap, see make_double_integral(): a reference for small surfaces.
enum class Passes { One, Two, TwoWithoutReaction, DoubleIntegral };

/// The most nodes that both surfaces of a double integral may have together. Its matrix is dense: in space it takes
/// 0.65 GB for so many, and each rank has it several times.
inline constexpr std::size_t most_nodes_of_double_integral = 3000;

/// The gaps g of a secondary (slave) surface are its signed least distances to a primary (master) one. The law is
/// integrated over the secondary surface in the undeformed body, the sum of w psi(g), and the primary one takes the
/// reaction. Choose the finer surface as the secondary one. Both may be one surface, which then interacts with itself:
/// each place with those of the other places that face it (see SelfVisibility), the law with half its energy, since
/// each pair of places counts twice. Where parts of a surface begin or cease to face each other within the law's range,
/// its energy jumps; what a step loses so is booked as dissipated under the interaction's name.
struct SurfacePair : SurfaceForces {
  std::string primary;                          ///< side set; `side_set` is the secondary surface
  Smoothing smoothing = Smoothing::CatmullRom;  ///< of both surfaces
  /// If both surfaces are one: the distance along it in the undeformed body below which its parts do not interact, > 0;
  /// about pi times the cutoff [L0]. Otherwise 0.
  double exclusion = 0;
  /// One for a surface that interacts with itself, or with factors. DoubleIntegral has no cutoff, no friction and no
  /// axisymmetric mesh; its law must be Van der Waals, see GapLaw::powers(). With two passes each has half of the
  /// friction.
  Passes passes = Passes::One;

  bool is_with_itself() const { return side_set == primary; }
};

/// Returns the first setting of a pair that is not allowed, whatever the mesh; nothing if all are. Friction is not
/// there for a surface that interacts with itself and for passes without reaction; its threshold is that of the step's
/// start.
std::optional<Refusal> refusal_of(const SurfacePair& pair);

/// Adds the pair to the model. Its matrices couple the nodes of sides that are near each other in the undeformed body;
/// integrators renew that as the bodies move. A program that steps the model without an Integrator calls
/// Model::update_couplings(), and Model::begin_step() for a surface that interacts with itself. Such a surface that
/// overlaps itself at rest is not noticed. On several ranks the model's mesh must have
/// both side sets whole, see localize(). Throws InputError, on all ranks, if a side set does not exist or is not whole,
/// passes are asked for that are not allowed, sides are not those of linear cells, more
/// than two of them meet in a node (in space, in an edge), the two sets share a node, the law is missing or has a
/// history, a number is out of range, a factor is negative or not finite somewhere, the friction is not allowed or does
/// not fit the law, or the surfaces at rest overlap and the law needs positive gaps; std::logic_error after
/// Model::close(). Collective.
void add_pair(Model& model, const SurfacePair& pair);

}  // namespace ixos
