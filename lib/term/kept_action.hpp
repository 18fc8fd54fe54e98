/// A tangent applied without a matrix, from what a kernel keeps at the quadrature points.
#pragma once
#include <cstddef>
#include <vector>

#include "term/block_cells.hpp"
#include "term/force_term.hpp"

namespace ixos {

/// The part that terms have in common: a term derives from it and fills the data in its linearize(). `Kept` computes
/// with the data of a batch, see ElasticAction and ModuliAction. They are kept in single precision. The cells must
/// outlive the action.
template <class Kept, class Kernel>
class KeptAction : public TangentAction {
  using Cells = BlockCells<Kernel>;
  using Nodal = typename Cells::Nodal;
  using Layout = typename Kept::Layout;

 public:
  void add_product(const double* x, double* y) const override {
    typename Kept::template Scratch<Pack> scratch(cells_.table.size());
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      Nodal u, f{};
      cells_.batches.gather(b, x, u);
      Kept::add_product(cells_.table, layout_, &data_[b * size_], u, scratch, f);
      cells_.batches.scatter_force(b, f, y);
    }
  }

  void add_diagonal(double* d) const override {
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      Nodal diagonal{};
      Kept::add_diagonal(cells_.table, layout_, &data_[b * size_], diagonal);
      cells_.batches.scatter_diagonal(b, diagonal, d);
    }
  }

 protected:
  explicit KeptAction(const Cells& cells) : cells_(cells) {}

  /// Calls linearize(batch, data), which fills the data of each batch.
  template <class Linearize>
  void keep(const Layout& layout, const Linearize& linearize) {
    layout_ = layout;
    size_ = cells_.table.size() * layout_.point_size();
    data_.resize(size_ * cells_.size());
    for (std::size_t b = 0; b < cells_.size(); ++b) linearize(b, &data_[b * size_]);
  }

 private:
  const Cells& cells_;
  Layout layout_;
  std::size_t size_ = 0;  ///< of a batch's data
  std::vector<NarrowPack> data_;
};

}  // namespace ixos
