#include "mesh/fingerprint.hpp"

#include <fmt/format.h>

#include "base/digest.hpp"

namespace ixos {

std::string fingerprint(const Mesh& mesh, const std::vector<double>& values) {
  Digest digest;
  digest.add_number(mesh.dimension);
  if (mesh.axisymmetric) digest.add_number(1);
  digest.add_number(mesh.plain_nodes);
  digest.add_array(mesh.coordinates);
  digest.add_array(mesh.derivative_of);
  for (const ElementBlock& block : mesh.blocks) {
    digest.add_array(block.name);
    digest.add_number(static_cast<long long>(block.type));
    digest.add_array(block.nodes);
    digest.add_array(block.derivative_scale);
  }
  for (const Tie& tie : mesh.ties) {
    digest.add_number(tie.node);
    digest.add_array(tie.masters);
    digest.add_array(tie.weights);
  }
  if (!values.empty()) digest.add_array(values);
  return fmt::format("{:016x}{:016x}", digest.value()[0], digest.value()[1]);
}

}  // namespace ixos
