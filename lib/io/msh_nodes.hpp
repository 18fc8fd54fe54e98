/// The nodes of a .msh file by their tags.
#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "io/msh_source.hpp"

namespace ixos {

class MshNodes {
 public:
  void reserve(std::size_t count) { places_.reserve(count); }
  std::size_t size() const { return places_.size(); }
  /// Adds the next node of the file.
  void add(std::uint64_t tag) { places_.emplace_back(tag, static_cast<int>(places_.size())); }
  /// Ends the list. Throws InputError with the place in the source if a tag is given twice.
  void finish(const MshSource& source);
  /// Returns the index of the node that an element names next. Throws InputError if there is none.
  int of_element(std::uint64_t tag, const MshSource& source) const;

 private:
  std::vector<std::pair<std::uint64_t, int>> places_;
};

}  // namespace ixos
