#include "base/digest.hpp"

#include <xxhash.h>

#include <new>

namespace ixos {
namespace {

Checksum words(const XXH128_hash_t& hash) { return {hash.high64, hash.low64}; }

}  // namespace

struct Digest::State {
  State() : state(XXH3_createState()) {
    if (state == nullptr) throw std::bad_alloc();
    XXH3_128bits_reset(state);
  }
  ~State() { XXH3_freeState(state); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  XXH3_state_t* state;
};

Digest::Digest() : state_(std::make_unique<State>()) {}
Digest::~Digest() = default;

void Digest::add(const void* data, std::size_t size) {
  if (size > 0) XXH3_128bits_update(state_->state, data, size);
}

Checksum Digest::value() const { return words(XXH3_128bits_digest(state_->state)); }

Checksum checksum(const void* data, std::size_t size) { return words(XXH3_128bits(data, size)); }

}  // namespace ixos
