#include "mesh/refinement.hpp"

#include <algorithm>
#include <utility>

#include "fem/cell_info.hpp"
#include "fem/corner_bits.hpp"

namespace ixos {
namespace {

/// Returns the corner of a linear cell at the other end of the axes that have a bit.
int flipped(int corner, int bits) { return corner_bits(corner_bits(corner) ^ bits); }

/// Finds which corner of each cell is its coarse cell's. The opposite one is then the coarse cell's middle, and both
/// nodes have the same part in all their cells, so that one cell decides for all that are connected with it.
class RefinementFinder {
 public:
  explicit RefinementFinder(const Mesh& mesh)
      : mesh_(mesh), n_(std::size_t{1} << mesh.dimension), all_(static_cast<int>(n_) - 1) {}

  std::optional<Refinement> refinement() {
    if (!collect_cells()) return std::nullopt;
    find_cells_of_nodes();
    outer_.assign(cells_.size(), -1);
    part_.assign(static_cast<std::size_t>(mesh_.nodes()), Part::Unknown);
    for (int cell = 0; cell < static_cast<int>(cells_.size()); ++cell)
      if (outer_[index(cell)] < 0 && !decide(cell)) return std::nullopt;
    if (!find_coarse_cells()) return std::nullopt;
    return std::move(result_);
  }

 private:
  enum class Part : char { Unknown, Corner, Middle };
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  int node(int cell, int corner) const { return cells_[index(cell)][corner]; }
  const int* cells_begin(int node) const { return cells_of_nodes_.data() + first_cell_[index(node)]; }
  const int* cells_end(int node) const { return cells_of_nodes_.data() + first_cell_[index(node) + 1]; }
  int corner_of(int cell, int node) const {
    const int* const nodes = cells_[index(cell)];
    return static_cast<int>(std::find(nodes, nodes + n_, node) - nodes);
  }
  bool contains(int cell, int node) const { return corner_of(cell, node) < static_cast<int>(n_); }

  bool collect_cells() {
    if (mesh_.axisymmetric || mesh_.plain_nodes >= 0 || !mesh_.ties.empty() || !mesh_.derivative_of.empty())
      return false;
    for (const ElementBlock& block : mesh_.blocks) {
      if (block.cells() > 0 && block.type != type()) return false;
      for (int cell = 0; cell < block.cells(); ++cell)
        cells_.push_back(&block.nodes[cell_entry(cell, nodes_per_cell(block.type))]);
    }
    return !cells_.empty() && cells_.size() % n_ == 0;
  }
  CellType type() const { return cube_type(mesh_.dimension); }

  void find_cells_of_nodes() {
    first_cell_.assign(index(mesh_.nodes()) + 1, 0);
    for (const int* nodes : cells_)
      for (std::size_t a = 0; a < n_; ++a) ++first_cell_[index(nodes[a]) + 1];
    for (std::size_t i = 1; i < first_cell_.size(); ++i) first_cell_[i] += first_cell_[i - 1];
    std::vector<std::size_t> next(first_cell_);
    cells_of_nodes_.resize(first_cell_.back());
    for (int cell = 0; cell < static_cast<int>(cells_.size()); ++cell)
      for (std::size_t a = 0; a < n_; ++a) cells_of_nodes_[next[index(cells_[index(cell)][a])]++] = cell;
  }

  /// Tries each corner of a cell as the coarse cell's. Returns whether one fits all connected cells.
  bool decide(int seed) {
    for (int corner = 0; corner < static_cast<int>(n_); ++corner) {
      decided_.clear();
      named_.clear();
      if (spread(seed, corner)) return true;
      for (const int cell : decided_) outer_[index(cell)] = -1;
      for (const int node : named_) part_[index(node)] = Part::Unknown;
    }
    return false;
  }

  bool spread(int seed, int corner) {
    set(seed, corner);
    std::size_t seen = 0;
    while (seen < decided_.size()) {  // name() decides more
      const int cell = decided_[seen++], outer = outer_[index(cell)];
      if (!name(node(cell, outer), Part::Corner, 0) || !name(node(cell, flipped(outer, all_)), Part::Middle, all_))
        return false;
    }
    return true;
  }
  void set(int cell, int corner) {
    outer_[index(cell)] = corner;
    decided_.push_back(cell);
  }
  /// Decides the cells around a node. Returns false if the node or one of them is decided otherwise.
  bool name(int node, Part part, int bits) {
    if (part_[index(node)] == part) return true;
    if (part_[index(node)] != Part::Unknown) return false;
    if (part == Part::Middle && cells_end(node) - cells_begin(node) != static_cast<std::ptrdiff_t>(n_)) return false;
    part_[index(node)] = part;
    named_.push_back(node);
    for (const int* cell = cells_begin(node); cell != cells_end(node); ++cell) {
      const int corner = flipped(corner_of(*cell, node), bits);
      if (outer_[index(*cell)] < 0)
        set(*cell, corner);
      else if (outer_[index(*cell)] != corner)
        return false;
    }
    return true;
  }

  bool find_coarse_cells() {
    std::vector<int> coarse_number(index(mesh_.nodes()), -1), coarse_cell(cells_.size(), -1);
    const auto d = index(mesh_.dimension);
    result_.coarse.dimension = mesh_.dimension;
    for (int node = 0; node < mesh_.nodes(); ++node) {
      if (part_[index(node)] != Part::Corner) continue;
      coarse_number[index(node)] = static_cast<int>(result_.fine_node.size());
      result_.fine_node.push_back(node);
      for (std::size_t i = 0; i < d; ++i) result_.coarse.coordinates.push_back(mesh_.coordinates[index(node) * d + i]);
    }
    ElementBlock block;
    block.name = "coarse cells";
    block.type = type();
    std::vector<std::vector<int>> corners(index(mesh_.nodes()));
    for (int middle = 0; middle < mesh_.nodes(); ++middle) {
      if (part_[index(middle)] != Part::Middle) continue;
      const auto own = corners_of_parent(middle);
      if (own.empty() || !share_corners(middle, coarse_number, corners)) return false;
      for (const int* cell = cells_begin(middle); cell != cells_end(middle); ++cell)
        coarse_cell[index(*cell)] = block.cells();
      for (const int corner : own) block.nodes.push_back(coarse_number[index(corner)]);
    }
    result_.coarse.blocks.push_back(std::move(block));
    auto next = coarse_cell.begin();
    for (const ElementBlock& fine : mesh_.blocks) {
      result_.coarse_cell.emplace_back(next, next + fine.cells());
      next += fine.cells();
    }
    result_.first_share.assign(1, 0);
    for (const std::vector<int>& mine : corners) {
      result_.corner.insert(result_.corner.end(), mine.begin(), mine.end());
      result_.first_share.push_back(result_.corner.size());
    }
    return true;
  }

  /// Returns the fine nodes at the coarse cell's corners in the order of a cell, oriented as its first fine cell; none
  /// if they are not different ones.
  std::vector<int> corners_of_parent(int middle) const {
    std::vector<int> corners(n_, -1);
    const int first = *cells_begin(middle), outer = outer_[index(first)];
    for (const int* cell = cells_begin(middle); cell != cells_end(middle); ++cell) {
      int across = 0;  // the axes along which this fine cell is beside the first one: their common nodes end there
      for (int axis = 0; axis < mesh_.dimension; ++axis)
        if (!contains(*cell, node(first, flipped(outer, all_ ^ (1 << axis))))) across |= 1 << axis;
      int& place = corners[index(flipped(outer, across))];
      const int corner = node(*cell, outer_[index(*cell)]);
      if (place >= 0 || std::count(corners.begin(), corners.end(), corner) > 0) return {};
      place = corner;
    }
    return corners;
  }

  /// Adds what a coarse cell says of its nodes' corners: those of the fine cells that have the node. Returns false if
  /// another coarse cell has said otherwise.
  bool share_corners(int middle, const std::vector<int>& coarse_number, std::vector<std::vector<int>>& corners) {
    said_.clear();
    for (const int* cell = cells_begin(middle); cell != cells_end(middle); ++cell) {
      const int outer = outer_[index(*cell)], corner = coarse_number[index(node(*cell, outer))];
      for (std::size_t a = 0; a < n_; ++a) said_.emplace_back(node(*cell, static_cast<int>(a)), corner);
    }
    std::sort(said_.begin(), said_.end());
    for (auto begin = said_.begin(), end = begin; begin != said_.end(); begin = end) {
      found_.clear();
      for (; end != said_.end() && end->first == begin->first; ++end) found_.push_back(end->second);
      std::vector<int>& mine = corners[index(begin->first)];
      if (mine.empty()) mine = found_;
      if (mine != found_ || (found_.size() & (found_.size() - 1)) != 0) return false;
    }
    return true;
  }

  const Mesh& mesh_;
  std::size_t n_;  ///< nodes of a cell
  int all_;        ///< bits of all axes
  std::vector<const int*> cells_;
  std::vector<std::size_t> first_cell_;
  std::vector<int> cells_of_nodes_;
  std::vector<int> outer_;  ///< per cell: its corner that is its coarse cell's; -1: not decided
  std::vector<Part> part_;  ///< per node
  std::vector<int> decided_, named_;
  std::vector<std::pair<int, int>> said_;  ///< scratch
  std::vector<int> found_;
  Refinement result_;
};

}  // namespace

std::optional<Refinement> find_refinement(const Mesh& mesh) { return RefinementFinder(mesh).refinement(); }

}  // namespace ixos
