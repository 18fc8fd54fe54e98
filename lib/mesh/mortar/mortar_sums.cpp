#include "mesh/mortar/mortar_sums.hpp"

#include <Teuchos_LAPACK.hpp>
#include <algorithm>
#include <cstddef>
#include <optional>

namespace ixos {
namespace {

/// Degree of the rules where shape functions are no polynomials of the place: rounding is all that is left on sides
/// whose opposite edges differ by a third.
constexpr int degree_on_distorted_sides = 18;

int degree_of(const Facet& secondary, const Facet& primary, bool axisymmetric) {
  if (!secondary.is_affine() || !primary.is_affine()) return degree_on_distorted_sides;
  return secondary.degree() + std::max(secondary.degree(), primary.degree()) + (axisymmetric ? 1 : 0);
}

}  // namespace

bool MortarSums::add(const Facet& secondary, const std::vector<FacingPart>& parts) {
  const std::size_t n = secondary.nodes().size();
  const ProjectionPlane plane = secondary.plane();
  std::vector<double> mass(n * n, 0.0), sums(n, 0.0);
  std::map<int, std::vector<double>> with_primary;  // by primary node: int N_j N_k, j the side's nodes
  for (const FacingPart& part : parts)
    for (const auto& [image, weight] : points_of(part.polygon, degree_of(secondary, *part.other, axisymmetric_))) {
      const std::optional<Vec<2>> own = secondary.find(plane, image), other = part.other->find(plane, image);
      if (!own || !other) return false;
      const double share = axisymmetric_ ? weight * secondary.point(*own)[0] : weight;
      const std::vector<double> value = secondary.values(*own), opposite = part.other->values(*other);
      for (std::size_t i = 0; i < n; ++i) {
        sums[i] += share * value[i];
        for (std::size_t j = 0; j < n; ++j) mass[i * n + j] += share * value[i] * value[j];
      }
      for (std::size_t k = 0; k < opposite.size(); ++k) {
        std::vector<double>& column = with_primary[part.other->nodes()[k]];
        column.resize(n, 0.0);
        for (std::size_t j = 0; j < n; ++j) column[j] += share * value[j] * opposite[k];
      }
    }
  std::vector<double> columns;
  for (const auto& [node, column] : with_primary) columns.insert(columns.end(), column.begin(), column.end());
  int info = 0;
  const int rows = static_cast<int>(n);
  Teuchos::LAPACK<int, double>().POSV('L', rows, static_cast<int>(with_primary.size()), mass.data(), rows,
                                      columns.data(), rows, &info);
  if (info != 0) return false;
  for (std::size_t i = 0; i < n; ++i) areas_[secondary.nodes()[i]] += sums[i];
  auto column = columns.begin();
  for (const auto& entry : with_primary)
    for (std::size_t i = 0; i < n; ++i) products_[secondary.nodes()[i]][entry.first] += sums[i] * *column++;
  return true;
}

}  // namespace ixos
