/// Interaction of a surface with an obstacle that is moved.
#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "term/interaction.hpp"
#include "term/wall/carried_body.hpp"
#include "term/wall/moving_frame.hpp"

namespace ixos {

/// An interaction in the frame of its obstacle, which a rigid motion carries along: Pi(u, t) = Pi_0(u seen from the
/// frame). The gap is g(x, t) = g_0(P + R^T (x - P - T)), and normals turn with R. Nodes pass into the frame, and
/// forces come back, so that any obstacle, law and element may be inside.
///
/// The motion is prescribed, or that of a rigid body, whose forces and border the term then adds, see CarriedBody.
///
/// Points of a rule are evaluated at the poses of their times. Other means join the places y0 and y1 that the ends of
/// the segment have in the frame, each at its own pose. Their force is that mean's, f_0 with f_0 . (y1 - y0) = Pi_1 -
/// Pi_0, turned by the mean of both angles, or of a body's rotations (FrameMotion::mean_turn()). With a prescribed
/// motion Pi_1 - Pi_0 - f . (u1 - u0) is the obstacle's work: exactly -f . (T1 - T0) if it does not turn, and of second
/// order in the step if it does.
class MovedInteraction final : public Interaction, public Admissibility, public SurfaceReport, public ObstacleMotion {
 public:
  /// `fixed` is the interaction with the obstacle at rest; `sides` contain those on which it acts.
  MovedInteraction(std::unique_ptr<Interaction> fixed, const FrameMotion& motion, const LocalMesh& mesh,
                   const std::vector<LocalSide>& sides, const Pattern& pattern);

  const Rule& followed(const Rule& rule) const override { return fixed_->followed(rule); }
  bool follows(Mean mean) const override { return fixed_->follows(mean); }
  bool has_friction() const override { return fixed_->has_friction(); }
  const Admissibility& admissibility() const override { return *this; }
  const SurfaceReport& reports() const override { return *this; }
  Coupling* coupling() override { return fixed_->coupling(); }
  /// A rigid body that moves by itself has no prescribed motion.
  const ObstacleMotion* motion() const override { return frame_.motion().body() == nullptr ? this : nullptr; }

  bool is_finite(double time) const override;
  double work(const Segment& segment, const Rule& rule) const override;

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
  void add_border(Border& border) const override;
  std::unique_ptr<TangentAction> create_action() const override;
  bool add_row_sums(const Segment& segment, double* sums) const override;
  /// Points only, of terms without a history: a mean, or friction, depends on the way between two times.
  bool has_time_derivative(const Rule& rule) const override;
  void add_time_derivative(const Segment& segment, const Rule& rule, double* f) const override;
  std::vector<std::string> parameters() const override { return fixed_->parameters(); }
  bool add_parameter_derivative(std::size_t parameter, const Segment& segment, const Rule& rule,
                                double* f) const override;
  double energy(const Place& at) const override;
  double mean_potential(const Segment& segment) const override;
  double rounding(const Place& at) const override;

  bool needs_positive_gaps() const override { return fixed_->admissibility().needs_positive_gaps(); }
  double admissible_step(const Segment& segment, const Rule& rule, const double* direction) const override;
  double gap_ratio(const Segment& way) const override;
  LowestPoint lowest_point(const Place& at) const override;
  bool is_clear(const Place&) const override { return false; }
  /// No point passes in a step in which the obstacle turns by more than 0.1 radian: ways are not straight then.
  LowestPoint passage(const Segment& way) const override;

  void report(const Place& at, InteractionReport& report) const override;
  void report_friction(const Place& at, FrictionReport& report) const override {
    fixed_->reports().report_friction(seen(at), report);
  }
  bool has(SurfaceNumber number) const override { return fixed_->reports().has(number); }
  void add_nodal(SurfaceNumber number, const Place& at, double* sums) const override {
    fixed_->reports().add_nodal(number, seen(at), sums);
  }
  void add_nodal_measure(CountedSides& counted, double* measure) const override {
    fixed_->reports().add_nodal_measure(counted, measure);
  }
  void lower_nodal_gap(const Place& at, double* gap) const override {
    fixed_->reports().lower_nodal_gap(seen(at), gap);
  }
  void lower_facing_gap(const Place& at, double* gap) const override {
    fixed_->reports().lower_facing_gap(seen(at), gap);
  }
  void set_nodal_normal(const Place& at, double* normal) const override;

  // An interaction with a history receives displacements in the frame.
  void initialize(const KnownState& start, TermHistories& histories) const override;
  void begin_step(const StepStart& start, StepMemories& step) const override;
  void begin_stage(const StageStart& start, StepMemories& step) const override;
  bool dissipates() const override { return fixed_->dissipates(); }
  StepWork accept(const AcceptedStep& step, TermHistories& histories) const override;
  bool has_state() const override { return fixed_->has_state(); }
  bool has_history() const override { return fixed_->has_history(); }
  bool outlives_scene() const override { return fixed_->outlives_scene(); }
  void transfer(Record& record, TermHistories& histories) override { fixed_->transfer(record, histories); }

 protected:
  std::vector<Term*> inside() const override { return {fixed_.get()}; }

 private:
  class Action;
  struct Kept;
  /// Adds the forces that add(segment in the frame, rule there, part) adds to force_ at each point of the rule, or for
  /// its mean, moved back; the part is that of `kept`, null if nothing is kept. Returns whether all are admissible.
  template <class Add>
  bool add_forces(const Segment& segment, const Rule& rule, Kept* kept, const Add& add, double* f) const;
  bool add_force(const Segment& segment, const Rule& rule, Kept* kept, double* f) const;
  void add_tangent(const Segment& segment, const Rule& rule, Tangent kind, const Kept* kept, double* values) const;
  void add_carried_tangent(const Segment& segment, const Rule& rule, Tangent kind, const Kept* kept,
                           double* values) const;
  /// A point of a rule, or its mean, whose tangent is L K R^T.
  struct TangentPlace {
    Turn left;
    RigidPose pose;  ///< of the point, or of the end; its turn is R
    Segment inside;
    Rule rule;
    const KeptPoints* part;
    const RulePoint* point;       ///< null for a mean
    const RigidPose* start;       ///< null for a point
    const CarriedForces* forces;  ///< null if they are not kept
  };
  const CarriedForces* forces_of(const Kept* kept, std::size_t point) const;
  template <class Visit>
  void at_tangents(const Segment& segment, const Rule& rule, const Kept* kept, const Visit& visit) const;
  void add_tangent(const TangentPlace& place, Tangent kind, double* values) const;
  /// Calls visit(point, pose) for each point of the rule, after it has set to_ to what is seen there.
  template <class Visit>
  void at_points(const Segment& segment, const Rule& rule, const Visit& visit) const {
    for (const RulePoint& point : rule.points) {
      const RigidPose pose = frame_.motion().pose(segment, point);
      frame_.see(pose, segment, point, to_);
      visit(point, pose);
    }
  }
  /// Sees both ends of a segment, each at its pose: in from_ and to_. Returns the poses.
  struct Poses {
    RigidPose start, end;
  };
  Poses see_ends(const Segment& segment) const;
  RigidPose pose(const Place& at) const { return frame_.motion().pose(at.u, at.time); }
  /// Returns the place as it is seen, its displacement in to_.
  Place seen(const Place& at) const;
  /// Return what is in to_, or in from_ and to_, with what the segment keeps.
  static Segment here(const double* u, const Segment& segment) {
    return {nullptr, nullptr, u, 0, 0, segment.histories, segment.step};
  }
  Segment here(const Segment& segment) const { return here(to_.data(), segment); }
  Segment ends(const Segment& segment) const {
    return {from_.data(), nullptr, to_.data(), 0, 0, segment.histories, segment.step};
  }
  std::vector<KnownState> known_in_frame(const std::vector<KnownState>& known) const;

  std::unique_ptr<Interaction> fixed_;
  MovingFrame frame_;
  std::unique_ptr<CarriedBody> carried_;  ///< null if the motion is prescribed
  const Pattern* pattern_;
  mutable std::vector<double> own_values_;          ///< scratch of a carried frame, zero between calls
  mutable std::vector<std::vector<double>> known_;  ///< scratch: states as they are seen
  mutable std::vector<double> from_, to_, change_;  ///< scratch, local
  mutable std::vector<double> force_;               ///< scratch, zero between calls
  mutable CarriedForces forces_;                    ///< scratch
};

}  // namespace ixos
