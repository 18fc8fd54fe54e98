/// Numbers of one batch's points at the ends of a segment.
#pragma once
#include <cstddef>

#include "base/scratch.hpp"
#include "state/place.hpp"

namespace ixos {

/// Gaps, places or displacement gradients at the points of one batch of cells or sides after another.
template <class T>
class EndScratch {
 public:
  EndScratch(std::size_t points, const Segment& segment)
      : segment_(segment),
        to_(points),
        from_(segment.from != nullptr ? points : 0),
        velocity_(segment.velocity != nullptr ? points : 0) {}

  /// Computes the numbers: value(local array, numbers) of both ends, change(local array, numbers) of the velocity.
  template <class Value, class Change>
  void set(const Value& value, const Change& change) {
    value(segment_.to, to_.data());
    if (segment_.from != nullptr) value(segment_.from, from_.data());
    if (segment_.velocity != nullptr) change(segment_.velocity, velocity_.data());
  }

  std::size_t size() const { return to_.size(); }
  const T* to() const { return to_.data(); }
  /// Return null if the segment has none.
  const T* from() const { return segment_.from != nullptr ? from_.data() : nullptr; }
  const T* velocity() const { return segment_.velocity != nullptr ? velocity_.data() : nullptr; }

 private:
  const Segment segment_;
  Scratch<T> to_, from_, velocity_;
};

}  // namespace ixos
