/// Viscosity of one block.
#pragma once
#include <memory>
#include <vector>

#include "base/symmetric_tensor.hpp"
#include "discretization/pattern.hpp"
#include "material/hooke.hpp"
#include "mesh/local_mesh.hpp"
#include "term/rate_term.hpp"

namespace ixos {

/// The viscosity of a block. A TermHistory keeps the energy that it has dissipated at each quadrature point.
class Viscosity : public RateTerm {
 public:
  bool is_diagonal() const final { return false; }
  /// Sets, for each local cell of the block, the mean density of the energy dissipated so far [E0].
  virtual void cell_dissipation(const TermHistories& histories, std::vector<double>& density) const = 0;
  /// Adds, for each local cell of the block, the mean viscous Cauchy stress J^-1 F S F^T of a displacement and a
  /// velocity over the reference volume [E0]. After a step whose force has the mean rate of strain of the step
  /// (Static), it takes that rate in place of the velocity's. The place needs its velocity.
  virtual void add_cell_stress(const Place& at, std::vector<SymmetricTensor>& stress) const = 0;
};

/// Returns the Kelvin-Voigt viscosity of one block of Standard elements; `points` as for make_elastic_term(). Mesh
/// and block must outlive it.
std::unique_ptr<Viscosity> make_viscous_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                             const Hooke& law, int points = 0);

}  // namespace ixos
