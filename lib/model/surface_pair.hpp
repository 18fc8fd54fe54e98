/// The interaction of the surfaces of two bodies.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "interaction/friction_law.hpp"
#include "interaction/gap_law.hpp"
#include "model/model.hpp"
#include "term/patch_points.hpp"
#include "term/surface_patches.hpp"

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
/// each place with those of the other places that face it (see SelfSight), the law with half its energy, since each
/// pair of places counts twice. Where parts of a surface begin or cease to face each other within the law's range, its
/// energy jumps; what a step loses so is booked as dissipated under the interaction's name.
struct SurfacePair {
  std::string secondary;              ///< side set
  std::string primary;                ///< side set
  std::shared_ptr<const GapLaw> law;  ///< see make_gap_law()
  double cutoff = 0;                  ///< gap beyond which nothing acts [L0]; 0: none
  int points = 0;                     ///< Gauss points per direction on each side of the secondary surface; 0: 5
  double margin = 0.8;                ///< in (0, 1), see PairOptions
  std::string name = "interaction";
  Smoothing smoothing = Smoothing::CatmullRom;  ///< of both surfaces
  /// Factors of the law's energy on the secondary surface, see SurfaceInteraction.
  std::function<double(const std::array<double, 3>&)> factor{};
  std::vector<double> nodal_factor{};
  /// If both surfaces are one: the distance along it in the undeformed body below which its parts do not interact, > 0;
  /// about pi times the cutoff [L0]. Otherwise 0.
  double exclusion = 0;
  /// One for a surface that interacts with itself, or with factors. DoubleIntegral has no cutoff, no friction and no
  /// axisymmetric mesh; its law must be Van der Waals, see powers_of().
  Passes passes = Passes::One;
  /// Along the primary surface, scaled by the factor like the law; with two passes each has half of it. None for a
  /// surface that interacts with itself and for passes without reaction; the threshold is that of the step's start.
  Friction friction{};
};

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
