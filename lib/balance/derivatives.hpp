/// Derivatives of the balance by what is no unknown: time, and numbers of terms.
#pragma once
#include <string>
#include <vector>

#include "balance/balance.hpp"

namespace ixos {

/// A number that terms name, see ForceTerm::parameters(): "Modulus Factor" of a block, "Law Factor" of an interaction.
struct TermParameter {
  std::string term;  ///< the name of a block, an interaction or a grip
  std::string name;
};

/// For sensitivities, adjoints and paths. All displacements, velocities and accelerations are kept. The model must
/// outlive it. Results are valid in owned rows.
class BalanceDerivatives {
 public:
  explicit BalanceDerivatives(const Model& model) : model_(model) {}

  /// Returns the numbers of all terms, each once, equal on all ranks. An interaction with friction has none yet: its
  /// threshold depends on the law.
  std::vector<TermParameter> parameters() const;
  /// Sets df, a local array, to the derivative of the forces of a point by the number. Returns false if the point is
  /// inadmissible on this rank. Throws std::logic_error if parameters() has no such number, and for a point with rates:
  /// the derivatives of damping forces are not there yet. [that of a force over that of the number]
  bool by_parameter(const BalancePoint& at, const TermParameter& parameter, double* df) const;

  /// Returns whether by_time() has the derivative: all terms have theirs, and the rates of all loads are those of their
  /// values at the end of the point's way. An expression without a rate, and a load that jumps there, have none.
  /// Collective.
  bool has_time_derivative(const BalancePoint& at) const;
  /// Sets df, a local array, to the derivative of forces less loads by time, the loads those at the end of the point's
  /// way: obstacles and driven ends move, loads change [E0 L0^(D-1)/T0]. Prescribed degrees of freedom are unknowns
  /// here. Throws std::logic_error unless has_time_derivative(). Collective.
  void by_time(const BalancePoint& at, double* df) const;

 private:
  const Segment& segment(const BalancePoint& at, const ForceTerm& term) const {
    return term.part() == Part::Elastic ? at.elastic : at.interaction;
  }
  const Rule& rule(const BalancePoint& at, const ForceTerm& term) const {
    return term.part() == Part::Elastic ? *at.elastic_rule : *at.interaction_rule;
  }
  bool loads_know_rates(double time, double span) const;

  const Model& model_;
};

}  // namespace ixos
