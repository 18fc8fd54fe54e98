/// Where a term is evaluated: a state, or the way of a stage.
#pragma once
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "rule/rule.hpp"
#include "state/histories.hpp"

namespace ixos {

/// Results that a term computes once for a step or a stage and uses in all evaluations. No step depends on those
/// of another step, and no checkpoint holds them.
class StepMemory {
 public:
  virtual ~StepMemory() = default;
};

/// The memories of all terms of a model for one step, by Term::slot(). Whoever takes the step owns them, so that two
/// integrators can step one model in turns.
class StepMemories {
 public:
  StepMemories() = default;
  explicit StepMemories(std::vector<std::unique_ptr<StepMemory>> all) : all_(std::move(all)) {}

  /// Returns the memory of a slot, which must be of that class: Term::create_memory() made it.
  template <class Memory>
  Memory& of(std::size_t slot) {
    return static_cast<Memory&>(*all_.at(slot));
  }
  template <class Memory>
  const Memory& of(std::size_t slot) const {
    return static_cast<const Memory&>(*all_.at(slot));
  }

 private:
  std::vector<std::unique_ptr<StepMemory>> all_;
};

/// A displacement at a time, with what the terms keep there. Arrays are local: owned nodes, then ghosts.
struct Place {
  const double* u = nullptr;                 ///< displacement [L0]
  double time = 0;                           ///< [T0]; moved obstacles and driven ends are where they are then
  const TermHistories* histories = nullptr;  ///< null for terms that keep nothing
  const StepMemories* step = nullptr;        ///< of the step on whose way the place is; null for a state
  const double* v = nullptr;                 ///< velocity [L0/T0]; may be null if nobody asks for it
};

/// Local arrays at the ends of a stage's segment, and its times. `from` and `velocity` (h v_from, a length) may be null
/// if the rule does not use them.
struct Segment {
  const double* from = nullptr;
  const double* velocity = nullptr;
  const double* to = nullptr;
  double start = 0;   ///< time at `from` [T0]
  double length = 0;  ///< time from `from` to `to` [T0]; 0 if `to` stands for a state, not for a step
  const TermHistories* histories = nullptr;  ///< at the step's start; null for terms that keep nothing
  const StepMemories* step = nullptr;        ///< of the step; null if `to` stands for a state
  /// The iterate of Newton's method before `to`: elastic tangents are then those of the mixed form, see
  /// volume_excess(). Null: the force's derivatives.
  const double* iterate = nullptr;
  double way = 1;  ///< share of the way from the iterate over which they linearise the change of volume

  /// Returns the time of a rule's point [T0].
  double time(const RulePoint& point) const { return start + point.time * length; }
  Place begin() const { return {from, start, histories, step}; }
  Place end() const { return {to, start + length, histories, step}; }
};

/// Returns the segment that stands for a state.
inline Segment segment_at(const Place& place) {
  return {nullptr, nullptr, place.u, place.time, 0, place.histories, place.step};
}

}  // namespace ixos
