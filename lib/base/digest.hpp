/// Checksums.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace ixos {

/// The two words of a checksum of 128 bits, high word first.
using Checksum = std::array<std::uint64_t, 2>;

/// XXH3, 128 bits (Collet), of bytes that are added piece by piece.
class Digest {
 public:
  Digest();
  ~Digest();
  Digest(const Digest&) = delete;
  Digest& operator=(const Digest&) = delete;

  void add(const void* data, std::size_t size);
  Checksum value() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Returns the checksum of one piece.
Checksum checksum(const void* data, std::size_t size);

}  // namespace ixos
