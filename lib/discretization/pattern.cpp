#include "discretization/pattern.hpp"

#include <Tpetra_CrsGraph.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <algorithm>
#include <stdexcept>

namespace ixos {

Pattern::Pattern(const LocalMesh& mesh, const std::vector<std::vector<int>>& stencils)
    : dimension_(mesh.dimension), ties_(mesh.ties), row_start_{0} {
  std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(mesh.owned_nodes));
  for (int node = 0; node < mesh.owned_nodes; ++node) neighbours[row_index(node)].push_back(node);
  std::vector<std::vector<int>> with_tied;  // cells and stencils of tied nodes
  std::vector<int> followed;                // the nodes of one, in place of tied ones their masters
  const auto couple = [&](const int* nodes, int count) {
    if (std::any_of(nodes, nodes + count, [&](int node) { return ties_.is_tied(node); })) {
      with_tied.emplace_back(nodes, nodes + count);
      followed.clear();
      for (int a = 0; a < count; ++a)
        ties_.for_each_share(nodes[a], [&](int node, double) { followed.push_back(node); });
      nodes = followed.data();
      count = static_cast<int>(followed.size());
    }
    for (int a = 0; a < count; ++a)
      if (nodes[a] < mesh.owned_nodes)
        neighbours[row_index(nodes[a])].insert(neighbours[row_index(nodes[a])].end(), nodes, nodes + count);
  };
  for (const LocalBlock& block : mesh.blocks) {
    const int n = nodes_per_cell(block.type);
    for (int cell = 0; cell < block.cells(); ++cell) couple(&block.nodes[cell_entry(cell, n)], n);
  }
  for (const std::vector<int>& stencil : stencils) couple(stencil.data(), static_cast<int>(stencil.size()));
  for (std::vector<int>& row : neighbours) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    columns_.insert(columns_.end(), row.begin(), row.end());
    row_start_.push_back(static_cast<int>(columns_.size()));
  }
  if (ties_.empty()) return;
  const auto own_stride = [this](int row) { return stride(row); };
  tied_ = TiedPairs(with_tied, mesh, static_cast<int>(matrix_values()), own_stride);
  tied_.find_targets(
      ties_, [this](int row, int column) { return offset(row, column); }, own_stride);
}

/// Returns the index of the pair of an owned row, -1 if the nodes are not coupled.
int Pattern::find(int row, int column) const {
  const auto begin = columns_.begin() + row_start_[row_index(row)];
  const auto end = columns_.begin() + row_start_[row_index(row) + 1];
  const auto found = std::lower_bound(begin, end, column);
  return found == end || *found != column ? -1 : static_cast<int>(found - columns_.begin());
}

namespace {

int checked(int found) {
  if (found < 0) throw std::logic_error("the nodes of a pair are not coupled");
  return found;
}

}  // namespace

int Pattern::pair(int row, int column) const { return row >= rows() ? -1 : checked(find(row, column)); }

int Pattern::offset_of(int row, int pair) const {
  const int first = row_start_[row_index(row)];
  return dimension_ * dimension_ * first + dimension_ * (pair - first);
}

int Pattern::offset(int row, int column) const { return has_row(row) ? checked(coupled_offset(row, column)) : -1; }

int Pattern::coupled_offset(int row, int column) const {
  if (ties_.is_tied(row) || ties_.is_tied(column)) return tied_.offset(row, column);
  if (row >= rows()) return -1;
  const int found = find(row, column);
  return found < 0 ? -1 : offset_of(row, found);
}

Teuchos::RCP<CrsMatrix> Pattern::create_matrix(const DofSpace& space) const {
  return create_matrix(space.owned_map(), space);
}

Teuchos::RCP<CrsMatrix> Pattern::create_local_matrix(const DofSpace& space) const {
  return create_matrix(space.local_map(), space);
}

Teuchos::RCP<CrsMatrix> Pattern::create_matrix(const Teuchos::RCP<const Map>& row_map, const DofSpace& space) const {
  if (graph_.is_null()) {
    using RowStarts = CrsGraph::local_graph_device_type::row_map_type::non_const_type;
    using Columns = CrsGraph::local_graph_device_type::entries_type::non_const_type;
    const std::size_t d = static_cast<std::size_t>(dimension_);
    RowStarts starts("row starts", static_cast<std::size_t>(rows()) * d + 1);
    Columns columns("columns", columns_.size() * d * d);
    std::size_t k = 0;
    for (int row = 0; row < rows(); ++row)
      for (std::size_t i = 0; i < d; ++i) {
        for (int p = row_start_[row_index(row)]; p < row_start_[row_index(row) + 1]; ++p)
          for (std::size_t j = 0; j < d; ++j)
            columns(k++) = columns_[static_cast<std::size_t>(p)] * dimension_ + static_cast<int>(j);
        starts(static_cast<std::size_t>(row) * d + i + 1) = k;
      }
    auto graph = Teuchos::rcp(new CrsGraph(row_map, space.local_map(), starts, columns));
    graph->fillComplete(space.owned_map(), space.owned_map());
    graph_ = graph;
  }
  if (!ties_.empty()) {  // the matrix sees the first values only, and keeps the memory of all
    using Values = CrsMatrix::local_matrix_device_type::values_type::non_const_type;
    const Values all("values", values());
    auto shared = Teuchos::rcp(
        new CrsMatrix(graph_, Values(Kokkos::subview(all, std::make_pair(std::size_t{0}, matrix_values())))));
    shared->fillComplete(space.owned_map(), space.owned_map());
    return shared;
  }
  auto matrix = Teuchos::rcp(new CrsMatrix(graph_));
  matrix->fillComplete(space.owned_map(), space.owned_map());
  return matrix;
}

}  // namespace ixos
