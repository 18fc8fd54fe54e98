/// The base of all terms of friction.
#pragma once
#include "term/interaction.hpp"

namespace ixos {

/// Friction beside the term of its law: it limits no step, and gaps and pressures are the other term's.
class FrictionInteraction : public Interaction, public Admissibility, public SurfaceReport {
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
  bool follows(Mean) const final { return true; }
  bool has_time_derivative(const Rule&) const final { return true; }

  const Admissibility& admissibility() const final { return *this; }
  const SurfaceReport& reports() const final { return *this; }
  Coupling* coupling() final { return nullptr; }
  const ObstacleMotion* motion() const final { return nullptr; }

  double admissible_step(const Segment&, const Rule&, const double*) const final { return 1; }
  double gap_ratio(const Segment&) const final { return 1; }
  LowestPoint lowest_point(const Place&) const final { return {}; }
  bool is_clear(const Place&) const final { return true; }
  LowestPoint passage(const Segment&) const final { return {}; }
  bool has(SurfaceNumber number) const final {
    return number == SurfaceNumber::Slip || number == SurfaceNumber::Dissipated || number == SurfaceNumber::Sliding;
  }
  void lower_nodal_gap(const Place&, double*) const final {}
  void set_nodal_normal(const Place&, double*) const final {}
};

}  // namespace ixos
