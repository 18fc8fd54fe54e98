/// Consistent mass.
#pragma once
#include <array>
#include <vector>

#include "mesh/local_mesh.hpp"
#include "model/pattern.hpp"

namespace ixos {

/// M_ab I with M_ab = int rho N_a N_b dV: one number for each node pair of the Pattern, rows of owned nodes only.
/// Units E0 T0^2 L0^(D-2).
class Mass {
 public:
  Mass(const LocalMesh& mesh, const Pattern& pattern);

  /// Adds a block of the given density [E0 T0^2/L0^2]. Exact for quadrilaterals with straight sides and for
  /// parallelepipeds.
  void add_block(const LocalBlock& block, double density);

  /// y = M x: x local (with ghosts), y the rows of owned nodes.
  void multiply(const double* x, double* y) const;
  /// values += factor M, in the layout of Pattern::create_matrix.
  void add_to(double factor, double* values) const;
  /// Sum of M_aa over this rank's owned nodes.
  double trace() const;

 private:
  const LocalMesh& mesh_;
  const Pattern& pattern_;
  std::vector<double> pairs_;
};

}  // namespace ixos
