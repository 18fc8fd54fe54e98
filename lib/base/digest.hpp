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
  /// Adds the number of entries of an array, then the entries, whose type has no padding.
  template <class Array>
  void add_array(const Array& values) {
    const auto size = static_cast<long long>(values.size());
    add(&size, sizeof(size));
    add(values.data(), values.size() * sizeof(values[0]));
  }
  void add_number(long long number) { add(&number, sizeof(number)); }
  Checksum value() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Returns the checksum of one piece.
Checksum checksum(const void* data, std::size_t size);

}  // namespace ixos
