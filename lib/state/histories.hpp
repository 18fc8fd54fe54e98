/// The histories of all terms of a model, as a value.
#pragma once
#include <cstddef>
#include <vector>

namespace ixos {

struct TermHistory;  // in state/history.hpp; its layout follows the width of a pack

/// By Term::slot(). It can be copied, compared and kept like a number.
class TermHistories {
 public:
  TermHistories();
  explicit TermHistories(std::vector<TermHistory> all);
  TermHistories(const TermHistories&);
  TermHistories(TermHistories&&) noexcept;
  TermHistories& operator=(const TermHistories&);
  TermHistories& operator=(TermHistories&&) noexcept;
  ~TermHistories();

  std::size_t size() const;
  /// Adds the histories of further slots.
  void extend(const TermHistories& longer);
  /// Throw std::logic_error if there is no history of that slot.
  const TermHistory& of(std::size_t slot) const;
  TermHistory& of(std::size_t slot);

  bool operator==(const TermHistories& other) const;
  bool operator!=(const TermHistories& other) const { return !(*this == other); }

 private:
  std::vector<TermHistory> all_;
};

}  // namespace ixos
