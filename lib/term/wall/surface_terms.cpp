#include "term/wall/surface_terms.hpp"

namespace ixos {

Interactions make_surface_terms(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern,
                                const std::shared_ptr<const GapLaw>& law,
                                const std::shared_ptr<const Obstacle>& obstacle, const SurfaceOptions& options) {
  if (const HalfSpace* wall = obstacle->half_space()) return make_flat_terms(mesh, sides, pattern, law, *wall, options);
  return make_curved_terms(mesh, sides, pattern, law, obstacle, options);
}

}  // namespace ixos
