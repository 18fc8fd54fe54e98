/// Elasticity of one block.
#pragma once
#include <memory>

#include "material/lame.hpp"
#include "mesh/local_mesh.hpp"
#include "model/pattern.hpp"
#include "model/term.hpp"

namespace ixos {

enum class ElasticLaw { NeoHooke, Linear };

/// The term for one block, its cells in SIMD batches. The caller has checked the mesh (see check_cells). `points`:
/// Gauss points a direction of elements that are not enriched, 0 for the element's own number; an enriched block says
/// its own.
std::unique_ptr<Term> make_elastic_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                        ElasticLaw law, const Lame& lame, int points = 0);

}  // namespace ixos
