/// The points of a batch of sides along a segment.
#pragma once
#include <cstddef>

#include "interaction/obstacle.hpp"
#include "rule/rule.hpp"
#include "term/end_scratch.hpp"
#include "term/wall/wall_sides.hpp"

namespace ixos {

/// Vectors at the points of one batch after another at the ends of a segment.
template <std::size_t D>
class SideEnds {
 public:
  /// Selects the vectors.
  enum class Of { Places, Displacements };

  SideEnds(const CurvedWallSides<D>& sides, Of of, const Segment& segment)
      : sides_(sides), of_(of), ends_(sides.points(), segment) {}

  /// Finds those of a batch, which hold until the next call.
  void set(std::size_t b) {
    ends_.set(
        [&](const double* u, PackPoint* x) {
          if (of_ == Of::Places)
            sides_.places(b, u, x);
          else
            sides_.changes(b, u, x);
        },
        [&](const double* change, PackPoint* x) { sides_.changes(b, change, x); });
  }

  const PackPoint& to(std::size_t q) const { return ends_.to()[q]; }
  /// Returns it at the start. The segment must have one.
  const PackPoint& from(std::size_t q) const { return ends_.from()[q]; }
  /// Returns it at a time point.
  PackPoint at(std::size_t q, const RulePoint& point) const {
    PackPoint x = to(q);
    for (Pack& component : x) component *= point.to;
    if (ends_.from() != nullptr) add(point.from, from(q), x);
    if (ends_.velocity() != nullptr) add(point.velocity, ends_.velocity()[q], x);
    return x;
  }

 private:
  static void add(double factor, const PackPoint& part, PackPoint& x) {
    for (std::size_t i = 0; i < 3; ++i) x[i] += factor * part[i];
  }

  const CurvedWallSides<D>& sides_;
  Of of_;
  EndScratch<PackPoint> ends_;
};

}  // namespace ixos
