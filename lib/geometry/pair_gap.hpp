/// The gap between a point of one surface and another surface, and its derivatives in the nodes of both.
#pragma once
#include <array>
#include <cstddef>

#include "geometry/placed_surface.hpp"

namespace ixos {

/// Derivatives of a signed least distance g (Laursen and Simo 1993; Wriggers 2006) in the places of the nodes of the
/// point's patch, which come first, and of the closest point's. With the weights S = (N of the point, -N of the closest
/// point) of their relative position and those of the closest point's tangents, D_k = (0, dN/dxi_k), the gradient is S
/// n. Over the parameters that are free, with the tangents x_k, M = x_k . x_l, b = x_kl . n, A = M - g b, p = A^-1 (S
/// x_k + g D_k n) and c = D_k n + b p, the second derivatives are -(c p^T + p c^T) + p b p^T + g c M^-1 c^T. A closest
/// point at a kink or a rim moves along it only: each unit vector m across it and across n adds S S^T m m^T/g.
template <std::size_t D>
class PairGap {
 public:
  static constexpr std::size_t most = 2 * SurfacePatch<D>::most;  ///< nodes
  /// By node and direction: D I + i.
  using Vector = std::array<double, D * most>;

  /// `weights`: those of the point, of its patch's `count` nodes; `patch`: that of the closest point.
  PairGap(const typename SurfacePatch<D>::Weights& weights, std::size_t count, const SurfacePatch<D>& patch,
          const SurfaceProjection<D>& projection);

  /// By derivative, the weights themselves and the slopes D_k, and direction, twice: K_aibj = sum of w^k_a M_kilj
  /// w^l_b.
  using Moduli = std::array<std::array<double, D * D>, D * D>;

  std::size_t nodes() const { return nodes_; }
  /// Returns w^k of a node: S for k = 0, D_(k - 1) beyond that.
  double weight(std::size_t k, std::size_t node) const { return k == 0 ? s_[node] : d_[k - 1][node]; }
  /// Returns dg/dx, S n.
  Vector gradient() const;
  /// Returns M of the matrix along * grad g grad g^T + across * d2g, which is symmetric.
  Moduli moduli(double along, double across) const;
  /// Adds this matrix to one of D nodes() rows, row by row.
  void add(double along, double across, double* matrix) const;
  /// Returns whether d2g is positive or negative semidefinite, with the sign of g: where no parameter is free.
  bool is_round() const { return free_ == 0; }

 private:
  static constexpr std::size_t parameters = D - 1;
  std::size_t nodes_;
  std::array<double, most> s_{};
  std::array<std::array<double, most>, parameters> d_{};
  Vec<D> normal_;
  double gap_;
  /// Number of parameters that are free; the first `free_` entries of what follows are theirs.
  std::size_t free_ = 0;
  std::array<Vec<D>, parameters> tangents_{};
  std::array<std::array<double, parameters>, parameters> bend_{}, inverse_metric_{}, inverse_{};
  std::array<Vec<D>, parameters> across_{};  ///< the unit vectors m, D - 1 - free_ of them
};

extern template class PairGap<2>;
extern template class PairGap<3>;

}  // namespace ixos
