/// The derivatives of forces that concern unknowns which are no node's.
#pragma once
#include <cstddef>
#include <vector>

namespace ixos {

/// The border of a tangent: with nodal unknowns x and globals g, of which `free` are unknowns,
///   | K       columns |
///   | rows^T  block   |.
/// Arrays are local, of length `local`, one for each free global. The columns are complete in owned rows; rows and the
/// block are shares of ranks. Globals are counted from the first one.
class Border {
 public:
  Border() = default;
  Border(std::size_t local, const std::vector<int>& free, int numbers)
      : first_(local - static_cast<std::size_t>(numbers)),
        place_(static_cast<std::size_t>(numbers), none),
        columns_(free.size(), std::vector<double>(local)),
        rows_(free.size(), std::vector<double>(local)),
        block_(free.size() * free.size()) {
    for (std::size_t k = 0; k < free.size(); ++k) place_[static_cast<std::size_t>(free[k])] = k;
  }

  std::size_t size() const { return columns_.size(); }
  /// Returns the place of the first global in local arrays.
  std::size_t first_global() const { return first_; }
  /// Returns whether the global is an unknown.
  bool has(std::size_t global) const { return place_[global] != none; }
  std::vector<double>& column(std::size_t global) { return columns_[place_[global]]; }
  std::vector<double>& row(std::size_t global) { return rows_[place_[global]]; }
  double& entry(std::size_t of, std::size_t by) { return block_[place_[of] * size() + place_[by]]; }

  /// By free global.
  std::vector<std::vector<double>>& columns() { return columns_; }
  std::vector<std::vector<double>>& rows() { return rows_; }
  std::vector<double>& block() { return block_; }  ///< row by row
  void clear() {
    for (auto* const arrays : {&columns_, &rows_})
      for (std::vector<double>& array : *arrays) array.assign(array.size(), 0.0);
    block_.assign(block_.size(), 0.0);
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t first_ = 0;
  std::vector<std::size_t> place_;
  std::vector<std::vector<double>> columns_, rows_;
  std::vector<double> block_;
};

}  // namespace ixos
