/// The elastic terms of kernels against locking; included only where terms are made, see elastic_term.hpp.
#pragma once
#include "fem/cell_type.hpp"  // whose names the elements below have, too

#include <array>
#include <functional>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "element/cell_kernel.hpp"
#include "element/kernel_law.hpp"
#include "element/projected_dilatation_kernel.hpp"
#include "fem/revolved.hpp"
#include "fem/with_element.hpp"
#include "term/body/block_cells.hpp"
#include "term/body/elastic_terms.hpp"
#include "term/body/elasticity_in.hpp"

namespace ixos {

/// `Kernel`: of AnyLaw, so that it is compiled once for all laws.
template <class Kernel>
class LockingFreeTerm final : public ElasticityIn<typename Kernel::Space> {
  using Base = ElasticityIn<typename Kernel::Space>;
  using Material = typename Kernel::Law;
  static constexpr std::size_t D = Kernel::D;
  static constexpr std::size_t N = Kernel::N;
  using Cells = BlockCells<Kernel>;
  using Nodal = typename Cells::Nodal;
  using CellTangent = typename Cells::CellTangent;
  using Gathered = GatheredSegment<Kernel>;
  using typename Base::Seen;

 public:
  LockingFreeTerm(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                  const std::shared_ptr<const ElasticLaw>& law, int points)
      : Base(law), material_(law), cells_(mesh, block, pattern, points) {}

  void place(const Pattern& pattern) override { cells_.batches.place(pattern); }

  bool add_force(const Segment& segment, const Rule& rule, double* f) const override {
    if (rule.mean == Mean::DiscreteGradient)
      throw std::logic_error("this element formulation has no discrete gradient");
    Pack least_jacobian = 1.0;
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      const Gathered ends(cells_.batches, b, segment);
      Nodal force{};
      least_jacobian =
          smaller(least_jacobian, Kernel::add_force(material_, cells_.geometry[b], ends.segment(), rule, force));
      cells_.batches.scatter_force(b, force, f);
    }
    return least(least_jacobian) > 0;
  }

  void add_tangent(const Segment& segment, const Rule& rule, Tangent, double* values) const override {
    for_each_tangent(segment, rule, [&](std::size_t b, const CellTangent& tangent) {
      cells_.batches.scatter_tangent(b, tangent, values);
    });
  }

  bool add_row_sums(const Segment& segment, double* sums) const override {
    for_each_tangent(segment, end_rule(),
                     [&](std::size_t b, const CellTangent& tangent) { cells_.scatter_row_sums(b, tangent, sums); });
    return true;
  }

  void add_diagonal(const Segment& segment, double* diagonal) const override {
    for_each_tangent(segment, end_rule(),
                     [&](std::size_t b, const CellTangent& tangent) { cells_.scatter_diagonal(b, tangent, diagonal); });
  }

 protected:
  std::size_t cells() const override { return cells_.batches.cells(); }
  void for_each_seen(const double* u, const std::function<void(const Seen&)>& visit) const override {
    Seen seen;
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      seen.found = Kernel::seen(material_, cells_.geometry[b], cells_.gathered(b, u), seen.h);
      seen.volumes.clear();
      for (const auto& point : cells_.geometry[b].points) seen.volumes.push_back(point.weight);
      seen.owned = cells_.owned[b];
      seen.first = Cells::number(b, 0);
      seen.lanes = cells_.batches.lanes(b);
      visit(seen);
    }
  }

 private:
  /// Calls visit(batch, tangent) for all cells. A visitor of any kind, so that the loop is compiled once.
  void for_each_tangent(const Segment& segment, const Rule& rule,
                        const std::function<void(std::size_t, const CellTangent&)>& visit) const {
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      const Gathered ends(cells_.batches, b, segment);
      CellTangent tangent{};
      Kernel::add_tangent(material_, cells_.geometry[b], ends.segment(), rule, tangent);
      visit(b, tangent);
    }
  }

  Material material_;
  Cells cells_;
};

/// Returns the term of Kernel<Element, law>.
template <template <class, class> class Kernel, class Element>
std::unique_ptr<Elasticity> make_kernel_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                             const std::shared_ptr<const ElasticLaw>& law, int points) {
  using Law = AnyLaw<SpaceOf<Element>>;
  return std::make_unique<LockingFreeTerm<Kernel<Element, Law>>>(mesh, block, pattern, law, points);
}

/// Returns the term with mean dilatation of cells of a dimension, `revolved`: of bodies of revolution.
template <int D, bool revolved>
std::unique_ptr<Elasticity> make_dilatation_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                                 const std::shared_ptr<const ElasticLaw>& law, int points) {
  return with_element_of<D>(block.type, [&](auto tag) -> std::unique_ptr<Elasticity> {
    using Plain = typename decltype(tag)::type;
    using Element = std::conditional_t<revolved, Revolved<Plain>, Plain>;
    if constexpr (has_dilatation<Plain>)
      return make_kernel_term<DilatationKernel, Element>(mesh, block, pattern, law, points);
    else
      throw std::logic_error("these cells have no mean dilatation");
  });
}

}  // namespace ixos
