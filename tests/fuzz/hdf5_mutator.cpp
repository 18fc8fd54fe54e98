// Mutations of HDF5 files that get past their checksums: libFuzzer's own, then the checksums of the blocks that carry
// one are made right, as whoever means harm would.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);  // NOLINT: its name
extern "C" std::uint32_t H5_checksum_metadata(const void* data, std::size_t size, std::uint32_t seed);

namespace {

/// The bytes of a version 2 object header before its checksum, by what it says itself (HDF5 File Format 3.0, IV.A.1.b).
std::size_t object_header(const std::uint8_t* block, std::size_t left) {
  if (left < 24) return 0;
  const unsigned flags = block[5];
  std::size_t at = 6 + ((flags & 32) != 0 ? 16 : 0) + ((flags & 16) != 0 ? 4 : 0), messages = 0;
  const std::size_t width = std::size_t{1} << (flags & 3);
  if (at + width > left) return 0;
  std::memcpy(&messages, block + at, width);
  at += width;
  return messages < left ? at + messages : 0;
}

/// The same of an extensible array's header (III.C.2) with addresses and lengths of eight bytes.
std::size_t array_header(const std::uint8_t*, std::size_t) { return 12 + 6 * 8 + 8; }

void mend(std::uint8_t* data, std::size_t size, const char* signature,
          std::size_t (*length_of)(const std::uint8_t*, std::size_t)) {
  const std::uint8_t* end = data + size;
  for (std::uint8_t* block = data; (block = std::search(block, data + size, signature, signature + 4)) != end;
       block += 4) {
    const auto left = static_cast<std::size_t>(end - block);
    const std::size_t length = length_of(block, left);
    if (length == 0 || length + 4 > left) continue;
    const std::uint32_t checksum = H5_checksum_metadata(block, length, 0);
    std::memcpy(block + length, &checksum, 4);
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned) {
  size = LLVMFuzzerMutate(data, size, most);
  mend(data, size, "OHDR", object_header);
  mend(data, size, "EAHD", array_header);
  return size;
}
