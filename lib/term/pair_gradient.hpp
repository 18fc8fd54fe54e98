/// The discrete gradient of the energy of two surfaces.
#pragma once
#include <functional>
#include <vector>

#include "term/pair_points.hpp"

namespace ixos {

/// At each point, with the foot, the normal m and the weights S of the relative position at the mean of both ends'
/// places, d = S dx, a = m . d and the mean T of the traction over the gaps g0 to g1, the force is S t with
///
///   t = (-T + C) m + (e - C a)/(d . d) d,   e = psi(g1) - psi(g0) + T a.
///
/// Its work in the step is the change of the energy, and its net force vanishes. C = e/a makes the net moment about the
/// mean places vanish, too (Sauer and De Lorenzis 2013). That has a pole where a point slides along the other surface,
/// a = 0. Where a^2 < |e|/k, with the law's stiffness k at its equilibrium gap, C is therefore 2 k a sign(e) - k^2
/// a^3/e, and Gonzalez' (1996) vector along d does the rest of the work; its moment is of second order in d.
/// Displacements below 1e-5 of the equilibrium gap take t = -T m.
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
  using Contact = typename PairPoints<D>::Contact;
  using Contacts = typename PairPoints<D>::Contacts;
  /// All points at both ends and at the mean places of the segment.
  struct Step {
    std::shared_ptr<const typename PairPoints<D>::Times> times;
    const Contacts &start, &end, &mean;
  };
  /// One point, with the quantities of the formula above.
  struct Point {
    const Contact *at_end, *at_mean;
    Vec<D> d;
    double along;       ///< a
    double size;        ///< of t along m, -T + C
    double rest;        ///< (e - C a)/(d . d)
    double mean_slope;  ///< derivative of -T by g1
    double by_gap;      ///< derivative of e by g1; that by a is T
    double traction;    ///< T
    double c_by_e, c_by_a;
    bool whole;  ///< the displacement is not too small for C
    Vec<D> force() const { return size * at_mean->foot.normal + rest * d; }
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
