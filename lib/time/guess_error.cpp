#include "time/guess_error.hpp"

#include <algorithm>
#include <cmath>

namespace ixos {

double guess_error(const Model& model, const std::vector<double>& guess, const std::vector<double>& u) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  double largest = 0;  // square
  for (const LocalBlock& block : mesh.blocks) {
    const auto corners = static_cast<std::size_t>(nodes_per_cell(corner_type(block.type)));
    const auto stride = static_cast<std::size_t>(nodes_per_cell(block.type));
    for (std::size_t cell = 0; cell < block.nodes.size(); cell += stride) {
      const auto first = static_cast<std::size_t>(block.nodes[cell]) * d;
      for (std::size_t k = 1; k < corners; ++k) {
        const auto node = static_cast<std::size_t>(block.nodes[cell + k]) * d;
        double square = 0, length = 0;
        for (std::size_t i = 0; i < d; ++i) {
          const double jump = (guess[node + i] - u[node + i]) - (guess[first + i] - u[first + i]);
          const double way = mesh.coordinates[node + i] - mesh.coordinates[first + i];
          square += jump * jump;
          length += way * way;
        }
        if (square > largest * length) largest = square / length;
      }
    }
  }
  return std::sqrt(largest);
}

}  // namespace ixos
