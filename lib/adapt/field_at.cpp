#include "adapt/field_at.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "fem/ties.hpp"
#include "fem/with_element.hpp"

namespace ixos {

void evaluate(const SplitMesh& mesh, const std::vector<double>& field, std::size_t count, const RootPoint& point,
              double* value) {
  const SplitMesh::Cell cell = mesh.cell_of(mesh.tree().leaf_at(point));
  const std::array<double, 3> xi = mesh.reference_point(cell, point);
  const ElementBlock& block = mesh.mesh().blocks[static_cast<std::size_t>(cell.block)];
  std::fill_n(value, count, 0.0);
  with_element(block.type, [&](auto tag) {
    using Element = typename decltype(tag)::type;
    std::array<double, Element::dimension> own;
    std::copy_n(xi.begin(), own.size(), own.begin());
    std::array<double, Element::nodes> shape;
    std::array<std::array<double, Element::dimension>, Element::nodes> gradient;
    evaluate_tied<Element>(block.tied, own, shape, gradient);
    const int* const nodes = &block.nodes[cell_entry(cell.cell, Element::nodes)];
    for (std::size_t a = 0; a < shape.size(); ++a)
      for (std::size_t i = 0; i < count; ++i)
        value[i] += shape[a] * field[static_cast<std::size_t>(nodes[a]) * count + i];
  });
}

std::vector<double> interpolated(const SplitMesh& from, const std::vector<double>& field, std::size_t count,
                                 const SplitMesh& to) {
  const std::vector<std::optional<RootPoint>>& places = to.places();
  std::vector<double> result(places.size() * count, 0.0);
  for (std::size_t node = 0; node < places.size(); ++node)
    if (places[node]) evaluate(from, field, count, *places[node], &result[node * count]);
  return result;
}

}  // namespace ixos
