/// A state in memory to which a program returns.
#pragma once
#include <functional>
#include <utility>

#include "base/memory_record.hpp"

namespace ixos {

/// Keeps a state that one function names, for example Integrator::transfer(), and restores it: in the same process and
/// in the same objects, to the last bit. Saving again reuses the memory. Collective as far as the function is.
class Snapshot {
 public:
  /// `transfer` names the state, as for a checkpoint; what it refers to must outlive the snapshot.
  explicit Snapshot(std::function<void(Record&)> transfer) : transfer_(std::move(transfer)) {}

  /// Keeps the present state instead of an earlier one. Throws what the function throws; then nothing is kept.
  void save();
  /// Returns to the state of the last save(), any number of times. Throws std::logic_error if there is none, or if the
  /// function names something that it did not name then.
  void restore();
  bool empty() const { return !full_; }
  /// Returns the memory that the kept values take on this rank.
  double bytes() const;

 private:
  class Memory;

  std::function<void(Record&)> transfer_;
  MemoryRecord::Values values_;
  long saves_ = 0;
  bool full_ = false;
};

}  // namespace ixos
