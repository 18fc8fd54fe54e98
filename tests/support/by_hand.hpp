/// Terms and models that a test leads through steps by hand.
#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "model/state_report.hpp"
#include "state/history.hpp"

namespace ixos::test {

inline TermHistories histories_of(const Model& model) { return model.create_histories(); }
inline StepMemories memories_of(const Model& model) { return model.create_memories(); }
inline TermHistories histories_of(Term& term) { return lone_histories(term); }
inline StepMemories memories_of(const Term& term) {
  std::vector<std::unique_ptr<StepMemory>> all;
  term.add_memories(all);
  return StepMemories(std::move(all));
}

/// A model or a term that no model has, with its histories and the memories of the step under way. It must not be
/// copied while a place or a segment of it is in use.
template <class Owner>
class ByHand {
 public:
  explicit ByHand(Owner& owner) : owner_(owner), histories(histories_of(owner)), memories(memories_of(owner)) {}
  /// For a term of a model.
  ByHand(Owner& owner, const Model& model)
      : owner_(owner), histories(model.create_histories()), memories(model.create_memories()) {}
  ByHand(const ByHand&) = delete;
  ByHand& operator=(const ByHand&) = delete;

  void initialize(const double* u, double time = 0) {
    owner_.initialize({u, nullptr, nullptr, time}, histories);
    in_step = false;
  }
  void begin_step(const double* u, double time, double dt, const double* v = nullptr) {
    owner_.begin_step({{u, v, nullptr, time}, dt, &histories}, memories);
    in_step = true;
  }
  void begin_stage(StageStart start) {
    start.histories = &histories;
    owner_.begin_stage(start, memories);
    in_step = true;
  }
  /// Returns what Term::accept() or Model::accept() does.
  auto accept(AcceptedStep step) {
    step.step = &memories;
    in_step = false;
    return owner_.accept(step, histories);
  }
  /// Takes a step from one displacement to another.
  auto step(const double* from, const double* to, double time, double dt) {
    begin_step(from, time, dt);
    return accept({{{from, nullptr, nullptr, time}, {to, nullptr, nullptr, time + dt}}, nullptr, dt});
  }

  const StepMemories* under_way() const { return in_step ? &memories : nullptr; }
  Place at(const double* u, double time = 0, const double* v = nullptr) const {
    return {u, time, &histories, under_way(), v};
  }
  Segment segment(const double* from, const double* velocity, const double* to, double start = 0,
                  double length = 0) const {
    return {from, velocity, to, start, length, &histories, under_way()};
  }
  /// Returns the segment with what is kept here.
  Segment in(Segment segment) const {
    segment.histories = &histories;
    segment.step = under_way();
    return segment;
  }

 private:
  Owner& owner_;

 public:
  TermHistories histories;
  StepMemories memories;
  bool in_step = false;
};

}  // namespace ixos::test
