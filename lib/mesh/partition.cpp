#include <fmt/format.h>
#include <metis.h>

#include <stdexcept>

#include "mesh/local_mesh.hpp"

namespace ixos {

std::vector<int> partition_nodes(const Mesh& mesh, int ranks) {
  std::vector<int> owner(static_cast<std::size_t>(mesh.nodes()), 0);
  if (ranks == 1) return owner;
  if (mesh.nodes() <= 2 * ranks) {
    // METIS balances parts of many nodes; of so few, a rank gets one each and further ranks none.
    for (std::size_t node = 0; node < owner.size(); ++node) owner[node] = static_cast<int>(node) % ranks;
    return owner;
  }

  std::vector<idx_t> start{0};
  std::vector<idx_t> nodes;
  for (const ElementBlock& block : mesh.blocks) {
    for (int cell = 0; cell < block.cells(); ++cell)
      start.push_back(start.back() + static_cast<idx_t>(nodes_per_cell(block.type)));
    nodes.insert(nodes.end(), block.nodes.begin(), block.nodes.end());
  }
  idx_t cells = mesh.cells();
  idx_t node_count = mesh.nodes();
  idx_t parts = ranks;
  idx_t cut = 0;
  std::vector<idx_t> cell_part(static_cast<std::size_t>(cells));
  std::vector<idx_t> node_part(static_cast<std::size_t>(node_count));
  std::vector<idx_t> options(METIS_NOPTIONS);
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_SEED] = 1;
  const int status = METIS_PartMeshNodal(&cells, &node_count, start.data(), nodes.data(), nullptr, nullptr, &parts,
                                         nullptr, options.data(), &cut, cell_part.data(), node_part.data());
  if (status != METIS_OK) throw std::runtime_error(fmt::format("METIS failed with status {}", status));
  for (std::size_t i = 0; i < owner.size(); ++i) owner[i] = static_cast<int>(node_part[i]);
  return owner;
}

}  // namespace ixos
