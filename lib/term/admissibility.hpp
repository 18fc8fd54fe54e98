/// Gaps, and ways of points within a step, that an interaction admits.
#pragma once
#include <array>
#include <limits>

#include "rule/rule.hpp"
#include "state/place.hpp"

namespace ixos {

/// The point of a surface that is nearest to its obstacle.
struct LowestPoint {
  double gap = std::numeric_limits<double>::infinity();  ///< [L0]
  std::array<double, 3> place{};                         ///< deformed [L0]; the third is 0 in two dimensions
};

class Admissibility {
 public:
  virtual ~Admissibility() = default;

  /// Returns whether a gap r <= 0 is inadmissible.
  virtual bool needs_positive_gaps() const = 0;

  /// Returns the largest step s <= 1 for which segment.to + s direction stays admissible with a margin.
  virtual double admissible_step(const Segment& segment, const Rule& rule, const double* direction) const = 0;

  /// Returns the largest ratio of the gaps at a quadrature point on the way of a step. Only points whose lesser gap is
  /// below ten times the equilibrium gap count. Returns 1 if the law is defined at every gap.
  virtual double gap_ratio(const Segment& way) const = 0;

  /// Returns the lowest point of this rank's sides. Quadrature points lie inside the sides, so this looks at the nodes,
  /// and between them at a grid twice as fine as the nodes of a side.
  virtual LowestPoint lowest_point(const Place& at) const = 0;
  /// Returns whether it is known, without that search, that the lowest point's gap is greater than zero.
  virtual bool is_clear(const Place& at) const = 0;

  /// Returns the end of a point of this rank's sides that surely passes through the obstacle, or through another body,
  /// on its straight way in a step, with the least gap that was found on the way; if several do, that of the deepest.
  /// The law does not notice that: it acts at the ends, or at a few points in time. An infinite gap if there is none. A
  /// moved obstacle is at its places at both ends of the way.
  virtual LowestPoint passage(const Segment& way) const = 0;
};

}  // namespace ixos
