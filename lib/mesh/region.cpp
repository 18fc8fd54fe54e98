#include "mesh/region.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.hpp"
#include "mesh/bounds.hpp"
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

/// Calls visit(node, next node) for each edge of a cell at least once.
template <class Visit>
void for_each_edge(const Mesh& mesh, const Side& side, const Visit& visit) {
  const SideCorners corners = corners_of(mesh, side);
  const std::size_t count = count_of(corners);
  for (std::size_t k = 0; k + 1 < count; ++k) visit(corners[k], corners[k + 1]);
  if (count > 2) visit(corners[count - 1], corners[0]);
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

double place_tolerance(const Mesh& mesh) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  double shortest = std::numeric_limits<double>::infinity();
  int number = 0;
  for (const ElementBlock& block : mesh.blocks) {
    for (int cell = 0; cell < block.cells(); ++cell)
      for (int side = 0; side < sides_per_cell(block.type); ++side)
        for_each_edge(mesh, {number, cell, side}, [&](int a, int b) {
          const Point edge = difference(&mesh.coordinates[static_cast<std::size_t>(a) * d],
                                        &mesh.coordinates[static_cast<std::size_t>(b) * d], d);
          if (const double square = dot(edge, edge); square > 0) shortest = std::min(shortest, square);  // collapsed
        });
    ++number;
  }
  if (!std::isfinite(shortest)) return 0;
  const Bounds bounds = bounds_of(mesh);
  double extent = 0;
  for (std::size_t i = 0; i < d; ++i) extent = std::max(extent, bounds.extent(i));
  return std::max(1e-3 * std::sqrt(shortest), 1e-9 * extent);
}

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
  doubts_ = !(region.tolerance > 0);
  tolerance_ = doubts_ ? place_tolerance(mesh) : region.tolerance;
}

double Inside::excess(int node) const {
  const auto d = static_cast<std::size_t>(mesh_.dimension);
  const double* x = &mesh_.coordinates[static_cast<std::size_t>(node) * d];
  double largest = 0;
  for (std::size_t i = 0; i < d; ++i) {
    if (!region_.lower.empty()) largest = std::max(largest, region_.lower[i] - x[i]);
    if (!region_.upper.empty()) largest = std::max(largest, x[i] - region_.upper[i]);
  }
  if (!region_.plane_normal.empty())
    largest = std::max(largest, std::abs(dot(region_.plane_normal, difference(x, region_.plane_point.data(), d))));
  if (!(region_.sphere_radius > 0)) return largest;
  const Point from_center = difference(x, region_.sphere_center.data(), d);
  return std::max(largest, std::sqrt(dot(from_center, from_center)) - region_.sphere_radius);
}

double Inside::excess(const Side& side) const {
  double largest = 0;
  for (const int corner : corners_of(mesh_, side))
    if (corner >= 0) largest = std::max(largest, excess(corner));
  if (region_.normal.empty()) return largest;
  const Point outward = outward_normal(mesh_, side);
  const bool fits = dot(region_.normal, outward) >= (cosine_ - 1e-12) * std::sqrt(dot(outward, outward));
  return fits ? largest : std::numeric_limits<double>::infinity();
}

std::string span_in_words(const Mesh& mesh) {
  const Bounds bounds = bounds_of(mesh);
  const auto text = [&](const Vec<3>& x) {
    return fmt::format("({})", fmt::join(x.begin(), x.begin() + mesh.dimension, ", "));
  };
  return fmt::format("{} to {}", text(bounds.lower), text(bounds.upper));
}

}  // namespace ixos
