// The sides of a surface in space as patches.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>

#include "base/error.hpp"
#include "geometry/curve_patches.hpp"
#include "geometry/face_patches.hpp"
#include "geometry/lagrange_patches.hpp"
#include "geometry/spline_faces.hpp"
#include "geometry/split_sides.hpp"
#include "geometry/surface_patches.hpp"
#include "mesh/side_grid.hpp"

namespace ixos {
namespace {

/// The nodes along a line of the grid through a node, in the direction of one of its edges, and their weights in the
/// derivative there by the length along the line: that of the parabola through the node and its neighbours, or, without
/// a continuation, of the parabola through the node and the next two.
struct Line {
  std::array<int, 3> nodes;       ///< the node of the continuation, -1 if there is none; the node; the edge's other end
  std::array<double, 3> weights;  ///< of these nodes; without a continuation they give the edge's slope
  int beyond = -1;                ///< without a continuation: the node after the edge's other end, if any
  double next = 0;                ///< and the length from there to it [L0]

  Line(const SideGrid& grid, int node, int end) : nodes{grid.continuation(node, end), node, end} {
    const double ahead = grid.strip_length(node, end);
    if (nodes[0] >= 0)
      weights = parabola_slope(grid.strip_length(nodes[0], node), ahead);
    else
      cut(grid);
    if (nodes[0] < 0) beyond = grid.continuation(end, node);
    if (beyond >= 0) next = grid.strip_length(end, beyond);
  }
  /// Makes it the slope of the edge.
  void cut(const SideGrid& grid) {
    const double ahead = grid.strip_length(nodes[1], nodes[2]);
    nodes[0] = -1;
    weights = {0, -1 / ahead, 1 / ahead};
  }
  NodeWeights derivative(double sign) const {
    NodeWeights result;
    if (beyond >= 0) {
      const double ahead = 1 / weights[2];
      result.add(nodes[1], -sign * (2 * ahead + next) / (ahead * (ahead + next)));
      result.add(nodes[2], sign * (ahead + next) / (ahead * next));
      result.add(beyond, -sign * ahead / (next * (ahead + next)));
      return result;
    }
    for (std::size_t k = 0; k < 3; ++k)
      if (nodes[k] >= 0) result.add(nodes[k], sign * weights[k]);
    return result;
  }
};

/// Returns the mixed derivative at a corner from the nodes around it: those of the face, of the faces beyond its edges
/// at the corner, and of the face at the opposite corner.
NodeWeights mixed_derivative(const SideGrid& grid, int face, Line first, Line second, double sign) {
  const int node = first.nodes[1];
  // The faces beside this one along the first and the second line.
  int beside_first = grid.across(face, node, second.nodes[2]), beside_second = grid.across(face, node, first.nodes[2]);
  if (first.nodes[0] >= 0 && (beside_first < 0 || !grid.has(beside_first, first.nodes[0]))) first.cut(grid);
  if (second.nodes[0] >= 0 && (beside_second < 0 || !grid.has(beside_second, second.nodes[0]))) second.cut(grid);
  if (first.nodes[0] >= 0 && second.nodes[0] >= 0 && !grid.is_regular(node)) {
    first.cut(grid);
    second.cut(grid);
  }
  const auto at = [&](std::size_t i, std::size_t j) {  // 0: behind, 1: here, 2: ahead
    if (i == 1) return second.nodes[j];
    if (j == 1) return first.nodes[i];
    if (i == 2 && j == 2) return grid.opposite(face, node);
    if (i == 0 && j == 2) return grid.opposite(beside_first, node);
    if (i == 2 && j == 0) return grid.opposite(beside_second, node);
    return grid.opposite(grid.across(beside_first, node, first.nodes[0]), node);
  };
  NodeWeights result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      if (first.nodes[i] < 0 || second.nodes[j] < 0) continue;
      result.add(at(i, j), sign * first.weights[i] * second.weights[j]);
    }
  return result;
}

/// Returns whether the patches of the two faces at the edge have one tangent plane along it.
bool is_smooth(const SideGrid& grid, int face, int a, int b) {
  const int other = grid.across(face, a, b);
  if (other < 0 || grid.is_crease(a, b)) return false;
  const auto matches = [&](int node) {
    if (grid.is_regular(node)) return true;
    // At a crease or a rim the lines along it continue from one face to the other.
    const SideGrid::Face& corners = grid.faces()[static_cast<std::size_t>(face)];
    const auto here = std::find(corners.begin(), corners.end(), node) - corners.begin();
    for (const auto turn : {1, 3}) {
      const int end = corners[static_cast<std::size_t>(here + turn) % 4];
      if (end == a || end == b || !grid.is_crease(node, end)) continue;
      const int beyond = grid.continuation(node, end);
      return beyond >= 0 && grid.has(other, beyond);
    }
    return false;
  };
  return matches(a) && matches(b);
}

SurfacePatch<3> smooth_face(const SideGrid& grid, int face) {
  const SideGrid::Face& c = grid.faces()[static_cast<std::size_t>(face)];
  // By corner: the corners at the other ends of its edges along the first and the second parameter.
  constexpr std::array<std::array<std::size_t, 2>, 4> ends{{{1, 3}, {0, 2}, {3, 1}, {2, 0}}};
  std::array<CornerDerivatives, 4> derivatives;
  for (std::size_t k = 0; k < 4; ++k) {
    const double by_first = k == 1 || k == 2 ? -1 : 1, by_second = k >= 2 ? -1 : 1;
    const Line first(grid, c[k], c[ends[k][0]]), second(grid, c[k], c[ends[k][1]]);
    derivatives[k] = {first.derivative(by_first), second.derivative(by_second),
                      mixed_derivative(grid, face, first, second, by_first * by_second)};
  }
  return bicubic_patch(c, derivatives, {grid.strip_length(c[0], c[1]), grid.strip_length(c[0], c[3])});
}

SurfacePatch<3> spline_face(const SplineFaces& splines, int face, const SideGrid::Face& corners,
                            const std::string& name, const std::vector<long long>& numbers) {
  try {
    return bezier_patch(corners, splines.controls(face));
  } catch (const std::length_error&) {
    throw InputError(
        fmt::format("too many faces of the surface \"{}\" meet near node {} of the mesh for Smoothing \"Spline\"; use "
                    "\"Catmull-Rom\" or \"None\"",
                    name, numbers[static_cast<std::size_t>(corners[0])]));
  }
}

/// Returns the ends of a face's edges, by side of its patch.
std::array<std::array<int, 2>, 4> edges_of(const SideGrid::Face& c) {
  return {{{c[0], c[3]}, {c[1], c[2]}, {c[0], c[1]}, {c[3], c[2]}}};
}

bool is_linear(const std::vector<LocalSide>& sides) { return sides.empty() || sides.front().nodes.size() <= 4; }

/// A node hangs in a surface if it follows several nodes, one of them of the surface: one that follows its periodic
/// partner, or nodes of a surface to which the surface is tied, ends no side of another size.
void refuse_hanging_nodes(const LocalMesh& mesh, const std::vector<int>& nodes, const std::string& name) {
  const std::set<int> own(nodes.begin(), nodes.end());
  const auto hangs = [&](int node) {
    return mesh.is_tied(node) && mesh.ties.end(node) - mesh.ties.begin(node) > 1 &&
           std::any_of(mesh.ties.begin(node), mesh.ties.end(node),
                       [&](const NodeTies::Share& share) { return own.count(share.master) > 0; });
  };
  if (std::none_of(nodes.begin(), nodes.end(), hangs)) return;
  throw InputError(
      fmt::format("the surface \"{}\" has hanging nodes, where cells of two sizes meet: curved patches do not close "
                  "there. Use Smoothing \"None\", or quadratic cells, whose own curved sides close",
                  name));
}

/// Returns a surface with triangles.
SurfacePatches<3> split_surface(const LocalMesh& mesh, const std::vector<LocalSide>& sides, Smoothing smoothing,
                                const std::string& name) {
  if (smoothing == Smoothing::Spline && is_linear(sides))
    throw InputError(
        fmt::format("the surface \"{}\" has triangles; Smoothing \"Spline\" needs four-sided faces, of whose grid it "
                    "makes a spline. "
                    "Use \"Catmull-Rom\" or \"None\"",
                    name));
  SurfacePatches<3> whole = surface_of_sides<3>(mesh, sides, name), surface;
  if (smoothing != Smoothing::None && is_linear(sides)) refuse_hanging_nodes(mesh, whole.nodes, name);
  SplitSides split = split_sides(mesh, sides, whole.nodes, smoothing == Smoothing::CatmullRom, name);
  const SideGrid grid(std::move(split.faces), split.x, name, split.numbers);
  surface.nodes = std::move(whole.nodes);
  surface.patches = std::move(split.patches);
  for (std::size_t p = 0; p < surface.patches.size(); ++p) {
    const auto edges = edges_of(grid.faces()[p]);
    for (std::size_t s = 0; s < 4; ++s)
      surface.patches[p].neighbours[s] = grid.across(static_cast<int>(p), edges[s][0], edges[s][1]);
    const auto side = static_cast<std::size_t>(split.side[p]);
    surface.owned.push_back(whole.owned[side]);
    surface.sides.push_back(whole.sides[side]);
    surface.part.push_back(p > 0 && split.side[p - 1] == split.side[p] ? surface.part.back() + 1 : 0);
  }
  return surface;
}

}  // namespace

template <>
SurfacePatches<3> surface_patches<3>(const LocalMesh& mesh, const std::vector<LocalSide>& sides, Smoothing smoothing,
                                     const std::string& name) {
  if (has_triangles(mesh, sides)) return split_surface(mesh, sides, smoothing, name);
  SurfacePatches<3> surface = surface_of_sides<3>(mesh, sides, name);
  std::vector<SideGrid::Face> faces;
  for (const LocalSide& side : sides) {
    SideGrid::Face face;
    for (std::size_t k = 0; k < 4; ++k) face[k] = surface_number(surface.nodes, side.nodes[k], mesh);
    faces.push_back(face);
  }
  std::vector<Vec<3>> x;
  std::vector<long long> numbers;
  for (const int node : surface.nodes) {
    x.push_back(reference_place<3>(mesh, node));
    numbers.push_back(mesh.message_number(static_cast<std::size_t>(node)));
  }
  const SideGrid grid(std::move(faces), x, name, numbers);
  const bool smooth = smoothing != Smoothing::None && is_linear(sides);
  if (smooth) refuse_hanging_nodes(mesh, surface.nodes, name);
  std::optional<SplineFaces> splines;
  if (smooth && smoothing == Smoothing::Spline) splines.emplace(grid);
  surface.through_nodes = !splines;
  for (int f = 0; f < static_cast<int>(grid.faces().size()); ++f) {
    const SideGrid::Face& c = grid.faces()[static_cast<std::size_t>(f)];
    SurfacePatch<3> patch;
    if (is_linear(sides)) {
      patch = splines ? spline_face(*splines, f, c, name, numbers) : smooth ? smooth_face(grid, f) : bilinear_patch(c);
    } else {
      std::vector<int> own;
      const LocalSide& side = sides[static_cast<std::size_t>(f)];
      for (const int node : side.nodes) own.push_back(surface_number(surface.nodes, node, mesh));
      patch = lagrange_patch<3>(own, tied_nodes(mesh.blocks[static_cast<std::size_t>(side.block)], side.side));
    }
    const auto edges = edges_of(c);
    for (std::size_t s = 0; s < 4; ++s) {
      patch.neighbours[s] = grid.across(f, edges[s][0], edges[s][1]);
      patch.smooth[s] = smooth && is_smooth(grid, f, edges[s][0], edges[s][1]);
    }
    surface.patches.push_back(std::move(patch));
  }
  return surface;
}

}  // namespace ixos
