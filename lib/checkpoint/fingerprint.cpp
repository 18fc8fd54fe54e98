#include "checkpoint/fingerprint.hpp"

#include <fmt/format.h>

#include <vector>

#include "base/digest.hpp"

namespace ixos {
namespace {

class MeshDigest : Digest {
 public:
  void add(long long number) { Digest::add(&number, sizeof(number)); }
  template <class T>
  void add(const std::vector<T>& values) {
    add(static_cast<long long>(values.size()));
    Digest::add(values.data(), values.size() * sizeof(T));
  }
  void add(const std::string& text) { add(std::vector<char>(text.begin(), text.end())); }
  std::string text() const { return fmt::format("{:016x}{:016x}", value()[0], value()[1]); }
};

}  // namespace

std::string fingerprint(const Mesh& mesh) {
  MeshDigest digest;
  digest.add(mesh.dimension);
  digest.add(mesh.plain_nodes);
  digest.add(mesh.coordinates);
  digest.add(mesh.derivative_of);
  for (const ElementBlock& block : mesh.blocks) {
    digest.add(block.name);
    digest.add(static_cast<long long>(block.type));
    digest.add(block.nodes);
    digest.add(block.derivative_scale);
  }
  return digest.text();
}

}  // namespace ixos
