#include "mesh/enrich.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "mesh/selection.hpp"

namespace ixos {
namespace {

struct Kind {
  CellType type;
  int inner;  ///< extra Lagrange nodes of a side; none of a Hermite side
};

Kind kind(ContactElement element) {
  switch (element) {
    case ContactElement::Q1C2:
      return {CellType::Quad4C2, 1};
    case ContactElement::Q1C3:
      return {CellType::Quad4C3, 2};
    case ContactElement::Q1C4:
      return {CellType::Quad4C4, 3};
    default:
      return {CellType::Quad4CH, 0};
  }
}

using Edge = std::pair<int, int>;  ///< nodes, counter-clockwise seen from outside

Edge edge_of(const ElementBlock& block, const Side& side) {
  const auto& ends = side_nodes(CellType::Quad4, side.side);
  return {block.nodes[cell_entry(side.cell, 4, ends[0])], block.nodes[cell_entry(side.cell, 4, ends[1])]};
}

class Enrichment {
 public:
  Enrichment(Mesh& mesh, const SideSet& set, const Kind& kind, int points)
      : mesh_(mesh), set_(set), kind_(kind), points_(points) {}

  void apply() {
    check();
    if (mesh_.plain_nodes < 0) mesh_.plain_nodes = mesh_.nodes();
    if (mesh_.derivative_of.empty() && kind_.type == CellType::Quad4CH)
      mesh_.derivative_of.assign(static_cast<std::size_t>(mesh_.nodes()), -1);
    for (const Side& side : set_.sides) {
      const Edge edge = edge_of(mesh_.blocks[static_cast<std::size_t>(side.block)], side);
      previous_[edge.second] = edge.first;
      next_[edge.first] = edge.second;
    }
    for (const Side& side : set_.sides) add_nodes(edge_of(mesh_.blocks[static_cast<std::size_t>(side.block)], side));
    split_blocks();
    renumber_sides();
    complete_node_sets();
  }

 private:
  void check() const {
    std::set<std::pair<int, int>> cells;
    for (const Side& side : set_.sides) {
      const ElementBlock& block = mesh_.blocks[static_cast<std::size_t>(side.block)];
      const std::string where =
          fmt::format("side set \"{}\", block \"{}\", cell {}", set_.name, block.name, side.cell + 1);
      if (block.type == CellType::Hex8)
        throw InputError(where + ": hexahedra have no enriched contact elements; Q1C1 only");
      if (block.type != CellType::Quad4)
        throw InputError(where + ": the cell has an enriched side already; a cell can have one");
      if (!cells.insert({side.block, side.cell}).second)
        throw InputError(where + ": two sides of the cell are in the set; an enriched cell can have one");
    }
  }

  double length(const Edge& edge) const {
    const auto a = 2 * static_cast<std::size_t>(edge.first), b = 2 * static_cast<std::size_t>(edge.second);
    return std::hypot(mesh_.coordinates[b] - mesh_.coordinates[a], mesh_.coordinates[b + 1] - mesh_.coordinates[a + 1]);
  }

  int add_node(const std::array<double, 2>& x, int derivative_of) {
    mesh_.coordinates.insert(mesh_.coordinates.end(), x.begin(), x.end());
    if (!mesh_.derivative_of.empty()) mesh_.derivative_of.push_back(derivative_of);
    return mesh_.nodes() - 1;
  }

  /// The node's neighbours along the set, itself where the set ends.
  Edge neighbours(int node) const {
    const auto before = previous_.find(node), after = next_.find(node);
    return {before == previous_.end() ? node : before->second, after == next_.end() ? node : after->second};
  }

  /// The length that a node's derivative is scaled by: the mean of its two sides'.
  double nodal_length(int node) const {
    const auto [before, after] = neighbours(node);
    const double lengths = length({before, node}) + length({node, after});
    return before == node || after == node ? lengths : lengths / 2;
  }

  int derivative_node(int node) {
    const auto known = derivative_nodes_.find(node);
    if (known != derivative_nodes_.end()) return known->second;
    const auto [before, after] = neighbours(node);
    const double spans = before == node || after == node ? 1 : 2;
    std::array<double, 2> tangent;  // dX/dxi of a side of the nodal length
    for (std::size_t i = 0; i < 2; ++i)
      tangent[i] = (mesh_.coordinates[2 * static_cast<std::size_t>(after) + i] -
                    mesh_.coordinates[2 * static_cast<std::size_t>(before) + i]) /
                   (2 * spans);
    return derivative_nodes_[node] = add_node(tangent, node);
  }

  void add_nodes(const Edge& edge) {
    std::vector<int>& extra = extra_[edge];
    if (kind_.type == CellType::Quad4CH) {
      extra = {derivative_node(edge.first), derivative_node(edge.second)};
      return;
    }
    for (int k = 1; k <= kind_.inner; ++k) {
      const double t = static_cast<double>(k) / (kind_.inner + 1);
      std::array<double, 2> x;
      for (std::size_t i = 0; i < 2; ++i)
        x[i] = (1 - t) * mesh_.coordinates[2 * static_cast<std::size_t>(edge.first) + i] +
               t * mesh_.coordinates[2 * static_cast<std::size_t>(edge.second) + i];
      extra.push_back(add_node(x, -1));
    }
  }

  /// Moves the set's cells to new blocks, turned so that their contact side is the first.
  void split_blocks() {
    std::vector<std::map<int, int>> turned(mesh_.blocks.size());  // by block: contact side of each enriched cell
    for (const Side& side : set_.sides) turned[static_cast<std::size_t>(side.block)][side.cell] = side.side;
    std::vector<ElementBlock> blocks;
    for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
      ElementBlock& old = mesh_.blocks[b];
      places_.emplace_back();
      if (turned[b].empty()) {
        for (int cell = 0; cell < old.cells(); ++cell)
          places_.back().push_back({static_cast<int>(blocks.size()), cell, 0});
        blocks.push_back(std::move(old));
        continue;
      }
      ElementBlock plain{old.name, old.type, {}, {}, old.points};
      ElementBlock rich{old.name, kind_.type, {}, {}, points_};
      const bool keeps_plain = turned[b].size() < static_cast<std::size_t>(old.cells());
      const int rich_block = static_cast<int>(blocks.size()) + (keeps_plain ? 1 : 0);
      for (int cell = 0; cell < old.cells(); ++cell) {
        const int* nodes = &old.nodes[cell_entry(cell, 4)];
        const auto found = turned[b].find(cell);
        if (found == turned[b].end()) {
          places_.back().push_back({static_cast<int>(blocks.size()), plain.cells(), 0});
          plain.nodes.insert(plain.nodes.end(), nodes, nodes + 4);
          continue;
        }
        const int turn = found->second;
        places_.back().push_back({rich_block, rich.cells(), turn});
        for (int a = 0; a < 4; ++a) rich.nodes.push_back(nodes[(a + turn) % 4]);
        const Edge edge{nodes[turn], nodes[(turn + 1) % 4]};
        const std::vector<int>& extra = extra_.at(edge);
        rich.nodes.insert(rich.nodes.end(), extra.begin(), extra.end());
        if (kind_.type == CellType::Quad4CH)
          for (int node : {edge.first, edge.second}) rich.derivative_scale.push_back(length(edge) / nodal_length(node));
      }
      if (keeps_plain) blocks.push_back(std::move(plain));
      blocks.push_back(std::move(rich));
    }
    mesh_.blocks = std::move(blocks);
  }

  void renumber_sides() {
    for (SideSet& set : mesh_.side_sets)
      for (Side& side : set.sides) {
        const Place& place = places_[static_cast<std::size_t>(side.block)][static_cast<std::size_t>(side.cell)];
        const bool quad = mesh_.blocks[static_cast<std::size_t>(place.block)].type != CellType::Hex8;
        side = {place.block, place.cell, quad ? (side.side - place.turn + 4) % 4 : side.side};
      }
  }

  void complete_node_sets() {
    for (NodeSet& set : mesh_.node_sets) {
      const std::set<int> members(set.nodes.begin(), set.nodes.end());
      std::set<int> added;
      for (const auto& [edge, extra] : extra_)
        if (members.count(edge.first) != 0 && members.count(edge.second) != 0) added.insert(extra.begin(), extra.end());
      set.nodes.insert(set.nodes.end(), added.begin(), added.end());
    }
  }

  struct Place {
    int block;
    int cell;
    int turn;  ///< the old number of the cell's first side
  };

  Mesh& mesh_;
  const SideSet set_;  ///< a copy: the mesh's own changes on the way
  Kind kind_;
  int points_;
  std::map<int, int> previous_, next_;      ///< along the set
  std::map<Edge, std::vector<int>> extra_;  ///< a side's nodes beyond its ends
  std::map<int, int> derivative_nodes_;
  std::vector<std::vector<Place>> places_;  ///< where each old cell went
};

}  // namespace

void enrich(Mesh& mesh, const std::string& side_set, ContactElement element, int points) {
  if (element == ContactElement::Q1C1) return;
  Enrichment(mesh, side_set_named(mesh, side_set), kind(element), points).apply();
}

}  // namespace ixos
