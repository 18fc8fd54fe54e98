/// States on other nodes and points: of a finer or a coarser mesh, or of a part of one.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "state/history.hpp"
#include "state/state.hpp"

namespace ixos {

/// A share of a node's value.
struct NodeShare {
  std::size_t node = 0;
  double weight = 0;
};

/// A share of a point's numbers, from a point of the term's cells or sides before. Weights are not negative and their
/// sum is 1.
struct PointShare {
  std::size_t cell = 0, point = 0;
  double weight = 0;
};

/// A point and the shares of its numbers.
struct PointSource {
  std::size_t cell = 0, point = 0;
  std::vector<PointShare> shares;
  std::array<double, 3> normal{};  ///< unit normal of the surface there; zero: vectors keep their part along it
};

/// Sets numbers of points by the kind of their column:
/// - Scalar, Growing: the mean, which lies between the numbers before;
/// - Nearest: the number with the largest weight;
/// - SurfaceVector: the mean, less its part along the normal;
/// - UnimodularTensor: exp(sum w ln C) - I of the C that the numbers stand for. Its determinant is 1, and it turns with
///   them (Arsigny et al. 2006, log-Euclidean mean).
/// A point that has one share of weight 1 and no normal has its numbers to the last bit. Points of `to` without a
/// source keep their numbers. Throws std::logic_error if the columns of both differ, or weights are not as PointShare
/// says.
void move_columns(const PointColumns& from, const std::vector<PointSource>& sources, PointColumns& to);

/// Where a state's numbers come from.
struct StateSource {
  std::size_t dimension = 0;                     ///< values a node
  std::vector<std::vector<NodeShare>> nodes;     ///< by node, ghosts included
  std::vector<std::vector<PointSource>> points;  ///< by Term::slot(); shorter or empty: histories have no past there
};

/// Returns the state at the same time with moved displacements, velocities, accelerations and histories. Loads and
/// reactions are empty: they belong to the step that led to the state. `histories`: of the model to which it moves,
/// without a past; lists, such as the visibility of a surface on itself, stay as they are there, and columns that only
/// the state has, such as the rates of its last step, are left out. Throws as move_columns().
State moved(const State& state, const StateSource& source, TermHistories histories);

}  // namespace ixos
