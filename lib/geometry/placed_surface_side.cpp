// On which side of a kink of a surface a place is.
#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>

#include "geometry/placed_surface.hpp"

namespace ixos {
namespace {

/// Returns the parameters of a point of a side; `along`: the other parameter, in space.
template <std::size_t D>
PatchParameters<D> on_side(std::size_t side, double along) {
  PatchParameters<D> xi{};
  xi[side / 2] = side % 2 == 0 ? 0 : 1;
  if constexpr (D == 3) xi[1 - side / 2] = along;
  return xi;
}

/// Returns the angle of a patch at a corner, or pi inside a side.
template <std::size_t D>
double angle_at(const PlacedPatch<D>& patch, const PatchParameters<D>& xi) {
  if constexpr (D == 2) {
    return 1;
  } else {
    for (const double t : xi)
      if (t != 0 && t != 1) return M_PI;
    const auto frame = patch.frame(xi);
    const Vec<D> a = (xi[0] == 0 ? 1.0 : -1.0) * frame.tangents[0], b = (xi[1] == 0 ? 1.0 : -1.0) * frame.tangents[1];
    return std::acos(std::clamp(inner(a, b) / (length(a) * length(b)), -1.0, 1.0));
  }
}

}  // namespace

/// Goes from the closest point's patch to the patches that meet it at the closest point, across the sides on which the
/// closest point is.
template <std::size_t D>
bool PlacedSurface<D>::is_outside(const Vec<D>& from_projection, const SurfaceProjection<D>& projection) const {
  const Vec<D>& place = projection.frame.place;
  struct Here {
    int patch;
    PatchParameters<D> xi;
  };
  boost::container::small_vector<Here, 8> all{{projection.patch, projection.xi}};
  Vec<D> normals{};
  for (std::size_t next = 0; next < all.size(); ++next) {
    const Here here = all[next];
    const PlacedPatch<D>& own = patch(here.patch);
    normals = normals + angle_at(own, here.xi) * own.normal(here.xi);
    for (std::size_t side = 0; side < SurfacePatch<D>::sides; ++side) {
      if (here.xi[side / 2] != (side % 2 == 0 ? 0 : 1)) continue;
      const int other = patches_[at(here.patch)].neighbours[side];
      if (other < 0) return true;
      if (std::any_of(all.begin(), all.end(), [&](const Here& known) { return known.patch == other; })) continue;
      // Finds the point on the other patch: on the side that faces this one, in either direction.
      Here there{other, {}};
      double least = std::numeric_limits<double>::infinity();
      const double along = D == 3 ? here.xi[(1 - side / 2) % (D - 1)] : 0;
      for (std::size_t s = 0; s < SurfacePatch<D>::sides; ++s)
        for (const double t : {along, 1 - along}) {
          if (patches_[at(other)].neighbours[s] != here.patch) continue;
          const PatchParameters<D> xi = on_side<D>(s, t);
          const double off = length(patch(other).at(xi) - place);
          if (!(off < least)) continue;
          least = off;
          there.xi = xi;
        }
      all.push_back(there);
    }
  }
  return inner(from_projection, normals) >= 0;
}

template bool PlacedSurface<2>::is_outside(const Vec<2>&, const SurfaceProjection<2>&) const;
template bool PlacedSurface<3>::is_outside(const Vec<3>&, const SurfaceProjection<3>&) const;

}  // namespace ixos
