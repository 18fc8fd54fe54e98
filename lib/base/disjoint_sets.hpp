/// Disjoint sets of numbers.
#pragma once
#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace ixos {

/// The numbers 0 to count - 1 in sets that can be joined. Each set is named after its least number.
class DisjointSets {
 public:
  /// Begins with a set for each number.
  explicit DisjointSets(int count) : parent_(static_cast<std::size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  /// Returns the name of the set that has the number.
  int of(int number) {
    while (up(number) != number) number = up(number) = up(up(number));
    return number;
  }
  /// Joins the sets of two numbers.
  void join(int a, int b) { up(std::max(of(a), of(b))) = std::min(of(a), of(b)); }

 private:
  int& up(int number) { return parent_[static_cast<std::size_t>(number)]; }
  std::vector<int> parent_;
};

}  // namespace ixos
