/// The elastic terms of each formulation.
#pragma once
#include <memory>

#include "term/body/elastic_term.hpp"

namespace ixos {

/// A function that makes a term, see make_elastic_term(). Separate files define those below, so that they compile
/// apart.
using ElasticTermMaker = std::unique_ptr<Elasticity>(const LocalMesh& mesh, const LocalBlock& block,
                                                     const Pattern& pattern,
                                                     const std::shared_ptr<const ElasticLaw>& law, int points);

ElasticTermMaker make_standard_term;
ElasticTermMaker make_enhanced_term;  ///< of a block that is not enriched

// Mean dilatations of plane, solid and revolved bodies.
ElasticTermMaker make_plane_dilatation_term;
ElasticTermMaker make_solid_dilatation_term;
ElasticTermMaker make_ring_dilatation_term;

}  // namespace ixos
