/// Interaction of a surface with the surface of another body.
#pragma once
#include <memory>

#include "discretization/pattern.hpp"
#include "term/pair/pair_points.hpp"

namespace ixos {

/// Returns the term of a full pass: the law is integrated over the secondary surface, and the primary one takes the
/// reaction, so that the net force and the net moment vanish to rounding. Reports, gaps and pressures are those of the
/// secondary surface. It follows rules with points, and the discrete gradient of PairGradient. The law must not have a
/// history. Its matrix entries go to nodes that the pattern couples, see PairCoupling; the others are left out. Mesh
/// and pattern must outlive the term.
template <std::size_t D>
std::unique_ptr<Interaction> make_pair_term(const LocalMesh& mesh, PairSurfaces<D> surfaces, const Pattern& pattern,
                                            std::shared_ptr<const GapLaw> law, const PairOptions& options);

}  // namespace ixos
