// Exodus meshes and their nodal fields.
#include <algorithm>

#include "base/error.hpp"
#include "input.hpp"
#include "io/exodus_mesh.hpp"
#include "mesh/quality.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ixos;
  const fuzz::MemoryFile file(data, size);
  try {
    const Mesh mesh = read_tried_exodus_mesh(file.path());
    for (const ElementBlock& block : mesh.blocks)
      fuzz::expect(std::all_of(block.nodes.begin(), block.nodes.end(),
                               [&](int node) { return node >= 0 && node < mesh.nodes(); }),
                   "a cell has a node that there is not");
    check_cells(mesh);
    fuzz::expect(read_tried_exodus_field(file.path(), "strength").size() == static_cast<std::size_t>(mesh.nodes()),
                 "a field has another number of nodes than the mesh");
  } catch (const InputError& error) {
    fuzz::expect_message(error);
  }
  return 0;
}
