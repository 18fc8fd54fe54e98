/// Terms that remember which parts of a surface see each other.
#pragma once
#include "base/record.hpp"

namespace ixos {

/// An interface of terms whose forces at a displacement depend on what a surface has seen of itself before: parts that
/// overlap no longer face each other. It is state, and no history of a law, but another scene that resumes from the
/// same displacement needs it, too.
class KeepsSight {
 public:
  virtual ~KeepsSight() = default;
  /// Transfers what the surface saw. If the record is that of another surface, loading changes nothing. Collective.
  virtual void transfer_sight(Record& record) = 0;
};

}  // namespace ixos
