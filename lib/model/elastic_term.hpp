/// Elasticity of one block.
#pragma once
#include <memory>

#include "material/lame.hpp"
#include "mesh/local_mesh.hpp"
#include "model/pattern.hpp"
#include "model/term.hpp"

namespace ixos {

enum class ElasticLaw { NeoHooke, Linear };

/// The term for one block, its cells in SIMD batches. Throws InputError where a cell's reference volume is not positive
/// at some quadrature point; the message names the cell (its number in the block on this rank, from 1).
std::unique_ptr<Term> make_elastic_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                        ElasticLaw law, const Lame& lame);

}  // namespace ixos
