// Meshes of gmsh.
#include <algorithm>

#include "base/error.hpp"
#include "input.hpp"
#include "io/gmsh_mesh.hpp"
#include "mesh/quality.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ixos;
  const fuzz::MemoryFile file(data, size);
  try {
    const Mesh mesh = read_gmsh_mesh(file.path());
    const auto is_node = [&](int node) { return node >= 0 && node < mesh.nodes(); };
    for (const ElementBlock& block : mesh.blocks)
      fuzz::expect(std::all_of(block.nodes.begin(), block.nodes.end(), is_node), "a cell has a node that there is not");
    for (const NodeSet& set : mesh.node_sets)
      fuzz::expect(std::all_of(set.nodes.begin(), set.nodes.end(), is_node), "a set has a node that there is not");
    for (const SideSet& set : mesh.side_sets)
      for (const Side& side : set.sides) {
        const ElementBlock& block = mesh.blocks.at(static_cast<std::size_t>(side.block));
        fuzz::expect(
            side.cell >= 0 && side.cell < block.cells() && side.side >= 0 && side.side < sides_per_cell(block.type),
            "a set has a side that there is not");
      }
    check_cells(mesh);
  } catch (const InputError& error) {
    fuzz::expect_message(error);
  }
  return 0;
}
