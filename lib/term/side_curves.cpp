#include "term/side_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"

namespace ixos {
namespace {

Planar reference(const LocalMesh& mesh, int node) {
  const auto first = 2 * static_cast<std::size_t>(node);
  return {mesh.coordinates[first], mesh.coordinates[first + 1]};
}

/// The chains that sides form: the numbers of the sides that end and that begin at each node.
struct Chains {
  std::map<int, int> ending, beginning;  ///< by local node

  Chains(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const std::string& name) {
    for (std::size_t i = 0; i < sides.size(); ++i)
      for (const bool first : {true, false}) {
        const int node = sides[i].nodes[first ? 0 : 1];
        if (!(first ? beginning : ending).insert({node, static_cast<int>(i)}).second)
          throw InputError(fmt::format("more than two sides of the surface \"{}\" meet in node {} of the mesh", name,
                                       mesh.message_number(static_cast<std::size_t>(node))));
      }
  }
  static int find(const std::map<int, int>& map, int node) {
    const auto found = map.find(node);
    return found == map.end() ? -1 : found->second;
  }
};

/// Returns whether two sides meet at 30 degrees or less.
bool meet_smoothly(const Planar& before, const Planar& after) {
  const double least_cosine = std::sqrt(3.0) / 2;
  return dot(before, after) >= least_cosine * length(before) * length(after);
}

}  // namespace

std::vector<Planar> SideCurves::places(const LocalMesh& mesh, const double* u) const {
  std::vector<Planar> x;
  x.reserve(nodes.size());
  for (const int node : nodes) {
    const auto first = 2 * static_cast<std::size_t>(node);
    x.push_back({mesh.coordinates[first] + u[first], mesh.coordinates[first + 1] + u[first + 1]});
  }
  return x;
}

SideCurves side_curves(const LocalMesh& mesh, const std::vector<LocalSide>& sides, Smoothing smoothing,
                       const std::string& name) {
  if (mesh.dimension != 2)
    throw InputError(
        fmt::format("the surface \"{}\" has three dimensions, where surfaces of two bodies cannot "
                    "interact yet; use a mesh of two dimensions",
                    name));
  for (const LocalSide& side : sides)
    if (side.nodes.size() != 2)
      throw InputError(
          fmt::format("the surface \"{}\" has sides of {} nodes; surfaces of two bodies need the sides of "
                      "linear cells, of two nodes (Contact Element Q1C1)",
                      name, side.nodes.size()));
  const Chains chains(mesh, sides, name);
  const auto side_of = [&](int i) {
    const auto& nodes = sides[static_cast<std::size_t>(i)].nodes;
    return reference(mesh, nodes[1]) - reference(mesh, nodes[0]);
  };
  SideCurves curves;
  for (const LocalSide& side : sides) curves.nodes.insert(curves.nodes.end(), side.nodes.begin(), side.nodes.end());
  std::sort(curves.nodes.begin(), curves.nodes.end(), [&](int a, int b) {  // alike on all ranks
    return mesh.global_ids[static_cast<std::size_t>(a)] < mesh.global_ids[static_cast<std::size_t>(b)];
  });
  curves.nodes.erase(std::unique(curves.nodes.begin(), curves.nodes.end()), curves.nodes.end());
  std::map<int, int> number;
  for (std::size_t i = 0; i < curves.nodes.size(); ++i) number[curves.nodes[i]] = static_cast<int>(i);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto& nodes = sides[i].nodes;
    const int own = static_cast<int>(i);
    const int before = Chains::find(chains.ending, nodes[0]), after = Chains::find(chains.beginning, nodes[1]);
    const auto goes_on = [&](int a, int b) {
      return smoothing == Smoothing::CatmullRom && a >= 0 && b >= 0 && meet_smoothly(side_of(a), side_of(b));
    };
    const bool smooth_start = goes_on(before, own), smooth_end = goes_on(own, after);
    CurveSegment segment;
    if (smooth_start || smooth_end) {
      std::array<int, 4> four{-1, number[nodes[0]], number[nodes[1]], -1};
      std::array<double, 3> lengths{0, length(side_of(own)), 0};
      if (smooth_start) {
        four[0] = number[sides[static_cast<std::size_t>(before)].nodes[0]];
        lengths[0] = length(side_of(before));
      }
      if (smooth_end) {
        four[3] = number[sides[static_cast<std::size_t>(after)].nodes[1]];
        lengths[2] = length(side_of(after));
      }
      segment = smooth_segment(four, lengths);
    } else {
      segment = straight_segment(number[nodes[0]], number[nodes[1]]);
    }
    segment.neighbours = {before, after};
    curves.segments.push_back(segment);
    curves.owned.push_back(sides[i].owned ? 1 : 0);
    curves.sides.push_back({sides[i].block, sides[i].cell, sides[i].side});
  }
  return curves;
}

}  // namespace ixos
