/// The longest step of an explicit scheme.
#pragma once
#include <vector>

#include "base/record.hpp"
#include "model/model.hpp"
#include "state/state.hpp"

namespace ixos {

/// The central difference scheme is stable for dt <= 2/(sqrt(w^2 + c^2) + c), w the highest frequency and c = 2 zeta w
/// its damping, if C acts on the extrapolated velocity (c = 0: 2/w). w^2 is bounded by the largest row sum of |M^-1 K|
/// (Gershgorin), cell by cell, so that nothing is assembled. The row sums of the elastic stiffness and c are renewed
/// every tenth step, those of the interactions at both ends of each step, because their stiffness grows tenfold within
/// one. The model must outlive it and have a lumped mass. Collective.
class StableStep {
 public:
  /// `safety`, at most 1, is the share of the bound that is used.
  StableStep(const Model& model, double safety);

  /// Returns the longest step from this state that is no longer than `wanted`. Uses the state's accelerations.
  double operator()(const State& state, double wanted);

  /// Writes or reads the state for checkpoints.
  void transfer(Record& record);

 private:
  void look_at(const Place& at);
  double limit(const Place& at) const;

  const Model& model_;
  double safety_;
  double column_bound_;          ///< largest sum of magnitudes of a tied node's weights
  double damping_ = 0;           ///< c [1/T0]
  int age_ = 0;                  ///< steps since the elastic row sums
  std::vector<double> elastic_;  ///< row sums, local
  mutable std::vector<double> sums_;
  std::vector<double> ahead_;
};

}  // namespace ixos
