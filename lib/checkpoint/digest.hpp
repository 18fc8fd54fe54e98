/// Checksums and fingerprints. Included by lib/checkpoint only.
#pragma once
#include <xxhash.h>

#include <cstddef>
#include <memory>

namespace ixos {

/// XXH3, 128 bits (Collet), of bytes that come in pieces.
class Digest {
 public:
  Digest() : state_(XXH3_createState(), XXH3_freeState) { XXH3_128bits_reset(state_.get()); }
  void add(const void* data, std::size_t size) {
    if (size > 0) XXH3_128bits_update(state_.get(), data, size);
  }
  XXH128_hash_t value() const { return XXH3_128bits_digest(state_.get()); }

 private:
  std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state_;
};

}  // namespace ixos
