#include "mesh/splitting/refined_region.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>

#include "base/error.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/selection.hpp"
#include "mesh/tree_point.hpp"

namespace ixos {
namespace {

namespace bg = boost::geometry;
using Box = bg::model::box<TreePoint>;

Box tree_box(const CornerBox& box) { return {tree_point(box.lower), tree_point(box.upper)}; }

void check_length(const char* name, const std::vector<double>& list, int dimension) {
  if (!list.empty() && list.size() != static_cast<std::size_t>(dimension))
    throw InputError(
        fmt::format("{} has {} coordinates, but the mesh has {} dimensions", name, list.size(), dimension));
}

}  // namespace

struct RegionSearch::Sides {
  bg::index::rtree<Box, bg::index::rstar<16>> boxes;
};

CornerBox box_around(const Mesh& mesh, const std::vector<int>& nodes) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  CornerBox box;
  for (std::size_t i = 0; i < d; ++i) {
    const auto [least, most] = std::minmax_element(nodes.begin(), nodes.end(), [&](int a, int b) {
      return mesh.coordinates[static_cast<std::size_t>(a) * d + i] <
             mesh.coordinates[static_cast<std::size_t>(b) * d + i];
    });
    box.lower[i] = mesh.coordinates[static_cast<std::size_t>(*least) * d + i];
    box.upper[i] = mesh.coordinates[static_cast<std::size_t>(*most) * d + i];
  }
  return box;
}

RegionSearch::RegionSearch(const Mesh& mesh, const RefinedRegion& region) : region_(region) {
  check_length("Lower", region.lower, mesh.dimension);
  check_length("Upper", region.upper, mesh.dimension);
  check_length("Sphere Center", region.sphere_center, mesh.dimension);
  if (region.lower.empty() && region.upper.empty() && region.sphere_radius == 0 && region.side_set.empty())
    throw InputError("nothing tells where the mesh is refined; give Lower, Upper, Sphere Radius or Side Set");
  for (std::size_t i = 0; i < std::min(region.lower.size(), region.upper.size()); ++i)
    if (region.lower[i] > region.upper[i])
      throw InputError(
          fmt::format("Lower {:.6g} is above Upper {:.6g} along {}", region.lower[i], region.upper[i], "xyz"[i]));
  if (region.sphere_radius == 0 && !region.sphere_center.empty())
    throw InputError("Sphere Center needs a Sphere Radius greater than 0");
  if (region.side_set.empty() && region.distance > 0) throw InputError("Distance needs a Side Set");
  for (const char axis : region.directions)
    if (axis != 'x' && axis != 'y' && (axis != 'z' || mesh.dimension == 2))
      throw InputError(fmt::format("Directions: \"{}\" is no axis of a mesh of {} dimensions; \"x\", \"y\"{} are", axis,
                                   mesh.dimension, mesh.dimension == 3 ? ", \"z\"" : ""));
  if (region_.sphere_center.empty()) region_.sphere_center.assign(3, 0.0);
  if (region.side_set.empty()) return;
  std::vector<Box> boxes;
  for (const Side& side : side_set_named(mesh, region.side_set).sides)
    boxes.push_back(tree_box(box_around(mesh, nodes_of_side(mesh, side))));
  sides_ = std::make_unique<const Sides>(Sides{decltype(Sides::boxes)(boxes)});
}

RegionSearch::~RegionSearch() = default;
RegionSearch::RegionSearch(RegionSearch&&) noexcept = default;

bool RegionSearch::meets(const CornerBox& box) const {
  for (std::size_t i = 0; i < region_.lower.size(); ++i)
    if (box.upper[i] < region_.lower[i]) return false;
  for (std::size_t i = 0; i < region_.upper.size(); ++i)
    if (box.lower[i] > region_.upper[i]) return false;
  if (region_.sphere_radius > 0) {
    double squares = 0;
    for (std::size_t i = 0; i < region_.sphere_center.size(); ++i) {
      const double nearest = std::clamp(region_.sphere_center[i], box.lower[i], box.upper[i]);
      squares += (nearest - region_.sphere_center[i]) * (nearest - region_.sphere_center[i]);
    }
    if (squares > region_.sphere_radius * region_.sphere_radius) return false;
  }
  if (!sides_) return true;
  const Box own = tree_box(box);
  const auto nearest = sides_->boxes.qbegin(bg::index::nearest(own, 1));
  return nearest != sides_->boxes.qend() && bg::distance(own, *nearest) <= region_.distance;
}

bool RegionSearch::splits_along(const std::array<double, 3>& direction) const {
  return is_along(direction, region_.directions);
}

bool is_along(const std::array<double, 3>& direction, const std::string& axes) {
  if (axes.empty()) return true;
  const auto largest = std::max_element(direction.begin(), direction.end(),
                                        [](double a, double b) { return std::abs(a) < std::abs(b); });
  return axes.find("xyz"[largest - direction.begin()]) != std::string::npos;
}

}  // namespace ixos
