/// The slip of a point along a patch of another surface as a function of displacements.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "geometry/placed_surface.hpp"
#include "interaction/friction_step.hpp"
#include "term/force_term.hpp"

namespace ixos {

/// The slip of a point with the patch of its closest point, since the places that set() was told. The slip is a vector
/// in the plane P = I - n n^T across the normal n of those places. It is a function of few numbers that are linear in
/// the displacements, the Motion. A motion of both surfaces as one is no slip. `change` stands for the change of the
/// Motion since then.
///
/// A force is the derivative of the slip times the traction, by the Motion: at the change itself (SlipKind::At), or
/// averaged over the straight path to it (SlipKind::Mean). The mean times the change is the traction times the slip.
template <std::size_t D>
class PatchSlip;

/// In the plane the slip is linear. With the gap g, the weights S of the relative position, and the patch's tangent t
/// and rotation w at the closest point,
///
///   slip = P (S du - g w x n),   w = t x N' du/(t . t).
template <>
class PatchSlip<2> {
 public:
  static constexpr std::size_t size = 2;
  using Motion = Vec<size>;  ///< the slip itself
  using Moduli = Small<double, size>;

  /// `weights`: those of the point, of its patch's `count` nodes; `place`: of the point; `patch`: that of the closest
  /// point. Nodes are those of the point's patch, then those of the closest point's.
  void set(const SurfacePatch<2>::Weights& weights, std::size_t count, const Vec<2>& place,
           const SurfacePatch<2>& patch, const SurfaceProjection<2>& projection);

  const Small<double, 2>& plane() const { return plane_; }  ///< P
  /// Returns the Motion of a local array of displacements at the nodes.
  Motion motion(const std::vector<int>& nodes, const double* u) const;
  Vec<2> slip(const Motion& change) const { return change; }

  Motion force(const Vec<2>& traction, const Motion& /*change*/, SlipKind) const { return traction; }
  /// Returns the derivative of the force by the change. Tangent::Convex leaves out that of the slip's derivative.
  Moduli moduli(const SlipResponse<double, 2>& response, const Motion& /*change*/, SlipKind, Tangent) const {
    return response.stiffness;
  }
  /// Returns the part of a force that acts on the point.
  static Vec<2> on_point(const Motion& force) { return force; }

  /// Adds factor times the force to a local array.
  void add_force(const std::vector<int>& nodes, double factor, const Motion& force, double* f) const;
  /// Adds factor times the matrix of the moduli to one of 2 rows a node.
  void add_stiffness(double factor, const Moduli& moduli, std::vector<double>& k) const;
  /// Returns the sum of the squares of the summands of the slip of a local array of displacements.
  double squares(const std::vector<int>& nodes, const double* u) const;

 private:
  Small<double, 2> plane_{};
  std::vector<Small<double, 2>> slips_;  ///< by node: the derivative of the slip by its displacement
};

/// In space no linear function of displacements vanishes for all rotations. The Motion has three vectors: the position
/// r of the point from the place of the closest point in the material, and the patch's tangents x_k there. No rotation
/// changes their scalar products b_k = r . x_k and g_kl = x_k . x_l and their volume v = r . (x_1 x x_2). With the
/// changes db_k, dg_kl and dv of these, and the dual vectors x^k, the normal m, the area A = |x_1 x x_2|, rho^k = r .
/// x^k and h = r . m of the start,
///
///   slip = P [x^k (db_k - rho^l dg_kl/2) + m (dv/A - h x^k . x^l dg_kl/2)].
///
/// For small displacements this is P (dr - w x r) with the rotation of the patch, w = sum of (m/2 c_k^T - c_k m^T)
/// dx_k, c_k = m x x^k. Other parameters of the patch give the same slip. Where the patch has the normal n at the
/// closest point, the slip is x^k db_k. The mean force then has no moment about the mean of the places of both ends; at
/// a kink its moment is of third order in the change.
template <>
class PatchSlip<3> {
 public:
  static constexpr std::size_t size = 9;
  using Motion = Vec<size>;  ///< r, x_1, x_2
  using Moduli = Small<double, size>;

  void set(const SurfacePatch<3>::Weights& weights, std::size_t count, const Vec<3>& place,
           const SurfacePatch<3>& patch, const SurfaceProjection<3>& projection);

  const Small<double, 3>& plane() const { return plane_; }
  Motion motion(const std::vector<int>& nodes, const double* u) const;
  Vec<3> slip(const Motion& change) const;

  Motion force(const Vec<3>& traction, const Motion& change, SlipKind kind) const;
  Moduli moduli(const SlipResponse<double, 3>& response, const Motion& change, SlipKind kind, Tangent tangent) const;
  static Vec<3> on_point(const Motion& force) { return {force[0], force[1], force[2]}; }

  void add_force(const std::vector<int>& nodes, double factor, const Motion& force, double* f) const;
  void add_stiffness(double factor, const Moduli& moduli, std::vector<double>& k) const;
  double squares(const std::vector<int>& nodes, const double* u) const;

 private:
  /// The slip's derivatives by the vectors of the Motion.
  using Derivative = std::array<Small<double, 3>, 3>;
  using Vectors = std::array<Vec<3>, 3>;

  Vectors vectors(const Motion& change) const;
  Derivative derivative(const Motion& change, SlipKind kind) const;
  void add_derivative(double factor, const Vectors& at, Derivative& sum) const;
  /// Adds the second derivatives of traction . slip.
  void add_bend(double factor, const Vec<3>& traction, const Vectors& at, Moduli& sum) const;

  Small<double, 3> plane_{};
  Motion start_{};
  // The slip is the sum of along_k Db_k + stretch_kl Dg_kl + across Dv; second_derivative() says the place of k and l.
  std::array<Vec<3>, 2> along_{};
  std::array<Vec<3>, 3> stretch_{};
  Vec<3> across_{};
  std::vector<Vec<3>> weights_;  ///< by node: in r, x_1 and x_2
};

}  // namespace ixos
