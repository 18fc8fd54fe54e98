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

/// A side of the cells of a block.
struct SideKind {
  int block;
  int side;
};

struct SurfaceOptions {
  int points = 0;          ///< Gauss points a direction on each side; 0: 5, but 8 on sides of order 3 or more
  double margin = 0.8;     ///< kappa: a Newton step keeps r_new >= kappa min(r, equilibrium gap)
  SurfaceFactor factor{};  ///< of the law's energy
  /// Those in the set on all ranks, so that each rank makes the same terms, also for kinds that it has no sides of.
  std::vector<SideKind> kinds{};
};

using Interactions = std::vector<std::unique_ptr<Interaction>>;

/// Returns the terms for the sides of one side set before `obstacle`, one for each element type and choice of tied
/// edges among them and the kinds of the options, and at least one. Before a half-space gaps are linear in the
/// displacement, which saves most of the work; the van der Waals law is compiled into that path.
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

/// Calls make(TypeTag<SideElement>, sides) for each element type and choice of tied edges among the sides and `kinds`:
/// a set may hold enriched sides beside plain ones. A rank without sides calls it once too, because the functions that
/// a model calls if it has a term are collective.
template <class Make>
void for_each_kind_of_side(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Make& make,
                           const std::vector<SideKind>& kinds = {}) {
  struct Group {
    CellType type;
    int side;
    std::vector<LocalSide> sides;
  };
  std::map<std::tuple<std::size_t, bool, unsigned>, Group> groups;
  const auto group_of = [&](int block_number, int side) -> Group& {
    const LocalBlock& block = mesh.blocks[static_cast<std::size_t>(block_number)];
    const std::size_t nodes = side_nodes(block.type, side).size();
    const Group empty{block.type, side, {}};
    return groups.insert({{nodes, is_hermite(block.type), side_ties(block, side)}, empty}).first->second;
  };
  for (const SideKind& kind : kinds) group_of(kind.block, kind.side);
  for (const LocalSide& side : sides) group_of(side.block, side.side).sides.push_back(side);
  if (groups.empty() && mesh.dimension == 2) make(TypeTag<Line2>{}, sides);
  if (groups.empty() && mesh.dimension == 3) make(TypeTag<Multilinear<2>>{}, sides);
  for (const auto& entry : groups) {
    const Group& group = entry.second;
    with_side_element(group.type, group.side, [&](auto side) { make(side, group.sides); });
  }
}

/// Makes the terms of one law and one kind of obstacle.
template <template <class SideElement, class Law> class SurfaceTerm, class Law, class Wall>
Interactions make_terms(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern,
                        const Law& law, const Wall& wall, const SurfaceOptions& options) {
  Interactions terms;
  const auto make = [&](auto side, const std::vector<LocalSide>& group) {
    using SideElement = typename decltype(side)::type;
    terms.push_back(std::make_unique<SurfaceTerm<SideElement, Law>>(mesh, group, pattern, law, wall, options));
  };
  for_each_kind_of_side(mesh, sides, make, options.kinds);
  return terms;
}

}  // namespace ixos
