/// Interaction of a surface with an obstacle that is moved.
#pragma once
#include <memory>
#include <vector>

#include "model/moving_frame.hpp"
#include "term/interaction.hpp"

namespace ixos {

/// An interaction in the frame of its obstacle, which a rigid motion carries along: Pi(u, t) = Pi_0(u seen from the
/// frame). The gap is g(x, t) = g_0(P + R^T (x - P - T)), and normals turn with R. Nodes pass into the frame, and
/// forces come back, so that any obstacle, law and element may be inside.
///
/// Points of a rule are evaluated at the poses of their times. Other means join the places y0 and y1 that the ends of
/// the segment have in the frame, each at its own pose. Their force is that mean's, f_0 with f_0 . (y1 - y0) = Pi_1 -
/// Pi_0, turned by the mean of both angles. Then Pi_1 - Pi_0 - f . (u1 - u0) is the obstacle's work: exactly -f . (T1 -
/// T0) if it does not turn, and of second order in the step if it does.
class MovedInteraction final : public Interaction {
 public:
  /// `fixed` is the interaction with the obstacle at rest; `sides` contain those on which it acts.
  MovedInteraction(std::unique_ptr<Interaction> fixed, const RigidMotion& motion, const LocalMesh& mesh,
                   const std::vector<LocalSide>& sides, const Pattern& pattern);

  bool is_moved() const override { return true; }
  const Rule& followed(const Rule& rule) const override { return fixed_->followed(rule); }
  bool has_friction() const override { return fixed_->has_friction(); }
  void add_nodal_friction(FrictionNumber number, double* sums) const override {
    fixed_->add_nodal_friction(number, sums);
  }
  void report_friction(const double* u, FrictionReport& report) const override {
    fixed_->report_friction(seen(u), report);
  }
  bool is_finite(double time) const override;
  void set_time(double time) const override { time_ = time; }
  double obstacle_work(const Segment& segment, const Rule& rule) const override;

  void place(const Pattern& pattern) override;
  bool is_gradient(const Rule& rule) const override;
  bool add_force(const Segment& segment, const Rule& rule, double* f) const override;
  void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, double* values) const override;
  /// The ends of segments and means are kept as the interaction keeps them. Other points in time are not: their
  /// tangents have other weights than their forces.
  std::unique_ptr<KeptPoints> create_kept() const override;
  bool add_force_and_keep(const Segment& segment, const Rule& rule, KeptPoints& kept, double* f) const override;
  void add_kept_tangent(const Segment& segment, const Rule& rule, Tangent kind, const KeptPoints& kept,
                        double* values) const override;
  std::unique_ptr<TangentAction> create_action() const override;
  bool add_row_sums(const Segment& segment, double* sums) const override;
  double energy(const double* u) const override;

  bool follows(Mean mean) const override { return fixed_->follows(mean); }
  bool needs_positive_gaps() const override { return fixed_->needs_positive_gaps(); }
  double admissible_step(const Segment& segment, const Rule& rule, const double* direction) const override;
  double mean_potential(const Segment& segment) const override;
  double gap_ratio(const double* from, const double* to) const override;
  double rounding(const double* u) const override;
  void report(const double* u, InteractionReport& report) const override;
  LowestPoint lowest_point(const double* u) const override;
  /// No point passes in a step in which the obstacle turns by more than 0.1 radian: ways are not straight then.
  LowestPoint passage(const double* from, const double* to) const override;
  void add_nodal_measure(CountedSides& counted, double* measure) const override;
  void add_nodal_pressure(const double* u, double* force) const override;
  bool has_damage() const override { return fixed_->has_damage(); }
  void add_nodal_damage(double* sums) const override { fixed_->add_nodal_damage(sums); }
  void lower_nodal_gap(const double* u, double* gap) const override;
  void set_nodal_normal(const double* u, double* normal) const override;

  // An interaction with a history receives displacements in the frame.
  void initialize(const KnownState& start) override { fixed_->initialize({seen(start.u)}); }
  void begin_step(const KnownState& start, double time, double dt) override;
  void begin_stage(const StageStart& start) override;
  bool dissipates() const override { return fixed_->dissipates(); }
  double accept(const AcceptedStep& step) override;
  bool has_state() const override { return fixed_->has_state(); }
  bool has_history() const override { return fixed_->has_history(); }
  void transfer(Record& record) override { fixed_->transfer(record); }

 private:
  class Action;
  struct Kept;
  /// `kept`: null if nothing is kept.
  bool add_force(const Segment& segment, const Rule& rule, Kept* kept, double* f) const;
  void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, const Kept* kept, double* values) const;
  /// Calls visit(point, pose) for each point of the rule, after it has set to_ to what is seen there.
  template <class Visit>
  void at_points(const Segment& segment, const Rule& rule, const Visit& visit) const {
    for (const RulePoint& point : rule.points) {
      const RigidPose pose = frame_.pose(segment.time(point));
      frame_.see(pose, segment, point, to_);
      visit(point, pose);
    }
  }
  /// Sees both ends of a segment, each at its pose: in from_ and to_. Returns the mean of the angles.
  double see_ends(const Segment& segment, RigidPose& end) const;
  /// Returns u as it is seen at the time of set_time(), in to_.
  const double* seen(const double* u) const;
  Segment here() const { return {nullptr, nullptr, to_.data()}; }
  Segment ends() const { return {from_.data(), nullptr, to_.data()}; }
  std::vector<KnownState> known_in_frame(const std::vector<KnownState>& known);

  std::unique_ptr<Interaction> fixed_;
  MovingFrame frame_;
  mutable double time_ = 0;                         ///< of set_time()
  double step_start_ = 0, step_end_ = 0;            ///< of the step that began last
  std::vector<double> stage_ends_;                  ///< of its stages that have begun [T0]
  std::vector<std::vector<double>> known_;          ///< states as they are seen, if the interaction keeps something
  mutable std::vector<double> from_, to_, change_;  ///< scratch, local
  mutable std::vector<double> force_;               ///< scratch, zero between calls
};

}  // namespace ixos
