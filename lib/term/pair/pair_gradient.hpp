/// The discrete gradient of the energy of two surfaces.
#pragma once
#include <array>
#include <boost/container/static_vector.hpp>
#include <functional>
#include <vector>

#include "term/pair/pair_points.hpp"

namespace ixos {

/// At each point, with the closest point y, the normal m and the weights S of the relative position r = S x at the mean
/// of both ends' places, d = S dx, a = m . d and the mean T of the traction over the gaps g0 to g1, the force is S (-T
/// m), and what lacks of the work, e = psi(g1) - psi(g0) + T a, is done by forces of three kinds,
///
///   c a m                    on S, along the normal,
///   c w_k/R^2 (z_k - y)      between y and the corners z_k of the point's own side, three of a triangle,
///   c b_j (t_j S + r N_,j)   along the closest point's tangents t_j = N_,j x, which turns them, too,
///
///   w_k = (z_k - y) . (dz_k - dy),   b_j = f (t_j . d + r . dt_j)/(t_j . t_j),   c = e/v,
///   v = a^2 + sum of w_k^2/R^2 + sum of b_j (t_j . d + r . dt_j),
///
/// with R^2 = sum of |z_k - x|^2 at the start. Each kind is the derivative of a scalar product of vectors between nodes
/// at the mean places, so the force does the change of the energy as its work, and its net force and its net moment
/// about the mean places vanish. f is 1, but falls to 0 at kinks and rims, and at the sides of the parts of a
/// triangle, so that the force is continuous where the closest point changes its patch. Where v < |e|/k, with k three
/// times the law's stiffness at its equilibrium gap, c is 2 k sign(e) - k^2 v/e, and Gonzalez' (1996) vector (e - c
/// v)/(d . d) S d does the rest of the work. Points do so that roll over a kink. Displacements below 1e-5 of the
/// equilibrium gap take -T m alone.
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
  static constexpr std::size_t corners = SurfacePatch<D>::corners;
  /// Returns whether a parameter is 1 at a corner; the corners go around the patch.
  static bool at_end(std::size_t corner, std::size_t parameter) {
    return parameter == 0 ? corner == 1 || corner == 2 : corner >= 2;
  }
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
  /// A free parameter of the closest point.
  struct Along {
    std::size_t parameter;
    Vec<D> t, way;  ///< t_j and dt_j
    double change;  ///< t_j . d + r . dt_j
    double square;  ///< t_j . t_j
    double b;
  };
  /// One point, with the quantities of the formula above.
  struct Point {
    const Contact *at_end, *at_mean;
    Vec<D> r, d;
    boost::container::static_vector<Corner, corners> corner;  ///< of the point's side, not of its patch
    boost::container::static_vector<Along, D - 1> along;
    double f;
    PatchParameters<D> f_slopes;  ///< by parameter
    double size;                  ///< R^2
    double a, v, c;               ///< of the formula
    double rest;                  ///< (e - c v)/(d . d)
    double traction;              ///< T
    double mean_slope;            ///< derivative of -T by g1
    double by_gap;                ///< derivative of e by g1; that by a is T
    double c_by_e, c_by_v;
    /// Returns the force on S.
    Vec<D> force() const {
      Vec<D> sum = rest * d + (c * a - traction) * at_mean->projection.normal;
      for (const Along& j : along) sum = sum + c * j.b * j.t;
      return sum;
    }
    /// Returns the force of a corner on the closest point's other side.
    Vec<D> force(std::size_t k) const { return c * corner[k].w / size * corner[k].r; }
    /// Returns the force that N_,j takes.
    Vec<D> turn(const Along& j) const { return c * j.b * r; }
  };
  Step take(const Segment& segment) const;
  bool evaluate(const Step& step, std::size_t number, Point& point) const;
  /// Sets c and the rest of the work, from e and v.
  void share(double e, Point& point) const;
  /// Sets f and its derivatives at a place of a primary patch.
  void fade(std::size_t patch, const PatchParameters<D>& xi, Point& point) const;
  using Weights = boost::container::static_vector<double, PairGap<D>::most>;
  Weights weights_of(const Contact& contact) const;
  void set_block(const Step& step, const Point& point, PairBlock& block) const;
  void set_convex_block(const Point& point, PairBlock& block) const;

  const PairPoints<D>& points_;
  double stiffness_;  ///< k
  /// By patch of the primary surface and corner: whether f is 0 there: a side with a kink or a rim ends, or it is the
  /// middle of a triangle.
  std::vector<std::array<bool, corners>> kinks_;
  // Memory, so that Newton iterations need no new one.
  mutable std::vector<typename PairPoints<D>::Places> places_;
  mutable PairBlock block_;
};

extern template class PairGradient<2>;
extern template class PairGradient<3>;

}  // namespace ixos
