/// The tied nodes of a rank.
#pragma once
#include <cstddef>
#include <vector>

namespace ixos {

/// The last local nodes, from first() on, follow others: u(first() + k) = sum of weight u(master) over the shares of k.
/// All masters are local and not tied. With C the matrix of these weights, below the identity of the other nodes,
/// values are interpolated, u = C u_free, and forces condensed, f_free = C^T f: solvers see independent nodes only.
class NodeTies {
 public:
  struct Share {
    int master;
    double weight;
  };

  NodeTies() = default;
  /// `first`: the number of local nodes that are not tied.
  explicit NodeTies(int first) : first_(first) {}
  /// Adds the next tied node.
  void add(const std::vector<Share>& shares);

  bool empty() const { return start_.size() == 1; }
  int size() const { return static_cast<int>(start_.size()) - 1; }
  int first() const { return first_; }
  bool is_tied(int node) const { return node >= first_ && !empty(); }
  /// Return the range of a tied node's shares.
  const Share* begin(int node) const { return shares_.data() + start_[place(node)]; }
  const Share* end(int node) const { return shares_.data() + start_[place(node) + 1]; }
  /// Calls visit(master, weight) for the shares of a node; one that is not tied is its own master, with the weight 1.
  template <class Visit>
  void for_each_share(int node, const Visit& visit) const {
    if (!is_tied(node)) return visit(node, 1.0);
    for (const Share* share = begin(node); share != end(node); ++share) visit(share->master, share->weight);
  }

  /// Sets the values of tied nodes in an array of `count` values for each local node.
  void interpolate(double* values, std::size_t count) const;
  /// Adds forces on tied nodes to those on their masters, and sets them to zero, in such an array.
  void condense(double* forces, std::size_t count) const;
  /// Adds with the magnitudes of the weights, for sums of magnitudes.
  void condense_magnitudes(double* sums, std::size_t count) const;
  /// Adds with the squares of the weights: entries of a diagonal, without what couples a node with its masters.
  void condense_diagonal(double* diagonal, std::size_t count) const;
  /// Returns the largest sum of weights' magnitudes of a node, at least 1.
  double largest_magnitude() const;

 private:
  std::size_t place(int node) const { return static_cast<std::size_t>(node - first_); }
  template <class Factor>
  void condense_with(double* values, std::size_t count, const Factor& factor) const;

  int first_ = 0;
  std::vector<std::size_t> start_{0};
  std::vector<Share> shares_;
};

}  // namespace ixos
