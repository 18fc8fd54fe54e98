#include "state/history.hpp"

#include <cstddef>
#include <stdexcept>
#include <utility>

namespace ixos {
namespace {

void check(std::size_t slot, std::size_t size) {
  if (slot >= size) throw std::logic_error("a term has no history here: evaluate it with the histories of a state");
}

}  // namespace

TermHistories::TermHistories() = default;
TermHistories::TermHistories(std::vector<TermHistory> all) : all_(std::move(all)) {}
TermHistories::TermHistories(const TermHistories&) = default;
TermHistories::TermHistories(TermHistories&&) noexcept = default;
TermHistories& TermHistories::operator=(const TermHistories&) = default;
TermHistories& TermHistories::operator=(TermHistories&&) noexcept = default;
TermHistories::~TermHistories() = default;

std::size_t TermHistories::size() const { return all_.size(); }

void TermHistories::extend(const TermHistories& longer) {
  if (longer.size() <= size()) return;
  all_.insert(all_.end(), longer.all_.begin() + static_cast<std::ptrdiff_t>(size()), longer.all_.end());
}

bool TermHistories::operator==(const TermHistories& other) const { return all_ == other.all_; }

const TermHistory& TermHistories::of(std::size_t slot) const {
  check(slot, all_.size());
  return all_[slot];
}

TermHistory& TermHistories::of(std::size_t slot) {
  check(slot, all_.size());
  return all_[slot];
}

}  // namespace ixos
