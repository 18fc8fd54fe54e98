/// The history of one term, as a value.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "state/histories.hpp"
#include "state/point_data.hpp"

namespace ixos {

/// The meaning of a column of numbers. It says how a column moves to other points, see moved().
enum class ColumnKind {
  Scalar,           ///< any number
  Growing,          ///< a number that no step lowers: a damage, a dissipated energy, a slip so far
  Nearest,          ///< a number of which no mean makes sense, such as one that may be a mark
  SurfaceVector,    ///< a vector in the tangent plane of a surface
  UnimodularTensor  ///< C - I of a symmetric positive definite C with determinant 1, see Components::symmetric
};

/// Some of the numbers of each point.
struct Column {
  std::string name;
  ColumnKind kind = ColumnKind::Scalar;
  std::size_t count = 1;  ///< numbers at each point
};

/// Numbers at the quadrature points of a term.
struct PointColumns {
  std::vector<Column> columns;  ///< one after the other in the numbers of a point
  PointData values;
  /// By point: its reference coordinates from -1 to 1 in the cell, or along the side, of two from the first of its
  /// corners to the second and to the last. The others are 0.
  std::vector<std::array<double, 3>> places{};

  bool operator==(const PointColumns& other) const { return values == other.values; }
};

/// The numbers that one term keeps from step to step. They can be copied, compared and written, and belong to no
/// object.
struct TermHistory {
  std::vector<PointColumns> points;
  std::vector<std::vector<int>> lists;  ///< by patch of a surface: the patches that it sees of the same surface
  /// Numbers of the step that was accepted last, for reports: no checkpoint holds them, and they do not count in a
  /// comparison.
  std::vector<double> last_step;

  bool operator==(const TermHistory& other) const { return points == other.points && lists == other.lists; }
};

}  // namespace ixos
