// The life of a model's terms through steps, and what they keep in checkpoints.
#include <algorithm>
#include <utility>
#include <vector>

#include "base/agreement.hpp"
#include "model/model.hpp"
#include "state/history.hpp"

namespace ixos {

TermHistories Model::create_histories() const {
  std::vector<TermHistory> all;
  for (const NamedTerm& named : terms_) named.term->add_histories(all);
  return TermHistories(std::move(all));
}

StepMemories Model::create_memories() const {
  std::vector<std::unique_ptr<StepMemory>> all;
  for (const NamedTerm& named : terms_) named.term->add_memories(all);
  return StepMemories(std::move(all));
}

void Model::initialize(const KnownState& start, TermHistories& histories) const {
  for (const NamedTerm& named : terms_) named.term->initialize(start, histories);
}

void Model::begin_step(const StepStart& start, StepMemories& step) const {
  for (const NamedTerm& named : terms_) named.term->begin_step(start, step);
}

void Model::begin_stage(const StageStart& start, StepMemories& step) const {
  for (const NamedTerm& named : terms_) named.term->begin_stage(start, step);
}

ModelWork Model::accept(const AcceptedStep& step, TermHistories& histories) const {
  std::vector<double> work(dissipation_names_.size() + 1, 0.0);  // the last one is of driven ends
  for (const NamedTerm& named : terms_) {
    const StepWork own = named.term->accept(step, histories);
    if (named.account >= 0) work[static_cast<std::size_t>(named.account)] += own.dissipated;
    work.back() += own.driven;
  }
  if (work.size() > 1 || has_supports_) space().sum(work.data(), static_cast<int>(work.size()));
  const double driven = work.back();
  work.pop_back();
  return {std::move(work), driven};
}

std::vector<std::string> Model::slot_names() const {
  std::vector<std::string> names(slots_);
  for (const NamedTerm& own : terms_) {
    const auto interaction = std::find_if(interactions_.begin(), interactions_.end(),
                                          [&](const NamedInteraction& named) { return named.term == own.term.get(); });
    std::fill(names.begin() + static_cast<std::ptrdiff_t>(own.term->slot()), names.end(),
              interaction == interactions_.end() ? own.name : interaction->name);
  }
  return names;
}

/// Returns the name of a term's section. That of a history counts the histories of the same name only, so that it is
/// found in a scene with other terms.
std::string Model::section_of(std::size_t term) const {
  if (!terms_[term].term->has_history()) return "term " + std::to_string(term + 1) + ", " + terms_[term].name;
  const auto count = std::count_if(
      terms_.begin(), terms_.begin() + static_cast<std::ptrdiff_t>(term) + 1,
      [&](const NamedTerm& other) { return other.term->has_history() && other.name == terms_[term].name; });
  return "history " + std::to_string(count) + " of " + terms_[term].name;
}

void Model::transfer(std::size_t term, Record& record, TermHistories& histories) {
  const Record::Section section(record, section_of(term));
  if (!record.loading()) return terms_[term].term->transfer(record, histories);
  // A term's numbers may fit on some ranks only. It throws after its last collective call.
  together<InputError>(space().comm(), [&] { terms_[term].term->transfer(record, histories); });
}

void Model::transfer(Record& record, TermHistories& histories) {
  for (std::size_t i = 0; i < terms_.size(); ++i)
    if (terms_[i].term->has_state()) transfer(i, record, histories);
}

void Model::transfer_to_another_scene(Record& record, TermHistories& histories) {
  for (std::size_t i = 0; i < terms_.size(); ++i)
    if (terms_[i].term->outlives_scene() && record.has_section(section_of(i))) transfer(i, record, histories);
}

}  // namespace ixos
