#include "term/wall/moved_interaction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ixos {
namespace {

const RulePoint end_point{1, 0, 0, 1};

/// Returns whether the point is the segment's end.
bool is_end(const RulePoint& point) {
  return point.to == 1 && point.from == 0 && point.velocity == 0 && point.time == 1;
}

}  // namespace

MovedInteraction::MovedInteraction(std::unique_ptr<Interaction> fixed, const FrameMotion& motion, const LocalMesh& mesh,
                                   const std::vector<LocalSide>& sides, const Pattern& pattern)
    : fixed_(std::move(fixed)), frame_(motion, mesh, sides, pattern), pattern_(&pattern) {
  const auto local = static_cast<std::size_t>(mesh.nodes()) * static_cast<std::size_t>(mesh.dimension);
  if (motion.body() != nullptr) carried_ = std::make_unique<CarriedBody>(frame_);
  for (std::vector<double>* array : {&from_, &to_, &change_, &force_}) array->resize(local);
}

void MovedInteraction::place(const Pattern& pattern) {
  fixed_->place(pattern);
  frame_.place(pattern);
  pattern_ = &pattern;
  own_values_.clear();
}

MovedInteraction::Poses MovedInteraction::see_ends(const Segment& segment) const {
  const Poses poses{frame_.motion().pose(segment.from, segment.start),
                    frame_.motion().pose(segment.to, segment.time(end_point))};
  frame_.see(poses.start, segment.from, from_);
  frame_.see(poses.end, segment.to, to_);
  return poses;
}

bool MovedInteraction::is_finite(double time) const {
  const RigidPose pose = frame_.motion().pose(nullptr, time);
  double sum = pose.angle + pose.spin;
  for (std::size_t i = 0; i < 3; ++i) sum += pose.translation[i] + pose.velocity[i];
  return std::isfinite(sum);
}

Place MovedInteraction::seen(const Place& at) const {
  frame_.see(pose(at), at.u, to_);
  return {to_.data(), at.time, at.histories, at.step};
}

/// A mean over the step of an obstacle that turns has no potential: its force is not turned as its end is.
bool MovedInteraction::is_gradient(const Rule& asked) const {
  const Rule& rule = fixed_->followed(asked);
  return fixed_->is_gradient(rule) && (rule.mean == Mean::Points || !frame_.turns());
}

/// Kept points of the interaction, one for each point of a rule or for its mean; with a body also the forces on the
/// frame's nodes.
struct MovedInteraction::Kept final : KeptPoints {
  std::vector<std::unique_ptr<KeptPoints>> parts;  ///< null where nothing was kept yet, or the interaction keeps none
  std::vector<CarriedForces> forces;

  /// Returns the part of point k, or null if the tangent has another weight there than the force.
  KeptPoints* part(std::size_t k, const RulePoint& point) const { return point.to == 1 ? parts[k].get() : nullptr; }
};

std::unique_ptr<KeptPoints> MovedInteraction::create_kept() const {
  if (!carried_ && fixed_->create_kept() == nullptr) return nullptr;
  return std::make_unique<Kept>();
}

bool MovedInteraction::add_force(const Segment& segment, const Rule& asked, double* f) const {
  return add_force(segment, asked, nullptr, f);
}

bool MovedInteraction::add_force_and_keep(const Segment& segment, const Rule& asked, KeptPoints& kept,
                                          double* f) const {
  auto& own = static_cast<Kept&>(kept);
  const Rule& rule = fixed_->followed(asked);
  own.parts.resize(rule.mean == Mean::Points ? rule.points.size() : 1);
  for (std::unique_ptr<KeptPoints>& part : own.parts)
    if (!part) part = fixed_->create_kept();
  if (carried_) own.forces.resize(own.parts.size());
  return add_force(segment, asked, &own, f);
}

bool MovedInteraction::add_force(const Segment& segment, const Rule& asked, Kept* kept, double* f) const {
  return add_forces(
      segment, asked, kept,
      [&](const Segment& inside, const Rule& own, KeptPoints* part) {
        return part != nullptr ? fixed_->add_force_and_keep(inside, own, *part, force_.data())
                               : fixed_->add_force(inside, own, force_.data());
      },
      f);
}

template <class Add>
bool MovedInteraction::add_forces(const Segment& segment, const Rule& asked, Kept* kept, const Add& add,
                                  double* f) const {
  const Rule& rule = fixed_->followed(asked);
  bool admissible = true, end_is_seen = false;
  std::size_t k = 0;
  at_points(segment, rule, [&](const RulePoint& point, const RigidPose& pose) {
    KeptPoints* part = kept != nullptr ? kept->part(k, point) : nullptr;
    admissible = add(here(segment), end_rule(point.weight), part) && admissible;
    if (carried_) {
      carried_->add_force(pose, to_, force_, f);
      if (kept != nullptr) carried_->gather(force_, kept->forces[k]);
    }
    ++k;
    frame_.add_moved(pose.turn, force_, f);
    end_is_seen = end_is_seen || is_end(point);
  });
  if (rule.mean != Mean::Points) {
    const Poses poses = see_ends(segment);
    admissible = add(ends(segment), rule, kept != nullptr ? kept->parts[0].get() : nullptr) && admissible;
    if (carried_) {
      carried_->add_force(carried_->between(poses.start, poses.end, from_, to_), force_, f);
      if (kept != nullptr) carried_->gather(force_, kept->forces[0]);
    }
    frame_.add_moved(frame_.motion().mean_turn(poses.start, poses.end), force_, f);
  } else if (!end_is_seen) {
    // The end must be admissible, too. The weight is 0; a force beyond the law's domain may be no number.
    frame_.see(frame_.motion().pose(segment.to, segment.time(end_point)), segment.to, to_);
    admissible = fixed_->add_force(here(segment), end_rule(0), force_.data()) && admissible;
    frame_.clear(force_);
  }
  return admissible;
}

void MovedInteraction::add_tangent(const Segment& segment, const Rule& asked, Tangent kind, double* values) const {
  add_tangent(segment, asked, kind, nullptr, values);
}

void MovedInteraction::add_kept_tangent(const Segment& segment, const Rule& asked, Tangent kind, const KeptPoints& kept,
                                        double* values) const {
  add_tangent(segment, asked, kind, &static_cast<const Kept&>(kept), values);
}

void MovedInteraction::add_tangent(const Segment& segment, const Rule& asked, Tangent kind, const Kept* kept,
                                   double* values) const {
  if (carried_) return add_carried_tangent(segment, asked, kind, kept, values);
  // The tangent of a turned frame is L K R^T: the values are turned into the frame and back.
  at_tangents(segment, asked, kept, [&](const TangentPlace& place) {
    if (frame_.turns()) frame_.turn_blocks(place.left, place.pose.turn, false, values);
    add_tangent(place, kind, values);
    if (frame_.turns()) frame_.turn_blocks(place.left, place.pose.turn, true, values);
  });
}

const CarriedForces* MovedInteraction::forces_of(const Kept* kept, std::size_t k) const {
  return kept != nullptr && carried_ ? &kept->forces[k] : nullptr;
}

/// Calls visit(place) for each point of the rule, or for its mean.
template <class Visit>
void MovedInteraction::at_tangents(const Segment& segment, const Rule& asked, const Kept* kept,
                                   const Visit& visit) const {
  const Rule& rule = fixed_->followed(asked);
  std::size_t k = 0;
  at_points(segment, rule, [&](const RulePoint& point, const RigidPose& pose) {
    const KeptPoints* part = kept != nullptr ? kept->part(k, point) : nullptr;
    visit(
        {pose.turn, pose, here(segment), end_rule(point.weight * point.to), part, &point, nullptr, forces_of(kept, k)});
    ++k;
  });
  if (rule.mean == Mean::Points) return;
  const Poses poses = see_ends(segment);
  visit({frame_.motion().mean_turn(poses.start, poses.end), poses.end, ends(segment), rule,
         kept != nullptr ? kept->parts[0].get() : nullptr, nullptr, &poses.start, forces_of(kept, 0)});
}

void MovedInteraction::add_tangent(const TangentPlace& place, Tangent kind, double* values) const {
  if (place.part != nullptr)
    fixed_->add_kept_tangent(place.inside, place.rule, kind, *place.part, values);
  else
    fixed_->add_tangent(place.inside, place.rule, kind, values);
}

/// The blocks of the frame pass through an array of their own, from which the body's border is made, too.
void MovedInteraction::add_carried_tangent(const Segment& segment, const Rule& asked, Tangent kind, const Kept* kept,
                                           double* values) const {
  carried_->clear();
  own_values_.resize(pattern_->values());  // zero
  at_tangents(segment, asked, kept, [&](const TangentPlace& place) {
    if (place.point != nullptr && place.point->to == 0) return;
    add_tangent(place, kind, own_values_.data());
    const CarriedForces* forces = place.forces;
    if (forces == nullptr) {
      const Rule rule = place.point != nullptr ? end_rule(place.point->weight) : place.rule;
      fixed_->add_force(place.inside, rule, force_.data());
      carried_->gather(force_, forces_);
      frame_.clear(force_);
      forces = &forces_;
    }
    const SurfaceSight& sight = place.point != nullptr ? carried_->at(place.pose, *place.point, to_)
                                                       : carried_->between(*place.start, place.pose, from_, to_);
    carried_->add_border(sight, *forces, own_values_, values);
  });
}

void MovedInteraction::add_border(Border& border) const {
  if (carried_) carried_->add_to(border);
}

bool MovedInteraction::add_row_sums(const Segment& segment, double* sums) const {
  const RigidPose pose = frame_.motion().pose(segment.to, segment.time(end_point));
  frame_.see(pose, segment.to, to_);
  const bool admissible = fixed_->add_row_sums(here(segment), force_.data());
  frame_.add_row_sums(pose, force_, sums);
  return admissible;
}

bool MovedInteraction::has_time_derivative(const Rule& rule) const {
  return fixed_->followed(rule).mean == Mean::Points && !fixed_->has_history();
}

/// With f = R f_0(u seen): a node at rest moves in the frame with minus the velocity of the obstacle there, and R
/// turns.
void MovedInteraction::add_time_derivative(const Segment& segment, const Rule& asked, double* f) const {
  std::vector<double> tangent;
  at_points(segment, fixed_->followed(asked), [&](const RulePoint& point, const RigidPose& pose) {
    const Rule here_only = end_rule(point.weight);
    fixed_->add_force(here(segment), here_only, force_.data());
    frame_.add_turning_rate(pose, force_, f);
    frame_.clear(force_);
    tangent.assign(pattern_->values(), 0.0);
    fixed_->add_tangent(here(segment), here_only, Tangent::Exact, tangent.data());
    frame_.see_velocity(pose, to_, change_);
    frame_.subtract_product(*pattern_, tangent, change_, force_);
    frame_.add_moved(pose.turn, force_, f);
  });
}

bool MovedInteraction::add_parameter_derivative(std::size_t parameter, const Segment& segment, const Rule& rule,
                                                double* f) const {
  return add_forces(
      segment, rule, nullptr,
      [&](const Segment& inside, const Rule& own, KeptPoints*) {
        return fixed_->add_parameter_derivative(parameter, inside, own, force_.data());
      },
      f);
}

double MovedInteraction::energy(const Place& at) const { return fixed_->energy(seen(at)); }

double MovedInteraction::work(const Segment& segment, const Rule& asked) const {
  const Rule& rule = fixed_->followed(asked);
  double work = 0;
  const auto add_power = [&](double weight, const RigidPose& pose) {
    fixed_->add_force(here(segment), end_rule(), force_.data());
    work -= segment.length * weight * frame_.power(pose, force_, to_);
    frame_.clear(force_);
  };
  at_points(segment, rule, [&](const RulePoint& point, const RigidPose& pose) { add_power(point.weight, pose); });
  if (rule.kept_weight != 0) {
    const RigidPose pose = frame_.motion().pose(segment.from, segment.start);
    frame_.see(pose, segment.from, to_);
    add_power(rule.kept_weight, pose);
  }
  if (rule.mean == Mean::Points) return work;
  const Poses poses = see_ends(segment);
  fixed_->add_force(ends(segment), rule, force_.data());
  work += frame_.work(frame_.motion().mean_turn(poses.start, poses.end), force_, from_, to_, segment.from, segment.to);
  frame_.clear(force_);
  return work;
}

double MovedInteraction::admissible_step(const Segment& segment, const Rule& rule, const double* direction) const {
  if (!needs_positive_gaps()) return 1;
  double step = 1;
  bool end_is_seen = false;
  const auto restrict_at = [&](const RulePoint& point, const RigidPose& pose) {
    frame_.see_change(pose, point.to, direction, change_);
    if (carried_) carried_->see_change(pose, point.to, direction, to_, change_);
    step = std::min(step, fixed_->admissibility().admissible_step(here(segment), Rule{}, change_.data()));
    end_is_seen = end_is_seen || is_end(point);
  };
  at_points(segment, rule, restrict_at);
  if (!end_is_seen) at_points(segment, end_rule(), restrict_at);
  return step;
}

double MovedInteraction::mean_potential(const Segment& segment) const {
  see_ends(segment);
  return fixed_->mean_potential(ends(segment));
}

double MovedInteraction::gap_ratio(const Segment& way) const {
  see_ends(way);
  return fixed_->admissibility().gap_ratio(ends(way));
}

double MovedInteraction::rounding(const Place& at) const { return fixed_->rounding(seen(at)); }

void MovedInteraction::report(const Place& at, InteractionReport& report) const {
  InteractionReport own;
  fixed_->reports().report(seen(at), own);
  std::array<double, 3> force{};
  std::copy(own.force.begin(), own.force.end(), force.begin());
  force = turned(pose(at).turn, force);
  report.force.resize(own.force.size(), 0.0);
  for (std::size_t i = 0; i < own.force.size(); ++i) report.force[i] += force[i];
  report.measure += own.measure;
  report.least_gap = std::min(report.least_gap, own.least_gap);
}

LowestPoint MovedInteraction::lowest_point(const Place& at) const {
  LowestPoint point = fixed_->admissibility().lowest_point(seen(at));
  point.place = MovingFrame::from_frame(pose(at), point.place);
  return point;
}

LowestPoint MovedInteraction::passage(const Segment& way) const {
  const Poses poses = see_ends(way);
  Turn difference = poses.end.turn;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) difference[i][j] -= poses.start.turn[i][j];
  if (std::sqrt(contraction(difference, difference) / 2) > 0.1) return {};
  LowestPoint point = fixed_->admissibility().passage(ends(way));
  point.place = MovingFrame::from_frame(poses.end, point.place);
  return point;
}

void MovedInteraction::set_nodal_normal(const Place& at, double* normal) const {
  const Place inside = seen(at);
  fixed_->reports().set_nodal_normal(inside, force_.data());
  std::vector<double> in_space(force_.size(), 0.0);
  frame_.add_moved(pose(at).turn, force_, in_space.data());
  // Several terms share nodes: only the nodes of this one are set.
  const std::size_t d = frame_.dimension();
  std::vector<double> gap(in_space.size() / d, std::numeric_limits<double>::quiet_NaN());
  fixed_->reports().lower_nodal_gap(inside, gap.data());
  for (std::size_t i = 0; i < in_space.size(); ++i)
    if (!std::isnan(gap[i / d])) normal[i] = in_space[i];
}

/// Returns the states as they are seen at their own times, without rates. An interaction that keeps nothing gets none.
std::vector<KnownState> MovedInteraction::known_in_frame(const std::vector<KnownState>& known) const {
  if (!fixed_->has_state()) return {};
  std::vector<KnownState> result;
  known_.resize(std::max(known_.size(), known.size()));
  for (std::size_t k = 0; k < known.size(); ++k) {
    known_[k].resize(to_.size());
    frame_.see(frame_.motion().pose(known[k].u, known[k].time), known[k].u, known_[k]);
    result.push_back({known_[k].data(), nullptr, nullptr, known[k].time});
  }
  return result;
}

void MovedInteraction::initialize(const KnownState& start, TermHistories& histories) const {
  const Place inside = seen({start.u, start.time});
  fixed_->initialize({inside.u, nullptr, nullptr, start.time}, histories);
}

void MovedInteraction::begin_step(const StepStart& start, StepMemories& step) const {
  for (const KnownState& seen : known_in_frame({start.state}))
    fixed_->begin_step({seen, start.dt, start.histories}, step);
}

void MovedInteraction::begin_stage(const StageStart& start, StepMemories& step) const {
  StageStart own = start;
  own.known = known_in_frame(start.known);
  own.driven = nullptr;
  own.driven_velocity = nullptr;
  if (!own.known.empty()) fixed_->begin_stage(own, step);
}

StepWork MovedInteraction::accept(const AcceptedStep& step, TermHistories& histories) const {
  AcceptedStep own = step;
  own.states = known_in_frame(step.states);
  return own.states.empty() ? StepWork{} : fixed_->accept(own, histories);
}

}  // namespace ixos
