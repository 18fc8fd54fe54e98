/// The nodes in the middle of edges, faces and cells.
#pragma once
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "mesh/added_nodes.hpp"
#include "mesh/mesh.hpp"

namespace ixos {

/// Calls visit(node, place) for the nodes of cells with bubbles beyond those of `drawn` cells, as often as cells have
/// them; `place`: where the map of the drawn cell has them [L0]; `size`: the largest difference of a coordinate from
/// that of the cell's first node [L0].
void for_each_bubble(const Mesh& mesh,
                     const std::function<void(int node, const std::vector<double>& place, double size)>& visit);

/// The middle nodes of a mesh's edges, faces and cells, by their corners. Cells share those that they share.
class Middles {
 public:
  /// Finds those of the quadratic cells.
  explicit Middles(Mesh& mesh);

  /// Appends a cell's nodes to `all`: `nodes`, of which it has `count`, the first ones of the type `completed`; then
  /// those that are missing, which are added to the mesh unless another cell has them. A new node stands where the map
  /// of the cell puts it: in the mean of the corners if these are all that it has; else where its quadratic form does,
  /// or that without nodes inside faces and cell (8, 20, 15 and 13 nodes).
  void complete(const int* nodes, int count, CellType completed, std::vector<int>& all);

  /// Returns the nodes that were added on edges and faces.
  const std::vector<Between>& added() const { return added_; }
  /// A node that was added: what it is the sum of, times these weights.
  struct Sum {
    int node;
    std::vector<std::pair<int, double>> weights;
  };
  const std::vector<Sum>& sums() const { return sums_; }

 private:
  Mesh& mesh_;
  std::map<std::vector<int>, int> nodes_;  ///< by ascending corners
  std::vector<Between> added_;
  std::vector<Sum> sums_;
};

}  // namespace ixos
