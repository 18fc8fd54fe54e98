#include "term/pair/pair_sums.hpp"

#include <algorithm>

namespace ixos {
namespace {

constexpr auto width = static_cast<std::size_t>(pack_width);

std::size_t packs(std::size_t nodes) { return (nodes + width - 1) / width; }

/// sum += factor * x, for `count` packs.
void add_scaled(double factor, const Pack* x, Pack* sum, std::size_t count) {
  for (std::size_t p = 0; p < count; ++p) sum[p] += factor * x[p];
}

}  // namespace

template <std::size_t D>
void PairSums<D>::begin(std::size_t secondary, std::size_t primary) {
  secondary_ = secondary;
  primary_ = primary;
  secondary_packs_ = packs(secondary);
  primary_packs_ = packs(primary);
  open_ = false;
  own_.fill(0);
  mixed_.assign(square * primary_packs_, Pack(0.0));
  weights_.resize(std::max(secondary_packs_, D * primary_packs_));
  among_secondary_.assign(secondary * square * secondary_packs_, Pack(0.0));
  across_.assign(secondary * square * primary_packs_, Pack(0.0));
  among_primary_.assign(primary * square * primary_packs_, Pack(0.0));
}

template <std::size_t D>
void PairSums<D>::load(const PairGap<D>& gap) {
  for (std::size_t l = 0; l < D; ++l)
    for (std::size_t p = 0; p < primary_packs_; ++p)
      weights_[l * primary_packs_ + p] = Pack([&](auto lane) {
        const std::size_t b = p * width + lane;
        return b < primary_ ? gap.weight(l, secondary_ + b) : 0.0;
      });
}

template <std::size_t D>
void PairSums<D>::add(const PairGap<D>& gap, double along, double across) {
  const typename PairGap<D>::Moduli m = gap.moduli(along, across);
  const std::size_t n = primary_packs_;
  open_ = true;
  load(gap);
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = 0; j < D; ++j) {
      own_[D * i + j] += m[i][j];
      for (std::size_t l = 0; l < D; ++l)
        add_scaled(m[i][D * l + j], weights_.data() + l * n, mixed_.data() + (D * i + j) * n, n);
    }
  for (std::size_t a = 0; a < primary_; ++a)
    for (std::size_t i = 0; i < D; ++i) {
      std::array<double, square> row{};
      for (std::size_t k = 0; k < D; ++k) {
        const double weight = gap.weight(k, secondary_ + a);
        for (std::size_t c = 0; c < square; ++c) row[c] += weight * m[D * k + i][c];
      }
      Pack* const sums = among_primary_.data() + (a * square + D * i) * n;
      for (std::size_t p = a / width; p < n; ++p)  // the others follow by symmetry
        for (std::size_t j = 0; j < D; ++j) {
          Pack sum = sums[j * n + p];
          for (std::size_t l = 0; l < D; ++l) sum += row[D * l + j] * weights_[l * n + p];
          sums[j * n + p] = sum;
        }
    }
}

template <std::size_t D>
void PairSums<D>::end_point(const typename SurfacePatch<D>::Weights& weights) {
  if (!open_) return;
  const std::size_t n = secondary_packs_;
  for (std::size_t p = 0; p < n; ++p)
    weights_[p] = Pack([&](auto lane) {
      const std::size_t b = p * width + lane;
      return b < secondary_ ? weights[b] : 0.0;
    });
  for (std::size_t a = 0; a < secondary_; ++a) {
    for (std::size_t ij = 0; ij < square; ++ij)
      add_scaled(weights[a] * own_[ij], weights_.data(), among_secondary_.data() + (a * square + ij) * n, n);
    add_scaled(weights[a], mixed_.data(), across_.data() + a * square * primary_packs_, square * primary_packs_);
  }
  open_ = false;
  own_.fill(0);
  std::fill(mixed_.begin(), mixed_.end(), Pack(0.0));
}

template <std::size_t D>
void PairSums<D>::write(std::vector<double>& matrix, bool reacts) const {
  const std::size_t size = D * (secondary_ + primary_);
  matrix.assign(size * size, 0.0);
  const auto copy = [&](const std::vector<Pack>& from, std::size_t rows, std::size_t first_row, std::size_t columns,
                        std::size_t first_column, bool twice, bool upper = false) {
    for (std::size_t a = 0; a < rows; ++a)
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) {
          const Pack* const own = from.data() + (a * square + D * i + j) * packs(columns);
          for (std::size_t b = upper ? a / width * width : 0; b < columns; ++b) {
            const std::size_t r = D * (first_row + a) + i, c = D * (first_column + b) + j;
            const double value = own[b / width][b % width];
            matrix[r * size + c] = value;
            if (twice) matrix[c * size + r] = value;
          }
        }
  };
  copy(among_secondary_, secondary_, 0, secondary_, 0, false);
  copy(across_, secondary_, 0, primary_, secondary_, reacts);
  if (reacts) copy(among_primary_, primary_, secondary_, primary_, secondary_, true, true);
}

template class PairSums<2>;
template class PairSums<3>;

}  // namespace ixos
