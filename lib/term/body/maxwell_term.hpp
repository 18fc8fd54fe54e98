/// Viscoelasticity of one block.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "base/symmetric_tensor.hpp"
#include "discretization/pattern.hpp"
#include "material/maxwell_branch.hpp"
#include "mesh/local_mesh.hpp"
#include "term/force_term.hpp"

namespace ixos {

/// This rank's integrals over the reference volume of squares at the end of an accepted step, at small strains, where
/// half of mu (Cb - Ci) is a branch's stress.
struct BranchSquares {
  std::vector<double> branches;  ///< of each stress [E0^2 L0^D]
  double sum = 0;                ///< of the sum of the stresses [E0^2 L0^D]
  double strain = 0;             ///< of half of Cb - I [L0^D]
};

/// The Maxwell branches of a block, beside its elasticity. A segment that has a length is a stage's: its force is the
/// gradient of the incremental potential E_n of MaxwellBranch over StageStart::mean_time, with the history at the
/// step's start. Over a segment without a length, histories are frozen: forces are those of the stored energy, which
/// energy() is.
///
/// accept() books D = [E_n(u) - energy after the step] - [E_n(u_n) - energy before it], E_n of the last stage. With the
/// mean of grad E_n over the straight path, work is the change of energy plus D (Ortiz and Stainier 1999); for other
/// rules D is a report, of the order of the history's error.
class Viscoelasticity : public ForceTerm {
 public:
  Part part() const final { return Part::Elastic; }
  bool has_time_derivative(const Rule&) const final { return true; }
  /// Adds the diagonal of the tangent at a displacement, histories frozen, to a local array.
  virtual void add_diagonal(const Place& at, double* diagonal) const = 0;
  /// Adds, for each local cell of the block, the mean density of the energy dissipated so far [E0]; makes an empty
  /// array one of zeros first.
  virtual void add_cell_dissipation(const TermHistories& histories, std::vector<double>& density) const = 0;
  /// Returns this rank's integral over the reference volume of the squared error [E0^2 L0^D] that a step between
  /// two displacements makes in half the sum of mu Ci: that of the stress at small strains. Then the volume.
  virtual std::array<double, 2> squared_error(const Segment& step) const = 0;
  /// Returns the squares of the step that was accepted last; no checkpoint holds them.
  virtual BranchSquares last_squares(const TermHistories& histories) const = 0;
  /// Adds, for each local cell of the block, the mean density of the stored energy [E0].
  virtual void add_cell_energy(const Place& at, std::vector<double>& density) const = 0;
  /// Adds, for each local cell of the block, the mean Cauchy stress over the reference volume [E0].
  virtual void add_cell_stress(const Place& at, std::vector<SymmetricTensor>& stress) const = 0;
};

/// Returns the branches of one block of Standard or Mean Dilatation elements; `points` as for make_elastic_term().
std::unique_ptr<Viscoelasticity> make_maxwell_term(const LocalMesh& mesh, const LocalBlock& block,
                                                   const Pattern& pattern, const std::vector<MaxwellBranch>& branches,
                                                   HistoryUpdate update = HistoryUpdate::BackwardEuler, int points = 0);

}  // namespace ixos
