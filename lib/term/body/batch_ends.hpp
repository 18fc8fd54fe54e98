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
  BatchEnds(const Cells& cells, const Segment& segment) : cells_(cells), ends_(cells.points(), segment) {}

  /// Finds those of a batch, which hold until the next call.
  PointEnds<Pack, Space::G> of(std::size_t b) {
    const auto gradients = [&](const double* local, Small<Pack, Space::G>* h) { cells_.gradients(b, local, h); };
    ends_.set(gradients, gradients);
    return {ends_.size(), ends_.to(), ends_.from(), ends_.velocity()};
  }

 private:
  const Cells& cells_;
  EndScratch<Small<Pack, Space::G>> ends_;
};

}  // namespace ixos
