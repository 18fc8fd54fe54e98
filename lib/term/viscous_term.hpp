/// Viscosity of one block.
#pragma once
#include <memory>
#include <vector>

#include "discretization/pattern.hpp"
#include "material/hooke.hpp"
#include "mesh/local_mesh.hpp"
#include "term/rate_term.hpp"

namespace ixos {

/// The viscosity of a block, which keeps the energy that it has dissipated at each quadrature point.
class Viscosity : public RateTerm {
 public:
  /// Sets, for each local cell of the block, the mean density of the energy dissipated so far [E0].
  virtual void cell_dissipation(std::vector<double>& density) const = 0;
};

/// Returns the Kelvin-Voigt viscosity of one block of Standard elements; `points` as for make_elastic_term().
std::unique_ptr<Viscosity> make_viscous_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                             const Hooke& law, int points = 0);

}  // namespace ixos
