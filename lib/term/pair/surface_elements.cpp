#include "term/pair/surface_elements.hpp"

#include "base/vector3.hpp"
#include "geometry/patch_points.hpp"

namespace ixos {
namespace {

constexpr auto width = static_cast<std::size_t>(pack_width);

}  // namespace

std::array<double, 9> cross_matrix(const Vec<3>& a) { return {0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0}; }

template <std::size_t D>
SurfaceElements<D>::SurfaceElements(const SurfacePatches<D>& surface, int points) : surface_(surface) {
  const std::vector<PatchPoint<D>> on_a_patch = patch_points<D>(points);
  per_patch_ = on_a_patch.size();
  for (std::size_t s = 0; s < surface.patches.size(); ++s)
    for (const PatchPoint<D>& point : on_a_patch) {
      const typename SurfacePatch<D>::Shape shape = surface.patches[s].shape(point.xi);
      points_.push_back({s, shape.value, shape.slopes});
      for (double& slope : points_.back().slopes[0]) slope *= point.weight;
    }
}

template <std::size_t D>
std::size_t SurfaceElements<D>::packs() const {
  return (points_.size() + width - 1) / width;
}

template <std::size_t D>
typename SurfaceElements<D>::Placed SurfaceElements<D>::at(const std::vector<Vec<D>>& nodes) const {
  Placed result;
  for (const Point& point : points_) {
    const SurfacePatch<D>& patch = surface_.patches[point.patch];
    Vec<D> place{};
    std::array<Vec<D>, D - 1> tangents{};
    for (std::size_t b = 0; b < patch.count; ++b) {
      const Vec<D>& x = nodes[static_cast<std::size_t>(patch.nodes[b])];
      place = place + point.value[b] * x;
      for (std::size_t k = 0; k + 1 < D; ++k) tangents[k] = tangents[k] + point.slopes[k][b] * x;
    }
    result.place.push_back(place);
    if constexpr (D == 2)
      result.area.push_back(tangents[0]);
    else
      result.area.push_back(cross(tangents[0], tangents[1]));
    result.tangents.push_back(tangents);
  }
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t k = 0; k < packs(); ++k) {
      const auto lane_of = [&](const std::vector<Vec<D>>& all, double beyond) {
        return Pack([&](auto lane) {
          const std::size_t q = k * width + lane;
          return q < all.size() ? all[q][i] : beyond;
        });
      };
      result.places[i].push_back(lane_of(result.place, 1e9));  // nothing acts so far away
      result.areas[i].push_back(lane_of(result.area, 0));
    }
  return result;
}

template <std::size_t D>
std::vector<typename SurfaceElements<D>::Matrix> SurfaceElements<D>::area_slopes(const Placed& placed,
                                                                                 std::size_t point) const {
  const Point& own = points_[point];
  const std::size_t count = surface_.patches[own.patch].count;
  std::vector<Matrix> result(count);
  for (std::size_t b = 0; b < count; ++b)
    if constexpr (D == 2) {
      result[b] = {own.slopes[0][b], 0, 0, own.slopes[0][b]};
    } else {
      const Vec<3> along = own.slopes[1][b] * placed.tangents[point][0] - own.slopes[0][b] * placed.tangents[point][1];
      result[b] = cross_matrix(along);
    }
  return result;
}

template <std::size_t D>
std::vector<Vec<D>> SurfaceElements<D>::at_nodes(const Placed& placed, const std::vector<Vec<D>>& by_place,
                                                 const std::vector<Vec<D>>& by_area) const {
  std::vector<Vec<D>> result(surface_.nodes.size(), Vec<D>{});
  for (std::size_t q = 0; q < points_.size(); ++q) {
    const SurfacePatch<D>& patch = surface_.patches[points_[q].patch];
    const std::vector<Matrix> slopes = area_slopes(placed, q);
    for (std::size_t b = 0; b < patch.count; ++b) {
      Vec<D>& sum = result[static_cast<std::size_t>(patch.nodes[b])];
      for (std::size_t j = 0; j < D; ++j) {
        sum[j] += points_[q].value[b] * by_place[q][j];
        for (std::size_t i = 0; i < D; ++i) sum[j] += by_area[q][i] * slopes[b][D * i + j];
      }
    }
  }
  return result;
}

template class SurfaceElements<2>;
template class SurfaceElements<3>;

}  // namespace ixos
