#include "discretization/tied_pairs.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>

namespace ixos {

TiedPairs::TiedPairs(const std::vector<std::vector<int>>& stencils, const LocalMesh& mesh, int first,
                     const std::function<int(int)>& stride)
    : dimension_(mesh.dimension), first_value_(first), end_(first) {
  std::map<int, std::set<int>> columns;
  for (const std::vector<int>& stencil : stencils)
    for (const int row : stencil)
      for (const int column : stencil)
        if (mesh.has_row(row) && (mesh.is_tied(row) || mesh.is_tied(column))) {
          columns[row].insert(column);
          if (mesh.is_tied(row))
            mesh.ties.for_each_share(column, [&](int master, double) { columns[row].insert(master); });
        }
  for (const auto& [node, own] : columns) {
    Row row{node, end_, 0, {own.begin(), own.end()}};
    const int blocks = static_cast<int>(own.size());
    row.stride = mesh.is_tied(node) ? dimension_ * blocks : stride(node);
    const int in_a_line = row.stride / dimension_;
    end_ += (blocks + in_a_line - 1) / in_a_line * row.stride * dimension_;
    rows_.push_back(std::move(row));
  }
}

const TiedPairs::Row* TiedPairs::row_of(int node) const {
  const auto found =
      std::lower_bound(rows_.begin(), rows_.end(), node, [](const Row& row, int wanted) { return row.node < wanted; });
  return found == rows_.end() || found->node != node ? nullptr : &*found;
}

/// An owned row's blocks stand in lines as long as the row is in the matrix.
int TiedPairs::offset_in(const Row& row, std::size_t number) const {
  const int in_a_line = row.stride / dimension_, k = static_cast<int>(number);
  return row.first + k / in_a_line * row.stride * dimension_ + k % in_a_line * dimension_;
}

int TiedPairs::offset(int row, int column) const {
  const Row* const found = row_of(row);
  if (found == nullptr) return -1;
  const auto place = std::lower_bound(found->columns.begin(), found->columns.end(), column);
  if (place == found->columns.end() || *place != column) return -1;
  return offset_in(*found, static_cast<std::size_t>(place - found->columns.begin()));
}

const std::vector<int>& TiedPairs::columns(int row) const {
  static const std::vector<int> none;
  const Row* const found = row_of(row);
  return found == nullptr ? none : found->columns;
}

void TiedPairs::find_targets(const NodeTies& ties, const std::function<int(int, int)>& offset,
                             const std::function<int(int)>& stride) {
  for (const Row& row : rows_)
    for (std::size_t k = 0; k < row.columns.size(); ++k)
      if (ties.is_tied(row.columns[k]))
        ties.for_each_share(row.columns[k], [&](int master, double weight) {
          add_target(offset_in(row, k), row.stride, offset(row.node, master), row.stride, weight);
        });
  for (const Row& row : rows_)
    if (ties.is_tied(row.node))
      ties.for_each_share(row.node, [&](int master, double weight) {
        if (offset(master, master) < 0) return;  // a row of another rank
        for (std::size_t k = 0; k < row.columns.size(); ++k)
          if (!ties.is_tied(row.columns[k]))
            add_target(offset_in(row, k), row.stride, offset(master, row.columns[k]), stride(master), weight);
      });
}

void TiedPairs::add_target(int from, int from_stride, int to, int to_stride, double weight) {
  if (!targets_.empty()) {
    Target& last = targets_.back();
    const bool follows = from == last.from + last.width && to == last.to + last.width && weight == last.weight;
    if (follows && from_stride == last.from_stride && to_stride == last.to_stride) {
      last.width += dimension_;
      return;
    }
  }
  targets_.push_back({from, from_stride, to, to_stride, dimension_, weight});
}

void TiedPairs::condense(double* values) const {
  for (const Target& target : targets_)
    for (int i = 0; i < dimension_; ++i) {
      const double* const from = values + target.from + std::ptrdiff_t{target.from_stride} * i;
      double* const to = values + target.to + std::ptrdiff_t{target.to_stride} * i;
      for (int j = 0; j < target.width; ++j) to[j] += target.weight * from[j];
    }
  std::fill(values + first_value_, values + end_, 0.0);
}

}  // namespace ixos
