// The sides of a surface in the plane as curves.
#include <fmt/format.h>

#include <map>

#include "base/error.hpp"
#include "geometry/curve_patches.hpp"
#include "geometry/lagrange_patches.hpp"
#include "geometry/surface_patches.hpp"
#include "mesh/meridian.hpp"

namespace ixos {
namespace {

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

}  // namespace

template <>
SurfacePatches<2> surface_patches<2>(const LocalMesh& mesh, const std::vector<LocalSide>& sides, Smoothing smoothing,
                                     const std::string& name) {
  SurfacePatches<2> surface = surface_of_sides<2>(mesh, sides, name);
  const Chains chains(mesh, sides, name);
  const std::vector<bool> on_axis = mesh.axisymmetric ? nodes_on_axis(mesh) : std::vector<bool>();
  const auto node_of = [&](int side, std::size_t end) { return sides[static_cast<std::size_t>(side)].nodes[end]; };
  const auto along = [&](int side) {
    return reference_place<2>(mesh, node_of(side, 1)) - reference_place<2>(mesh, node_of(side, 0));
  };
  const auto number = [&](int node) { return surface_number(surface.nodes, node, mesh); };
  const auto before = [&](int side) { return Chains::find(chains.ending, node_of(side, 0)); };
  const auto after = [&](int side) { return Chains::find(chains.beginning, node_of(side, 1)); };
  // The sides that a side continues, and that continue it, smoothly.
  const auto smoothly_before = [&](int side) {
    const int other = side < 0 ? -1 : before(side);
    return other >= 0 && meet_smoothly(along(other), along(side)) ? other : -1;
  };
  const auto smoothly_after = [&](int side) {
    const int other = side < 0 ? -1 : after(side);
    return other >= 0 && meet_smoothly(along(side), along(other)) ? other : -1;
  };
  const auto end_of = [&](int side, std::size_t end) { return side < 0 ? -1 : number(node_of(side, end)); };
  for (int own = 0; own < static_cast<int>(sides.size()); ++own) {
    const int previous = smoothly_before(own), next = smoothly_after(own);
    SurfacePatch<2> patch;
    if (const std::vector<int>& nodes = sides[static_cast<std::size_t>(own)].nodes; nodes.size() > 2) {
      std::vector<int> numbers;
      numbers.reserve(nodes.size());
      for (const int node : nodes) numbers.push_back(number(node));
      patch = lagrange_patch<2>(numbers);
    } else if (smoothing == Smoothing::None || (previous < 0 && next < 0)) {
      patch = straight_patch(end_of(own, 0), end_of(own, 1));
    } else if (smoothing == Smoothing::Spline) {
      patch = spline_patch({end_of(smoothly_before(previous), 0), end_of(previous, 0), end_of(own, 0), end_of(own, 1),
                            end_of(next, 1), end_of(smoothly_after(next), 1)});
    } else {
      const auto length_of = [&](int side) { return side < 0 ? 0 : length(along(side)); };
      patch = smooth_patch({end_of(previous, 0), end_of(own, 0), end_of(own, 1), end_of(next, 1)},
                           {length_of(previous), length_of(own), length_of(next)});
    }
    patch.neighbours = {before(own), after(own)};
    // A curve of a body of revolution does not end freely at the axis: its mirror image continues it.
    for (const std::size_t end : {0U, 1U})
      if (!on_axis.empty() && patch.neighbours[end] < 0 && on_axis[static_cast<std::size_t>(node_of(own, end))])
        patch.neighbours[end] = own;
    surface.patches.push_back(patch);
  }
  return surface;
}

}  // namespace ixos
