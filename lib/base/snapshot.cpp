#include "base/snapshot.hpp"

#include <iterator>
#include <stdexcept>

namespace ixos {

class Snapshot::Memory final : public MemoryRecord {
 public:
  using MemoryRecord::MemoryRecord;

  bool same_scene() const override { return true; }
  bool same_solution() const override { return true; }
  bool same_partition() const override { return true; }
  bool in_memory() const override { return true; }
  void all_shares(const char*, std::vector<double>&) override {
    throw std::logic_error("a snapshot has no shares of other ranks");
  }
};

void Snapshot::save() {
  full_ = false;
  Memory memory(values_, ++saves_);
  transfer_(memory);
  for (auto value = values_.begin(); value != values_.end();)  // of earlier saves, which this one did not name
    value = value->second.saved == saves_ ? std::next(value) : values_.erase(value);
  full_ = true;
}

void Snapshot::restore() {
  if (!full_) throw std::logic_error("nothing was saved to restore");
  Memory memory(values_, 0);
  transfer_(memory);
}

double Snapshot::bytes() const {
  double sum = 0;
  for (const auto& [path, value] : values_)
    sum += static_cast<double>(sizeof(value) + value.text.size() + 8 * value.numbers.size());
  return sum;
}

}  // namespace ixos
