/// Elasticity of one block.
#pragma once
#include <memory>

#include "material/lame.hpp"
#include "mesh/local_mesh.hpp"
#include "model/pattern.hpp"
#include "model/term.hpp"

namespace ixos {

enum class ElasticLaw { NeoHooke, Linear };

/// The element's energy. All of them are functions of the displacement alone.
enum class Formulation {
  Standard,        ///< ElasticKernel: locks if nearly incompressible, and in bending
  MeanDilatation,  ///< MeanDilatationKernel: cures the first, of all cell types
  Enhanced         ///< EnhancedKernel: cures both if pressures are moderate; enriched cells stay Standard
};

/// Returns the term for one block, its cells in SIMD batches. The caller has checked the mesh (see check_cells).
/// `points`: Gauss points a direction of elements that are not enriched, 0 for the element's own number; an enriched
/// block gives its own number. All but Standard accept no rule with Mean::DiscreteGradient; Enhanced needs two points
/// or more.
std::unique_ptr<Term> make_elastic_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                        ElasticLaw law, const Lame& lame, int points = 0,
                                        Formulation formulation = Formulation::Standard);

}  // namespace ixos
