#include "mesh/cell_bending.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "base/vector3.hpp"
#include "fem/cell_info.hpp"
#include "mesh/cell_sides.hpp"

namespace ixos {
namespace {

using Point = std::array<double, 3>;

constexpr int samples = 64, longest_line = 64;

struct CellNumber {
  int block, cell;
};

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double length(const Point& a) { return std::hypot(a[0], a[1], a[2]); }

/// Returns the sides at both ends of a parametric direction, in 2D and 3D.
std::array<int, 2> ends_of(std::size_t direction) {
  constexpr std::array<std::array<int, 2>, 3> sides{{{3, 1}, {0, 2}, {4, 5}}};
  return sides[direction];
}

bool may_lock(CellType type, const BendingQuery& query) {
  return !is_quadratic(type) && is_cube(type) && (!query.enriched_only || is_enriched(type));
}

/// The cells of a mesh by their corners.
class CellsAtNodes {
 public:
  explicit CellsAtNodes(const Mesh& mesh) : mesh_(mesh), first_(static_cast<std::size_t>(mesh.nodes()) + 1, 0) {
    for_each_corner([this](std::size_t node, const CellNumber&) { ++first_[node + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    cells_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for_each_corner([this, &next](std::size_t node, const CellNumber& cell) { cells_[next[node]++] = cell; });
  }

  /// Returns the same side of the other cell that has it; block -1 if there is none.
  Side beyond(const Side& side) const {
    const SideCorners corners = sorted_corners(mesh_, side);
    const auto node = static_cast<std::size_t>(corners.back());
    for (std::size_t k = first_[node]; k < first_[node + 1]; ++k) {
      const CellNumber& cell = cells_[k];
      if (cell.block == side.block && cell.cell == side.cell) continue;
      const int sides = sides_per_cell(mesh_.blocks[static_cast<std::size_t>(cell.block)].type);
      for (int s = 0; s < sides; ++s) {
        const Side other{cell.block, cell.cell, s};
        if (sorted_corners(mesh_, other) == corners) return other;
      }
    }
    return {-1, 0, 0};
  }

 private:
  template <class Visit>
  void for_each_corner(const Visit& visit) const {
    int number = 0;
    for (const ElementBlock& block : mesh_.blocks) {
      const int all = nodes_per_cell(block.type), corners = nodes_per_cell(corner_type(block.type));
      for (int cell = 0; cell < block.cells(); ++cell)
        for (int a = 0; a < corners; ++a)
          visit(static_cast<std::size_t>(block.nodes[cell_entry(cell, all, a)]), CellNumber{number, cell});
      ++number;
    }
  }

  const Mesh& mesh_;
  std::vector<std::size_t> first_;  ///< by node, of its cells
  std::vector<CellNumber> cells_;
};

/// The cells that follow each other through opposite sides.
struct Line {
  int cells = 1;
  double length = 0;     ///< [L0]
  bool is_held = false;  ///< it ends at a side whose corners are all held
};

class BendingSearch {
 public:
  BendingSearch(const Mesh& mesh, const BendingQuery& query) : mesh_(mesh), query_(query), neighbours_(mesh) {}

  /// Returns the ratios of a cell in its worst direction, and its volume (in 2D its area).
  std::pair<CellBending, double> look(const CellNumber& cell) const {
    const CellType type = mesh_.blocks[static_cast<std::size_t>(cell.block)].type;
    if (!is_cube(type)) return {{}, 0};
    std::array<Point, 3> half{{{0, 0, 0}, {0, 0, 0}, {0, 0, 1}}};  // columns of the Jacobian at the centre
    const auto d = static_cast<std::size_t>(mesh_.dimension);
    for (std::size_t i = 0; i < d; ++i) {
      half[i] = across(cell, i);
      for (double& component : half[i]) component *= 0.5;
    }
    const Point normal = cross(half[0], half[1]);
    const double volume = std::abs(normal[0] * half[2][0] + normal[1] * half[2][1] + normal[2] * half[2][2]);
    CellBending worst;
    if (!(volume > 0) || !may_lock(type, query_)) return {worst, volume};
    std::array<double, 3> gradient{};  // |grad xi_i|
    for (std::size_t i = 0; i < d; ++i) gradient[i] = length(cross(half[(i + 1) % 3], half[(i + 2) % 3])) / volume;
    std::array<Line, 3> lines;
    for (std::size_t i = 0; i < d; ++i) lines[i] = line_through(cell, i);
    for (std::size_t i = 0; i < d; ++i)
      for (std::size_t j = 0; j < d; ++j) {
        const Line& thickness = lines[j];
        if (i == j || thickness.is_held || lines[i].length < query_.slenderness * thickness.length) continue;
        const double size = length(half[i]), slopes = gradient[i] * gradient[i] + gradient[j] * gradient[j];
        const double ratio = (query_.moduli.along + query_.moduli.shear * size * size * slopes) / query_.moduli.plate;
        const double body = 1 + (ratio - 1) / (static_cast<double>(thickness.cells) * thickness.cells);
        if (worst.layers == 0 || body > worst.body) worst = {ratio, body, thickness.cells, size / length(half[j])};
      }
    return {worst, volume};
  }

 private:
  Point centre(const Side& side) const { return centre_of(mesh_, sorted_corners(mesh_, side)); }
  Point across(const CellNumber& cell, std::size_t direction) const {
    const std::array<int, 2> ends = ends_of(direction);
    return minus(centre({cell.block, cell.cell, ends[1]}), centre({cell.block, cell.cell, ends[0]}));
  }
  bool holds(const Side& side) const {
    if (query_.held.empty()) return false;
    const SideCorners corners = sorted_corners(mesh_, side);
    return std::all_of(corners.begin(), corners.end(),
                       [this](int node) { return node < 0 || query_.held[static_cast<std::size_t>(node)]; });
  }

  Line line_through(const CellNumber& cell, std::size_t direction) const {
    Line line;
    line.length = length(across(cell, direction));
    for (int end : ends_of(direction)) {
      Side side{cell.block, cell.cell, end};
      for (int count = 0; count < longest_line; ++count) {
        const Side next = neighbours_.beyond(side);
        if (next.block < 0) {
          line.is_held = line.is_held || holds(side);
          break;
        }
        const CellType type = mesh_.blocks[static_cast<std::size_t>(next.block)].type;
        if (!is_cube(type)) break;
        const Side far{next.block, next.cell, opposite_side(type, next.side)};
        if (far.block == cell.block && far.cell == cell.cell && far.side == end) return line;  // around a ring
        ++line.cells;
        line.length += length(minus(centre(far), centre(next)));
        side = far;
      }
    }
    return line;
  }

  const Mesh& mesh_;
  const BendingQuery& query_;
  CellsAtNodes neighbours_;
};

/// Returns some cells of the blocks of that name, evenly spaced in their order; none if there is one cell only.
std::vector<CellNumber> sampled_cells(const Mesh& mesh, const std::string& name) {
  std::vector<CellNumber> cells;
  long total = 0;
  for (const ElementBlock& block : mesh.blocks)
    if (block.name == name) total += block.cells();
  if (total < 2) return cells;
  const long stride = std::max(1L, total / samples);
  long before = 0;
  int number = 0;
  for (const ElementBlock& block : mesh.blocks) {
    if (block.name == name) {
      for (int cell = 0; cell < block.cells(); ++cell)
        if ((before + cell) % stride == stride / 2) cells.push_back({number, cell});
      before += block.cells();
    }
    ++number;
  }
  return cells;
}

}  // namespace

CellBending typical_bending(const Mesh& mesh, const BendingQuery& query) {
  if (std::none_of(mesh.blocks.begin(), mesh.blocks.end(),
                   [&](const ElementBlock& block) { return block.name == query.block && may_lock(block.type, query); }))
    return {};
  const std::vector<CellNumber> cells = sampled_cells(mesh, query.block);
  if (cells.empty()) return {};
  const BendingSearch search(mesh, query);
  std::vector<std::pair<CellBending, double>> found;
  double half = 0;
  for (const CellNumber& cell : cells) {
    found.push_back(search.look(cell));
    half += 0.5 * found.back().second;
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first.body > b.first.body; });
  double passed = 0;
  for (const auto& [bending, volume] : found) {
    passed += volume;
    if (passed > (1 + 1e-9) * half) return bending;
  }
  return {};
}

}  // namespace ixos
