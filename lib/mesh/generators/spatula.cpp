#include "mesh/generators/spatula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/error.hpp"
#include "mesh/generators/spatula_pad.hpp"
#include "mesh/generators/spatula_section.hpp"

namespace ixos {
namespace {

/// A place in the mesh seen from above, or, in the shaft, across the section's upward direction.
struct Place {
  int station, column;
  int row = 0;  ///< 0: of the sweep; else a row around the tip, its columns those of the core without the outermost two
};

/// Makes the mesh: every place carries a stack of nodes, one for each layer of cells and one more; quadrilaterals of
/// places carry stacks of hexahedra. Along the places' boundary runs a rim: the cells of the rings at the narrow ends.
class Builder {
 public:
  explicit Builder(const SpatulaShape& shape)
      : shape_(shape), d_(spatula_divisions(shape)), pad_(shape, d_), layers_(shape, d_) {
    mesh_.dimension = 3;
  }

  Mesh build() {
    add_nodes();
    const int n = d_.core_cells, k = d_.tip_rows, last = d_.stations();
    for (int s = 0; s < last; ++s) {
      for (int i = 0; i < n; ++i) add_stack({{{s, i}, {s + 1, i}, {s + 1, i + 1}, {s, i + 1}}});
      add_rim({s, 0}, {s + 1, 0});
      add_rim({s + 1, n}, {s, n});
    }
    for (int i = k; i < n - k; ++i) {
      for (int row = 0; row < k; ++row)
        add_stack({tip_place(row, i), tip_place(row + 1, i), tip_place(row + 1, i + 1), tip_place(row, i + 1)});
      add_rim(tip_place(k, i), tip_place(k, i + 1));
    }
    mesh_.blocks.push_back(std::move(body_));
    for (SideSet* set : {&pad_set_, &end_set_, &surface_}) add_set(std::move(*set));
    mesh_.node_sets.push_back({"tip", {node(tip_place(k, n / 2), {n / 2, 0, d_.rings})}});
    return std::move(mesh_);
  }

 private:
  /// Row `row` around the tip. Beyond the core's outermost columns it uses the columns of the last station, where the
  /// sides are joined to the tip.
  Place tip_place(int row, int column) const {
    const int n = d_.core_cells, k = d_.tip_rows, last = d_.stations();
    if (column == k) return {last, k - row};
    if (column == n - k) return {last, n - k + row};
    return {last, column, row};
  }

  bool on_boundary(const Place& p) const { return p.column == 0 || p.column == d_.core_cells || p.row == d_.tip_rows; }

  std::size_t index(const Place& p) const {
    const int n = d_.core_cells, inner = n - 2 * d_.tip_rows - 1;
    if (p.row == 0) return cell_entry(p.station, n + 1, p.column);
    return cell_entry(d_.stations() + 1, n + 1) + cell_entry(p.row - 1, inner, p.column - d_.tip_rows - 1);
  }

  /// Nodes of a place: the stack from below, then those of the rim between its corners, ring by ring.
  int node(const Place& place, const SectionNode& at) const {
    const int m = d_.core_layers;
    int local = d_.rings + at.layer;
    if (at.layer == 0) local -= at.ring;
    if (at.layer == m) local += at.ring;
    if (at.ring > 0 && at.layer > 0 && at.layer < m) local = m + 2 * d_.rings + (at.ring - 1) * (m - 1) + at.layer;
    return first_[index(place)] + local;
  }

  void add_nodes() {
    const int n = d_.core_cells, k = d_.tip_rows;
    for (int s = 0; s <= d_.stations(); ++s)
      for (int i = 0; i <= n; ++i) add_place({s, i});
    for (int row = 1; row <= k; ++row)
      for (int i = k + 1; i < n - k; ++i) add_place({d_.stations(), i, row});
  }

  void add_place(const Place& place) {
    first_.push_back(mesh_.nodes());
    const int m = d_.core_layers, c = place.column;
    for (int ring = d_.rings; ring > 0; --ring) add_node(place, {c, 0, ring});
    for (int layer = 0; layer <= m; ++layer) add_node(place, {c, layer, 0});
    for (int ring = 1; ring <= d_.rings; ++ring) add_node(place, {c, m, ring});
    if (!on_boundary(place)) return;
    for (int ring = 1; ring <= d_.rings; ++ring)
      for (int layer = 1; layer < m; ++layer) add_node(place, {c, layer, ring});
  }

  void add_node(const Place& place, const SectionNode& at) {
    const auto x = position(place, at);
    mesh_.coordinates.insert(mesh_.coordinates.end(), x.begin(), x.end());
  }

  std::array<double, 3> position(const Place& place, const SectionNode& at) const {
    const double inset = 1 - static_cast<double>(at.ring) / d_.rings;
    const int in_pad = place.station - d_.shaft - d_.transition;
    const double height = layers_.height(at);
    if (in_pad >= 0) {
      const auto [x, y] =
          place.row > 0 ? pad_.at_tip(place.row, place.column, inset) : pad_.swept(in_pad, place.column, inset);
      return {x, y, shape_.gap + pad_.thickness(x) * height};
    }
    const double length = station_length(shape_, d_, place.station);
    const CenterlinePoint center = centerline(shape_, length);
    const double round = roundness(shape_, length);
    const auto disk = disk_node(shape_, d_, at);
    const double y = (1 - round) * pad_.swept(0, place.column, inset)[1] + round * disk[0];
    const double up = (1 - round) * shape_.rear_thickness * (height - 0.5) + round * disk[1];
    const std::array<double, 3> x{center.x + center.sine * up, place.column * 2 == d_.core_cells ? 0 : y,
                                  center.z + center.cosine * up};
    if (!(x[2] >= shape_.gap * (1 - 1e-12)))
      throw InputError(
          fmt::format("transition length {} is too short, the transition sinks below the pad's underside: "
                      "lengthen it, or choose a larger inclination or a smaller fillet radius or shaft diameter",
                      shape_.transition_length));
    return x;
  }

  /// A cell of four lower and four upper nodes, and those of its sides that lie on the surface.
  void add_cell(const std::array<int, 8>& nodes, const std::vector<std::pair<int, SideSet*>>& sides) {
    for (const auto& [side, set] : sides) {
      if (set != &surface_) set->sides.push_back({0, body_.cells(), side});
      surface_.sides.push_back({0, body_.cells(), side});
    }
    body_.nodes.insert(body_.nodes.end(), nodes.begin(), nodes.end());
  }

  /// The hexahedra over a quadrilateral of places, counter-clockwise from above.
  void add_stack(const std::array<Place, 4>& corners) {
    const int layers = d_.core_layers + 2 * d_.rings;
    const bool in_pad = corners[0].station >= d_.shaft + d_.transition;
    for (int layer = 0; layer < layers; ++layer) {
      std::array<int, 8> nodes;
      for (std::size_t a = 0; a < 4; ++a) {
        nodes[a] = first_[index(corners[a])] + layer;
        nodes[a + 4] = nodes[a] + 1;
      }
      std::vector<std::pair<int, SideSet*>> sides;
      if (layer == 0) sides.emplace_back(bottom, in_pad ? &pad_set_ : &surface_);
      if (layer == layers - 1) sides.emplace_back(top, &surface_);
      if (corners[0].station == 0) sides.emplace_back(last_edge, &end_set_);
      add_cell(nodes, sides);
    }
  }

  /// The rings' cells beyond the boundary edge from a to b, to whose left the places lie.
  void add_rim(const Place& a, const Place& b) {
    for (int ring = 0; ring < d_.rings; ++ring)
      for (int layer = 0; layer < d_.core_layers; ++layer) {
        std::array<int, 8> nodes;
        for (int up : {0, 1}) {
          const auto at = [&](const Place& p, int r) { return node(p, {p.column, layer + up, r}); };
          const std::array<int, 4> around{at(a, ring), at(a, ring + 1), at(b, ring + 1), at(b, ring)};
          std::copy(around.begin(), around.end(), up == 0 ? nodes.begin() : nodes.begin() + 4);
        }
        std::vector<std::pair<int, SideSet*>> sides;
        if (ring + 1 == d_.rings) sides.emplace_back(second_edge, &surface_);
        if (a.station == 0) sides.emplace_back(first_edge, &end_set_);
        if (b.station == 0) sides.emplace_back(third_edge, &end_set_);
        add_cell(nodes, sides);
      }
  }

  void add_set(SideSet set) {
    std::set<int> nodes;
    const ElementBlock& body = mesh_.blocks[0];
    for (const Side& side : set.sides)
      for (int a : side_nodes(body.type, side.side)) nodes.insert(body.nodes[cell_entry(side.cell, 8, a)]);
    mesh_.node_sets.push_back({set.name, {nodes.begin(), nodes.end()}});
    mesh_.side_sets.push_back(std::move(set));
  }

  static constexpr int first_edge = 0, second_edge = 1, third_edge = 2, last_edge = 3, bottom = 4, top = 5;  // sides

  const SpatulaShape shape_;
  const SpatulaDivisions d_;
  const SpatulaPad pad_;
  const SpatulaLayers layers_;
  std::vector<int> first_;  ///< by place: its lowest node
  Mesh mesh_;
  ElementBlock body_{"body", CellType::Hex8, {}};
  SideSet pad_set_{"pad", {}}, end_set_{"shaft end", {}}, surface_{"surface", {}};
};

}  // namespace

Mesh spatula(const SpatulaShape& shape) { return Builder(shape).build(); }

}  // namespace ixos
