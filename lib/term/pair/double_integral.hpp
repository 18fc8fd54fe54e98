/// Interaction of two surfaces by all pairs of their area elements.
#pragma once
#include <memory>

#include "geometry/pair_search.hpp"
#include "interaction/pair_kernel.hpp"
#include "term/interaction.hpp"

namespace ixos {

/// Returns the interaction with the energy of both surfaces, the sum of (a1 . a2) W(r) over all pairs of their points,
/// a the vectors of SurfaceElements: the one of two bodies if the surfaces are closed, for any curvature. The density
/// of the deformed bodies is that of the law. The work grows with the product of the numbers of points, `points` (0: 5)
/// per direction on each side, and the matrix is dense: it is a reference for small surfaces. Points must lie closer to
/// each other than a third of the gap.
///
/// `distance`: the interaction of the same surfaces by the least distance. It says which gaps and steps are admissible,
/// and it reports gaps, normals, pressures, measures and rounding. Energy and force are those of the double integral.
/// It follows rules with points. A rank evaluates the secondary sides near its nodes, all of them if it owns a node of
/// the primary surface. Mesh, surfaces and pattern must outlive the term.
template <std::size_t D>
std::unique_ptr<Interaction> make_double_integral(const LocalMesh& mesh, PairSurfaces<D> surfaces,
                                                  const Pattern& pattern, std::unique_ptr<Interaction> distance,
                                                  const PairKernel<D>& kernel, int points);

}  // namespace ixos
