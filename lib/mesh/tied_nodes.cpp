#include "mesh/tied_nodes.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "mesh/cell_place.hpp"

namespace ixos {
namespace {

auto name_in(const Mesh& mesh) {
  return [&mesh](int node) { return node_in_words(mesh, node); };
}

}  // namespace

std::vector<Tie> resolved_ties(const Mesh& mesh) { return resolved_ties(mesh.ties, name_in(mesh)); }

void place_tied_nodes(Mesh& mesh) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<Tie> in_place;
  std::copy_if(mesh.ties.begin(), mesh.ties.end(), std::back_inserter(in_place),
               [](const Tie& tie) { return tie.in_place; });
  for (const Tie& tie : resolved_ties(in_place, name_in(mesh))) {
    double* const place = &mesh.coordinates[static_cast<std::size_t>(tie.node) * d];
    std::fill_n(place, d, 0.0);
    for (std::size_t k = 0; k < tie.masters.size(); ++k)
      for (std::size_t i = 0; i < d; ++i)
        place[i] += tie.weights[k] * mesh.coordinates[static_cast<std::size_t>(tie.masters[k]) * d + i];
  }
}

}  // namespace ixos
