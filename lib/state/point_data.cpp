#include "state/point_data.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "base/error.hpp"

namespace ixos {
namespace {

constexpr auto width = static_cast<std::size_t>(pack_width);

constexpr double sides_of_a_cell = 6, cells_of_a_block = 4294967296.0, parts_of_a_side = 4;

std::vector<double> numbers_of(const LocalMesh& mesh, const std::vector<LocalSide>& sides) {
  std::vector<double> numbers;
  for (const LocalSide& side : sides) {
    const LocalBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
    const int cell = side.cell < 0 ? -1 - side.cell : block.original_cells[static_cast<std::size_t>(side.cell)];
    numbers.push_back((side.block * cells_of_a_block + cell) * sides_of_a_cell + side.side +
                      side.part / parts_of_a_side);
  }
  return numbers;
}

}  // namespace

PointData::PointData(std::vector<double> cells, std::size_t points, std::size_t numbers)
    : cells_(std::move(cells)),
      points_(points),
      numbers_(numbers),
      data_((cells_.size() + width - 1) / width * points * numbers, Pack(0.0)) {}

PointData::PointData(const LocalBlock& block, std::size_t points, std::size_t numbers)
    : PointData(std::vector<double>(block.original_cells.begin(), block.original_cells.end()), points, numbers) {}

PointData::PointData(const LocalMesh& mesh, const std::vector<LocalSide>& sides, std::size_t points,
                     std::size_t numbers)
    : PointData(numbers_of(mesh, sides), points, numbers) {}

void PointData::fill(double value) { std::fill(data_.begin(), data_.end(), Pack(value)); }

bool PointData::operator==(const PointData& other) const {
  return points_ == other.points_ && numbers_ == other.numbers_ && cells_ == other.cells_ &&
         cell_by_cell() == other.cell_by_cell();
}

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
  std::vector<double> values, cells = cells_;
  if (!record.loading()) {
    values = cell_by_cell();
    record.share("cells", cells);
    record.share("values", values);
    return;
  }
  if (record.same_partition()) {
    record.share("cells", cells);
    record.share("values", values);
    if (cells != cells_ || values.size() != cells.size() * size)
      throw InputError("the values at quadrature points do not fit their cells");
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) set_cell(cell, &values[cell * size]);
    return;
  }
  record.all_shares("cells", cells);
  record.all_shares("values", values);
  std::unordered_map<double, std::size_t> places;
  for (std::size_t i = 0; i < cells.size(); ++i) places[cells[i]] = i;
  const auto is_missing = [&](double cell) { return places.count(cell) == 0; };
  if (values.size() != cells.size() * size || std::any_of(cells_.begin(), cells_.end(), is_missing))
    throw InputError("the values at quadrature points do not fit the cells of the mesh");
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) set_cell(cell, &values[places[cells_[cell]] * size]);
}

}  // namespace ixos
