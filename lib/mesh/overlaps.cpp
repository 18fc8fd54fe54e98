#include "mesh/overlaps.hpp"

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "fem/cell_type.hpp"
#include "mesh/bounds.hpp"
#include "mesh/cell_place.hpp"
#include "mesh/cell_sides.hpp"

namespace ixos {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;
using Point = bg::model::point<double, 3, bg::cs::cartesian>;
using Box = bg::model::box<Point>;
using Cell = std::pair<int, int>;  ///< block, and cell of it
using Cells = bgi::rtree<std::pair<Box, Cell>, bgi::quadratic<16>>;

Point point(const Vec<3>& x) { return {x[0], x[1], x[2]}; }
Box box(const Bounds& bounds) { return {point(bounds.lower), point(bounds.upper)}; }

Cells cells_of(const Mesh& mesh) {
  std::vector<std::pair<Box, Cell>> boxes;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const ElementBlock& block = mesh.blocks[b];
    const auto width = static_cast<std::size_t>(nodes_per_cell(block.type));
    for (int cell = 0; cell < block.cells(); ++cell) {
      Bounds bounds;
      for (std::size_t a = 0; a < width; ++a)
        bounds.add(node_place(mesh, block.nodes[static_cast<std::size_t>(cell) * width + a]));
      boxes.push_back({box(bounds), {static_cast<int>(b), cell}});
    }
  }
  return Cells(boxes);
}

/// The cells of a body, and which of their sides are on its boundary.
class Body {
 public:
  explicit Body(const Mesh& mesh) : mesh_(mesh), cells_(cells_of(mesh)) {
    for (const Side& side : boundary_sides(mesh)) boundary_.insert({side.block, side.cell, side.side});
  }

  /// Returns whether a point is in the body, and not on its boundary.
  bool holds(const Vec<3>& x) const {
    for (auto cell = cells_.qbegin(bgi::intersects(point(x))); cell != cells_.qend(); ++cell)
      if (is_inside(cell->second, x)) return true;
    return false;
  }

 private:
  bool is_inside(const Cell& cell, const Vec<3>& x) const {
    const CellType type = mesh_.blocks[static_cast<std::size_t>(cell.first)].type;
    for (int k = 0; k < sides_per_cell(type); ++k) {
      const Side side{cell.first, cell.second, k};
      const std::array<double, 3> normal = outward_normal(mesh_, side),
                                  centre = centre_of(mesh_, corners_of(mesh_, side));
      double way = 0, size = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        way += normal[i] * (x[i] - centre[i]);
        size += normal[i] * normal[i];
      }
      // The normal is as long as the side, in 3D as its area: a way of so small a part of the side is none.
      const double none = 1e-9 * (mesh_.dimension == 3 ? std::pow(size, 0.75) : size);
      if (way > (boundary_.count({cell.first, cell.second, k}) > 0 ? -none : none)) return false;
    }
    return true;
  }

  const Mesh& mesh_;
  Cells cells_;
  std::set<std::array<int, 3>> boundary_;
};

/// Returns a node, or the centre of a cell, of a mesh that a body holds.
std::optional<std::array<double, 3>> point_within(const Mesh& mesh, const Body& body) {
  for (int node = 0; node < mesh.nodes(); ++node)
    if (const Vec<3> x = node_place(mesh, node); body.holds(x)) return std::array<double, 3>{x[0], x[1], x[2]};
  for (const ElementBlock& block : mesh.blocks)
    for (int cell = 0; cell < block.cells(); ++cell)
      if (const std::array<double, 3> x = cell_centre(mesh, block, cell); body.holds({x[0], x[1], x[2]})) return x;
  return std::nullopt;
}

}  // namespace

std::optional<Overlap> find_overlap(const std::vector<const Mesh*>& meshes) {
  std::vector<Bounds> bounds;
  std::vector<std::pair<Box, std::size_t>> boxes;
  for (const Mesh* const mesh : meshes) {
    bounds.push_back(bounds_of(*mesh));
    boxes.emplace_back(box(bounds.back()), boxes.size());
  }
  const bgi::rtree<std::pair<Box, std::size_t>, bgi::quadratic<16>> all(boxes);
  for (std::size_t second = 0; second < meshes.size(); ++second) {
    std::unique_ptr<const Body> body;
    for (auto near = all.qbegin(bgi::intersects(boxes[second].first)); near != all.qend(); ++near) {
      const std::size_t first = near->second;
      if (first == second) continue;
      if (!body) body = std::make_unique<const Body>(*meshes[second]);
      if (const auto place = point_within(*meshes[first], *body)) return Overlap{first, second, *place};
    }
  }
  return std::nullopt;
}

}  // namespace ixos
