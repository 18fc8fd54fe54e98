/// Mass, consistent or lumped.
#pragma once
#include <array>
#include <vector>

#include "discretization/pattern.hpp"
#include "mesh/local_mesh.hpp"

namespace ixos {

/// How a model resists acceleration. A static model has no mass and no damping: neither is allocated.
enum class Inertia { Consistent, Lumped, None };

/// M_ab I with M_ab = int rho N_a N_b dV: one number for each node pair of the Pattern, rows of owned nodes only.
/// Lumped: its row sums on the diagonal, which keep the body's mass and its first moments. A quadratic cell adds its
/// own diagonal instead, scaled to its mass (Hinton, Rock and Zienkiewicz 1976): on parallelepipeds these are the row
/// sums, which are Simpson's weights; on curved cells and rings at the axis, where row sums may vanish, they stay
/// positive. Units E0 T0^2 L0^(D-2).
///
/// Masters take over the mass of what follows them: with tied nodes it is C^T M C (see NodeTies), lumped its row sums.
class Mass {
 public:
  Mass(const LocalMesh& mesh, const Pattern& pattern, bool lumped = false);

  bool is_lumped() const { return lumped_; }

  /// Adds a block of the given density [E0 T0^2/L0^2]. Exact for quadrilaterals with straight sides and for
  /// parallelepipeds. Throws InputError if the mass of Hermite elements is to be lumped.
  /// The block must outlive the mass.
  void add_block(const LocalBlock& block, double density);
  /// Throws InputError, on this rank, if ties leave an owned node no lumped mass, for negative weights.
  void check_lumped() const;
  /// Computes the mass anew in a pattern that has changed.
  void place();

  /// Sets y = M x: x local (with ghosts), y the rows of owned nodes.
  void multiply(const double* x, double* y) const;
  /// Adds factor times M's diagonal to d, rows of owned nodes.
  void add_diagonal(double factor, double* d) const;
  /// Adds factor M to values, in the layout of Pattern::create_matrix.
  void add_to(double factor, double* values) const;
  /// Sets values to factor M: add_to() without the need to clear them before.
  void set(double factor, double* values) const;
  /// Computes x = M^-1 y, and the largest y_i/M_i. Lumped masses only, rows of owned nodes.
  void divide(const double* y, double* x) const;
  double largest_quotient(const double* y) const;

 private:
  const LocalMesh& mesh_;
  const Pattern& pattern_;
  void integrate(const LocalBlock& block, double density);

  bool lumped_;
  struct Body {
    const LocalBlock* block;
    double density;
  };
  std::vector<Body> bodies_;
  std::vector<double> pairs_;  ///< by node pair; lumped: by owned node
};

}  // namespace ixos
