#include "solve/direct/band_ldu.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "base/pack.hpp"

namespace ixos {
namespace {

constexpr std::size_t lanes = Pack::size();
constexpr auto unaligned = std::experimental::element_aligned;

/// A row of a block.
using Row = std::experimental::fixed_size_simd<double, 4>;

Pack load(const double* from) { return Pack(from, unaligned); }

/// Returns the number of packs that cover rows `first` to `last`.
std::size_t packs(int first, int last) {
  return last < first ? 0 : (static_cast<std::size_t>(last - first) + lanes) / lanes;
}

}  // namespace

BandLdu::BandLdu(const std::vector<int>& last, Symmetry symmetry) : size_(static_cast<int>(last.size())) {
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
  if (symmetry == Symmetry::None) upper_ = start;
  entries_.resize(factors() * start);
  pivots_.resize(blocks_.size());
  std::size_t sources = 0;
  for (std::size_t k = 0, earliest = 0; k < blocks_.size(); ++k) {
    while (blocks_[earliest].last < blocks_[k].first) ++earliest;
    sources = std::max(sources, k - earliest);
  }
  sources_.resize(sources);
}

double BandLdu::operations(const std::vector<int>& last) {
  double sum = 0;
  for (int j = 0, end = 0; j < static_cast<int>(last.size()); ++j) {
    end = std::max(end, last[static_cast<std::size_t>(j)]);
    sum += static_cast<double>(end - j) * (end - j);
  }
  return sum;
}

std::size_t BandLdu::padded_size() const { return blocks_.size() * width + lanes; }

std::size_t BandLdu::place(int i, int j) const {
  const int row = std::max(i, j), column = std::min(i, j);
  const Block& block = blocks_[static_cast<std::size_t>(column / columns)];
  return (i < j ? upper_ : 0) + block.start + static_cast<std::size_t>(column - block.first) * block.stride +
         static_cast<std::size_t>(row - block.first);
}

std::array<BandLdu::Columns, 2> BandLdu::both(const Block& block) {
  double* const lower = &entries_[block.start];
  return {{{lower, lower + upper_}, {lower + upper_, lower}}};
}

void BandLdu::clear() {
  std::fill(entries_.begin(), entries_.end(), 0.0);
  for (int j = size_; j < static_cast<int>(blocks_.size()) * columns; ++j) entries_[place(j, j)] = 1;
}

bool BandLdu::factor() {
  std::size_t earliest = 0;
  for (std::size_t k = 0; k < blocks_.size(); ++k) {
    while (blocks_[earliest].last < blocks_[k].first) ++earliest;
    for (std::size_t f = 0; f < factors(); ++f) subtract(k, earliest, f);
    if (!factor(blocks_[k])) return false;
  }
  return true;
}

/// Divides the block, from which all earlier ones have been subtracted, into factors.
bool BandLdu::factor(const Block& block) {
  const auto both_factors = both(block);
  const std::size_t stride = block.stride;
  auto& pivot = pivots_[static_cast<std::size_t>(block.first) / width];
  std::array<double, width> inverse;
  for (std::size_t c = 0; c < width; ++c) {
    for (std::size_t f = 0; f < factors(); ++f) {
      const auto [own, other] = both_factors[f];
      for (std::size_t m = 0; m < c; ++m) {
        const double scaled = other[m * stride + c] * pivot[m];
        for (std::size_t r = c; r < width; ++r) own[c * stride + r] -= scaled * own[m * stride + r];
      }
    }
    pivot[c] = both_factors[0].own[c * stride + c];
    inverse[c] = 1 / pivot[c];
    if (!std::isfinite(inverse[c]) || inverse[c] == 0) return false;
    for (std::size_t f = 0; f < factors(); ++f)
      for (std::size_t r = c + 1; r < width; ++r) both_factors[f].own[c * stride + r] *= inverse[c];
  }
  const std::size_t count = packs(block.first + columns, block.last);
  for (std::size_t f = 0; f < factors(); ++f) {
    const auto [own, other] = both_factors[f];
    for (std::size_t k = 0; k < count; ++k) {
      double* const row = own + width + k * lanes;
      std::array<Pack, width> value;
      for (std::size_t c = 0; c < width; ++c) {
        value[c] = load(row + c * stride);
        for (std::size_t m = 0; m < c; ++m) value[c] -= other[m * stride + c] * value[m];
      }
      for (std::size_t c = 0; c < width; ++c) (value[c] * inverse[c]).copy_to(row + c * stride, unaligned);
    }
  }
  return true;
}

/// Subtracts L D U of the columns of the earlier blocks from `first` on from block k of factor f.
void BandLdu::subtract(std::size_t k, std::size_t first, std::size_t f) {
  if (first == k) return;
  const Block& block = blocks_[k];
  Source* source = sources_.data();
  for (std::size_t s = first; s < k; ++s, ++source) {
    const Block& from = blocks_[s];
    const Columns columns_of = both(from)[f];
    const auto below = static_cast<std::size_t>(block.first - from.first);
    source->rows = columns_of.own + below;
    source->stride = from.stride;
    source->packs = packs(block.first, from.last);
    const std::array<double, width> pivot = pivots_[s];
    for (std::size_t m = 0; m < width; ++m)
      (pivot[m] * Row(columns_of.other + m * from.stride + below, unaligned))
          .copy_to(&source->scaled[m * width], unaligned);
  }
  double* const target = both(block)[f].own;
  const Source* const end = source;
  const std::size_t count = (end - 1)->packs;
  std::size_t done = 0;
  for (; done + 3 <= count; done += 3) subtract_rows<3>(target, block.stride, done, end);
  if (done + 2 == count) subtract_rows<2>(target, block.stride, done, end);
  if (done + 1 == count) subtract_rows<1>(target, block.stride, done, end);
}

/// Does it for n packs of rows from pack `done` on. The columns of the block stay in registers.
template <std::size_t n>
void BandLdu::subtract_rows(double* target, std::size_t stride, std::size_t done, const Source* end) const {
  std::array<std::array<Pack, n>, width> sum;
  for (std::size_t c = 0; c < width; ++c)
    for (std::size_t r = 0; r < n; ++r) sum[c][r] = load(target + c * stride + (done + r) * lanes);
  const auto add = [&](const Source& source, auto rows) __attribute__((always_inline)) {
    for (std::size_t m = 0; m < width; ++m) {
      std::array<Pack, rows> row;
      for (std::size_t r = 0; r < rows; ++r) row[r] = load(source.rows + m * source.stride + (done + r) * lanes);
      for (std::size_t c = 0; c < width; ++c)
        for (std::size_t r = 0; r < rows; ++r) sum[c][r] -= source.scaled[m * width + c] * row[r];
    }
  };
  // Later sources have more rows.
  const Source* source = sources_.data();
  while (source->packs <= done) ++source;
  if constexpr (n > 1)
    for (; source != end && source->packs == done + 1; ++source) add(*source, std::integral_constant<std::size_t, 1>());
  if constexpr (n > 2)
    for (; source != end && source->packs == done + 2; ++source) add(*source, std::integral_constant<std::size_t, 2>());
  for (; source != end; ++source) add(*source, std::integral_constant<std::size_t, n>());
  for (std::size_t c = 0; c < width; ++c)
    for (std::size_t r = 0; r < n; ++r) sum[c][r].copy_to(target + c * stride + (done + r) * lanes, unaligned);
}

double BandLdu::pivot_ratio() const {
  double least = 0, largest = 0;
  for (int j = 0; j < size_; ++j) {
    const double magnitude =
        std::abs(pivots_[static_cast<std::size_t>(j) / width][static_cast<std::size_t>(j) % width]);
    least = j == 0 ? magnitude : std::min(least, magnitude);
    largest = std::max(largest, magnitude);
  }
  return size_ == 0 ? 1 : least / largest;
}

void BandLdu::solve(double* x, std::size_t count) const {
  const std::size_t stride = padded_size();
  for (; count >= 4; count -= 4, x += 4 * stride) solve_columns<4>(x);
  if (count == 3) solve_columns<3>(x);
  if (count == 2) solve_columns<2>(x);
  if (count == 1) solve_columns<1>(x);
}

/// Does it for n columns.
template <std::size_t n>
void BandLdu::solve_columns(double* x) const {
  const std::size_t distance = padded_size();
  for (const Block& block : blocks_) {
    const double* column = &entries_[block.start];
    std::array<std::array<double, width>, n> known;
    for (std::size_t k = 0; k < n; ++k) {
      double* const here = x + k * distance + block.first;
      for (std::size_t c = 0; c < width; ++c)
        for (std::size_t r = c + 1; r < width; ++r) here[r] -= column[c * block.stride + r] * here[c];
      std::copy_n(here, width, known[k].begin());
    }
    const std::size_t count = packs(block.first + columns, block.last);
    for (std::size_t p = 0; p < count; ++p) {
      const std::size_t row = width + p * lanes;
      std::array<Pack, width> factor;
      for (std::size_t c = 0; c < width; ++c) factor[c] = load(column + c * block.stride + row);
      for (std::size_t k = 0; k < n; ++k) {
        double* const here = x + k * distance + block.first + row;
        Pack sum = load(here);
        for (std::size_t c = 0; c < width; ++c) sum -= known[k][c] * factor[c];
        sum.copy_to(here, unaligned);
      }
    }
  }
  for (std::size_t b = blocks_.size(); b-- > 0;) {
    const Block& block = blocks_[b];
    const double* column = &entries_[upper_ + block.start];
    std::array<std::array<Pack, width>, n> sum{};
    const std::size_t count = packs(block.first + columns, block.last);
    for (std::size_t p = 0; p < count; ++p) {
      const std::size_t row = width + p * lanes;
      std::array<Pack, n> known;
      for (std::size_t k = 0; k < n; ++k) known[k] = load(x + k * distance + block.first + row);
      for (std::size_t c = 0; c < width; ++c) {
        const Pack factor = load(column + c * block.stride + row);
        for (std::size_t k = 0; k < n; ++k) sum[k][c] += known[k] * factor;
      }
    }
    for (std::size_t k = 0; k < n; ++k) {
      double* const here = x + k * distance + block.first;
      for (std::size_t c = width; c-- > 0;) {
        here[c] = here[c] / pivots_[b][c] - total(sum[k][c]);
        for (std::size_t r = c + 1; r < width; ++r) here[c] -= column[c * block.stride + r] * here[r];
      }
    }
  }
}

}  // namespace ixos
