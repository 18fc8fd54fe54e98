/// The elastic term of one kernel; included only where terms are made, see elastic_term.hpp.
#pragma once
#include "term/body/elastic_term.hpp"

#include <stdexcept>
#include <type_traits>

#include "element/elastic_action.hpp"
#include "element/elastic_kernel.hpp"
#include "element/moduli_action.hpp"
#include "material/linear_elastic.hpp"
#include "material/neo_hooke.hpp"
#include "rule/straight_points.hpp"
#include "term/body/block_cells.hpp"
#include "term/body/kept_action.hpp"

namespace ixos {

/// The type of what a material keeps of a point; a placeholder if the kernel keeps nothing.
template <class Kernel, bool keeps>
struct KeptState {
  using type = char;
};
template <class Kernel>
struct KeptState<Kernel, true> {
  using type = typename Kernel::Law::template Kept<Kernel::G, Pack>;
};
/// The type of its sums over the points of a straight path.
template <class Kernel, bool keeps>
struct KeptSums {
  using type = char;
};
template <class Kernel>
struct KeptSums<Kernel, true> {
  using type = typename Kernel::Law::template Path<Kernel::G, Pack>::Sums;
};

/// Returns a rule with one point whose tangent is that of a mean over a straight path, but for terms of second order in
/// the step; other rules as they are. The weight counts by the point's share of the end, so the point is the mean of
/// the rule's points with those shares as weights.
inline Rule tangent_at_one_point(const Rule& rule) {
  if (rule.mean != Mean::Points || !has_straight_points(rule)) return rule;
  double share = 0, place = 0;
  for (const RulePoint& point : rule.points) {
    share += point.weight * point.to;
    place += point.weight * point.to * point.to;
  }
  place /= share;
  return {{{share / place, 1 - place, 0, place}}};
}

template <class Kernel>
class ElasticTerm final : public Elasticity {
  using Element = typename Kernel::Shape;
  using Material = typename Kernel::Law;
  static constexpr std::size_t D = Kernel::D;
  static constexpr std::size_t N = Kernel::N;
  static constexpr bool has_action = std::is_same_v<Kernel, ElasticKernel<Element, Material>> && !Kernel::revolved;
  using Cells = BlockCells<Kernel>;
  using Nodal = typename Cells::Nodal;
  using CellTangent = typename Cells::CellTangent;
  using Gathered = GatheredSegment<Kernel>;
  using PointState = typename KeptState<Kernel, Kernel::keeps_points>::type;
  /// In three dimensions it takes longer to write and read the sums than to compute them again.
  static constexpr bool keeps_sums = Kernel::keeps_points && Kernel::has_path && D == 2;
  using PathSums = typename KeptSums<Kernel, keeps_sums>::type;

 public:
  ElasticTerm(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern, const Material& material,
              int points)
      : material_(material),
        youngs_modulus_(youngs_modulus(material.lame)),
        cells_(mesh, block, pattern, points),
        has_default_points_(cell_rule<Element>(block, points) == mass_rule<Element>()) {}

  void place(const Pattern& pattern) override { cells_.batches.place(pattern); }

  bool add_force(const Segment& segment, const Rule& rule, double* f) const override {
    if (!Kernel::has_discrete_gradient && rule.mean == Mean::DiscreteGradient)
      throw std::logic_error("this element formulation has no discrete gradient");
    return for_each_force(segment, f, [&](std::size_t b, const auto& ends, Nodal& force) {
      return Kernel::add_force(material_, cells_.geometry[b], ends, rule, force);
    });
  }

  void add_tangent(const Segment& segment, const Rule& rule, Tangent, double* values) const override {
    for_each_batch(segment, rule, [&](std::size_t b, const CellTangent& tangent) {
      cells_.batches.scatter_tangent(b, tangent, values);
    });
  }

  std::unique_ptr<KeptPoints> create_kept() const override {
    if constexpr (Kernel::keeps_points) return std::make_unique<Kept>();
    return nullptr;
  }

  bool add_force_and_keep(const Segment& segment, const Rule& rule, KeptPoints& kept, double* f) const override {
    if constexpr (Kernel::keeps_points) {
      if (!keeps(rule)) return add_force(segment, rule, f);
      if constexpr (keeps_sums)
        if (Kernel::sums_along_path(rule)) {
          const std::size_t size = cells_.table.size();
          auto& sums = dynamic_cast<Kept&>(kept).sums;
          sums.resize(size * cells_.size());
          return for_each_force(segment, f, [&](std::size_t b, const auto& ends, Nodal& force) {
            return Kernel::add_force_and_sums(material_, cells_.geometry[b], ends, rule, force, &sums[b * size]);
          });
        }
      const std::size_t size = cells_.table.size() * rule.points.size();
      auto& states = dynamic_cast<Kept&>(kept).states;
      states.resize(size * cells_.size());
      return for_each_force(segment, f, [&](std::size_t b, const auto& ends, Nodal& force) {
        return Kernel::add_force(material_, cells_.geometry[b], ends, rule, force, &states[b * size]);
      });
    }
    return add_force(segment, rule, f);
  }

  void add_kept_tangent(const Segment& segment, const Rule& rule, Tangent kind, const KeptPoints& kept,
                        double* values) const override {
    if constexpr (Kernel::keeps_points) {
      if (keeps(rule)) {
        for (std::size_t b = 0; b < cells_.size(); ++b) {
          CellTangent tangent{};
          add_kept_tangent(b, segment, rule, dynamic_cast<const Kept&>(kept), tangent);
          cells_.batches.scatter_tangent(b, tangent, values);
        }
        return;
      }
    }
    add_tangent(segment, rule, kind, values);
  }

  bool add_row_sums(const Segment& segment, double* sums) const override {
    for_each_batch(segment, end_rule(),
                   [&](std::size_t b, const CellTangent& tangent) { cells_.scatter_row_sums(b, tangent, sums); });
    return true;
  }

  void add_diagonal(const Segment& segment, double* diagonal) const override {
    for_each_batch(segment, end_rule(), [&](std::size_t b, const CellTangent& tangent) {
      Nodal values;
      for (std::size_t r = 0; r < N * D; ++r) values[r / D][r % D] = tangent[r][r];
      cells_.batches.scatter_diagonal(b, values, diagonal);
    });
  }

  /// Returns null unless the kernel is ElasticKernel of a body without axial symmetry.
  std::unique_ptr<TangentAction> create_action() const override {
    if constexpr (has_action) return std::make_unique<Action>(*this);
    return nullptr;
  }

  double energy(const Place& at) const override {
    Pack sum = 0.0;
    for (std::size_t b = 0; b < cells_.size(); ++b)
      sum += cells_.owned[b] * Kernel::energy(material_, cells_.geometry[b], cells_.gathered(b, at.u));
    return total(sum);
  }

  void cell_fields(const double* u, CellFields& fields) const override {
    for (std::vector<double>* field : {&fields.stress_invariant, &fields.jacobian, &fields.energy_density})
      field->resize(cells_.batches.cells());
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      const auto means = Kernel::mean(material_, cells_.geometry[b], cells_.gathered(b, u),
                                      [&](const auto& h) { return invariants(material_, h); });
      for (std::size_t lane = 0; lane < cells_.batches.lanes(b); ++lane) {
        const std::size_t cell = Cells::number(b, lane);
        fields.stress_invariant[cell] = means[0][lane] / youngs_modulus_;
        fields.jacobian[cell] = means[1][lane];
        fields.energy_density[cell] = means[2][lane];
      }
    }
  }

  void cell_stress(const double* u, std::vector<SymmetricTensor>& stress) const override {
    stress.resize(cells_.batches.cells());
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      const auto mean = Kernel::mean(material_, cells_.geometry[b], cells_.gathered(b, u),
                                     [&](const auto& h) { return cauchy_stress(material_, h); });
      for (std::size_t lane = 0; lane < cells_.batches.lanes(b); ++lane)
        for (std::size_t i = 0; i < mean.size(); ++i) stress[Cells::number(b, lane)][i] = mean[i][lane];
    }
  }

 private:
  /// States of the material by batch, point and time point; or its sums by batch and point.
  class Kept final : public KeptPoints {
   public:
    std::vector<PointState> states;
    std::vector<PathSums> sums;
  };

  /// Returns whether a force by that rule keeps something.
  static bool keeps(const Rule& rule) {
    return rule.mean == Mean::Points && (keeps_sums || !Kernel::sums_along_path(rule));
  }

  /// Adds the tangent of a batch.
  void add_kept_tangent(std::size_t b, const Segment& segment, const Rule& rule, const Kept& kept,
                        CellTangent& tangent) const {
    if constexpr (keeps_sums)
      if (Kernel::sums_along_path(rule)) {
        const PathSums* sums = &kept.sums[b * cells_.table.size()];
        if (Kernel::add_summed_tangent(material_, cells_.geometry[b], sums, tangent)) return;
        const Gathered ends(cells_.batches, b, segment);
        return Kernel::add_tangent(material_, cells_.geometry[b], ends.segment(), rule, tangent);
      }
    const std::size_t size = cells_.table.size() * rule.points.size();
    Kernel::add_kept_tangent(material_, cells_.geometry[b], rule, &kept.states[b * size], tangent);
  }

  /// Calls visit(batch, segment, force), which adds to the batch's force and returns its least Jacobians, for all
  /// cells. Returns whether all Jacobians are greater than 0.
  template <class Visit>
  bool for_each_force(const Segment& segment, double* f, const Visit& visit) const {
    Pack least_jacobian = 1.0;
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      const Gathered ends(cells_.batches, b, segment);
      Nodal force{};
      least_jacobian = smaller(least_jacobian, visit(b, ends.segment(), force));
      cells_.batches.scatter_force(b, force, f);
    }
    return least(least_jacobian) > 0;
  }

  /// Calls visit(batch, tangent) for all cells.
  template <class Visit>
  void for_each_batch(const Segment& segment, const Rule& rule, const Visit& visit) const {
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      const Gathered ends(cells_.batches, b, segment);
      CellTangent tangent{};
      Kernel::add_tangent(material_, cells_.geometry[b], ends.segment(), rule, tangent);
      visit(b, tangent);
    }
  }

  using Linearization = std::conditional_t<Material::has_spatial_tangent, ElasticAction<Element, Material>,
                                           ModuliAction<Element, Material>>;

  class Action final : public KeptAction<Linearization, Kernel> {
   public:
    explicit Action(const ElasticTerm& term) : KeptAction<Linearization, Kernel>(term.cells_), term_(term) {}

    /// A mean over a straight path is evaluated at one point: with four, a product took up to four times as long. The
    /// solution does not change, as Newton's method corrects what is missing, of second order in the step.
    void linearize(const Segment& segment, const Rule& asked, Tangent, const LinearPart& linear) override {
      const Rule rule = tangent_at_one_point(asked);
      this->keep({term_.material_, rule, linear.rest, linear.inertia}, [&](std::size_t b, NarrowPack* data) {
        const Gathered ends(term_.cells_.batches, b, segment);
        Linearization::linearize(term_.material_, term_.cells_.geometry[b], ends.segment(), rule, linear.rest,
                                 linear.inertia, data);
      });
    }

    /// Returns whether the quadrature points are those of Mass.
    bool applies_mass() const override { return term_.has_default_points_; }

   private:
    const ElasticTerm& term_;
  };

  Material material_;
  double youngs_modulus_;
  Cells cells_;
  bool has_default_points_;
};

/// Returns the term of Kernel<Element, law> for a law that is compiled into the kernels.
template <template <class, class> class Kernel, class Element>
std::unique_ptr<Elasticity> make_kernel_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                             const std::shared_ptr<const ElasticLaw>& law, int points) {
  if (const auto* own = dynamic_cast<const ElasticLawOf<NeoHooke>*>(law.get()))
    return std::make_unique<ElasticTerm<Kernel<Element, NeoHooke>>>(mesh, block, pattern, own->law(), points);
  if (const auto* own = dynamic_cast<const ElasticLawOf<LinearElastic>*>(law.get()))
    return std::make_unique<ElasticTerm<Kernel<Element, LinearElastic>>>(mesh, block, pattern, own->law(), points);
  throw std::logic_error("the elastic law is not compiled into the kernels");
}

/// A separate file defines each of these functions, so that they compile apart: make_any_term() serves laws that are
/// not compiled into the kernels, make_revolved_term() all laws in bodies of revolution, the others one formulation of
/// the laws that are compiled in. An enhanced block is not enriched.
std::unique_ptr<Elasticity> make_mean_dilatation_term(const LocalMesh& mesh, const LocalBlock& block,
                                                      const Pattern& pattern,
                                                      const std::shared_ptr<const ElasticLaw>& law, int points);
std::unique_ptr<Elasticity> make_enhanced_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                               const std::shared_ptr<const ElasticLaw>& law, int points);

std::unique_ptr<Elasticity> make_any_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                          const std::shared_ptr<const ElasticLaw>& law, int points,
                                          Formulation formulation);

std::unique_ptr<Elasticity> make_revolved_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                               const std::shared_ptr<const ElasticLaw>& law, int points,
                                               Formulation formulation);

}  // namespace ixos
