#include "term/wall/wall_sides.hpp"

#include <map>
#include <tuple>

#include "fem/cell_type.hpp"
#include "fem/enriched_cell.hpp"

namespace ixos {

std::vector<SideGroup> grouped(const LocalMesh& mesh, const std::vector<LocalSide>& sides,
                               const std::vector<SideKind>& kinds) {
  std::map<std::tuple<std::size_t, std::size_t, bool, unsigned>, SideGroup> groups;
  const auto group_of = [&](int block_number, int side) -> SideGroup& {
    const LocalBlock& block = mesh.blocks[static_cast<std::size_t>(block_number)];
    const std::size_t nodes = side_nodes(block.type, side).size(),
                      corners = side_nodes(corner_type(block.type), side).size();
    const SideGroup empty{block.type, side, {}};
    return groups.insert({{nodes, corners, is_hermite(block.type), side_ties(block, side)}, empty}).first->second;
  };
  for (const SideKind& kind : kinds) group_of(kind.block, kind.side);
  for (const LocalSide& side : sides) group_of(side.block, side.side).sides.push_back(side);
  std::vector<SideGroup> result;
  result.reserve(groups.size());
  for (auto& entry : groups) result.push_back(std::move(entry.second));
  if (result.empty()) result.push_back({mesh.dimension == 2 ? CellType::Quad4 : CellType::Hex8, 0, {}});
  return result;
}

}  // namespace ixos
