#include "mesh/splitting/cell_splits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/error.hpp"
#include "mesh/splitting/tree_cell.hpp"

namespace ixos {

CellSplits::Key CellSplits::key(const TreeCell& cell) {
  Key key{cell.block, cell.root};
  if (cell.shape == TreeShape::Simplex) {
    key[2] = cell.halvings[0];
    key[5] = static_cast<int>(cell.path & 0x7fffffffU);
    key[6] = static_cast<int>(cell.path >> 31U & 0x7fffffffU);
    return key;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    key[2 + k] = cell.halvings[k];
    key[5 + k] = static_cast<int>(std::lround(std::ldexp((cell.lower[k] + 1) / 2, cell.halvings[k])));
  }
  return key;
}

void CellSplits::add(const TreeCell& cell, int axis) { axis_[key(cell)] = axis; }

int CellSplits::axis(const TreeCell& cell) const {
  const auto found = axis_.find(key(cell));
  return found == axis_.end() ? -1 : found->second;
}

bool CellSplits::contain(const CellSplits& others) const {
  return std::includes(axis_.begin(), axis_.end(), others.axis_.begin(), others.axis_.end());
}

std::string CellSplits::text() const {
  std::string text;
  for (const auto& [key, axis] : axis_) text += fmt::format("{} {}\n", fmt::join(key, " "), axis);
  return text;
}

CellSplits CellSplits::of_text(const std::string& text) {
  CellSplits result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream numbers(line);
    Key key{};
    int axis = -1;
    for (int& number : key) numbers >> number;
    numbers >> axis;
    const bool is_whole = numbers && (numbers >> std::ws).eof() && *std::min_element(key.begin(), key.end()) >= 0;
    if (!is_whole || axis < 0 || axis > 2) throw InputError("\"" + line + "\" is no split of a cell");
    result.axis_[key] = axis;
  }
  return result;
}

}  // namespace ixos
