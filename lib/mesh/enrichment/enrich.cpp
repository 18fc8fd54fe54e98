#include "mesh/enrichment/enrich.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "base/error.hpp"
#include "fem/cell_info.hpp"
#include "fem/corner_element.hpp"
#include "mesh/enrichment/contact_elements.hpp"
#include "mesh/enrichment/contact_nodes.hpp"
#include "mesh/selection.hpp"
#include "mesh/side_set_nodes.hpp"

namespace ixos {

const std::vector<std::pair<std::string, ContactElement>>& contact_elements() {
  static const std::vector<std::pair<std::string, ContactElement>> all{
      {"Q1C1", ContactElement::Q1C1}, {"Q1C2", ContactElement::Q1C2}, {"Q1C3", ContactElement::Q1C3},
      {"Q1C4", ContactElement::Q1C4}, {"Q1CH", ContactElement::Q1CH}, {"Q2C2", ContactElement::Q2C2},
      {"Q2C4", ContactElement::Q2C4}};
  return all;
}

namespace {

/// Returns whether an edge on which a node hangs ends at the sides of the set, or the node is one of theirs.
bool has_hanging_nodes(const Mesh& mesh, const SideSet& set) {
  const std::set<int> nodes = nodes_of(mesh, set);
  return std::any_of(mesh.hanging_edges.begin(), mesh.hanging_edges.end(), [&](const std::array<int, 3>& edge) {
    return std::any_of(edge.begin(), edge.end(), [&](int node) { return nodes.count(node) > 0; });
  });
}

/// Returns the type of cells whose contact side is that element, which is neither Q1C1 nor Q2C2.
CellType enriched_type(int dimension, ContactElement element) {
  for (const auto& [name, own] : contact_elements())
    for (const CellInfo& info : cell_infos())
      if (own == element && info.dimension == dimension && info.contact == name) return info.type;
  throw std::logic_error("no cell has that contact side");
}

void check(const Mesh& mesh, const SideSet& set) {
  std::set<std::pair<int, int>> cells;
  for (const Side& side : set.sides) {
    const ElementBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
    const std::string where =
        fmt::format("side set \"{}\", block \"{}\", cell {}", set.name, block.name, side.cell + 1);
    if (corner_type(block.type) != cube_type(mesh.dimension))
      throw InputError(where + ": only quadrilaterals and hexahedra have enriched sides");
    if (is_enriched(block.type))
      throw InputError(where + ": the cell already has an enriched side; a cell can have only one");
    if (!cells.insert({side.block, side.cell}).second)
      throw InputError(where + ": two sides of the cell are in the set; an enriched cell can have only one");
  }
}

/// A cell turned so that one of its sides becomes the contact side.
struct Turn {
  std::vector<int> node;  ///< by new node: the old one, corners first
  std::vector<int> side;  ///< by old side: the new one
};

/// Returns the corner joined to `corner` by the edge that leaves the side `corners` of a hexahedron.
int opposite(int corner, const std::vector<int>& corners) {
  const int layer = corner / 4 * 4, above = (corner + 4) % 8;
  for (int other : {layer + (corner + 1) % 4, layer + (corner + 3) % 4})
    if (std::find(corners.begin(), corners.end(), above) != corners.end() &&
        std::find(corners.begin(), corners.end(), other) == corners.end())
      return other;
  return above;
}

/// Adds the middles of edges, faces and the cell to a turn of the corners.
void turn_middles(int dimension, Turn& turn) {
  const auto& pattern = corners_of_nodes(dimension);
  for (std::size_t a = turn.node.size(); a < pattern.size(); ++a) {
    std::vector<int> old;
    for (int corner : pattern[a]) old.push_back(turn.node[static_cast<std::size_t>(corner)]);
    std::sort(old.begin(), old.end());
    turn.node.push_back(static_cast<int>(std::find(pattern.begin(), pattern.end(), old) - pattern.begin()));
  }
}

Turn turn_of(CellType plain, int side) {
  const CellType linear = corner_type(plain);
  Turn turn;
  if (linear == CellType::Quad4) {
    for (int a = 0; a < 4; ++a) turn.node.push_back((a + side) % 4);
  } else {
    const std::vector<int>& corners = side_nodes(linear, side);
    turn.node = {corners[0], corners[3], corners[2], corners[1]};  // the bottom is seen from inside
    for (int a = 0; a < 4; ++a) turn.node.push_back(opposite(turn.node[static_cast<std::size_t>(a)], corners));
  }
  const int sides = sides_per_cell(linear);
  turn.side.resize(static_cast<std::size_t>(sides));
  for (int now = 0; now < sides; ++now) {
    std::set<int> corners;
    for (int a : side_nodes(linear, now)) corners.insert(turn.node[static_cast<std::size_t>(a)]);
    for (int old = 0; old < sides; ++old)
      if (corners == std::set<int>(side_nodes(linear, old).begin(), side_nodes(linear, old).end()))
        turn.side[static_cast<std::size_t>(old)] = now;
  }
  if (is_quadratic(plain)) turn_middles(linear == CellType::Quad4 ? 2 : 3, turn);
  return turn;
}

/// Moves the set's cells to new blocks, turned so that their contact side is where their type wants it.
class BlockSplit {
 public:
  BlockSplit(Mesh& mesh, const SideSet& set, const std::vector<ExtraNodes>& extra, CellType type, int points)
      : mesh_(mesh), extra_(extra), type_(type), points_(points), rich_(mesh.blocks.size()) {
    for (int side = 0; side < sides_per_cell(type); ++side) turns_.push_back(turn_of(plain_type(type), side));
    for (std::size_t k = 0; k < set.sides.size(); ++k)
      rich_[static_cast<std::size_t>(set.sides[k].block)][set.sides[k].cell] = {set.sides[k].side, k};
  }

  void apply() {
    std::vector<ElementBlock> blocks;
    for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) split(mesh_.blocks[b], rich_[b], blocks);
    mesh_.blocks = std::move(blocks);
    for (SideSet& set : mesh_.side_sets) move(set.sides);
    move(mesh_.hanging_sides);
  }

 private:
  struct Place {
    int block;
    int cell;
    int turn;  ///< the old number of the contact side, -1 of cells that are not turned
  };
  struct Rich {
    int side;           ///< the cell's contact side
    std::size_t index;  ///< its number in the set
  };

  void move(std::vector<Side>& sides) const {
    for (Side& side : sides) {
      const Place& place = places_[static_cast<std::size_t>(side.block)][static_cast<std::size_t>(side.cell)];
      const auto old = static_cast<std::size_t>(side.side);
      side = {place.block, place.cell, place.turn < 0 ? side.side : turn(place.turn).side[old]};
    }
  }

  const Turn& turn(int side) const { return turns_[static_cast<std::size_t>(side)]; }

  /// Cells without enrichment stay in front, the others follow, by the edges that are tied.
  void split(ElementBlock& old, const std::map<int, Rich>& rich, std::vector<ElementBlock>& blocks) {
    std::map<unsigned, int> number;  // by tied edges: the block
    for (const auto& [cell, entry] : rich) number[extra_[entry.index].tied] = 0;
    const auto first = static_cast<int>(blocks.size());
    int next = rich.size() < static_cast<std::size_t>(old.cells()) || rich.empty() ? first + 1 : first;
    for (auto& [tied, block] : number) block = next++;
    blocks.resize(static_cast<std::size_t>(next));
    for (const auto& [tied, block] : number)
      blocks[static_cast<std::size_t>(block)] = {old.name, type_, {}, {}, points_, tied};

    places_.emplace_back();
    std::vector<int> plain_nodes;
    std::vector<long long> plain_numbers;
    std::vector<double> plain_scale = old.derivative_scale;  // of an enriched block, which is never split
    const int n = nodes_per_cell(old.type);
    int plain = 0;
    for (int cell = 0; cell < old.cells(); ++cell) {
      const int* nodes = &old.nodes[cell_entry(cell, n)];
      const auto found = rich.find(cell);
      const auto number_in_file = old.file_numbers.begin() + (old.file_numbers.empty() ? 0 : cell);
      const auto end_of_number = number_in_file + (old.file_numbers.empty() ? 0 : 1);
      if (found == rich.end()) {
        plain_numbers.insert(plain_numbers.end(), number_in_file, end_of_number);
        places_.back().push_back({first, plain++, -1});
        plain_nodes.insert(plain_nodes.end(), nodes, nodes + n);
        continue;
      }
      const ExtraNodes& extra = extra_[found->second.index];
      const int block = number.at(extra.tied);
      ElementBlock& target = blocks[static_cast<std::size_t>(block)];
      places_.back().push_back({block, target.cells(), found->second.side});
      for (int a : turn(found->second.side).node) target.nodes.push_back(nodes[a]);
      target.nodes.insert(target.nodes.end(), extra.nodes.begin(), extra.nodes.end());
      target.file_numbers.insert(target.file_numbers.end(), number_in_file, end_of_number);
      target.derivative_scale.insert(target.derivative_scale.end(), extra.derivative_scale.begin(),
                                     extra.derivative_scale.end());
    }
    if (plain > 0 || rich.empty())
      blocks[static_cast<std::size_t>(first)] = {old.name,   old.type, std::move(plain_nodes),  std::move(plain_scale),
                                                 old.points, old.tied, std::move(plain_numbers)};
  }

  Mesh& mesh_;
  const std::vector<ExtraNodes>& extra_;
  CellType type_;
  int points_;
  std::vector<Turn> turns_;
  std::vector<std::map<int, Rich>> rich_;   ///< by block: its cells in the set
  std::vector<std::vector<Place>> places_;  ///< where each old cell went
};

std::vector<ExtraNodes> add_nodes(Mesh& mesh, const SideSet& set, ContactElement element) {
  switch (element) {
    case ContactElement::Q1C2:
      return add_lagrange_nodes(mesh, set, 2);
    case ContactElement::Q1C3:
      return add_lagrange_nodes(mesh, set, 3);
    case ContactElement::Q1C4:
      return add_lagrange_nodes(mesh, set, 4);
    case ContactElement::Q2C4:
      return add_quarter_nodes(mesh, set);
    case ContactElement::Q1CH:
      return mesh.dimension == 2 ? add_hermite_nodes(mesh, set) : add_hermite_face_nodes(mesh, set);
    case ContactElement::Q1C1:
    case ContactElement::Q2C2:
      break;
  }
  throw std::logic_error("the sides of this contact element have no extra nodes");
}

}  // namespace

ContactElement fitting_element(const Mesh& mesh, const SideSet& set, ContactElement asked) {
  const bool of_quadratic = asked == ContactElement::Q2C2 || asked == ContactElement::Q2C4;
  ContactElement fitting = asked;
  for (const Side& side : set.sides) {
    const ElementBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
    const std::string where = fmt::format("side set \"{}\", block \"{}\"", set.name, block.name);
    if (!is_cube(block.type) && asked != ContactElement::Q1C1 && asked != ContactElement::Q2C2)
      throw InputError(where +
                       ": only quadrilaterals and hexahedra have enriched sides; leave out the contact element");
    if (!is_quadratic(block.type) && of_quadratic)
      throw InputError(where +
                       ": Q2C2 and Q2C4 are contact elements of quadratic cells, and these cells are linear; choose "
                       "Q1C1, Q1C2, Q1C3, Q1C4 or Q1CH, or quadratic cells (Mesh/Cell Order 2)");
    if (is_quadratic(block.type) && !of_quadratic && asked != ContactElement::Q1C1)
      throw InputError(where +
                       ": Q1C2, Q1C3, Q1C4 and Q1CH are contact elements of linear cells, and these cells are "
                       "quadratic; choose Q2C2, their own side, Q2C4, or linear cells");
    if (is_quadratic(block.type) && asked == ContactElement::Q1C1) fitting = ContactElement::Q2C2;
  }
  return fitting;
}

void enrich(Mesh& mesh, const std::string& side_set, ContactElement element, int points) {
  if (element == ContactElement::Q1C1) return;
  const SideSet set = side_set_named(mesh, side_set);  // a copy: the mesh's own changes on the way
  if (fitting_element(mesh, set, element) == ContactElement::Q2C2) return;
  check(mesh, set);
  if (element == ContactElement::Q1CH && has_hanging_nodes(mesh, set))
    throw InputError("side set \"" + side_set +
                     "\": Hermite sides (Q1CH) are continued from cell to cell, which hanging nodes interrupt; choose "
                     "Q1C2 or Q1C4, or leave the mesh as coarse as it is");
  if (mesh.plain_nodes < 0) mesh.plain_nodes = mesh.nodes();
  const CellType type = enriched_type(mesh.dimension, element);
  const std::vector<ExtraNodes> extra = add_nodes(mesh, set, element);
  BlockSplit(mesh, set, extra, type, points).apply();
}

}  // namespace ixos
