#include "mesh/fitted_normal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/eigenpairs.hpp"
#include "base/error.hpp"
#include "mesh/node_place.hpp"

namespace ixos {

Vec<3> fitted_normal(int dimension, const std::vector<Vec<3>>& places, const std::function<void(double*, int)>& sum) {
  constexpr double flat = 1e-6;
  Vec<4> total{0, 0, 0, static_cast<double>(places.size())};
  for (const Vec<3>& x : places)
    for (std::size_t i = 0; i < 3; ++i) total[i] += x[i];
  if (sum) sum(total.data(), 4);
  const Vec<3> middle = 1 / std::max(total[3], 1.0) * Vec<3>{total[0], total[1], total[2]};
  Small<double, 3> moments{};
  for (const Vec<3>& x : places)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) moments[i][j] += (x[i] - middle[i]) * (x[j] - middle[j]);
  if (sum) sum(moments[0].data(), 9);
  const Eigenpairs<double, 3> found = eigenpairs(moments);
  // In the plane the direction z has the moment 0, and comes first.
  std::array<std::size_t, 3> order{0, 1, 2};
  const auto is_out_of_plane = [&](std::size_t k) { return dimension == 2 && std::abs(found.vector[k][2]) > 0.5; };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (is_out_of_plane(a) != is_out_of_plane(b)) return is_out_of_plane(a);
    return found.value[a] < found.value[b];
  });
  const std::size_t least = dimension == 2 ? 1 : 0;
  const auto extent = [&](std::size_t k) { return std::sqrt(std::max(found.value[order[k]], 0.0)); };
  if (!(extent(least + 1) > flat * extent(2)) || extent(2) == 0)
    throw InputError(dimension == 2 ? "its nodes are at one point, which has no line"
                                    : "its nodes are on one line, which has no plane");
  if (extent(least) > flat * extent(2))
    throw InputError(fmt::format("its nodes are not in one plane: they leave it by {:.2g} of their extent",
                                 extent(least) / extent(2)));
  Vec<3> normal = found.vector[order[least]];
  for (double& component : normal)
    if (std::abs(component) < flat) component = 0;
  return 1 / length(normal) * normal;
}

Vec<3> fitted_normal(const Mesh& mesh, const NodeSet& set) {
  std::vector<Vec<3>> places;
  places.reserve(set.nodes.size());
  for (const int node : set.nodes)
    if (!mesh.is_derivative(node)) places.push_back(node_place(mesh, node));
  return fitted_normal(mesh.dimension, places);
}

}  // namespace ixos
