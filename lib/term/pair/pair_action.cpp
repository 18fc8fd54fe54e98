#include "term/pair/pair_action.hpp"

#include <algorithm>

namespace ixos {

template <std::size_t D>
void PairAction<D>::linearize(const Segment& segment, const Rule& rule, Tangent kind, const LinearPart&) {
  blocks_.clear();
  rows_.clear();
  values_.clear();
  count_ = 0;
  tangent_(segment, rule, kind, [this](const PairBlock& block) {
    if (count_ > 0 && parts_[0].secondary != block.secondary) keep_sum();
    if (count_ == parts_.size()) parts_.emplace_back();
    parts_[count_++] = block;
  });
  if (count_ > 0) keep_sum();
}

template <std::size_t D>
void PairAction<D>::keep_sum() {
  std::vector<int>& nodes = nodes_;
  nodes.clear();
  for (std::size_t k = 0; k < count_; ++k) nodes.insert(nodes.end(), parts_[k].nodes.begin(), parts_[k].nodes.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  const std::size_t size = D * nodes.size();
  blocks_.push_back({rows_.size(), values_.size(), size});
  for (const int node : nodes)
    for (std::size_t i = 0; i < D; ++i) rows_.push_back(D * static_cast<std::size_t>(node) + i);
  values_.resize(values_.size() + size * size, 0.0F);
  float* const sum = values_.data() + blocks_.back().values;
  std::vector<std::size_t>& places = places_;
  for (std::size_t k = 0; k < count_; ++k) {
    places.clear();
    for (const int node : parts_[k].nodes)
      places.push_back(D *
                       static_cast<std::size_t>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin()));
    const double* value = parts_[k].k.data();
    for (const std::size_t row : places)
      for (std::size_t i = 0; i < D; ++i)
        for (const std::size_t column : places)
          for (std::size_t j = 0; j < D; ++j) sum[(row + i) * size + column + j] += static_cast<float>(*value++);
  }
  count_ = 0;
}

/// The matrices are symmetric: their rows stand for columns.
template <std::size_t D>
void PairAction<D>::add_product(const double* x, double* y) const {
  std::vector<double>& sum = sum_;
  for (const Block& block : blocks_) {
    const std::size_t* const rows = rows_.data() + block.rows;
    sum.assign(block.size, 0.0);
    const float* column = values_.data() + block.values;
    for (std::size_t c = 0; c < block.size; ++c, column += block.size) {
      const double factor = x[rows[c]];
      for (std::size_t r = 0; r < block.size; ++r) sum[r] += factor * column[r];
    }
    for (std::size_t r = 0; r < block.size; ++r) y[rows[r]] += sum[r];
  }
}

template <std::size_t D>
void PairAction<D>::add_diagonal(double* d) const {
  for (const Block& block : blocks_)
    for (std::size_t r = 0; r < block.size; ++r) d[rows_[block.rows + r]] += values_[block.values + r * block.size + r];
}

template class PairAction<2>;
template class PairAction<3>;

}  // namespace ixos
