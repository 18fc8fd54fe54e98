#include <array>

#include "mesh/enrichment/contact_nodes.hpp"
#include "mesh/enrichment/face_grid.hpp"

namespace ixos {
namespace {

/// The kinds of a node's derivatives: along its fan's spokes 0 and 2, along 1 and 3, or mixed.
constexpr std::size_t mixed = 2;

/// The derivative along a spoke points to the end of the first of its direction, and away from that of the second.
double sign_of(std::size_t spoke) { return spoke < 2 ? 1 : -1; }

class HermiteFaceNodes {
 public:
  HermiteFaceNodes(Mesh& mesh, const SideSet& set)
      : mesh_(mesh), grid_(mesh, set), tied_(tied_edges(mesh, set)), nodes_(grid_.fans().size(), {-1, -1, -1}) {}

  std::vector<ExtraNodes> add() {
    std::vector<ExtraNodes> result;
    for (std::size_t f = 0; f < grid_.faces().size(); ++f) result.push_back(add_face(f));
    complete_node_sets(mesh_, added_);
    return result;
  }

 private:
  ExtraNodes add_face(std::size_t number) {
    // By corner: its face's edges along xi and eta, and whether it is at the end of their coordinates.
    constexpr std::size_t edges[4][2] = {{0, 3}, {0, 1}, {2, 1}, {2, 3}};
    constexpr bool at_end[4][2] = {{false, false}, {true, false}, {true, true}, {false, true}};
    const Face& face = grid_.faces()[number];
    ExtraNodes extra;
    Between inside{{face.begin(), face.end()}, {}};
    std::array<Between, 4> along;
    for (std::size_t k = 0; k < 4; ++k) along[k].corners = {face[k], face[(k + 1) % 4]};
    for (std::size_t c = 0; c < 4; ++c) {
      const auto [f, position] = grid_.place(number, c);
      const Fan& fan = grid_.fans()[f];
      double product = 1;
      for (std::size_t d = 0; d < 2; ++d) {
        // Its edge to the next corner is the first of the two spokes.
        const std::size_t edge = edges[c][d], spoke = (position + (edge == c ? 0 : 1)) % fan.spokes.size();
        const double scale = (at_end[c][d] ? -1 : 1) * sign_of(spoke) * width(fan, spoke) / nodal_width(fan, spoke % 2);
        product *= scale;
        if (tied_.count(edge_key(fan.node, fan.spokes[spoke])) != 0) {
          extra.tied |= 1U << edge;
          extra.nodes.push_back(fan.node);
          extra.derivative_scale.push_back(1);
          continue;
        }
        extra.nodes.push_back(node(f, spoke % 2));
        extra.derivative_scale.push_back(scale);
        along[edge].nodes.push_back(extra.nodes.back());
      }
      extra.nodes.push_back(node(f, mixed));
      extra.derivative_scale.push_back(product);
      inside.nodes.push_back(extra.nodes.back());
    }
    added_.insert(added_.end(), along.begin(), along.end());
    added_.push_back(std::move(inside));
    return extra;
  }

  double width(const Fan& fan, std::size_t spoke) const { return grid_.width(fan.node, fan.spokes[spoke]); }

  /// Returns the length that scales a node's derivative: the mean of its spokes' lengths.
  double nodal_width(const Fan& fan, std::size_t direction) const {
    double sum = 0, count = 0;
    for (std::size_t spoke = direction; spoke < fan.spokes.size(); spoke += 2, ++count) sum += width(fan, spoke);
    return sum / count;
  }

  int node(std::size_t f, std::size_t kind) {
    int& known = nodes_[f][kind];
    if (known >= 0) return known;
    const Fan& fan = grid_.fans()[f];
    return known = add_node(mesh_, kind == mixed ? twist(fan) : tangent(fan, kind), fan.node);
  }

  /// Adds factor times a node's place.
  void add_place(int node, double factor, std::vector<double>& sum) const {
    for (std::size_t i = 0; i < 3; ++i) sum[i] += factor * mesh_.coordinates[3 * static_cast<std::size_t>(node) + i];
  }

  /// Returns dX/dxi of a face of the nodal width: the mean of the spokes' slopes.
  std::vector<double> tangent(const Fan& fan, std::size_t direction) const {
    std::vector<double> sum(3, 0.0);
    const double spans = fan.spokes.size() > direction + 2 ? 2 : 1;
    for (std::size_t spoke = direction; spoke < fan.spokes.size(); spoke += 2) {
      add_place(fan.spokes[spoke], sign_of(spoke) / (2 * spans), sum);
      add_place(fan.node, -sign_of(spoke) / (2 * spans), sum);
    }
    return sum;
  }

  /// Returns d2X/dxi deta of a face of the nodal widths: of bilinear faces, weighted with their widths.
  std::vector<double> twist(const Fan& fan) const {
    double area = 0;
    for (std::size_t k = 0; k < fan.faces.size(); ++k) area += width(fan, k) * width(fan, (k + 1) % fan.spokes.size());
    const double share = nodal_width(fan, 0) * nodal_width(fan, 1) / (4 * area);
    std::vector<double> sum(3, 0.0);
    for (std::size_t k = 0; k < fan.faces.size(); ++k) {
      const std::size_t next = (k + 1) % fan.spokes.size();
      const double factor = sign_of(k) * sign_of(next) * share;
      const int first = fan.spokes[k], second = fan.spokes[next];
      for (int corner : grid_.faces()[fan.faces[k]])
        add_place(corner, corner == first || corner == second ? -factor : factor, sum);
    }
    return sum;
  }

  Mesh& mesh_;
  FaceGrid grid_;
  std::set<Edge> tied_;
  std::vector<std::array<int, 3>> nodes_;  ///< by fan: its derivative nodes, -1 if none was needed yet
  std::vector<Between> added_;
};

}  // namespace

std::vector<ExtraNodes> add_hermite_face_nodes(Mesh& mesh, const SideSet& set) {
  return HermiteFaceNodes(mesh, set).add();
}

}  // namespace ixos
