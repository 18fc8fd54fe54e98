/// The discrete gradient of the energy of two surfaces.
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "term/pair_points.hpp"

namespace ixos {

/// At each point, with the foot, the normal m and the weights S of the relative position at the mean of both ends'
/// places, d = S dx, a = m . d and the mean T of the traction over the gaps g0 to g1, the force is S (-T m), and what
/// lacks of the work, e = psi(g1) - psi(g0) + T a, is done by forces between the foot y and the corners z_k of the
/// point's own side,
///
///   c w_k/R^2 (z_k - y),   w_k = (z_k - y) . (dz_k - dy),   c = e/v,   v = sum of w_k^2/R^2,
///
/// with R^2 = sum of |z_k - x|^2 at the start. They point along the line between both places, so that the force does
/// the change of the energy as its work, and its net force and its net moment about the mean places vanish. The side of
/// a point never changes, so the force is continuous where the foot changes its patch. A foot that rolls keeps its
/// distances to the corners, v = 0. Where v < |e|/k, with k three times the law's stiffness at its equilibrium gap, c
/// is therefore 2 k sign(e) - k^2 v/e, and Gonzalez' (1996) vector (e - c v)/(d . d) S d does the rest of the work.
/// Displacements below 1e-5 of the equilibrium gap take -T m alone.
template <std::size_t D>
class PairGradient {
 public:
  /// The points must outlive it.
  explicit PairGradient(const PairPoints<D>& points);

  /// Adds the force to a local array. Returns the least gap at the end of the segment.
  double add_force(const Segment& segment, double* f) const;
  /// Calls visit(block) for the matrix of each point: the derivative of the force by the end of the segment, which is
  /// not symmetric. Convex: the mean stiffness along the gradient, if it is positive.
  void for_each_block(const Segment& segment, Tangent kind, const std::function<void(const PairBlock&)>& visit) const;

 private:
  static constexpr std::size_t corners = D == 2 ? 2 : 4;  ///< of a patch, its first nodes
  using Contact = typename PairPoints<D>::Contact;
  using Contacts = typename PairPoints<D>::Contacts;
  /// All points at both ends and at the mean places of the segment.
  struct Step {
    std::shared_ptr<const typename PairPoints<D>::Times> times;
    const Contacts &start, &end, &mean;
  };
  /// A corner of a point's side.
  struct Corner {
    Vec<D> r, d;  ///< z - y, its change in the step
    double w;
  };
  /// One point, with the quantities of the formula above.
  struct Point {
    const Contact *at_end, *at_mean;
    Vec<D> d;
    std::array<Corner, corners> corner;
    double size;        ///< R^2
    double v, c;        ///< of the formula
    double rest;        ///< (e - c v)/(d . d)
    double traction;    ///< T
    double mean_slope;  ///< derivative of -T by g1
    double by_gap;      ///< derivative of e by g1; that by a is T
    double c_by_e, c_by_v;
    Vec<D> force() const { return rest * d - traction * at_mean->foot.normal; }
    /// Returns the force of a corner on the foot's other side.
    Vec<D> force(std::size_t k) const { return c * corner[k].w / size * corner[k].r; }
  };
  bool acts(const Contact& contact) const;
  Step take(const Segment& segment) const;
  bool evaluate(const Step& step, std::size_t number, Point& point) const;
  std::vector<double> weights_of(const Contact& contact) const;
  PairBlock block_of(const Step& step, const Point& point) const;
  PairBlock convex_block_of(const Point& point) const;

  const PairPoints<D>& points_;
  double stiffness_;  ///< k
};

extern template class PairGradient<2>;
extern template class PairGradient<3>;

}  // namespace ixos
