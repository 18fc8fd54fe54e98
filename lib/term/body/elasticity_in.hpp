/// Reports of elastic terms, the same for all formulations.
#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "base/pack.hpp"
#include "base/small_matrix.hpp"
#include "material/elastic_law.hpp"
#include "term/body/elastic_term.hpp"

namespace ixos {

/// Points of a batch of cells, with the displacement gradients for the law.
template <class Space>
struct SeenPoints {
  Pack owned = 1.0;                      ///< 1 for cells whose energy counts on this rank, else 0
  Pack found = 1.0;                      ///< 0 in lanes where the law sees nothing
  std::vector<Small<Pack, Space::G>> h;  ///< displacement gradients
  std::vector<Pack> volumes;             ///< reference volumes [L0^D]
  std::size_t first = 0, lanes = 0;      ///< the number of the first cell in the block, and of cells
};

/// The elasticity of a block in a space. No function of this class depends on the type of cells.
template <class Space>
class ElasticityIn : public Elasticity {
 public:
  using Seen = SeenPoints<Space>;

  double energy(const Place& at) const final;
  bool has_time_derivative(const Rule&) const final { return true; }
  void cell_fields(const double* u, CellFields& fields) const final;
  void cell_stress(const double* u, std::vector<SymmetricTensor>& stress) const final;

 protected:
  explicit ElasticityIn(std::shared_ptr<const ElasticLaw> law) : law_(std::move(law)) {}

  const PointLaw<Space>& points_law() const { return law_->points(Space{}); }
  const std::shared_ptr<const ElasticLaw>& law() const { return law_; }

  /// Returns the number of local cells of the block.
  virtual std::size_t cells() const = 0;
  /// Calls visit(points) for all batches.
  virtual void for_each_seen(const double* u, const std::function<void(const Seen&)>& visit) const = 0;

 private:
  std::shared_ptr<const ElasticLaw> law_;
};

}  // namespace ixos
