#include "mesh/overlaps.hpp"

#include <algorithm>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <utility>

#include "base/vector3.hpp"
#include "fem/cell_type.hpp"
#include "mesh/bounds.hpp"
#include "mesh/cell_place.hpp"
#include "mesh/cell_sides.hpp"
#include "mesh/tree_point.hpp"

namespace ixos {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;
using Box = bg::model::box<TreePoint>;
using Cell = std::pair<int, int>;  ///< block, and cell of it
using Cells = bgi::rtree<std::pair<Box, Cell>, bgi::quadratic<16>>;

Box box(const Bounds& bounds) { return {tree_point(bounds.lower), tree_point(bounds.upper)}; }

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
  Body(const Mesh& mesh, double depth) : mesh_(mesh), depth_(depth), cells_(cells_of(mesh)) {
    for (const Side& side : boundary_sides(mesh)) boundary_.insert({side.block, side.cell, side.side});
  }

  /// Returns whether a point is in the body, and not on its boundary.
  bool holds(const Vec<3>& x) const {
    for (auto cell = cells_.qbegin(bgi::intersects(tree_point(x))); cell != cells_.qend(); ++cell)
      if (is_inside(cell->second, x)) return true;
    return false;
  }

 private:
  bool is_inside(const Cell& cell, const Vec<3>& x) const {
    const int sides = sides_per_cell(mesh_.blocks[static_cast<std::size_t>(cell.first)].type);
    double height = std::numeric_limits<double>::infinity();  // above all sides, to the point
    double least = height;                                    // side, or edge of a side
    bool in_boundary = false;
    for (int k = 0; k < sides; ++k) {
      const Side side{cell.first, cell.second, k};
      const std::array<double, 3> normal = outward_normal(mesh_, side),
                                  centre = centre_of(mesh_, corners_of(mesh_, side));
      const double size = std::sqrt(dot(normal, normal));  // the length of the side, in 3D twice its area
      double way = 0;
      for (std::size_t i = 0; i < 3; ++i) way += normal[i] * (centre[i] - x[i]) / size;
      least = std::min(least, mesh_.dimension == 3 ? std::sqrt(size / 2) : size);
      if (boundary_.count({cell.first, cell.second, k}) > 0) {
        height = std::min(height, way);
        in_boundary = true;
      } else if (way < -1e-9 * std::sqrt(size)) {
        return false;
      }
    }
    return !in_boundary || height > depth_ * least;
  }

  const Mesh& mesh_;
  double depth_;
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

std::optional<Overlap> find_overlap(const std::vector<const Mesh*>& meshes, double depth) {
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
      if (!body) body = std::make_unique<const Body>(*meshes[second], depth);
      if (const auto place = point_within(*meshes[first], *body)) return Overlap{first, second, *place};
    }
  }
  return std::nullopt;
}

}  // namespace ixos
