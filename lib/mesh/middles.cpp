#include "mesh/middles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "fem/cell_info.hpp"
#include "fem/corner_element.hpp"
#include "fem/simplex_nodes.hpp"
#include "fem/with_element.hpp"

namespace ixos {
namespace {

std::vector<int> corners_of(const int* nodes, const NodeCorners& own) {
  std::vector<int> corners;
  for (const int corner : own) corners.push_back(nodes[corner]);
  return corners;
}

std::vector<int> sorted(std::vector<int> corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Returns the shape functions of a plain type at the place of a node that another of its shape has: by node.
std::vector<double> values_in(CellType own, const NodeCorners& place) {
  return with_element(own, [&](auto tag) -> std::vector<double> {
    using Element = typename decltype(tag)::type;
    if constexpr (HasPlace<Element>::value) {
      std::array<std::array<double, Element::dimension>, Element::nodes> corners{}, gradient;
      for (const int c : place) corners[static_cast<std::size_t>(c)] = Element::place(static_cast<std::size_t>(c));
      std::array<double, Element::nodes> value;
      Element::evaluate(middle_of(corners, place), value, gradient);
      return {value.begin(), value.end()};
    } else {
      throw std::logic_error("no other cell of this shape has more nodes");
    }
  });
}

/// Returns the weights of corners and edges at the middle of a face of four corners, or of the cell with eight, in the
/// quadratic form without nodes inside: by node of the type that has them all.
std::vector<double> values_without_middles(const std::vector<NodeCorners>& pattern, const NodeCorners& place) {
  std::vector<double> values(pattern.size(), 0.0);
  for (std::size_t a = 0; a < pattern.size(); ++a) {
    const bool inside = std::all_of(pattern[a].begin(), pattern[a].end(), [&](int corner) {
      return std::find(place.begin(), place.end(), corner) != place.end();
    });
    if (inside && pattern[a].size() == 1) values[a] = -0.25;
    if (inside && pattern[a].size() == 2) values[a] = place.size() == 4 ? 0.5 : 0.25;
  }
  return values;
}

/// Returns the weights of a cell's first `count` nodes at the place of one that it has not.
std::vector<double> weights_at(CellType completed, int count, const NodeCorners& place) {
  const CellType corners = corner_type(completed);
  if (count == nodes_per_cell(corners)) {
    std::vector<double> mean(static_cast<std::size_t>(count), 0.0);
    for (const int corner : place) mean[static_cast<std::size_t>(corner)] = 1 / static_cast<double>(place.size());
    return mean;
  }
  const CellInfo* const own = find_cell([&](const CellInfo& info) {
    return info.shape == cell_info(completed).shape && info.plain == info.type && info.nodes == count;
  });
  return own != nullptr ? values_in(own->type, place)
                        : values_without_middles(cell_info(completed).node_corners, place);
}

}  // namespace

void for_each_bubble(const Mesh& mesh,
                     const std::function<void(int node, const std::vector<double>& place, double size)>& visit) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  for (const ElementBlock& block : mesh.blocks) {
    const CellInfo& info = cell_info(block.type);
    if (!info.bubbles) continue;
    const int drawn = nodes_per_cell(info.drawn);
    for (int a = drawn; a < info.nodes; ++a) {
      const std::vector<double> weights = weights_at(block.type, drawn, info.node_corners[static_cast<std::size_t>(a)]);
      for (int cell = 0; cell < block.cells(); ++cell) {
        const int* nodes = &block.nodes[cell_entry(cell, info.nodes)];
        std::vector<double> place(d, 0.0);
        double size = 0;
        for (std::size_t b = 0; b < weights.size(); ++b)
          for (std::size_t i = 0; i < d; ++i) {
            const double x = mesh.coordinates[static_cast<std::size_t>(nodes[b]) * d + i];
            place[i] += weights[b] * x;
            size = std::max(size, std::abs(x - mesh.coordinates[static_cast<std::size_t>(nodes[0]) * d + i]));
          }
        visit(nodes[a], place, size);
      }
    }
  }
}

Middles::Middles(Mesh& mesh) : mesh_(mesh) {
  for (const ElementBlock& block : mesh.blocks) {
    const std::vector<NodeCorners>& pattern = cell_info(block.type).node_corners;
    const auto corners = static_cast<std::size_t>(nodes_per_cell(corner_type(block.type)));
    for (int cell = 0; is_quadratic(block.type) && cell < block.cells(); ++cell) {
      const int* nodes = &block.nodes[cell_entry(cell, nodes_per_cell(block.type))];
      for (std::size_t a = corners; a < pattern.size(); ++a)
        nodes_.insert({sorted(corners_of(nodes, pattern[a])), nodes[a]});
    }
  }
}

void Middles::complete(const int* nodes, int count, CellType completed, std::vector<int>& all) {
  const std::vector<NodeCorners>& pattern = cell_info(completed).node_corners;
  const std::vector<int> own(nodes, nodes + count);
  const auto corners = static_cast<std::size_t>(nodes_per_cell(corner_type(completed)));
  all.insert(all.end(), own.begin(), own.end());
  for (std::size_t a = corners; a < own.size(); ++a)
    nodes_.insert({sorted(corners_of(own.data(), pattern[a])), own[a]});
  for (std::size_t a = own.size(); a < pattern.size(); ++a) {
    const std::vector<int> between = corners_of(own.data(), pattern[a]);
    const auto [found, fresh] = nodes_.insert({sorted(between), mesh_.nodes()});
    all.push_back(found->second);
    if (!fresh) continue;
    Sum sum{found->second, {}};
    const std::vector<double> weights = weights_at(completed, count, pattern[a]);
    const auto d = static_cast<std::size_t>(mesh_.dimension);
    std::vector<double> x(d, 0.0);
    for (std::size_t b = 0; b < own.size(); ++b) {
      if (weights[b] == 0) continue;
      sum.weights.emplace_back(own[b], weights[b]);
      for (std::size_t i = 0; i < d; ++i)
        x[i] += weights[b] * mesh_.coordinates[static_cast<std::size_t>(own[b]) * d + i];
    }
    add_node(mesh_, x, -1);
    if (between.size() < corners) added_.push_back({between, {found->second}});
    sums_.push_back(std::move(sum));
  }
}

}  // namespace ixos
