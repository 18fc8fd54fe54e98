/// The nodes of a surface in the frame of a moving rigid body.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "discretization/pattern.hpp"
#include "mesh/local_mesh.hpp"
#include "rule/rule.hpp"
#include "term/force_term.hpp"
#include "term/wall/frame_motion.hpp"

namespace ixos {

/// Returns L V R^T of a block V, whose rows are `stride` apart.
template <std::size_t D>
Small<double, D> turned_block(const Small<double, 3>& l, const double* v, std::size_t stride,
                              const Small<double, 3>& r) {
  Small<double, D> rows{}, result{};
  for (std::size_t k = 0; k < D; ++k)
    for (std::size_t j = 0; j < D; ++j)
      for (std::size_t i = 0; i < D; ++i) rows[i][j] += l[i][k] * v[k * stride + j];
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j)
      for (std::size_t k = 0; k < D; ++k) result[i][j] += rows[i][k] * r[j][k];
  return result;
}

/// A node at x = X + u has the place y = P + R^T (x - P - T) in the frame of a rigid body at the pose x = P + T + R (y
/// - P). Its displacement there is y - X = R^T (u - T) + (R^T - I)(X - P). A derivative node of a Hermite side has
/// derivatives in place of places, and no translation. Arrays are local; only the entries of the surface's nodes are
/// read or written.
class MovingFrame {
 public:
  MovingFrame(FrameMotion motion, const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern);

  const FrameMotion& motion() const { return motion_; }
  bool turns() const { return motion_.turns(); }
  std::size_t dimension() const { return d_; }
  /// Finds the blocks of the nodes in a pattern that has changed.
  void place(const Pattern& pattern);

  /// Sets `seen` to the displacement in the frame at a rule's point of the segment, or of u.
  void see(const RigidPose& pose, const Segment& segment, const RulePoint& point, std::vector<double>& seen) const;
  void see(const RigidPose& pose, const double* u, std::vector<double>& seen) const;
  /// Sets `seen` to `factor` times the vectors turned into the frame, R^T du.
  void see_change(const RigidPose& pose, double factor, const double* du, std::vector<double>& seen) const;
  /// Adds forces in a frame that is turned, R f, to `sum`, and sets f to 0.
  void add_moved(const Turn& turn, std::vector<double>& f, double* sum) const;
  /// Adds a bound of the row sums of R K R^T from row sums of K, and sets those to 0.
  void add_row_sums(const RigidPose& pose, std::vector<double>& sums, double* all) const;
  /// Adds R_ik^2 d_k, the diagonal of R D R^T from a diagonal D, and sets that to 0.
  void add_diagonal(const RigidPose& pose, std::vector<double>& diagonal, double* all) const;
  /// Replaces the blocks V of all pairs of the nodes by L^T V R, or L V R^T if `back`, L and R the rotations.
  void turn_blocks(const Turn& left, const Turn& right, bool back, double* values) const;
  /// Adds R V R^T for the blocks V of all pairs of nodes in the frame, in the layout of a pattern.
  static void add_moved_matrix(const RigidPose& pose, const Pattern& pattern, const std::vector<double>& seen,
                               double* values);
  /// Subtracts K x from y for the blocks K of all pairs of the nodes; x and y are local arrays, x zero elsewhere.
  void subtract_product(const Pattern& pattern, const std::vector<double>& values, const std::vector<double>& x,
                        std::vector<double>& y) const;
  /// Returns the point of space at place y of the frame.
  static std::array<double, 3> from_frame(const RigidPose& pose, const std::array<double, 3>& y);

  /// Sets `velocity` to that of the body's points where the nodes are, turned into the frame; `seen` as above.
  void see_velocity(const RigidPose& pose, const std::vector<double>& seen, std::vector<double>& velocity) const;
  /// Adds the rate of R f as the body turns, spin n x R f, to `sum`.
  void add_turning_rate(const RigidPose& pose, const std::vector<double>& f, double* sum) const;
  /// Returns the sum of f . (velocity of the body's points where the nodes are) over owned nodes; f and the
  /// displacements `seen` are those in the frame.
  double power(const RigidPose& pose, const std::vector<double>& f, const std::vector<double>& seen) const;
  /// Returns the sum of f . dw over owned nodes, f in the turned frame, dw = seen1 - seen0 - R^T (u1 - u0).
  double work(const Turn& turn, const std::vector<double>& f, const std::vector<double>& seen0,
              const std::vector<double>& seen1, const double* u0, const double* u1) const;
  void clear(std::vector<double>& array) const;

  using Triple = std::array<double, 3>;
  struct Node {
    std::size_t first;  ///< degree of freedom
    bool owned, derivative;
    Triple place;  ///< X, or the derivative of X
  };
  struct Block {
    std::size_t first, stride;  ///< in the matrix values
    std::size_t row, column;    ///< among the nodes
  };
  const std::vector<Node>& nodes() const { return nodes_; }
  /// Returns the blocks of pairs with a row on this rank; none if the frame only moves as prescribed, and never turns.
  const std::vector<Block>& blocks() const { return blocks_; }
  /// Returns the arm R (y - P) in space from the body's point to a node, or the derivative of the place.
  Triple arm(const RigidPose& pose, const Node& node, const std::vector<double>& seen) const;
  Triple vector_at(const Node& node, const double* values) const {
    const double* const v = values + node.first;
    return {v[0], v[1], d_ == 3 ? v[2] : 0.0};
  }

 private:
  template <class Factor>
  void add_turned(const RigidPose& pose, const Factor& factor, std::vector<double>& values, double* sums) const;
  /// Sets `seen` at each node to what it sees of the displacement, whose component at place i of local arrays is u(i).
  template <class Displacement>
  void see_nodes(const RigidPose& pose, const Displacement& u, std::vector<double>& seen) const;
  template <std::size_t D, class Displacement>
  void see_nodes_of(const RigidPose& pose, const Displacement& u, std::vector<double>& seen) const;
  template <std::size_t D>
  void turn_blocks_of(const Small<double, 3>& l, const Small<double, 3>& r, double* values) const;
  /// Sets or adds the components of v that the mesh has.
  void set(const Triple& v, double* at) const {
    at[0] = v[0];
    at[1] = v[1];
    if (d_ == 3) at[2] = v[2];
  }
  void add(const Triple& v, double* at) const {
    at[0] += v[0];
    at[1] += v[1];
    if (d_ == 3) at[2] += v[2];
  }

  FrameMotion motion_;
  std::size_t d_;
  std::vector<Node> nodes_;
  std::vector<Block> blocks_;
};

}  // namespace ixos
