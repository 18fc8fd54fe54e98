/// Sides before a flat wall: from displacements to gaps, and from gaps' forces back.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "interaction/half_space.hpp"
#include "term/wall/surface_sides.hpp"

namespace ixos {

/// Nodal arrays of a batch of sides are gaps, or changes along the wall's normal, see SurfaceKernel.
template <class SideElement>
class FlatSides : public SurfaceSides<SideElement> {
  using Base = SurfaceSides<SideElement>;

 public:
  using Base::batches;
  using Base::D;
  using Base::N;
  using Nodal = std::array<Pack, N>;

  FlatSides(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern, const HalfSpace& wall,
            int points)
      : Base(mesh, sides, pattern, points), wall_(wall) {
    double origin = 0;
    for (std::size_t d = 0; d < D; ++d) origin += wall.point[d] * wall.normal[d];
    for (std::size_t b = 0; b < this->size(); ++b) {
      reference_gap_.push_back(along_normal(this->reference(b)));
      // A derivative has no distance from the origin.
      for (std::size_t a = 0; a < Base::places; ++a) reference_gap_.back()[a] -= origin;
    }
  }

  const std::array<double, 3>& normal() const { return wall_.normal; }

  /// Returns the gaps at displacement u, and the change of the gaps under a change of u.
  Nodal gaps_of(std::size_t b, const double* u) const {
    Nodal gap = change_of(b, u);
    for (std::size_t a = 0; a < N; ++a) gap[a] += reference_gap_[b][a];
    return gap;
  }
  Nodal change_of(std::size_t b, const double* local) const {
    Small<Pack, N, D> values;
    batches().gather(b, local, values);
    return along_normal(values);
  }

  /// Returns the vectors of that length along the normal.
  Small<Pack, N, D> from_normal(const Nodal& along) const {
    Small<Pack, N, D> result;
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d) result[a][d] = along[a] * wall_.normal[d];
    return result;
  }
  /// Sets a matrix on such vectors from the one on their lengths.
  template <std::size_t Nodes>
  void spread(const Small<Pack, Nodes>& along, Small<Pack, Nodes * D>& matrix) const {
    for (std::size_t r = 0; r < Nodes * D; ++r)
      for (std::size_t c = 0; c < Nodes * D; ++c)
        matrix[r][c] = along[r / D][c / D] * (wall_.normal[r % D] * wall_.normal[c % D]);
  }

 private:
  Nodal along_normal(const Small<Pack, N, D>& vectors) const {
    Nodal result;
    for (std::size_t a = 0; a < N; ++a) {
      result[a] = vectors[a][0] * wall_.normal[0];
      for (std::size_t d = 1; d < D; ++d) result[a] += vectors[a][d] * wall_.normal[d];
    }
    return result;
  }

  HalfSpace wall_;
  std::vector<Nodal> reference_gap_;
};

}  // namespace ixos
