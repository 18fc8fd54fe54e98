/// Displacement gradients over a segment.
#pragma once
#include <cstddef>

#include "term/body/body_cells.hpp"
#include "term/end_scratch.hpp"

namespace ixos {

/// The displacement gradients at the ends of a segment, of a batch at a time.
template <class Space>
class BatchEnds {
 public:
  using Cells = BodyCells<Space>;
  BatchEnds(const Cells& cells, const Segment& segment)
      : cells_(cells),
        at_iterate_(segment.iterate),
        way_(segment.way),
        ends_(cells.points(), segment),
        iterate_(segment.iterate != nullptr ? cells.points() : 0) {}

  /// Finds those of a batch, which hold until the next call.
  PointEnds<Pack, Space::G> of(std::size_t b) {
    const auto gradients = [&](const double* local, Small<Pack, Space::G>* h) { cells_.gradients(b, local, h); };
    ends_.set(gradients, gradients);
    if (at_iterate_ == nullptr) return {ends_.size(), ends_.to(), ends_.from(), ends_.velocity()};
    gradients(at_iterate_, iterate_.data());
    return {ends_.size(), ends_.to(), ends_.from(), ends_.velocity(), iterate_.data(), way_};
  }

 private:
  const Cells& cells_;
  const double* at_iterate_;
  double way_;
  EndScratch<Small<Pack, Space::G>> ends_;
  Scratch<Small<Pack, Space::G>> iterate_;
};

}  // namespace ixos
