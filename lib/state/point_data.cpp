#include "state/point_data.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "base/error.hpp"

namespace ixos {
namespace {

constexpr auto width = static_cast<std::size_t>(pack_width);

constexpr double sides_of_a_cell = 6, cells_of_a_block = 4294967296.0, parts_of_a_side = 4;

std::vector<PointOwner> owners_of(const LocalBlock& block) {
  std::vector<PointOwner> owners;
  for (const int cell : block.original_cells) owners.push_back({block.number, cell, -1, 0});
  return owners;
}

std::vector<PointOwner> owners_of(const LocalMesh& mesh, const std::vector<LocalSide>& sides) {
  std::vector<PointOwner> owners;
  for (const LocalSide& side : sides) {
    const LocalBlock& block = mesh.blocks[static_cast<std::size_t>(side.block)];
    const int cell = side.cell < 0 ? -1 - side.cell : block.original_cells[static_cast<std::size_t>(side.cell)];
    owners.push_back({side.block, cell, side.side, side.part});
  }
  return owners;
}

/// Returns a number that tells a cell from others of its block, or a side from others in the mesh.
double number_of(const PointOwner& owner) {
  if (owner.side < 0) return owner.cell;
  return (owner.block * cells_of_a_block + owner.cell) * sides_of_a_cell + owner.side + owner.part / parts_of_a_side;
}

}  // namespace

PointData::PointData(std::vector<PointOwner> owners, std::size_t points, std::size_t numbers)
    : owners_(std::move(owners)),
      points_(points),
      numbers_(numbers),
      data_((owners_.size() + width - 1) / width * points * numbers, Pack(0.0)) {}

PointData::PointData(const LocalBlock& block, std::size_t points, std::size_t numbers)
    : PointData(owners_of(block), points, numbers) {}

PointData::PointData(const LocalMesh& mesh, const std::vector<LocalSide>& sides, std::size_t points,
                     std::size_t numbers)
    : PointData(owners_of(mesh, sides), points, numbers) {}

std::vector<double> PointData::cells() const {
  std::vector<double> numbers;
  for (const PointOwner& owner : owners_) numbers.push_back(number_of(owner));
  return numbers;
}

void PointData::fill(double value) { std::fill(data_.begin(), data_.end(), Pack(value)); }

bool PointData::operator==(const PointData& other) const {
  return points_ == other.points_ && numbers_ == other.numbers_ && cells() == other.cells() &&
         cell_by_cell() == other.cell_by_cell();
}

std::vector<double> PointData::cell_by_cell() const {
  const std::size_t size = points_ * numbers_;
  std::vector<double> values(owners_.size() * size);
  for (std::size_t cell = 0; cell < owners_.size(); ++cell)
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
  std::vector<double> values, cells = this->cells();
  if (!record.loading()) {
    values = cell_by_cell();
    record.share("cells", cells);
    record.share("values", values);
    return;
  }
  const std::vector<double> own = cells;
  if (record.same_partition()) {
    record.share("cells", cells);
    record.share("values", values);
    if (cells != own || values.size() != cells.size() * size)
      throw InputError("the values at quadrature points do not fit their cells");
    for (std::size_t cell = 0; cell < own.size(); ++cell) set_cell(cell, &values[cell * size]);
    return;
  }
  record.all_shares("cells", cells);
  record.all_shares("values", values);
  std::unordered_map<double, std::size_t> places;
  for (std::size_t i = 0; i < cells.size(); ++i) places[cells[i]] = i;
  const auto is_missing = [&](double cell) { return places.count(cell) == 0; };
  if (values.size() != cells.size() * size || std::any_of(own.begin(), own.end(), is_missing))
    throw InputError("the values at quadrature points do not fit the cells of the mesh");
  for (std::size_t cell = 0; cell < own.size(); ++cell) set_cell(cell, &values[places[own[cell]] * size]);
}

}  // namespace ixos
