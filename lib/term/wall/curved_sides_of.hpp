/// Makes sides before an obstacle of any shape; included only where they are made.
#pragma once
#include <cstddef>
#include <memory>

#include "term/wall/curved_sides.hpp"
#include "term/wall/point_matrices.hpp"
#include "term/wall/sides_of.hpp"

namespace ixos {

template <class SideElement>
auto CurvedSides<SideElement>::create_matrices() const -> std::unique_ptr<typename Interface::Matrices> {
  return std::make_unique<PointMatrices<SideElement>>(*this);
}

template <std::size_t D>
std::unique_ptr<CurvedWallSides<D>> make_curved_sides(const LocalMesh& mesh, const SideGroup& group,
                                                      const Pattern& pattern, int points) {
  return sides_of<D, CurvedSides, CurvedWallSides<D>>(group, mesh, group.sides, pattern, points);
}

}  // namespace ixos
