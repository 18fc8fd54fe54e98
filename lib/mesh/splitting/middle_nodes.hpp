/// Nodes half way between others.
#pragma once
#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace ixos {

/// Finds the node in the middle of two others, however the middle is reached: that of a face is in the middle of either
/// pair of its edges' middles.
class MiddleNodes {
 public:
  using Pair = std::array<int, 2>;

  /// `nodes`: the number of nodes that are no middles.
  explicit MiddleNodes(int nodes) : origins_(static_cast<std::size_t>(nodes)) {}

  /// Returns the node between a and b; -1 if there is none.
  int find(int a, int b);
  /// Returns the node that was named as the one between a and b; -1 if none was. It suffices where no face is halved
  /// both ways: for simplices.
  int named(int a, int b) const;
  /// Returns the pairs of nodes that cross a and b on a face: if these are the middles of two of its edges, those of
  /// the other two.
  std::vector<Pair> crossing(int a, int b) const;
  /// Names a node, of those that there are, as the one between a and b.
  void set(int a, int b, int node);
  /// Names the next node, whose number it returns, as the one between a and b.
  int add(int a, int b);
  /// Returns two nodes of which this one is the middle, those that were named first; -1 twice for others.
  Pair origin(int node) const;

 private:
  static std::uint64_t key(int a, int b);

  std::unordered_map<std::uint64_t, int> nodes_;
  /// By node: the pairs of which it is the middle, one along an edge, two across a face, three in a cell.
  std::vector<boost::container::static_vector<Pair, 3>> origins_;
};

}  // namespace ixos
