/// Random numbers without a state.
#pragma once
#include <cmath>
#include <cstdint>
#include <initializer_list>

namespace ixos {

/// Returns a number in [0, 1) that depends on its arguments alone, on all machines alike: SplitMix64 (Steele, Lea and
/// Flood 2014) hashes seed, owner and index.
inline double counted_random(std::uint64_t seed, std::uint64_t owner, std::uint64_t index) {
  std::uint64_t state = seed;
  for (const std::uint64_t next : {owner, index}) {
    state += 0x9e3779b97f4a7c15U * (next + 1);
    state = (state ^ (state >> 30U)) * 0xbf58476d1ce4e5b9U;
    state = (state ^ (state >> 27U)) * 0x94d049bb133111ebU;
    state ^= state >> 31U;
  }
  return static_cast<double>(state >> 11U) * 0x1p-53;
}

/// Returns a number of the normal distribution of mean 0 and deviation 1 (Box and Muller 1958), likewise.
inline double counted_normal(std::uint64_t seed, std::uint64_t owner, std::uint64_t index) {
  const double radius = counted_random(seed, owner, 2 * index), angle = counted_random(seed, owner, 2 * index + 1);
  return std::sqrt(-2 * std::log(1 - radius)) * std::cos(2 * 3.141592653589793 * angle);
}

}  // namespace ixos
