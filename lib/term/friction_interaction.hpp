/// What all terms of friction have in common.
#pragma once
#include "term/interaction.hpp"

namespace ixos {

/// Friction beside the term of its law: it limits no step, and gaps and pressures are the other term's.
class FrictionInteraction : public Interaction {
 public:
  bool has_friction() const final { return true; }
  bool dissipates() const final { return true; }
  bool has_state() const final { return true; }
  bool has_history() const final { return true; }

  /// The mean over the path in closed form, for all rules that average over it.
  const Rule& followed(const Rule& rule) const final {
    static const Rule mean = exact_rule();
    return rule.is_path_mean() ? mean : rule;
  }

  double admissible_step(const Segment&, const Rule&, const double*) const final { return 1; }
  double gap_ratio(const double*, const double*) const final { return 1; }
  LowestPoint lowest_point(const double*) const final { return {}; }
  void add_nodal_pressure(const double*, double*) const final {}
  void lower_nodal_gap(const double*, double*) const final {}
  void set_nodal_normal(const double*, double*) const final {}
};

}  // namespace ixos
