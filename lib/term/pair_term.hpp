/// Interaction of a surface with the surface of another body.
#pragma once
#include <memory>

#include "discretization/pattern.hpp"
#include "term/pair_points.hpp"

namespace ixos {

/// Returns the term of a full pass: the law is integrated over the secondary surface, and the primary one takes the
/// reaction, so that the net force and the net moment vanish to rounding. Reports, gaps and pressures are those of the
/// secondary surface. It follows rules with points only (Mean::Points). The law must not have a history. The nodes of
/// both surfaces must be coupled in the pattern with each other; mesh and pattern must outlive the term.
std::unique_ptr<Interaction> make_pair_term(const LocalMesh& mesh, SideCurves secondary, SideCurves primary,
                                            const Pattern& pattern, std::shared_ptr<const GapLaw> law,
                                            const PairOptions& options);

}  // namespace ixos
