/// The history of points that slide.
#pragma once
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "state/history.hpp"

namespace ixos {

/// Returns the columns of friction's points in that dimension over these numbers, dimension + 3 at each point: the
/// traction of the elastic slip [E0], the slip so far [L0], the energy dissipated so far per area [E0 L0], and whether
/// the point slides. `places`: see PointColumns. The numbers of the last step are
/// FrictionReport::work and lag.
inline TermHistory slip_history(std::size_t dimension, const PointData& values,
                                std::vector<std::array<double, 3>> places) {
  return {{{{{"traction", ColumnKind::SurfaceVector, dimension},
             {"slip", ColumnKind::Growing, 1},
             {"dissipated", ColumnKind::Growing, 1},
             {"sliding", ColumnKind::Scalar, 1}},
            values,
            std::move(places)}},
          {},
          {0, 0}};
}

}  // namespace ixos
