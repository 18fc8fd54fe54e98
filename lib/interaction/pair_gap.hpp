/// The gap between a point of one surface and another surface, and its derivatives in the nodes of both.
#pragma once
#include <array>
#include <cstddef>

#include "interaction/placed_curves.hpp"

namespace ixos {

/// Derivatives of a signed least distance g (Laursen and Simo 1993; Wriggers 2006) in the places of the nodes of the
/// point's segment, which come first, and of the foot's. With the weights S = (N of the point, -N of the foot) of their
/// relative position and those of the foot's tangent, D = (0, dN/dt), the gradient is S n. With the tangent x_t, M =
/// x_t . x_t, b = x_tt . n, A = M - g b, p = S x_t + g D n and c = D n + b p/A the second derivatives are
/// -(c p^T + p c^T)/A + b p p^T/A^2 + g c c^T/M. At a corner or a free end they are S S^T (I - n n^T)/g.
class PairGap {
 public:
  static constexpr std::size_t most = 2 * CurveSegment::most;  ///< nodes
  /// By node and direction: 2 I + i.
  using Vector = std::array<double, 2 * most>;
  using Matrix = std::array<Vector, 2 * most>;

  /// `weights`: those of the point, of its segment's `count` nodes; `x`: the places of the foot's nodes.
  PairGap(const CurveSegment::Weights& weights, std::size_t count, const CurveSegment& segment,
          const CurveSegment::Points& x, const SurfaceFoot& foot);

  std::size_t nodes() const { return nodes_; }
  /// Returns dg/dx, S n.
  Vector gradient() const;
  /// Adds along * grad g grad g^T + across * d2g to a matrix.
  void add(double along, double across, Matrix& matrix) const;
  /// Returns whether d2g is positive or negative semidefinite, with the sign of g: at a corner or a free end.
  bool is_round() const { return round_; }

 private:
  std::size_t nodes_;
  std::array<double, most> s_{}, d_{};
  Planar normal_;
  double gap_;
  bool round_;
  double metric_ = 1, divisor_ = 1, bend_ = 0;
  Planar tangent_{};
};

}  // namespace ixos
