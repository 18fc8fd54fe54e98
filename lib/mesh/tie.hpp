/// Nodes whose displacements follow those of others.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace ixos {

/// u(node) = sum_k weights[k] u(masters[k]), for displacements, velocities and accelerations alike. The weights sum to
/// 1, so that a translation moves the node as its masters. Where the node stands at sum_k weights[k] X(masters[k]) in
/// the reference, it also follows any other affine motion, and its forces exert no moment beyond their own.
struct Tie {
  int node = -1;
  std::vector<int> masters;
  std::vector<double> weights;
  bool in_place = true;  ///< whether the node stands where its masters put it; not on the far side of a periodic mesh
};

/// Replaces masters that are tied themselves by their own masters, until none is. Returns the ties by ascending node,
/// the masters of each ascending, without those of the weight 0. Throws InputError if a node is tied twice, follows
/// itself, or follows nothing; `name` returns a node in words.
std::vector<Tie> resolved_ties(const std::vector<Tie>& ties, const std::function<std::string(int)>& name);

}  // namespace ixos
