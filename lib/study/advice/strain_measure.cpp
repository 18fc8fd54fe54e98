#include "study/advice/strain_measure.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "scene/output/strain_columns.hpp"

namespace ixos {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

}  // namespace

bool MeasuredStrains::known() const {
  return std::isfinite(rotation) && std::isfinite(least) && std::isfinite(largest);
}

void MeasuredStrains::add(const MeasuredStrains& other) {
  if (!other.known()) return;
  if (!known()) {
    *this = other;
    return;
  }
  rotation = std::max(rotation, other.rotation);
  least = std::min(least, other.least);
  largest = std::max(largest, other.largest);
}

MeasuredStrains measured_strains(const HistoryTable& table, double end) {
  MeasuredStrains result;
  for (const char* column : strain_columns)
    if (!table.has(column)) return result;
  const std::vector<double>&times = table.column("time"), &rotation = table.column(strain_columns[0]),
        &least = table.column(strain_columns[1]), &largest = table.column(strain_columns[2]);
  for (std::size_t i = 0; i < times.size(); ++i)
    if (i == 0 || times[i - 1] < end) result.add({rotation[i], least[i], largest[i]});
  return result;
}

double measure_error(const std::string& law, const MeasuredStrains& strains) {
  if (law == "Linear Elastic") {
    if (!strains.known()) return unknown;
    const double sine = std::sin(strains.rotation / 2);
    return 2 * sine * sine + std::max(-strains.least, strains.largest);
  }
  if (law == "Saint Venant-Kirchhoff") {
    if (!strains.known()) return unknown;
    const double stretch = 1 + std::min(0.0, strains.least);
    return 3 * stretch * stretch > 1 && stretch > 0 ? 1 - stretch * (1 + stretch) / 2 : unknown;
  }
  return 0;
}

}  // namespace ixos
