/// An interaction that reports nothing.
#pragma once
#include "term/interaction.hpp"

namespace ixos::test {

/// Answers all questions but those of force and tangent as if nothing acted: no energy, no gaps, every step admissible.
class SilentInteraction : public Interaction {
 public:
  bool add_row_sums(const Segment&, double*) const override { return true; }
  double energy(const double*) const override { return 0; }
  double gap_ratio(const double*, const double*) const override { return 1; }
  void report(const double*, InteractionReport&) const override {}
  bool needs_positive_gaps() const override { return false; }
  double admissible_step(const Segment&, const Rule&, const double*) const override { return 1; }
  double mean_potential(const Segment&) const override { return 0; }
  double rounding(const double*) const override { return 0; }
  LowestPoint lowest_point(const double*) const override { return {}; }
  void add_nodal_measure(CountedSides&, double*) const override {}
  void add_nodal_pressure(const double*, double*) const override {}
  void lower_nodal_gap(const double*, double*) const override {}
  void set_nodal_normal(const double*, double*) const override {}
};

}  // namespace ixos::test
