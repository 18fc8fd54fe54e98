/// Nodes that stay in planes.
#pragma once
#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

#include "base/vec.hpp"

namespace ixos {

/// n . u = 0 for the normals n of each node. With P = I - sum of n n^T, the matrix K becomes P K P + k (I - P) and the
/// force f becomes P f: a solution stays in the planes, and K stays symmetric. A component that is held at zero drops
/// out of the normals of its node.
class NodePlanes {
 public:
  /// Adds a plane through a node, whose normal has any length but zero. `dimension`: that of the space.
  void add(int node, std::size_t dimension, const Vec<3>& normal);
  /// Takes component i of a node out of its normals.
  void hold(int node, std::size_t i);

  bool empty() const { return nodes_.empty(); }
  std::size_t size() const { return nodes_.size(); }
  /// Returns the normals of a node, orthogonal and of length 1; none if it has no plane.
  const std::vector<Vec<3>>& normals(int node) const;

  /// Sets x = P x for the nodes below `end` in an array of all local nodes.
  void project(double* x, int end) const;
  /// Adds factor (I - P) from to `to` for the nodes below `end` in such arrays.
  void add_across(double factor, const double* from, double* to, int end) const;
  /// Calls visit(node) for the nodes, in the order in which they came.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (const Node& own : nodes_) visit(own.node);
  }

 private:
  struct Node {
    int node;
    std::vector<Vec<3>> normals;
  };
  std::size_t dimension_ = 0;
  std::vector<Node> nodes_;
  std::unordered_map<int, std::size_t> index_;
};

}  // namespace ixos
