/// Memory that products will need.
#pragma once
#include <cstddef>

namespace ixos {

/// Prefetches `count` entries. Products read the data kept at the points between evaluate() and integrate(), which take
/// as long: in three dimensions each point prefetches that of the next element, so that the memory is always busy. The
/// last element prefetches what lies behind the data, which is harmless.
template <class Kept>
[[gnu::always_inline]] inline void prefetch(const Kept* data, std::size_t count) {
  constexpr std::size_t cache_line = 64;
  const auto* bytes = reinterpret_cast<const char*>(data);
  for (std::size_t byte = 0; byte < count * sizeof(Kept); byte += cache_line) __builtin_prefetch(bytes + byte);
}

}  // namespace ixos
