#include "mesh/level_width.hpp"

#include <vector>

namespace ixos {
namespace {

/// The cells of each node.
struct NodeCells {
  std::vector<std::size_t> start;
  std::vector<std::pair<int, int>> cells;  ///< block and cell
};

NodeCells cells_of_nodes(const Mesh& mesh) {
  NodeCells result;
  result.start.assign(static_cast<std::size_t>(mesh.nodes()) + 2, 0);
  for (const ElementBlock& block : mesh.blocks)
    for (int node : block.nodes) ++result.start[static_cast<std::size_t>(node) + 2];
  for (std::size_t i = 2; i < result.start.size(); ++i) result.start[i] += result.start[i - 1];
  result.cells.resize(result.start.back());
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const ElementBlock& block = mesh.blocks[b];
    const int n = nodes_per_cell(block.type);
    for (int cell = 0; cell < block.cells(); ++cell)
      for (int a = 0; a < n; ++a)
        result.cells[result.start[static_cast<std::size_t>(block.nodes[cell_entry(cell, n, a)]) + 1]++] = {
            static_cast<int>(b), cell};
  }
  return result;
}

struct Levels {
  int count = 0;  ///< over all parts that do not touch
  int last = 0;   ///< a node of the last level of the first part
};

Levels breadth_first(const Mesh& mesh, const NodeCells& by_node, int first) {
  std::vector<char> seen(static_cast<std::size_t>(mesh.nodes()), 0);
  std::vector<int> front, next;
  Levels levels;
  int candidate = first;
  for (int part = 0; candidate < mesh.nodes(); ++part) {
    front = {candidate};
    seen[static_cast<std::size_t>(candidate)] = 1;
    while (!front.empty()) {
      ++levels.count;
      if (part == 0) levels.last = front.front();
      next.clear();
      for (int node : front)
        for (std::size_t k = by_node.start[static_cast<std::size_t>(node)];
             k < by_node.start[static_cast<std::size_t>(node) + 1]; ++k) {
          const ElementBlock& block = mesh.blocks[static_cast<std::size_t>(by_node.cells[k].first)];
          const int n = nodes_per_cell(block.type);
          const int* nodes = &block.nodes[cell_entry(by_node.cells[k].second, n)];
          for (int a = 0; a < n; ++a)
            if (char& mark = seen[static_cast<std::size_t>(nodes[a])]; mark == 0) {
              mark = 1;
              next.push_back(nodes[a]);
            }
        }
      front.swap(next);
    }
    if (part == 0) candidate = 0;
    while (candidate < mesh.nodes() && seen[static_cast<std::size_t>(candidate)] != 0) ++candidate;
  }
  return levels;
}

}  // namespace

double mean_level_width(const Mesh& mesh) {
  if (mesh.nodes() == 0) return 0;
  const NodeCells by_node = cells_of_nodes(mesh);
  const Levels from_anywhere = breadth_first(mesh, by_node, 0);
  const Levels from_far = breadth_first(mesh, by_node, from_anywhere.last);
  return static_cast<double>(mesh.nodes()) / from_far.count;
}

}  // namespace ixos
