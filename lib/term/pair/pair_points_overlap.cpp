// How deep points can be in the other body, and points below a free rim of its surface.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "term/pair/pair_points.hpp"

namespace ixos {

template <std::size_t D>
double overlap_depth(const LocalMesh& mesh, const SurfacePatches<D>& primary) {
  bool closed = true;
  for (const SurfacePatch<D>& patch : primary.patches)
    for (const int neighbour : patch.neighbours) closed = closed && neighbour >= 0;
  if (closed) return std::numeric_limits<double>::infinity();
  std::set<int> blocks, nodes;
  for (const std::array<int, 3>& side : primary.sides) blocks.insert(side[0]);
  for (const int b : blocks) {
    const std::vector<int>& own = mesh.blocks[static_cast<std::size_t>(b)].nodes;
    nodes.insert(own.begin(), own.end());
  }
  std::vector<Vec<D>> x;
  for (const int node : primary.nodes) x.push_back(reference_place<D>(mesh, node));
  const PlacedSurface<D> surface(primary.patches, x);
  double depth = 0;
  for (const int node : nodes) {
    if (mesh.is_derivative(static_cast<std::size_t>(node))) continue;
    const Vec<D> place = reference_place<D>(mesh, node);
    const SurfaceProjection<D> projection = surface.nearest(place);  // below a rim its gap is positive
    depth = std::max(depth, -inner(place - projection.frame.place, PlacedPatch<D>::normal(projection.frame)));
  }
  return depth;
}

template <std::size_t D>
void PairPoints<D>::count_below_rim(SurfaceProjection<D>& projection) const {
  if (overlap_.depth == 0 || visibility_ || projection.patch < 0 || !(projection.gap > 0)) return;
  const SurfacePatch<D>& patch = primary().patches[static_cast<std::size_t>(projection.patch)];
  bool rim = false;
  for (std::size_t side = 0; side < SurfacePatch<D>::sides; ++side)
    rim = rim || (patch.neighbours[side] < 0 && projection.fixed[side / 2] &&
                  projection.xi[side / 2] == (side % 2 == 0 ? 0 : 1));
  // A point farther outside is beside the body, not below its face.
  const double below = -inner(projection.normal, PlacedPatch<D>::normal(projection.frame));
  if (!rim || below < std::cos(15 * M_PI / 180)) return;
  projection.gap = -projection.gap;
  projection.normal = -1 * projection.normal;
}

template double overlap_depth(const LocalMesh&, const SurfacePatches<2>&);
template double overlap_depth(const LocalMesh&, const SurfacePatches<3>&);
template void PairPoints<2>::count_below_rim(SurfaceProjection<2>&) const;
template void PairPoints<3>::count_below_rim(SurfaceProjection<3>&) const;

}  // namespace ixos
