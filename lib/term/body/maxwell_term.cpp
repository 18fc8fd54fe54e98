#include "term/body/maxwell_term.hpp"

#include <stdexcept>
#include <type_traits>

#include "element/elastic_kernel.hpp"
#include "element/moduli_action.hpp"
#include "fem/with_element.hpp"
#include "material/linear_elastic.hpp"
#include "term/body/block_cells.hpp"
#include "term/body/branch_points.hpp"
#include "term/body/kept_action.hpp"

namespace ixos {
namespace {

template <class Element>
class MaxwellTerm final : public Viscoelasticity {
  using Kernel = ElasticKernel<Element, LinearElastic>;  // for its geometry; also that of rings
  static constexpr std::size_t D = Kernel::D;
  static constexpr std::size_t N = Kernel::N;
  static constexpr std::size_t G = Kernel::G;
  static constexpr std::size_t C = Kernel::C;
  using Components = std::conditional_t<D == 3, SolidComponents, PlaneComponents>;
  using Points = BranchPoints<Components, G>;
  using Steps = typename Points::Steps;
  using Cells = BlockCells<Kernel>;
  using Gradients = CellGradients<Kernel>;
  using Nodal = typename Cells::Nodal;
  using CellTangent = typename Cells::CellTangent;
  using Moduli = Small<Pack, C>;
  using Ends = GatheredSegment<Kernel>;

 public:
  MaxwellTerm(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
              const std::vector<MaxwellBranch>& branches, HistoryUpdate update, int points)
      : update_(update),
        cells_(mesh, block, pattern, points),
        points_(block, cells_.table.size(), branches),
        frozen_(points_.steps(0)) {}

  bool dissipates() const override { return true; }
  bool has_state() const override { return true; }
  bool has_history() const override { return true; }

  void place(const Pattern& pattern) override { cells_.batches.place(pattern); }

  void initialize(const KnownState&, TermHistories& histories) const override {
    histories.of(slot()) = points_.history();
  }

  void begin_stage(const StageStart& start, StepMemories& step) const override {
    if (!(start.mean_time > 0)) throw std::logic_error("a stage without a length has no incremental potential");
    step.of<Memory>(slot()).steps = points_.steps(start.mean_time);
  }

  StepWork accept(const AcceptedStep& step, TermHistories& histories) const override {
    TermHistory& history = histories.of(slot());
    PointData& kept = history.points.front().values;
    const Steps& stage = step.step->of<Memory>(slot()).steps;
    Pack sum = 0.0, stress = 0.0, strain = 0.0;
    std::vector<Pack> branches(frozen_.size(), Pack(0.0));
    typename Points::StepSquares squares{};
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      const Gradients from(cells_, b, step.states.front().u), to(cells_, b, step.states.back().u);
      for (std::size_t q = 0; q < cells_.table.size(); ++q) {
        const Pack loss = points_.accept(kept, b, q, from(q), to(q), stage, step.dt, update_, squares);
        const Pack share = cells_.owned[b] * weight(b, q);
        sum += share * loss;
        for (std::size_t n = 0; n < branches.size(); ++n) branches[n] += share * squares.branches[n];
        stress += share * squares.sum;
        strain += share * squares.strain;
      }
    }
    history.last_step.clear();
    for (const Pack& branch : branches) history.last_step.push_back(total(branch));
    history.last_step.push_back(total(stress));
    history.last_step.push_back(total(strain));
    return {total(sum), 0};
  }

  BranchSquares last_squares(const TermHistories& histories) const override {
    const std::vector<double>& numbers = histories.of(slot()).last_step;
    if (numbers.empty()) return {};
    const std::size_t branches = numbers.size() - 2;
    return {{numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(branches)},
            numbers[branches],
            numbers[branches + 1]};
  }

  void transfer(Record& record, TermHistories& histories) override {
    points_.transfer(record, histories.of(slot()).points.front().values);
  }

  bool add_force(const Segment& segment, const Rule& rule, double* f) const override {
    check(rule);
    const PointData& kept = this->kept(segment.histories);
    const Steps& steps = steps_of(segment);
    Pack least_jacobian = 1.0;
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      const Ends ends(cells_.batches, b, segment);
      Nodal force{};
      for (std::size_t q = 0; q < cells_.table.size(); ++q) {
        const auto dn = Kernel::shape_gradients(cells_.geometry[b], q);
        const typename Kernel::template Ends<Pack> at(ends.segment(), dn);
        Small<Pack, G> mean{};
        for (const RulePoint& point : rule.points) {
          const auto strain = Points::strain(at.at(point));
          least_jacobian = smaller(least_jacobian, strain.jacobian);
          const auto p = points_.stress(kept, b, q, strain, steps);
          add_components(point.weight * weight(b, q), p, mean);
        }
        least_jacobian = smaller(least_jacobian, at.jacobian());
        add_nodal_forces(mean, dn, force);
      }
      cells_.batches.scatter_force(b, force, f);
    }
    return least(least_jacobian) > 0;  // the elastic law may be one of small strains, which never asks
  }

  void add_tangent(const Segment& segment, const Rule& rule, Tangent, double* values) const override {
    for_each_tangent(segment, rule, [&](std::size_t b, const CellTangent& tangent) {
      cells_.batches.scatter_tangent(b, tangent, values);
    });
  }

  /// Returns null in a body of revolution, whose elasticity has no action either.
  std::unique_ptr<TangentAction> create_action() const override {
    if constexpr (!Kernel::revolved) return std::make_unique<Action>(*this);
    return nullptr;
  }

  bool add_row_sums(const Segment& segment, double* sums) const override {
    for_each_tangent(segment, end_rule(),
                     [&](std::size_t b, const CellTangent& tangent) { cells_.scatter_row_sums(b, tangent, sums); });
    return true;
  }

  void add_diagonal(const Place& at, double* diagonal) const override {
    for_each_tangent(segment_at(at), end_rule(), [&](std::size_t b, const CellTangent& tangent) {
      Nodal values;
      for (std::size_t r = 0; r < N * D; ++r) values[r / D][r % D] = tangent[r][r];
      cells_.batches.scatter_diagonal(b, values, diagonal);
    });
  }

  double energy(const Place& at) const override {
    const PointData& kept = this->kept(at.histories);
    return integral(
        at.u, [&](std::size_t b, std::size_t q, const auto& h) { return points_.stored(kept, b, q, h, frozen_); });
  }

  double potential(const Place& at) const override {
    const PointData& kept = this->kept(at.histories);
    const Steps& stage = at.step->of<Memory>(slot()).steps;
    return integral(
        at.u, [&](std::size_t b, std::size_t q, const auto& h) { return points_.potential(kept, b, q, h, stage); });
  }

  void add_cell_dissipation(const TermHistories& histories, std::vector<double>& density) const override {
    const PointData& kept = this->kept(&histories);
    density.resize(cells_.batches.cells());
    for (std::size_t b = 0; b < cells_.size(); ++b)
      for_each_mean(
          b, [&](std::size_t q) { return std::array<Pack, 1>{points_.dissipated(kept, b, q)}; },
          [&](std::size_t cell, std::size_t lane, const auto& mean) { density[cell] += mean[0][lane]; });
  }

  std::array<double, 2> squared_error(const Segment& step) const override {
    const PointData& kept = this->kept(step.histories);
    Pack sum = 0.0, volume = 0.0;
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      const Gradients from(cells_, b, step.from), to(cells_, b, step.to);
      for (std::size_t q = 0; q < cells_.table.size(); ++q) {
        const Pack share = cells_.owned[b] * weight(b, q);
        sum += share * points_.squared_error(kept, b, q, from(q), to(q), step.length, update_);
        volume += share;
      }
    }
    return {total(sum), total(volume)};
  }

  void add_cell_energy(const Place& at, std::vector<double>& density) const override {
    const PointData& kept = this->kept(at.histories);
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      const Gradients displacement(cells_, b, at.u);
      for_each_mean(
          b, [&](std::size_t q) { return std::array<Pack, 1>{points_.stored(kept, b, q, displacement(q), frozen_)}; },
          [&](std::size_t cell, std::size_t lane, const auto& mean) { density[cell] += mean[0][lane]; });
    }
  }

  void add_cell_stress(const Place& at, std::vector<SymmetricTensor>& stress) const override {
    const PointData& kept = this->kept(at.histories);
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      const Gradients displacement(cells_, b, at.u);
      for_each_mean(
          b, [&](std::size_t q) { return cauchy_stress(kept, b, q, displacement(q)); },
          [&](std::size_t cell, std::size_t lane, const auto& mean) {
            for (std::size_t i = 0; i < mean.size(); ++i) stress[cell][i] += mean[i][lane];
          });
    }
  }

 protected:
  TermHistory create_history() const override { return points_.history(); }
  std::unique_ptr<StepMemory> create_memory() const override {
    auto memory = std::make_unique<Memory>();
    memory->steps = frozen_;
    return memory;
  }

 private:
  /// A stage: the steps of its force.
  struct Memory final : StepMemory {
    Steps steps;
  };

  const PointData& kept(const TermHistories* histories) const {
    if (histories == nullptr) throw std::logic_error("Maxwell branches need the histories of a state");
    return histories->of(slot()).points.front().values;
  }

  static void check(const Rule& rule) {
    if (rule.mean != Mean::Points) throw std::logic_error("Maxwell branches take means of points only");
  }

  const Pack& weight(std::size_t b, std::size_t q) const { return cells_.geometry[b].points[q].weight; }
  const Steps& steps_of(const Segment& segment) const {
    return segment.length > 0 ? segment.step->of<Memory>(slot()).steps : frozen_;
  }

  static void add_components(const Pack& factor, const Small<Pack, 3>& p, Small<Pack, G>& sum) {
    for (std::size_t r = 0; r < C; ++r) {
      const auto [i, j] = Components::all[r];
      sum[i][j] += factor * p[i][j];
    }
  }

  /// Returns `scale` times the moduli of a point, sums over branches and time points.
  Moduli moduli(const PointData& kept, std::size_t b, std::size_t q, const Ends& ends, const Steps& steps,
                const Rule& rule, const Pack& scale) const {
    const typename Kernel::template Ends<Pack> at(ends.segment(), Kernel::shape_gradients(cells_.geometry[b], q));
    Moduli result{};
    for (const RulePoint& point : rule.points)
      points_.add_moduli(kept, b, q, at.at(point), steps, Pack(point.weight * point.to * scale), result);
    for (std::size_t r = 0; r < C; ++r)
      for (std::size_t c = r + 1; c < C; ++c) result[r][c] = result[c][r];
    return result;
  }

  /// Calls visit(batch, tangent) for all cells.
  template <class Visit>
  void for_each_tangent(const Segment& segment, const Rule& rule, const Visit& visit) const {
    check(rule);
    const PointData& kept = this->kept(segment.histories);
    const Steps& steps = steps_of(segment);
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      const Ends ends(cells_.batches, b, segment);
      CellTangent tangent{};
      for (std::size_t q = 0; q < cells_.table.size(); ++q) {
        const auto dn = Kernel::shape_gradients(cells_.geometry[b], q);
        add_contraction<true>(dn, dn, moduli(kept, b, q, ends, steps, rule, weight(b, q)), tangent);
      }
      visit(b, tangent);
    }
  }

  using Linearization = ModuliAction<Element, LinearElastic>;

  /// It has no linear part: the elasticity beside it applies that.
  class Action final : public KeptAction<Linearization, Kernel> {
   public:
    explicit Action(const MaxwellTerm& term) : KeptAction<Linearization, Kernel>(term.cells_), term_(term) {}

    void linearize(const Segment& segment, const Rule& rule, Tangent, const LinearPart&) override {
      check(rule);
      const PointData& kept = term_.kept(segment.histories);
      const Steps& steps = term_.steps_of(segment);
      this->keep({}, [&](std::size_t b, NarrowPack* data) {
        const Ends ends(term_.cells_.batches, b, segment);
        Linearization::keep(term_.cells_.geometry[b].points, 0, data,
                            [&](std::size_t q) { return term_.moduli(kept, b, q, ends, steps, rule, Pack(1.0)); });
      });
    }

    bool applies_mass() const override { return true; }

   private:
    const MaxwellTerm& term_;
  };

  /// Returns this rank's share of the integral of density(batch, point, H).
  template <class Density>
  double integral(const double* u, const Density& density) const {
    Pack sum = 0.0;
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      const Gradients displacement(cells_, b, u);
      for (std::size_t q = 0; q < cells_.table.size(); ++q)
        sum += cells_.owned[b] * weight(b, q) * density(b, q, displacement(q));
    }
    return total(sum);
  }

  std::array<Pack, 6> cauchy_stress(const PointData& kept, std::size_t b, std::size_t q,
                                    const Small<Pack, G>& h) const {
    using Algebra = typename Points::Strain::Algebra;
    const auto strain = Points::strain(h);
    const auto kirchhoff = Algebra::product_transposed(points_.stress(kept, b, q, strain, frozen_), strain.f);
    const auto component = [&](std::size_t i, std::size_t j) {
      return Components::has(i, j) ? Pack(kirchhoff[i][j] / strain.jacobian) : Pack(0.0);
    };
    return {component(0, 0), component(1, 1), component(2, 2), component(0, 1), component(1, 2), component(2, 0)};
  }

  /// Calls visit(cell, lane, mean of value(point)) for the cells of a batch.
  template <class Value, class Visit>
  void for_each_mean(std::size_t b, const Value& value, const Visit& visit) const {
    const auto mean = mean_over_points(
        cells_.geometry[b].points, [](std::size_t q) { return q; }, value);
    for (std::size_t lane = 0; lane < cells_.batches.lanes(b); ++lane) visit(cells_.number(b, lane), lane, mean);
  }

  HistoryUpdate update_;
  Cells cells_;
  Points points_;
  Steps frozen_;  ///< of length 0
};

}  // namespace

std::unique_ptr<Viscoelasticity> make_maxwell_term(const LocalMesh& mesh, const LocalBlock& block,
                                                   const Pattern& pattern, const std::vector<MaxwellBranch>& branches,
                                                   HistoryUpdate update, int points) {
  const auto make = [&](auto element) -> std::unique_ptr<Viscoelasticity> {
    return std::make_unique<MaxwellTerm<typename decltype(element)::type>>(mesh, block, pattern, branches, update,
                                                                           points);
  };
  if (!mesh.axisymmetric) return with_element(block.type, make);
  return with_plane_element(block.type,
                            [&](auto element) { return make(TypeTag<Revolved<typename decltype(element)::type>>{}); });
}

}  // namespace ixos
