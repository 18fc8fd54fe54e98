#include "discretization/material_point.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/small_matrix.hpp"
#include "fem/jacobian.hpp"
#include "fem/shape_table.hpp"
#include "fem/with_element.hpp"

namespace ixos {
namespace {

/// Finds x in the cell by Newton's method on the geometry map. Returns false if x is outside.
template <class Element>
bool find_in_cell(const LocalMesh& mesh, const LocalBlock& block, int cell, const std::vector<double>& x,
                  MaterialPoint& point) {
  constexpr std::size_t D = Element::dimension;
  constexpr std::size_t N = Element::nodes;
  const int* nodes = &block.nodes[cell_entry(cell, N)];
  const std::size_t places = is_hermite(block.type) ? std::size_t{1} << D : N;  // the others are derivatives
  std::array<double, D> low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t a = 0; a < places; ++a)
    for (std::size_t i = 0; i < D; ++i) {
      const double value = mesh.coordinates[static_cast<std::size_t>(nodes[a]) * D + i];
      low[i] = std::min(low[i], value);
      high[i] = std::max(high[i], value);
    }
  for (std::size_t i = 0; i < D; ++i) {
    const double slack = 0.2 * (high[i] - low[i]);  // a side that is not straight may bulge
    if (x[i] < low[i] - slack || x[i] > high[i] + slack) return false;
  }

  const auto scale = cell_scales<Element>(block, cell);
  std::array<double, D> xi{};
  if constexpr (HasRule<Element>::value) {  // whose origin is a corner
    constexpr std::size_t corners = CellTraits<Element>::Corners::nodes;
    for (std::size_t a = 0; a < corners; ++a)
      for (std::size_t d = 0; d < D; ++d) xi[d] += Element::place(a)[d] / static_cast<double>(corners);
  }
  std::array<double, N> value;
  std::array<std::array<double, D>, N> gradient;
  for (int iteration = 0; iteration < 30; ++iteration) {
    evaluate_tied<Element>(block.tied, xi, value, gradient);
    const auto tangents = jacobian<D>(mesh.coordinates, nodes, scale, gradient);
    const auto back = inverse(tangents, determinant(tangents));
    std::array<double, D> place{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t i = 0; i < D; ++i)
        place[i] += scale[a] * mesh.coordinates[static_cast<std::size_t>(nodes[a]) * D + i] * value[a];
    double change = 0;
    for (std::size_t d = 0; d < D; ++d) {
      double step = 0;
      for (std::size_t i = 0; i < D; ++i) step += back[d][i] * (x[i] - place[i]);
      xi[d] += step;
      change = std::max(change, std::abs(step));
    }
    if (change < 1e-13) break;
  }
  if (!is_inside<CellTraits<Element>::shape>(xi, 1e-9)) return false;
  evaluate_tied<Element>(block.tied, xi, value, gradient);
  point.nodes.assign(nodes, nodes + N);
  for (std::size_t a = 0; a < N; ++a) point.weights.push_back(scale[a] * value[a]);
  return true;
}

/// Returns the body's bounding box, for a message. Collective.
std::string span(const LocalMesh& mesh, const DofSpace& space) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const double none = std::numeric_limits<double>::infinity();
  std::vector<double> low(d, none), high(d, -none);
  for (std::size_t k = 0; k < mesh.coordinates.size(); ++k) {
    if (mesh.is_derivative(k / d)) continue;
    low[k % d] = std::min(low[k % d], mesh.coordinates[k]);
    high[k % d] = std::max(high[k % d], mesh.coordinates[k]);
  }
  for (std::size_t i = 0; i < d; ++i) {
    low[i] = space.minimum(low[i]);
    high[i] = space.maximum(high[i]);
  }
  return fmt::format("({}) to ({})", fmt::join(low, ", "), fmt::join(high, ", "));
}

bool find(const LocalMesh& mesh, const std::vector<double>& x, MaterialPoint& point) {
  for (const LocalBlock& block : mesh.blocks) {
    const bool found = with_element(block.type, [&](auto element) {
      for (int cell = 0; cell < block.cells(); ++cell)
        if (block.owned[static_cast<std::size_t>(cell)] != 0 &&
            find_in_cell<typename decltype(element)::type>(mesh, block, cell, x, point))
          return true;
      return false;
    });
    if (found) return true;
  }
  return false;
}

}  // namespace

std::vector<double> MaterialPoint::value(const DofSpace& space, const std::vector<double>& local) const {
  const auto d = static_cast<std::size_t>(space.dimension());
  std::vector<double> sum(d, 0.0);
  for (std::size_t a = 0; a < nodes.size(); ++a)
    for (std::size_t i = 0; i < d; ++i) sum[i] += weights[a] * local[static_cast<std::size_t>(nodes[a]) * d + i];
  space.sum(sum.data(), static_cast<int>(d));
  return sum;
}

MaterialPoint locate(const LocalMesh& mesh, const DofSpace& space, const std::vector<double>& x) {
  MaterialPoint point;
  const double rank = space.comm()->getRank();
  const double none = std::numeric_limits<double>::infinity();
  const double owner = space.minimum(find(mesh, x, point) ? rank : none);
  if (owner == none)
    throw InputError(fmt::format("the point ({}) lies outside the body, whose reference configuration spans {}",
                                 fmt::join(x, ", "), span(mesh, space)));
  if (owner != rank) point = {};
  return point;
}

}  // namespace ixos
