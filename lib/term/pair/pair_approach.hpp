/// How far two surfaces may approach each other, and where they are nearest.
#pragma once
#include "term/pair/pair_points.hpp"

namespace ixos {

/// Bounds on the motion of two surfaces, or of parts of one, and their lowest point: see
/// Admissibility::admissible_step() and lowest_point().
template <std::size_t D>
class PairApproach {
 public:
  using Places = typename PairPoints<D>::Places;
  using Contact = typename PairPoints<D>::Contact;

  /// `margin`: see PairOptions. The points must outlive it.
  PairApproach(const PairPoints<D>& points, double margin);

  /// Returns an s in [0, 1], nearly the largest, for which the gaps at all places + s share ways surely have the
  /// margin. Follows the surfaces in up to 8 parts, each as long as no gap can have fallen to its least one: the bound
  /// of a part does not know the direction of the motion. `shares`: of each place.
  double free_step(const std::vector<Places>& times, const Places& ways, const std::vector<double>& shares) const;
  /// Returns the lowest point of the surfaces, also on the straight way from `start`, if that is given: a scheme that
  /// looks at the end of a step only can find a state in which the bodies have passed through each other. It looks as
  /// often as the bodies move by the longest side of a surface relative to each other, at most 10,000 times.
  LowestPoint lowest_point(const Places& x, const Places* start) const;
  /// Returns whether lowest_point() would surely find a gap greater than zero, because both surfaces are closed and
  /// have moved less than the gap that it found last. The gap of a point that passes below a free rim jumps.
  bool is_clear(const Places& x, const Places* start) const;

 private:
  /// Lowers the lowest point to the nodes and the middles of the sides of both surfaces before the other one.
  void lower_both(const Places& x, LowestPoint& lowest) const;
  /// Lowers it to the points at which forces act: the other searches look for the deepest overlap only as far as the
  /// longest side.
  void lower_to_points(const Places& x, LowestPoint& lowest) const;
  /// Lowers it to the corners and middles of the patches of a surface before what they see of it.
  void lower_to_itself(const Places& x, LowestPoint& lowest) const;
  void lower_on_the_way(const Places& from, const Places& to, LowestPoint& lowest) const;
  /// Returns a lower bound on the point's gap.
  double gap_of(const Contact& c) const { return c.projection.patch < 0 ? points_.law().range() : c.projection.gap; }
  /// Returns the largest s in [0, 1] for contacts that move along the ways.
  double free_share(const typename PairPoints<D>::Contacts& contacts, const Places& ways) const;
  /// Returns the point's place along its own patch at the given values of the surface's nodes.
  Vec<D> interpolate(const Contact& contact, const std::vector<Vec<D>>& values) const;

  const PairPoints<D>& points_;
  double margin_;
  bool is_closed_ = true;     ///< neither surface has a free rim
  mutable double found_ = 0;  ///< the gap that lowest_point() found last at `looked_`, 0 if there is none
  mutable Places looked_;
  /// Memory, so that free_step() needs no new one.
  struct Memory {
    std::vector<Places> ends, part, covered;
    std::vector<std::size_t> order;
    Places ways;
  };
  mutable Memory memory_;
};

extern template class PairApproach<2>;
extern template class PairApproach<3>;

}  // namespace ixos
