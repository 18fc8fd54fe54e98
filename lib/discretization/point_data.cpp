#include "discretization/point_data.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>

#include "base/error.hpp"

namespace ixos {
namespace {

constexpr auto width = static_cast<std::size_t>(pack_width);

}  // namespace

PointData::PointData(const LocalBlock& block, std::size_t points, std::size_t numbers)
    : cells_(block.original_cells),
      points_(points),
      numbers_(numbers),
      data_((cells_.size() + width - 1) / width * points * numbers, Pack(0.0)) {}

void PointData::clear() { std::fill(data_.begin(), data_.end(), Pack(0.0)); }

std::vector<double> PointData::cell_by_cell() const {
  const std::size_t size = points_ * numbers_;
  std::vector<double> values(cells_.size() * size);
  for (std::size_t cell = 0; cell < cells_.size(); ++cell)
    for (std::size_t i = 0; i < size; ++i)
      values[cell * size + i] = double(data_[cell / width * size + i][cell % width]);
  return values;
}

void PointData::set_cell(std::size_t cell, const double* values) {
  const std::size_t size = points_ * numbers_;
  for (std::size_t i = 0; i < size; ++i) data_[cell / width * size + i][cell % width] = values[i];
}

void PointData::transfer(Record& record) {
  const std::size_t size = points_ * numbers_;
  std::vector<double> values, cells(cells_.begin(), cells_.end());
  if (!record.loading()) {
    values = cell_by_cell();
    record.share("cells", cells);
    record.share("values", values);
    return;
  }
  record.all_shares("cells", cells);
  record.all_shares("values", values);
  if (values.size() != cells.size() * size) throw InputError("the values at quadrature points do not fit their cells");
  std::unordered_map<long long, std::size_t> places;
  for (const double cell : cells)
    if (!(std::abs(cell) < 1e15)) throw InputError("\"cells\" has a value that is not the number of a cell");
  for (std::size_t i = 0; i < cells.size(); ++i) places.emplace(static_cast<long long>(cells[i]), i);
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    const auto found = places.find(cells_[cell]);
    if (found == places.end())
      throw InputError("the checkpoint has no values at quadrature points for cell " +
                       std::to_string(cells_[cell] + 1));
    set_cell(cell, &values[found->second * size]);
  }
}

}  // namespace ixos
