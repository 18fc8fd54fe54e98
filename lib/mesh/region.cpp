#include "mesh/region.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "mesh/cell_sides.hpp"

namespace ixos {
namespace {

using Vector = std::vector<double>;
using Point = std::array<double, 3>;

/// Returns the product of vectors with as many components as the first one.
template <class A, class B>
double dot(const A& a, const B& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// Returns a - b, with zeros for missing components.
Point difference(const double* a, const double* b, std::size_t d) {
  Point result{};
  for (std::size_t i = 0; i < d; ++i) result[i] = a[i] - b[i];
  return result;
}

/// Scales a direction to length 1. Throws InputError if it is zero.
void normalize(Vector& direction, const char* name) {
  if (direction.empty()) return;
  const double largest = std::abs(*std::max_element(direction.begin(), direction.end(),
                                                    [](double a, double b) { return std::abs(a) < std::abs(b); }));
  if (!(largest > 0)) throw InputError(fmt::format("{} is zero; a direction is needed", name));
  for (double& x : direction) x /= largest;  // so that no square overflows
  const double length = std::sqrt(dot(direction, direction));
  for (double& x : direction) x /= length;
}

}  // namespace

Inside::Inside(const Mesh& mesh, const Region& region) : mesh_(mesh), region_(region) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const std::array<std::pair<const char*, const Vector*>, 6> lists{{{"Lower", &region.lower},
                                                                    {"Upper", &region.upper},
                                                                    {"Plane Normal", &region.plane_normal},
                                                                    {"Plane Point", &region.plane_point},
                                                                    {"Sphere Center", &region.sphere_center},
                                                                    {"Normal", &region.normal}}};
  for (const auto& [name, list] : lists)
    if (!list->empty() && list->size() != d)
      throw InputError(
          fmt::format("{} has {} coordinates, but the mesh has {} dimensions", name, list->size(), mesh.dimension));
  if (!region.plane_point.empty() && region.plane_normal.empty())
    throw InputError("Plane Point is given without Plane Normal");
  if (!region.sphere_center.empty() && !(region.sphere_radius > 0))
    throw InputError("Sphere Center is given without Sphere Radius");
  normalize(region_.plane_normal, "Plane Normal");
  normalize(region_.normal, "Normal");
  cosine_ = std::cos(region.normal_angle * std::acos(-1.0) / 180);
  if (region.plane_point.empty()) region_.plane_point.resize(d);
  if (region.sphere_center.empty()) region_.sphere_center.resize(d);
  if (mesh.coordinates.empty()) return;
  const auto [low, high] = std::minmax_element(mesh.coordinates.begin(), mesh.coordinates.end());
  slack_ = 1e-9 * (*high - *low);
}

bool Inside::node(int node) const {
  const auto d = static_cast<std::size_t>(mesh_.dimension);
  const double* x = &mesh_.coordinates[static_cast<std::size_t>(node) * d];
  for (std::size_t i = 0; i < d; ++i) {
    if (!region_.lower.empty() && x[i] < region_.lower[i] - slack_) return false;
    if (!region_.upper.empty() && x[i] > region_.upper[i] + slack_) return false;
  }
  if (!region_.plane_normal.empty() &&
      std::abs(dot(region_.plane_normal, difference(x, region_.plane_point.data(), d))) > slack_)
    return false;
  if (!(region_.sphere_radius > 0)) return true;
  const Point from_center = difference(x, region_.sphere_center.data(), d);
  return std::sqrt(dot(from_center, from_center)) <= region_.sphere_radius + slack_;
}

bool Inside::side(const Side& side) const {
  const auto d = static_cast<std::size_t>(mesh_.dimension);
  const SideCorners corners = corners_of(mesh_, side);
  if (!std::all_of(corners.begin(), corners.end(), [&](int corner) { return corner < 0 || node(corner); }))
    return false;
  if (region_.normal.empty()) return true;
  // From corner a of the side to corner b. Sides run counter-clockwise, seen from outside.
  const auto along = [&](std::size_t a, std::size_t b) {
    const auto place = [&](std::size_t k) { return &mesh_.coordinates[static_cast<std::size_t>(corners[k]) * d]; };
    return difference(place(b), place(a), d);
  };
  Point outward;
  if (d == 2) {
    const Point t = along(0, 1);
    outward = {t[1], -t[0], 0};
  } else {
    const Point s = along(0, 2), t = along(1, 3);
    outward = {s[1] * t[2] - s[2] * t[1], s[2] * t[0] - s[0] * t[2], s[0] * t[1] - s[1] * t[0]};
  }
  const double length = std::sqrt(dot(outward, outward));
  return dot(region_.normal, outward) >= (cosine_ - 1e-12) * length;
}

std::string Inside::span() const {
  const auto d = static_cast<std::size_t>(mesh_.dimension);
  Vector low(mesh_.coordinates.begin(), mesh_.coordinates.begin() + mesh_.dimension), high(low);
  for (std::size_t k = 0; k < mesh_.coordinates.size(); ++k) {
    low[k % d] = std::min(low[k % d], mesh_.coordinates[k]);
    high[k % d] = std::max(high[k % d], mesh_.coordinates[k]);
  }
  return fmt::format("({}) to ({})", fmt::join(low, ", "), fmt::join(high, ", "));
}

}  // namespace ixos
