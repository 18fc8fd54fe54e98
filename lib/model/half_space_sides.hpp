/// Sides of one element type before a flat wall: from displacements to gaps, and from gaps' forces back.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "fem/cell_types.hpp"
#include "interaction/half_space.hpp"
#include "mesh/local_mesh.hpp"
#include "model/element_batches.hpp"

namespace ixos {

/// Nodal arrays of a batch of sides are gaps, or changes along the wall's normal, see SurfaceKernel.
template <class SideElement>
class HalfSpaceSides {
 public:
  static constexpr std::size_t D = SideElement::dimension + 1;
  static constexpr std::size_t N = SideElement::nodes;
  using Nodal = std::array<Pack, N>;

  /// `points`: Gauss points a direction; 0: 5, but 8 on sides of order 3 or more.
  HalfSpaceSides(const LocalMesh& mesh, const std::vector<LocalSide>& sides, const Pattern& pattern,
                 const HalfSpace& wall, int points)
      : wall_(wall),
        quadrature_(counts(points), ties(mesh, sides)),
        batches_(node_table(sides), pattern, scale_table(mesh, sides)) {
    double origin = 0;
    for (std::size_t d = 0; d < D; ++d) origin += wall.point[d] * wall.normal[d];
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      Small<Pack, N, D> x;
      batches_.gather(b, mesh.coordinates.data(), x);
      reference_gap_.push_back(along_normal(x));
      // The other nodes of a Hermite side are derivatives: no place, and no distance from the origin.
      for (std::size_t a = 0; a < places; ++a) reference_gap_.back()[a] -= origin;
      for (std::size_t q = 0; q < quadrature_.size(); ++q) measure_.push_back(quadrature_.weight[q] * stretch(x, q));
      owned_.emplace_back([&](auto lane) {
        return lane < batches_.lanes(b) && sides[b * static_cast<std::size_t>(pack_width) + lane].owned ? 1.0 : 0.0;
      });
    }
  }

  const ShapeTable<SideElement>& quadrature() const { return quadrature_; }
  const ElementBatches<N, D>& batches() const { return batches_; }
  std::size_t size() const { return batches_.size(); }  ///< batches
  const std::array<double, 3>& normal() const { return wall_.normal; }
  /// Returns quadrature weight times reference length or area, by quadrature point.
  const Pack* measure(std::size_t b) const { return &measure_[b * quadrature_.size()]; }
  /// Returns 1 for sides that count on this rank, otherwise 0.
  const Pack& owned(std::size_t b) const { return owned_[b]; }

  /// Returns the gaps at displacement u, and the change of the gaps under a change of u.
  Nodal gaps_of(std::size_t b, const double* u) const {
    Nodal gap = change_of(b, u);
    for (std::size_t a = 0; a < N; ++a) gap[a] += reference_gap_[b][a];
    return gap;
  }
  Nodal change_of(std::size_t b, const double* local) const {
    Small<Pack, N, D> values;
    batches_.gather(b, local, values);
    return along_normal(values);
  }

  /// Returns the vectors of that length along the normal.
  Small<Pack, N, D> from_normal(const Nodal& along) const {
    Small<Pack, N, D> result;
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t d = 0; d < D; ++d) result[a][d] = along[a] * wall_.normal[d];
    return result;
  }

 private:
  static constexpr std::size_t places = IsHermite<SideElement>::value ? std::size_t{1} << (D - 1) : N;

  static std::array<int, D - 1> counts(int points) {
    std::array<int, D - 1> result;
    const int own = SideElement::default_points[0] > 3 ? 8 : 5;  // beyond order 2 more
    result.fill(points > 0 ? points : own);
    return result;
  }

  /// Returns the tied edges, which are the same for all sides.
  static unsigned ties(const LocalMesh& mesh, const std::vector<LocalSide>& sides) {
    if (sides.empty()) return 0;
    return side_ties(mesh.blocks[static_cast<std::size_t>(sides.front().block)], sides.front().side);
  }

  static std::vector<double> scale_table(const LocalMesh& mesh, const std::vector<LocalSide>& sides) {
    std::vector<double> scales;
    if (places == N) return scales;
    for (const LocalSide& side : sides)
      for (std::size_t a = 0; a < N; ++a)
        scales.push_back(side_node_scale(mesh.blocks[static_cast<std::size_t>(side.block)], side.cell, side.side, a));
    return scales;
  }

  static std::vector<int> node_table(const std::vector<LocalSide>& sides) {
    std::vector<int> nodes;
    for (const LocalSide& side : sides) nodes.insert(nodes.end(), side.nodes.begin(), side.nodes.end());
    return nodes;
  }

  Nodal along_normal(const Small<Pack, N, D>& vectors) const {
    Nodal result;
    for (std::size_t a = 0; a < N; ++a) {
      result[a] = vectors[a][0] * wall_.normal[0];
      for (std::size_t d = 1; d < D; ++d) result[a] += vectors[a][d] * wall_.normal[d];
    }
    return result;
  }

  /// Returns the reference length or area per unit of the reference side at quadrature point q.
  Pack stretch(const Small<Pack, N, D>& x, std::size_t q) const {
    Small<Pack, D - 1, D> tangent{};
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t k = 0; k + 1 < D; ++k)
        for (std::size_t d = 0; d < D; ++d) tangent[k][d] += quadrature_.gradient[q][a][k] * x[a][d];
    Pack square = 0.0;
    if constexpr (D == 2) {
      square = tangent[0][0] * tangent[0][0] + tangent[0][1] * tangent[0][1];
    } else {
      for (std::size_t d = 0; d < 3; ++d) {
        const std::size_t e = (d + 1) % 3, f = (d + 2) % 3;
        const Pack component = tangent[0][e] * tangent[1][f] - tangent[0][f] * tangent[1][e];
        square += component * component;
      }
    }
    return std::experimental::sqrt(square);
  }

  HalfSpace wall_;
  ShapeTable<SideElement> quadrature_;
  ElementBatches<N, D> batches_;
  std::vector<Nodal> reference_gap_;
  std::vector<Pack> measure_;  ///< batches x quadrature points
  std::vector<Pack> owned_;
};

}  // namespace ixos
