/// Interaction of a surface with a rigid obstacle.
#pragma once
#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "discretization/pattern.hpp"
#include "fem/with_element.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/obstacle.hpp"
#include "mesh/local_mesh.hpp"
#include "term/interaction.hpp"

namespace ixos {

struct SurfaceOptions {
  int points = 0;       ///< Gauss points a direction on each side; 0: 5, but 8 on sides of order 3 or more
  double margin = 0.8;  ///< kappa: a Newton step keeps r_new >= kappa min(r, equilibrium gap)
};

using Interactions = std::vector<std::unique_ptr<Interaction>>;

/// Returns the terms for the sides of one side set before `obstacle`, one for each element type and choice of tied
/// edges among them, and at least one. Before a half-space gaps are linear in the displacement, which saves most of the
/// work; the van der Waals law is compiled into that path.
Interactions make_surface_terms(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern,
                                const std::shared_ptr<const GapLaw>& law,
                                const std::shared_ptr<const Obstacle>& obstacle, const SurfaceOptions& options);

/// Makes the terms of one kind of obstacle; they compile apart.
Interactions make_flat_terms(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern,
                             const std::shared_ptr<const GapLaw>& law, const HalfSpace& wall,
                             const SurfaceOptions& options);
Interactions make_curved_terms(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern,
                               const std::shared_ptr<const GapLaw>& law,
                               const std::shared_ptr<const Obstacle>& obstacle, const SurfaceOptions& options);

/// Calls make(TypeTag<SideElement>, sides) for each element type and choice of tied edges among the sides: a set may
/// hold enriched sides beside plain ones. A rank without sides calls it once too, because the functions that a model
/// calls if it has a term are collective.
template <class Make>
void for_each_kind_of_side(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Make& make) {
  std::map<std::tuple<std::size_t, bool, unsigned>, std::vector<LocalSide>> groups;
  for (const LocalSide& side : sides) {
    const LocalBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
    groups[{side.nodes.size(), is_hermite(block.type), side_ties(block, side.side)}].push_back(side);
  }
  if (groups.empty() && mesh.dimension == 2) make(TypeTag<Line2>{}, sides);
  if (groups.empty() && mesh.dimension == 3) make(TypeTag<Multilinear<2>>{}, sides);
  for (const auto& entry : groups) {
    const std::vector<LocalSide>& group = entry.second;
    const CellType type = mesh.blocks[static_cast<std::size_t>(group.front().block)].type;
    with_side_element(type, group.front().side, [&](auto side) { make(side, group); });
  }
}

}  // namespace ixos
