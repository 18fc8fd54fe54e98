/// A tangent applied without a matrix, from what a term keeps at the quadrature points.
#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include "term/body/body_cells.hpp"
#include "term/force_term.hpp"

namespace ixos {

/// The part that terms have in common: a term derives from it and fills the data in its linearize(). They are kept in
/// single precision. The cells must outlive the action.
template <class Space>
class KeptAction : public TangentAction {
  using Cells = BodyCells<Space>;

 public:
  void add_product(const double* x, double* y) const override {
    cells_.add_product(product_, data_.data(), size_, x, y);
  }
  void add_rough_product(const double* x, double* y) const override {
    cells_.add_rough_product(product_, data_.data(), size_, x, y);
  }
  void add_diagonal(double* d) const override { cells_.add_diagonal_of(product_, data_.data(), size_, d); }
  bool has_coarse() const override { return cells_.has_coarse(); }
  void add_coarse(const CoarseSpace& coarse, double* values) const override {
    cells_.add_coarse(product_, data_.data(), size_, coarse, values);
  }
  bool applies_mass() const override { return cells_.has_default_points(); }

 protected:
  explicit KeptAction(const Cells& cells) : cells_(cells) {}

  /// Calls linearize(batch, data), which fills the data of each batch for that product.
  template <class Linearize>
  void keep(PointProduct<Cells::D> product, const Linearize& linearize) {
    product_ = std::move(product);
    size_ = cells_.points() * product_.point_size();
    data_.resize(size_ * cells_.size());
    for (std::size_t b = 0; b < cells_.size(); ++b) linearize(b, &data_[b * size_]);
  }

 private:
  const Cells& cells_;
  PointProduct<Cells::D> product_;
  std::size_t size_ = 0;  ///< of a batch's data
  std::vector<NarrowPack> data_;
};

}  // namespace ixos
