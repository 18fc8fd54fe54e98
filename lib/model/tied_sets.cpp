#include "model/tied_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "mesh/cell_place.hpp"

namespace ixos {
namespace {

std::string in_words(const LocalMesh& mesh, int node) {
  const auto n = static_cast<std::size_t>(node), d = static_cast<std::size_t>(mesh.dimension);
  std::array<double, 3> place{};
  std::copy_n(&mesh.coordinates[n * d], d, place.begin());
  return fmt::format("node {} of the mesh at {}", mesh.message_number(n), point_in_words(place, mesh.dimension));
}

}  // namespace

void TiedConditions::add(const std::string& node_set, int node, IsHeld is_held) {
  conditions_.push_back({node_set, node, std::move(is_held)});
}

void TiedConditions::check(const LocalMesh& mesh, const Comm& comm) const {
  if (mesh.global_tied == 0) return;
  together<InputError>(comm, [&] {
    for (const auto& [node_set, node, is_held] : conditions_)
      for (const NodeTies::Share* share = mesh.ties.begin(node); share != mesh.ties.end(node); ++share)
        if (!is_held(share->master))
          throw InputError(
              fmt::format("the node set \"{}\" has {}, which is tied to {}; no condition holds that one in the same "
                          "way. Add it to a set with such a condition, or leave the tied node out",
                          node_set, in_words(mesh, node), in_words(mesh, share->master)));
  });
}

}  // namespace ixos
