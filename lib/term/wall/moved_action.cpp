// The tangent of an interaction with a moved obstacle, applied without a matrix.
#include <utility>
#include <vector>

#include "discretization/coarse_space.hpp"
#include "term/wall/moved_interaction.hpp"

namespace ixos {

/// A sum of actions in frames that are turned, R_left K R_right^T: one for each point of the rule. The diagonal takes
/// that of K along the axes of the frame, turned; it serves preconditioners, which need no more.
class MovedInteraction::Action final : public TangentAction {
 public:
  explicit Action(const MovedInteraction& term) : term_(term), x_(term.to_.size()), y_(term.to_.size()) {}

  void linearize(const Segment& segment, const Rule& asked, Tangent kind, const LinearPart& linear) override {
    const Rule& rule = term_.fixed_->followed(asked);
    parts_.resize(rule.mean == Mean::Points ? rule.points.size() : 1);
    for (Part& part : parts_)
      if (!part.action) part.action = term_.fixed_->create_action();
    std::size_t k = 0;
    if (term_.carried_) term_.add_carried_tangent(segment, asked, kind, nullptr, nullptr);
    term_.at_points(segment, rule, [&](const RulePoint& point, const RigidPose& pose) {
      parts_[k].pose = pose;
      parts_[k++].action->linearize(term_.here(segment), end_rule(point.weight * point.to), kind, linear);
    });
    if (rule.mean == Mean::Points) return;
    parts_[0].pose = term_.see_ends(segment).end;  // a gradient: the obstacle does not turn
    parts_[0].action->linearize(term_.ends(segment), rule, kind, linear);
  }

  bool applies_mass() const override { return false; }

  void add_product(const double* x, double* y) const override {
    for (const Part& part : parts_) {
      if (!term_.frame_.turns()) {
        part.action->add_product(x, y);
        continue;
      }
      term_.frame_.see_change(part.pose, 1, x, x_);
      part.action->add_product(x_.data(), y_.data());
      term_.frame_.add_moved(part.pose.turn, y_, y);
    }
  }

  void add_diagonal(double* d) const override {
    for (const Part& part : parts_) {
      part.action->add_diagonal(y_.data());
      term_.frame_.add_diagonal(part.pose, y_, d);
    }
  }

  bool has_coarse() const override { return term_.fixed_->create_action()->has_coarse(); }

  void add_coarse(const CoarseSpace& coarse, double* values) const override {
    for (const Part& part : parts_) {
      if (!term_.frame_.turns()) {
        part.action->add_coarse(coarse, values);
        continue;
      }
      std::vector<double> seen(coarse.values(), 0.0);
      part.action->add_coarse(coarse, seen.data());
      coarse.pattern().condense(seen.data());  // all blocks turn alike, those of tied nodes too
      term_.frame_.add_moved_matrix(part.pose, coarse.pattern(), seen, values);
    }
  }

 private:
  struct Part {
    std::unique_ptr<TangentAction> action;
    RigidPose pose;
  };
  const MovedInteraction& term_;
  std::vector<Part> parts_;
  mutable std::vector<double> x_, y_;  ///< y_ is zero between calls
};

/// A term without an action has none before a moved obstacle, either.
std::unique_ptr<TangentAction> MovedInteraction::create_action() const {
  if (fixed_->create_action() == nullptr) return nullptr;
  return std::make_unique<Action>(*this);
}

}  // namespace ixos
