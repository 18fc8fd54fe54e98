#include "discretization/hanging_corners.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "base/agreement.hpp"

namespace ixos {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

bool is_near(double a, double b) { return std::abs(std::abs(a) - b) < 1e-9; }

/// By a node in the middle of an edge or a face: the ends of the edge, or the corners of the face.
using Middles = std::map<int, std::vector<int>>;

/// Reads edges and faces off the ties of the nodes at their quarters. The weights of an edge's end, middle and other
/// end are 3/8, 3/4 and -1/8; those of a face are products of such.
void find_middles(const NodeTies& ties, Middles& edges, Middles& faces) {
  for (int node = ties.first(); node < ties.first() + ties.size(); ++node) {
    const auto* const begin = ties.begin(node);
    const auto* const end = ties.end(node);
    int middle = -1;
    std::vector<int> corners;
    const bool is_face = end - begin == 9;
    if (!is_face && end - begin != 3) continue;
    for (const auto* share = begin; share != end; ++share) {
      const double w = share->weight;
      if (is_near(w, is_face ? 9.0 / 16 : 3.0 / 4)) middle = share->master;
      const bool is_corner = is_face ? is_near(w, 9.0 / 64) || is_near(w, 3.0 / 64) || is_near(w, 1.0 / 64)
                                     : is_near(w, 3.0 / 8) || is_near(w, 1.0 / 8);
      if (is_corner) corners.push_back(share->master);
    }
    if (middle >= 0 && corners.size() == (is_face ? 4U : 2U)) (is_face ? faces : edges)[middle] = corners;
  }
}

}  // namespace

std::map<int, std::vector<int>> hanging_corners(const LocalMesh& mesh, const DofSpace& space,
                                                const std::vector<char>& corner) {
  if (space.maximum(mesh.ties.empty() ? 0 : 1) == 0) return {};
  Middles edges, faces;
  find_middles(mesh.ties, edges, faces);
  const auto d = at(mesh.dimension);
  // An owner sees all cells around its node: it knows whether that hangs, and the others ask it.
  std::vector<double> flag(at(space.local()), 0.0);
  const auto is_set = [&](int node) { return flag[at(node) * d] > 0.5; };
  const auto for_each_candidate = [&](const auto& visit) {
    for (const Middles* middles : {&edges, &faces})
      for (const auto& [node, corners] : *middles)
        if (corner[at(node)] != 0) visit(node, corners);
  };
  for_each_candidate([&](int node, const std::vector<int>&) { flag[at(node) * d] = 1; });
  space.update_ghosts(flag.data());
  std::map<int, std::vector<int>> result;
  const auto hangs_nowhere = [&](const std::vector<int>& corners) {
    return std::none_of(corners.begin(), corners.end(), is_set);
  };
  // A face's middle is that of its edges' middles, too, which hang: its corners count.
  for_each_candidate([&](int node, const std::vector<int>& corners) {
    if (hangs_nowhere(corners)) result[node] = corners;
  });
  std::vector<double> decision(flag.size(), 0.0);
  for (const auto& [node, corners] : result) decision[at(node) * d] = 1;
  space.update_ghosts(decision.data());
  together<std::logic_error>(space.comm(), [&] {
    for (int node = 0; node < mesh.ties.first(); ++node) {
      if (corner[at(node)] == 0) continue;
      const bool is_tied = decision[at(node) * d] > 0.5;
      if (!is_tied) result.erase(node);
      if (is_tied && result.count(node) == 0)
        throw std::logic_error("a rank lacks the nodes of a coarser edge or face");
    }
  });
  return result;
}

}  // namespace ixos
