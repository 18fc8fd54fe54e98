#include "solve/band_ldl.hpp"

#include <algorithm>
#include <cmath>

#include "base/pack.hpp"

namespace ixos {
namespace {

constexpr std::size_t lanes = Pack::size();
constexpr auto unaligned = std::experimental::element_aligned;

Pack load(const double* from) { return Pack(from, unaligned); }

/// Returns the number of packs that cover rows `first` to `last`.
std::size_t packs(int first, int last) {
  return last < first ? 0 : (static_cast<std::size_t>(last - first) + lanes) / lanes;
}

}  // namespace

BandLdl::BandLdl(const std::vector<int>& last) : size_(static_cast<int>(last.size())) {
  std::size_t start = 0;
  int end = 0;
  for (int first = 0; first < size_; first += columns) {
    end = std::max(end, first + columns - 1);
    for (int j = first; j < std::min(first + columns, size_); ++j)
      end = std::max(end, last[static_cast<std::size_t>(j)]);
    // Whole packs, and the factors of a later block, may reach beyond the last row, where the entries are zero.
    const std::size_t beyond = std::max(lanes, width) - 1;
    const std::size_t stride = (static_cast<std::size_t>(end - first + 1) + beyond + lanes - 1) / lanes * lanes;
    blocks_.push_back({first, end, start, stride});
    start += width * stride;
  }
  entries_.resize(start);
  pivots_.resize(blocks_.size());
}

double BandLdl::operations(const std::vector<int>& last) {
  double sum = 0;
  for (int j = 0, end = 0; j < static_cast<int>(last.size()); ++j) {
    end = std::max(end, last[static_cast<std::size_t>(j)]);
    sum += static_cast<double>(end - j) * (end - j);
  }
  return sum;
}

std::size_t BandLdl::padded_size() const { return blocks_.size() * width + lanes; }

std::size_t BandLdl::place(int i, int j) const {
  const Block& block = blocks_[static_cast<std::size_t>(j / columns)];
  return block.start + static_cast<std::size_t>(j - block.first) * block.stride +
         static_cast<std::size_t>(i - block.first);
}

void BandLdl::clear() {
  std::fill(entries_.begin(), entries_.end(), 0.0);
  for (int j = size_; j < static_cast<int>(blocks_.size()) * columns; ++j) entries_[place(j, j)] = 1;
}

bool BandLdl::factor() {
  for (std::size_t k = 0; k < blocks_.size(); ++k) {
    const Block& block = blocks_[k];
    if (!factor(block)) return false;
    for (std::size_t later = k + 1; later < blocks_.size() && blocks_[later].first <= block.last; ++later)
      subtract(blocks_[later], block);
  }
  return true;
}

/// Divides the block, from which all earlier ones have been subtracted, into factors.
bool BandLdl::factor(const Block& block) {
  std::array<double*, width> column;
  for (std::size_t c = 0; c < width; ++c) column[c] = &entries_[block.start + c * block.stride];
  auto& pivot = pivots_[static_cast<std::size_t>(block.first) / width];
  std::array<double, width> inverse;
  for (std::size_t c = 0; c < width; ++c) {
    for (std::size_t m = 0; m < c; ++m) {
      const double scaled = column[m][c] * pivot[m];
      for (std::size_t r = c; r < width; ++r) column[c][r] -= scaled * column[m][r];
    }
    pivot[c] = column[c][c];
    inverse[c] = 1 / pivot[c];
    if (!std::isfinite(inverse[c]) || inverse[c] == 0) return false;
    for (std::size_t r = c + 1; r < width; ++r) column[c][r] *= inverse[c];
  }
  const std::size_t count = packs(block.first + columns, block.last);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t row = width + k * lanes;
    std::array<Pack, width> value;
    for (std::size_t c = 0; c < width; ++c) {
      value[c] = load(column[c] + row);
      for (std::size_t m = 0; m < c; ++m) value[c] -= column[m][c] * value[m];
    }
    for (std::size_t c = 0; c < width; ++c) (value[c] * inverse[c]).copy_to(column[c] + row, unaligned);
  }
  return true;
}

/// Subtracts L D L^T of the columns of `from` from the later block.
void BandLdl::subtract(const Block& block, const Block& from) {
  const double* source = &entries_[from.start + static_cast<std::size_t>(block.first - from.first)];
  double* target = &entries_[block.start];
  const auto& pivot = pivots_[static_cast<std::size_t>(from.first) / width];
  std::array<std::array<Pack, width>, width> factor;
  for (std::size_t m = 0; m < width; ++m)
    for (std::size_t c = 0; c < width; ++c) factor[m][c] = pivot[m] * source[m * from.stride + c];
  const std::size_t count = packs(block.first, from.last);
  for (std::size_t k = 0; k < count; ++k) {
    std::array<Pack, width> row;
    for (std::size_t m = 0; m < width; ++m) row[m] = load(source + m * from.stride + k * lanes);
    for (std::size_t c = 0; c < width; ++c) {
      double* const place = target + c * block.stride + k * lanes;
      Pack sum = load(place);
      for (std::size_t m = 0; m < width; ++m) sum -= factor[m][c] * row[m];
      sum.copy_to(place, unaligned);
    }
  }
}

void BandLdl::solve(double* x) const {
  for (const Block& block : blocks_) {
    const double* column = &entries_[block.start];
    double* const here = x + block.first;
    for (std::size_t c = 0; c < width; ++c)
      for (std::size_t r = c + 1; r < width; ++r) here[r] -= column[c * block.stride + r] * here[c];
    const std::array<double, width> known{here[0], here[1], here[2], here[3]};
    const std::size_t count = packs(block.first + columns, block.last);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t row = width + k * lanes;
      Pack sum = load(here + row);
      for (std::size_t c = 0; c < width; ++c) sum -= known[c] * load(column + c * block.stride + row);
      sum.copy_to(here + row, unaligned);
    }
  }
  for (std::size_t b = blocks_.size(); b-- > 0;) {
    const Block& block = blocks_[b];
    const double* column = &entries_[block.start];
    double* const here = x + block.first;
    std::array<Pack, width> sum{};
    const std::size_t count = packs(block.first + columns, block.last);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t row = width + k * lanes;
      const Pack known = load(here + row);
      for (std::size_t c = 0; c < width; ++c) sum[c] += known * load(column + c * block.stride + row);
    }
    for (std::size_t c = width; c-- > 0;) {
      here[c] = here[c] / pivots_[b][c] - total(sum[c]);
      for (std::size_t r = c + 1; r < width; ++r) here[c] -= column[c * block.stride + r] * here[r];
    }
  }
}

}  // namespace ixos
