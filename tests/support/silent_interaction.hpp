/// An interaction that reports nothing.
#pragma once
#include "term/interaction.hpp"

namespace ixos::test {

/// Answers all questions but those of force and tangent as if nothing acted: no energy, no gaps, every step admissible.
class SilentInteraction : public Interaction, public Admissibility, public SurfaceReport {
 public:
  bool add_row_sums(const Segment&, double*) const override { return true; }
  double energy(const Place&) const override { return 0; }
  const Rule& followed(const Rule& rule) const override { return rule; }
  bool follows(Mean) const override { return true; }
  bool has_friction() const override { return false; }
  bool has_time_derivative(const Rule&) const override { return true; }
  double mean_potential(const Segment&) const override { return 0; }
  double rounding(const Place&) const override { return 0; }
  const Admissibility& admissibility() const override { return *this; }
  const SurfaceReport& reports() const override { return *this; }
  Coupling* coupling() override { return nullptr; }
  const ObstacleMotion* motion() const override { return nullptr; }

  bool needs_positive_gaps() const override { return false; }
  double admissible_step(const Segment&, const Rule&, const double*) const override { return 1; }
  double gap_ratio(const Segment&) const override { return 1; }
  LowestPoint lowest_point(const Place&) const override { return {}; }
  bool is_clear(const Place&) const override { return false; }
  LowestPoint passage(const Segment&) const override { return {}; }

  void report(const Place&, InteractionReport&) const override {}
  void report_friction(const Place&, FrictionReport&) const override {}
  bool has(SurfaceNumber) const override { return false; }
  void add_nodal(SurfaceNumber, const Place&, double*) const override {}
  void add_nodal_measure(CountedSides&, double*) const override {}
  void lower_nodal_gap(const Place&, double*) const override {}
  void set_nodal_normal(const Place&, double*) const override {}
};

}  // namespace ixos::test
