#include "discretization/point_data.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace ixos {
namespace {

constexpr auto width = static_cast<std::size_t>(pack_width);

}  // namespace

PointData::PointData(const LocalBlock& block, std::size_t points, std::size_t numbers)
    : cells_(block.original_cells),
      global_cells_(block.global_cells),
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
  if (record.same_partition()) {
    const std::vector<double> mine = cells;
    record.share("cells", cells);
    record.share("values", values);
    if (cells != mine || values.size() != cells.size() * size)
      throw InputError("the values at quadrature points do not fit their cells");
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) set_cell(cell, &values[cell * size]);
    return;
  }
  record.all_shares("cells", cells);
  record.all_shares("values", values);
  // All ranks see the same numbers, and throw together.
  std::vector<std::size_t> places(static_cast<std::size_t>(global_cells_), cells.size());
  bool fits = values.size() == cells.size() * size;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool known = cells[i] >= 0 && cells[i] < global_cells_;
    fits = fits && known;
    if (known) places[static_cast<std::size_t>(cells[i])] = i;
  }
  fits = fits && std::all_of(places.begin(), places.end(), [&](std::size_t place) { return place < cells.size(); });
  if (!fits) throw InputError("the values at quadrature points do not fit the cells of their block");
  for (std::size_t cell = 0; cell < cells_.size(); ++cell)
    set_cell(cell, &values[places[static_cast<std::size_t>(cells_[cell])] * size]);
}

}  // namespace ixos
