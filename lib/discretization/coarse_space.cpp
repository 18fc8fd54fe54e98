#include "discretization/coarse_space.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Export.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "discretization/hanging_corners.hpp"
#include "fem/corner_element.hpp"
#include "fem/with_element.hpp"
#include "mesh/refinement.hpp"

namespace ixos {
namespace {

/// Calls visit(nodes of the cell) for all local cells of a block.
template <class Visit>
void for_each_cell(const LocalBlock& block, const Visit& visit) {
  for (int cell = 0; cell < block.cells(); ++cell) visit(&block.nodes[cell_entry(cell, nodes_per_cell(block.type))]);
}

/// Returns, by node of an element, whether the node stands at its own place; no node does on a tied edge's inside.
template <class Element>
std::array<bool, Element::nodes> places_of(unsigned tied) {
  std::array<bool, Element::nodes> result;
  result.fill(true);
  if constexpr (HasInnerNodes<Element>::value)
    for (const InnerNode& inner : Element::inner_nodes())
      if ((tied >> inner.edge & 1U) != 0) result[inner.node] = false;
  return result;
}

}  // namespace

CoarseSpace::CoarseSpace(const LocalMesh& fine, const DofSpace& fine_space, const std::vector<int>& constrained)
    : fine_space_(fine_space),
      dimension_(static_cast<std::size_t>(fine.dimension)),
      coarse_(fine.refinement ? coarse_cells(fine, number_) : coarse_mesh(fine, fine_space, number_),
              fine_space.comm()),
      on_coarse_(static_cast<std::size_t>(space().local())),
      on_fine_(fine_local()) {
  if (fine.refinement) {
    take_shares(fine);
    if (fine_space.comm()->getSize() > 1) {
      LocalMesh all = mesh();
      all.owned_nodes = all.nodes();
      local_rows_ = std::make_unique<const Pattern>(all);
    }
  } else {
    find_shares(fine);
  }
  find_left_out(constrained);
}

LocalMesh CoarseSpace::coarse_cells(const LocalMesh& fine, std::vector<int>& number) {
  number = fine.refinement->number;
  return fine.refinement->coarse;
}

void CoarseSpace::take_shares(const LocalMesh& fine) {
  const LocalRefinement& refinement = *fine.refinement;
  first_share_ = refinement.first_share;
  for (std::size_t node = 0; node < number_.size(); ++node) {
    const std::size_t begin = first_share_[node], end = first_share_[node + 1];
    for (std::size_t k = begin; k < end; ++k)
      shares_.push_back({refinement.corner[k], 1 / static_cast<double>(end - begin)});
    std::sort(shares_.begin() + static_cast<std::ptrdiff_t>(begin), shares_.end(),
              [](const Share& a, const Share& b) { return a.corner < b.corner; });
  }
}

/// Sets `number` and returns the mesh of the corners, in the order of the fine mesh's nodes.
LocalMesh CoarseSpace::coarse_mesh(const LocalMesh& fine, const DofSpace& fine_space, std::vector<int>& number) {
  number.assign(static_cast<std::size_t>(fine.nodes()), -1);
  LocalMesh coarse;
  coarse.dimension = fine.dimension;
  coarse.axisymmetric = fine.axisymmetric;
  coarse.largest_radius = fine.largest_radius;
  coarse.global_cells = fine.global_cells;
  for (const LocalBlock& block : fine.blocks) {
    if (block.global_cells > 0 && !is_quadratic(block.type))
      throw std::logic_error("linear cells that refine no coarser ones have no coarse space");
    for_each_cell(block, [&](const int* nodes) {
      for (int a = 0; a < nodes_per_cell(corner_type(block.type)); ++a) number[static_cast<std::size_t>(nodes[a])] = 0;
    });
  }
  std::vector<char> corner(number.size());
  for (std::size_t node = 0; node < number.size(); ++node) corner[node] = number[node] == 0 ? 1 : 0;
  const std::map<int, std::vector<int>> hanging = hanging_corners(fine, fine_space, corner);
  for (const auto& [node, masters] : hanging)
    for (const int master : masters) number[static_cast<std::size_t>(master)] = 0;
  const auto d = static_cast<std::size_t>(fine.dimension);
  int count = 0;
  for (const bool tied : {false, true}) {
    for (std::size_t node = 0; node < number.size(); ++node) {
      if (number[node] < 0 || (hanging.count(static_cast<int>(node)) > 0) != tied) continue;
      number[node] = count++;
      if (!tied && static_cast<int>(node) < fine.owned_nodes) coarse.owned_nodes = count;
      for (std::size_t i = 0; i < d; ++i) coarse.coordinates.push_back(fine.coordinates[node * d + i]);
      coarse.original_ids.push_back(fine.original_ids[node]);
    }
    if (!tied) coarse.ties = NodeTies(count);
  }
  double ties = 0;
  for (const auto& [node, masters] : hanging) {
    std::vector<NodeTies::Share> shares;
    for (const int master : masters)
      shares.push_back({number[static_cast<std::size_t>(master)], 1 / static_cast<double>(masters.size())});
    coarse.ties.add(shares);
    ties += node < fine.owned_nodes ? 1 : 0;
  }
  fine_space.sum(&ties, 1);
  coarse.global_tied = std::lround(ties);
  for (const LocalBlock& block : fine.blocks) {
    LocalBlock here;
    here.name = block.name;
    here.type = corner_type(block.type);
    here.owned = block.owned;
    here.original_cells = block.original_cells;
    here.global_cells = block.global_cells;
    for_each_cell(block, [&](const int* nodes) {
      for (int a = 0; a < nodes_per_cell(here.type); ++a)
        here.nodes.push_back(number[static_cast<std::size_t>(nodes[a])]);
    });
    coarse.blocks.push_back(std::move(here));
  }
  // The ranks number their nodes one after the other. Ghosts learn their numbers through the fine nodes.
  const Map map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(), static_cast<std::size_t>(coarse.owned_nodes),
                0, fine_space.comm());
  coarse.global_nodes = static_cast<long long>(map.getGlobalNumElements());
  std::vector<double> ids(static_cast<std::size_t>(fine_space.local()), 0.0);
  for (std::size_t node = 0; node < static_cast<std::size_t>(fine.owned_nodes); ++node)
    if (number[node] >= 0 && number[node] < coarse.owned_nodes)
      ids[node * d] = static_cast<double>(map.getGlobalElement(number[node]));
  fine_space.update_ghosts(ids.data());
  coarse.global_ids.resize(static_cast<std::size_t>(count));
  for (std::size_t node = 0; node < number.size(); ++node)
    if (number[node] >= 0)
      coarse.global_ids[static_cast<std::size_t>(number[node])] = coarse.ties.is_tied(number[node])
                                                                      ? coarse.global_nodes + fine.original_ids[node]
                                                                      : std::llround(ids[node * d]);
  return coarse;
}

void CoarseSpace::find_shares(const LocalMesh& fine) {
  const std::size_t nodes = number_.size();
  std::vector<std::vector<Share>> shares(nodes);
  for (const LocalBlock& block : fine.blocks)
    with_element(block.type, [&](auto tag) {
      using Element = typename decltype(tag)::type;
      if constexpr (!std::is_void_v<typename CornerElement<Element>::type>) {
        const auto in_cell = corner_shares<Element>();
        const auto has_place = places_of<Element>(block.tied);
        for_each_cell(block, [&](const int* cell) {
          for (std::size_t a = 0; a < in_cell.size(); ++a) {
            std::vector<Share>& mine = shares[static_cast<std::size_t>(cell[a])];
            if (!mine.empty() || !has_place[a]) continue;  // a neighbour names the same corners
            for (std::size_t c = 0; c < in_cell[a].size(); ++c)
              if (in_cell[a][c] != 0) mine.push_back({number(cell[c]), in_cell[a][c]});
            mine = resolved(std::move(mine));
          }
        });
      }
    });
  first_share_.assign(1, 0);
  for (const std::vector<Share>& mine : shares) {
    shares_.insert(shares_.end(), mine.begin(), mine.end());
    first_share_.push_back(shares_.size());
  }
}

/// Returns the shares of the corners that are not tied, ascending.
std::vector<CoarseSpace::Share> CoarseSpace::resolved(std::vector<Share> shares) const {
  std::map<int, double> weights;
  for (const Share& share : shares)
    mesh().ties.for_each_share(share.corner,
                               [&](int master, double weight) { weights[master] += share.weight * weight; });
  shares.clear();
  for (const auto& [corner, weight] : weights) shares.push_back({corner, weight});
  return shares;
}

/// A rank sees all fine nodes that an owned corner moves; ghosts learn from their owners.
void CoarseSpace::find_left_out(const std::vector<int>& constrained) {
  std::vector<double> left_out(on_coarse_.size(), 0.0);
  for (const int dof : constrained) {
    const auto node = static_cast<std::size_t>(dof) / dimension_, i = static_cast<std::size_t>(dof) % dimension_;
    for (const Share* share = shares_begin(node); share != shares_end(node); ++share)
      left_out[static_cast<std::size_t>(share->corner) * dimension_ + i] = 1;
  }
  space().update_ghosts(left_out.data());
  is_left_out_.assign(left_out.begin(), left_out.end());
  for (std::size_t dof = 0; dof < left_out.size(); ++dof)
    if (is_left_out_[dof] != 0) left_out_.push_back(static_cast<int>(dof));
}

void CoarseSpace::prolongate(const Vector& coarse, Vector& fine) const {
  space().import(coarse, on_coarse_.data());
  for (const int dof : left_out_) on_coarse_[static_cast<std::size_t>(dof)] = 0;
  const auto to = fine.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t node = 0; node < to.extent(0) / dimension_; ++node)
    for (std::size_t i = 0; i < dimension_; ++i) {
      double sum = 0;
      for (const Share* share = shares_begin(node); share != shares_end(node); ++share)
        sum += share->weight * on_coarse_[static_cast<std::size_t>(share->corner) * dimension_ + i];
      to(node * dimension_ + i, 0) = sum;
    }
}

void CoarseSpace::restrict_to_coarse(const Vector& fine, Vector& coarse) const {
  fine_space_.import(fine, on_fine_.data());
  std::fill(on_coarse_.begin(), on_coarse_.end(), 0.0);  // sums on ghosts are not whole, and not used
  const std::size_t free = number_.size() - static_cast<std::size_t>(fine_space_.ties().size());
  for (std::size_t node = 0; node < free; ++node)
    for (const Share* share = shares_begin(node); share != shares_end(node); ++share)
      for (std::size_t i = 0; i < dimension_; ++i)
        on_coarse_[static_cast<std::size_t>(share->corner) * dimension_ + i] +=
            share->weight * on_fine_[node * dimension_ + i];
  for (const int dof : left_out_) on_coarse_[static_cast<std::size_t>(dof)] = 0;
  const auto to = coarse.getLocalViewHost(Tpetra::Access::OverwriteAll);
  std::copy_n(on_coarse_.data(), to.extent(0), to.data());
}

Teuchos::RCP<CrsMatrix> CoarseSpace::matrix(const std::function<void(double*)>& add, double diagonal) const {
  const auto result = create_matrix();
  if (local_rows_) {
    const auto mine = local_rows_->create_local_matrix(space());
    add(mine->getLocalMatrixHost().values.data());
    const Tpetra::Export<LocalId, GlobalId> exporter(space().local_map(), space().owned_map());
    result->resumeFill();
    result->doExport(*mine, exporter, Tpetra::ADD);
    result->fillComplete(space().owned_map(), space().owned_map());
  } else {
    add(result->getLocalMatrixHost().values.data());
    coarse_.pattern().condense(result->getLocalMatrixHost().values.data());
  }
  leave_out(diagonal, result->getLocalMatrixHost().values.data());
  return result;
}

void CoarseSpace::add_diagonal(const double* fine, double* values) const {
  const std::size_t counted = local_rows_ ? static_cast<std::size_t>(fine_space_.owned()) / dimension_ : number_.size();
  for (std::size_t node = 0; node < counted; ++node) {
    const double* const d = fine + node * dimension_;
    if (std::all_of(d, d + dimension_, [](double x) { return x == 0; })) continue;
    for (const Share* row = shares_begin(node); row != shares_end(node); ++row) {
      if (row->corner >= pattern().rows()) continue;
      for (const Share* column = shares_begin(node); column != shares_end(node); ++column) {
        const auto first = static_cast<std::size_t>(pattern().offset(row->corner, column->corner));
        const auto next = static_cast<std::size_t>(pattern().stride(row->corner)) + 1;
        for (std::size_t i = 0; i < dimension_; ++i) values[first + i * next] += row->weight * column->weight * d[i];
      }
    }
  }
}

void CoarseSpace::leave_out(double diagonal, double* values) const {
  if (left_out_.empty()) return;
  coarse_.pattern().for_each_row([&](int row, const auto& places) {
    const bool row_out = is_left_out_[static_cast<std::size_t>(row)] != 0;
    places([&](int column, std::size_t place) {
      if (row_out || is_left_out_[static_cast<std::size_t>(column)] != 0) values[place] = row == column ? diagonal : 0;
    });
  });
}

}  // namespace ixos
