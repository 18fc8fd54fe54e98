/// Interaction of a surface with a rigid obstacle.
#pragma once
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "discretization/pattern.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/obstacle.hpp"
#include "mesh/local_mesh.hpp"
#include "term/interaction.hpp"
#include "term/wall/wall_sides.hpp"

namespace ixos {

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
/// displacement, which saves most of the work.
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

/// Makes the terms of one kind of obstacle, Term<2> or Term<3>. make_sides(group, dimension): the sides of a group,
/// with the dimension as a std::integral_constant. `arguments`: the last ones of Term's constructor.
template <template <std::size_t D> class Term, class MakeSides, class... Arguments>
Interactions make_terms(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const SurfaceOptions& options,
                        const MakeSides& make_sides, const Arguments&... arguments) {
  Interactions terms;
  const auto add = [&](const SideGroup& group, auto dimension) {
    auto own = make_sides(group, dimension);
    own->scale(options.factor);
    terms.push_back(std::make_unique<Term<dimension.value>>(mesh, group.sides, std::move(own), arguments...));
  };
  for (const SideGroup& group : grouped(mesh, sides, options.kinds)) {
    if (mesh.dimension == 2)
      add(group, std::integral_constant<std::size_t, 2>());
    else
      add(group, std::integral_constant<std::size_t, 3>());
  }
  return terms;
}

}  // namespace ixos
