#include "checkpoint/fingerprint.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <memory>
#include <vector>

namespace ixos {
namespace {

class Digest {
 public:
  Digest() : state_(XXH3_createState(), XXH3_freeState) { XXH3_128bits_reset(state_.get()); }
  void add(long long number) { XXH3_128bits_update(state_.get(), &number, sizeof(number)); }
  template <class T>
  void add(const std::vector<T>& values) {
    add(static_cast<long long>(values.size()));
    XXH3_128bits_update(state_.get(), values.data(), values.size() * sizeof(T));
  }
  void add(const std::string& text) { add(std::vector<char>(text.begin(), text.end())); }
  std::string text() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
  }

 private:
  std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state_;
};

}  // namespace

std::string fingerprint(const Mesh& mesh) {
  Digest digest;
  digest.add(mesh.dimension);
  digest.add(mesh.plain_nodes);
  digest.add(mesh.coordinates);
  digest.add(mesh.derivative_of);
  for (const ElementBlock& block : mesh.blocks) {
    digest.add(block.name);
    digest.add(static_cast<long long>(block.type));
    digest.add(block.nodes);
    digest.add(block.derivative_scale);
    digest.add(block.points);
  }
  for (const SideSet& set : mesh.side_sets) {
    digest.add(set.name);
    std::vector<int> sides;
    for (const Side& side : set.sides) sides.insert(sides.end(), {side.block, side.cell, side.side});
    digest.add(sides);
  }
  for (const NodeSet& set : mesh.node_sets) {
    digest.add(set.name);
    digest.add(set.nodes);
  }
  return digest.text();
}

}  // namespace ixos
