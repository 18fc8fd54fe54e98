/// Quadrature points of a cell as a law sees them: many at once.
#pragma once
#include <cstddef>

#include "base/small_matrix.hpp"
#include "material/meridian_moduli.hpp"
#include "material/spatial_tangent.hpp"
#include "rule/rule.hpp"

namespace ixos {

/// The spaces in which bodies deform. Displacement gradients are G x G, of which moduli connect C components.
struct PlaneSpace {  ///< plane strain
  static constexpr std::size_t G = 2, C = 4;
  static constexpr bool is_ring = false;
};
struct SolidSpace {
  static constexpr std::size_t G = 3, C = 9;
  static constexpr bool is_ring = false;
};
struct RingSpace {  ///< bodies of revolution, see RevolvedLaw
  static constexpr std::size_t G = 3, C = meridian_size;
  static constexpr bool is_ring = true;
};

/// Displacement gradients of points at the ends of a segment. `from` and `velocity` (h v_from) are null if the rule
/// uses neither.
template <class T, std::size_t G>
struct PointEnds {
  std::size_t size = 0;
  const Small<T, G>* to = nullptr;
  const Small<T, G>* from = nullptr;
  const Small<T, G>* velocity = nullptr;
  const Small<T, G>* iterate = nullptr;  ///< see Segment; null for the derivatives of forces
  double way = 1;                        ///< see Segment

  /// Returns `count` of the points, from the one of number `first` on.
  PointEnds part(std::size_t first, std::size_t count) const {
    const auto part_of = [&](const Small<T, G>* end) { return end == nullptr ? nullptr : end + first; };
    return {count, to + first, part_of(from), part_of(velocity), part_of(iterate), way};
  }

  /// Returns the displacement gradient of a point at a time point of a rule.
  [[gnu::always_inline]] Small<T, G> at(std::size_t q, const RulePoint& point) const { return at(to, q, point); }
  /// Returns the same of the iterate.
  Small<T, G> iterate_at(std::size_t q, const RulePoint& point) const { return at(iterate, q, point); }

 private:
  [[gnu::always_inline]] Small<T, G> at(const Small<T, G>* end, std::size_t q, const RulePoint& point) const {
    Small<T, G> h;
    for (std::size_t i = 0; i < G; ++i)
      for (std::size_t j = 0; j < G; ++j) {
        h[i][j] = point.to * end[q][i][j];
        if (from != nullptr) h[i][j] += point.from * from[q][i][j];
        if (velocity != nullptr) h[i][j] += point.velocity * velocity[q][i][j];
      }
    return h;
  }
};

/// A point in the deformed body: F^-1 and the moduli there.
template <class T, std::size_t G>
struct SpatialState {
  Small<T, G> inverse;
  SpatialTangent<T> moduli;
};

}  // namespace ixos
