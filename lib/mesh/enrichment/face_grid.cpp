#include "mesh/enrichment/face_grid.hpp"

#include <fmt/format.h>

#include <set>

#include "base/error.hpp"
#include "mesh/cell_sides.hpp"

namespace ixos {
namespace {

/// By spoke: the corner of the face that follows it counter-clockwise.
using Around = std::map<int, std::pair<std::size_t, std::size_t>>;

[[noreturn]] void refuse(const Mesh& mesh, const SideSet& set, int node, const std::string& what) {
  const double* x = &mesh.coordinates[3 * static_cast<std::size_t>(node)];
  throw InputError(fmt::format(
      "side set \"{}\", node {} at ({:.6g}, {:.6g}, {:.6g}): {}; the Hermite contact element Q1CH needs a "
      "regular grid of faces, four around each node inside the set and at most three around one of its rim; "
      "Q1C1 to Q1C4 take any faces",
      set.name, node + 1, x[0], x[1], x[2], what));
}

/// Takes the faces that follow each other from a spoke on.
Fan take_fan(const std::vector<Face>& faces, int node, int spoke, Around& around) {
  Fan fan{node, {spoke}, {}};
  for (auto found = around.find(spoke); found != around.end(); found = around.find(fan.spokes.back())) {
    const auto [face, corner] = found->second;
    around.erase(found);
    fan.faces.push_back(face);
    const int next = faces[face][(corner + 3) % 4];
    if (next == spoke) break;
    fan.spokes.push_back(next);
  }
  return fan;
}

}  // namespace

FaceGrid::FaceGrid(const Mesh& mesh, const SideSet& set) : places_(set.sides.size()) {
  for (const Side& side : set.sides) {
    const std::vector<int> corners = nodes_of_side(mesh, side);
    faces_.push_back({corners[0], corners[1], corners[2], corners[3]});
  }
  find_fans(mesh, set);
  find_widths(mesh);
}

void FaceGrid::find_fans(const Mesh& mesh, const SideSet& set) {
  std::map<int, Around> nodes;
  for (std::size_t f = 0; f < faces_.size(); ++f)
    for (std::size_t c = 0; c < 4; ++c)
      if (!nodes[faces_[f][c]].insert({faces_[f][(c + 1) % 4], {f, c}}).second)
        refuse(mesh, set, faces_[f][c], "more than two faces share an edge that ends there");
  for (auto& [node, around] : nodes) {
    std::set<int> inside;  // spokes that a face precedes
    for (const auto& [spoke, at] : around) inside.insert(faces_[at.first][(at.second + 3) % 4]);
    std::vector<int> starts;  // of open fans; then of closed ones, where any spoke will do
    for (const auto& [spoke, at] : around)
      if (inside.count(spoke) == 0) starts.push_back(spoke);
    for (std::size_t k = 0; !around.empty(); ++k) {
      Fan fan = take_fan(faces_, node, k < starts.size() ? starts[k] : around.begin()->first, around);
      const bool closed = fan.faces.size() == fan.spokes.size();
      if (closed ? fan.faces.size() != 4 : fan.faces.size() > 3)
        refuse(mesh, set, node,
               fmt::format("{} faces meet {}", fan.faces.size(), closed ? "around it" : "at it on the rim"));
      for (std::size_t position = 0; position < fan.faces.size(); ++position)
        for (std::size_t c = 0; c < 4; ++c)
          if (faces_[fan.faces[position]][c] == node) places_[fan.faces[position]][c] = {fans_.size(), position};
      fans_.push_back(std::move(fan));
    }
  }
}

void FaceGrid::find_widths(const Mesh& mesh) {
  std::map<Edge, std::vector<Edge>> opposite;
  for (const Face& face : faces_)
    for (std::size_t k = 0; k < 4; ++k)
      opposite[edge_key(face[k], face[(k + 1) % 4])].push_back(edge_key(face[(k + 2) % 4], face[(k + 3) % 4]));
  for (const auto& entry : opposite) {
    if (widths_.count(entry.first) != 0) continue;
    std::vector<Edge> row{entry.first};
    widths_[entry.first] = 0;
    double sum = 0;
    for (std::size_t k = 0; k < row.size(); ++k) {
      sum += length(mesh, row[k]);
      for (const Edge& next : opposite.at(row[k]))
        if (widths_.insert({next, 0.0}).second) row.push_back(next);
    }
    for (const Edge& edge : row) widths_[edge] = sum / static_cast<double>(row.size());
  }
}

}  // namespace ixos
