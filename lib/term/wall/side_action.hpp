/// The tangent of a surface before an obstacle, applied without a matrix, and what is kept for it.
#pragma once
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "term/force_term.hpp"

namespace ixos {

/// Matrices of quadrature points, kept beside forces.
template <class K>
struct KeptStiffness final : KeptPoints {
  std::vector<K> stiffness;  ///< batches x quadrature points; batches where nothing acts may have none
};

/// Keeps a matrix for each side. `Sides`: FlatWallSides or CurvedWallSides, which must outlive it.
template <class Sides>
class SideAction final : public TangentAction {
 public:
  using Matrices = typename Sides::Matrices;
  /// Sets the matrices of all batches.
  using Linearize = std::function<void(const Segment&, const Rule&, Tangent, Matrices&)>;

  SideAction(const Sides& sides, Linearize linearize)
      : sides_(sides), linearize_(std::move(linearize)), matrices_(sides.create_matrices()) {}

  void linearize(const Segment& segment, const Rule& rule, Tangent kind, const LinearPart&) override {
    linearize_(segment, rule, kind, *matrices_);
  }
  bool applies_mass() const override { return false; }
  void add_product(const double* x, double* y) const override { matrices_->add_product(x, y); }
  void add_diagonal(double* d) const override { matrices_->add_diagonal(d); }
  bool has_coarse() const override { return sides_.may_be_coarsened(); }
  void add_coarse(const CoarseSpace& coarse, double* values) const override { matrices_->add_coarse(coarse, values); }

 private:
  const Sides& sides_;
  Linearize linearize_;
  std::unique_ptr<Matrices> matrices_;
};

}  // namespace ixos
