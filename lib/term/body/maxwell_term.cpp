#include "term/body/maxwell_term.hpp"

#include <stdexcept>
#include <type_traits>

#include "element/cell_means.hpp"
#include "term/body/batch_ends.hpp"
#include "term/body/body_cells.hpp"
#include "term/body/branch_points.hpp"
#include "term/body/kept_action.hpp"

namespace ixos {
namespace {

template <class Space>
class MaxwellTerm final : public Viscoelasticity {
  static constexpr std::size_t G = Space::G;
  static constexpr std::size_t C = Space::C;
  using Components = std::conditional_t<std::is_same_v<Space, SolidSpace>, SolidComponents, PlaneComponents>;
  using Points = BranchPoints<Components, G>;
  using Steps = typename Points::Steps;
  using Cells = BodyCells<Space>;
  using Gradient = typename Cells::Gradient;
  using Gradients = std::vector<Gradient>;
  using Moduli = typename Cells::Moduli;

 public:
  MaxwellTerm(const LocalBlock& block, std::unique_ptr<Cells> cells, const std::vector<MaxwellBranch>& branches,
              HistoryUpdate update)
      : update_(update),
        cells_(std::move(cells)),
        points_(block, cells_->points(), branches),
        frozen_(points_.steps(0)) {}

  bool dissipates() const override { return true; }
  bool has_state() const override { return true; }
  bool has_history() const override { return true; }

  void place(const Pattern& pattern) override { cells_->place(pattern); }

  void initialize(const KnownState&, TermHistories& histories) const override {
    histories.of(slot()) = create_history();
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
    Gradients from(cells_->points()), to(cells_->points());
    for (std::size_t b = 0; b < cells_->size(); ++b) {
      cells_->gradients(b, step.states.front().u, from.data());
      cells_->gradients(b, step.states.back().u, to.data());
      for (std::size_t q = 0; q < to.size(); ++q) {
        const Pack loss = points_.accept(kept, b, q, from[q], to[q], stage, step.dt, update_, squares);
        const Pack share = cells_->owned(b) * cells_->weight(b, q);
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
    BatchEnds<Space> ends(*cells_, segment);
    Gradients p(cells_->points());
    Pack least_jacobian = 1.0;
    for (std::size_t b = 0; b < cells_->size(); ++b) {
      const PointEnds<Pack, G> here = ends.of(b);
      for (std::size_t q = 0; q < p.size(); ++q) {
        p[q] = {};
        for (const RulePoint& point : rule.points) {
          const auto strain = Points::strain(here.at(q, point));
          least_jacobian = smaller(least_jacobian, strain.jacobian);
          add_components(point.weight, points_.stress(kept, b, q, strain, steps), p[q]);
        }
        least_jacobian = smaller(least_jacobian, determinant(deformation_gradient(here.to[q])));
      }
      cells_->add_forces(b, p.data(), f);
    }
    return least(least_jacobian) > 0;  // the elastic law may be one of small strains, which never asks
  }

  void add_tangent(const Segment& segment, const Rule& rule, Tangent, double* values) const override {
    with_moduli(segment, rule,
                [&](std::size_t b, const auto& moduli) { cells_->add_tangent(b, true, moduli, values); });
  }

  /// Returns null in a body of revolution, whose elasticity has no action either.
  std::unique_ptr<TangentAction> create_action() const override {
    if constexpr (!Space::is_ring) return std::make_unique<Action>(*this);
    return nullptr;
  }

  bool add_row_sums(const Segment& segment, double* sums) const override {
    with_moduli(segment, end_rule(), [&](std::size_t b, const auto& moduli) { cells_->add_row_sums(b, moduli, sums); });
    return true;
  }

  void add_diagonal(const Place& at, double* diagonal) const override {
    with_moduli(segment_at(at), end_rule(),
                [&](std::size_t b, const auto& moduli) { cells_->add_diagonal(b, moduli, diagonal); });
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
    density.resize(cells_->cells());
    for (std::size_t b = 0; b < cells_->size(); ++b)
      for_each_mean(
          b, [&](std::size_t q) { return std::array<Pack, 1>{points_.dissipated(kept, b, q)}; },
          [&](std::size_t cell, std::size_t lane, const auto& mean) { density[cell] += mean[0][lane]; });
  }

  std::array<double, 2> squared_error(const Segment& step) const override {
    const PointData& kept = this->kept(step.histories);
    Pack sum = 0.0, volume = 0.0;
    Gradients from(cells_->points()), to(cells_->points());
    for (std::size_t b = 0; b < cells_->size(); ++b) {
      cells_->gradients(b, step.from, from.data());
      cells_->gradients(b, step.to, to.data());
      for (std::size_t q = 0; q < to.size(); ++q) {
        const Pack share = cells_->owned(b) * cells_->weight(b, q);
        sum += share * points_.squared_error(kept, b, q, from[q], to[q], step.length, update_);
        volume += share;
      }
    }
    return {total(sum), total(volume)};
  }

  void add_cell_energy(const Place& at, std::vector<double>& density) const override {
    const PointData& kept = this->kept(at.histories);
    Gradients h(cells_->points());
    for (std::size_t b = 0; b < cells_->size(); ++b) {
      cells_->gradients(b, at.u, h.data());
      for_each_mean(
          b, [&](std::size_t q) { return std::array<Pack, 1>{points_.stored(kept, b, q, h[q], frozen_)}; },
          [&](std::size_t cell, std::size_t lane, const auto& mean) { density[cell] += mean[0][lane]; });
    }
  }

  void add_cell_stress(const Place& at, std::vector<SymmetricTensor>& stress) const override {
    const PointData& kept = this->kept(at.histories);
    Gradients h(cells_->points());
    for (std::size_t b = 0; b < cells_->size(); ++b) {
      cells_->gradients(b, at.u, h.data());
      for_each_mean(
          b, [&](std::size_t q) { return cauchy_stress(kept, b, q, h[q]); },
          [&](std::size_t cell, std::size_t lane, const auto& mean) {
            for (std::size_t i = 0; i < mean.size(); ++i) stress[cell][i] += mean[i][lane];
          });
    }
  }

 protected:
  TermHistory create_history() const override { return points_.history(cells_->places()); }
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

  const Steps& steps_of(const Segment& segment) const {
    return segment.length > 0 ? segment.step->of<Memory>(slot()).steps : frozen_;
  }

  static void add_components(double factor, const Small<Pack, 3>& p, Small<Pack, G>& sum) {
    for (std::size_t r = 0; r < C; ++r) {
      const auto [i, j] = Components::all[r];
      sum[i][j] += factor * p[i][j];
    }
  }

  /// Returns the moduli of a point, sums over branches and time points.
  Moduli moduli(const PointData& kept, std::size_t b, std::size_t q, const PointEnds<Pack, G>& ends, const Steps& steps,
                const Rule& rule) const {
    Moduli result{};
    for (const RulePoint& point : rule.points)
      points_.add_moduli(kept, b, q, ends.at(q, point), steps, Pack(point.weight * point.to), result);
    for (std::size_t r = 0; r < C; ++r)
      for (std::size_t c = r + 1; c < C; ++c) result[r][c] = result[c][r];
    return result;
  }

  /// Calls visit(batch, moduli of its points) for all batches.
  template <class Visit>
  void with_moduli(const Segment& segment, const Rule& rule, const Visit& visit) const {
    check(rule);
    const PointData& kept = this->kept(segment.histories);
    const Steps& steps = steps_of(segment);
    BatchEnds<Space> ends(*cells_, segment);
    PointEnds<Pack, G> here;
    std::size_t b = 0;
    const typename Cells::ModuliOf of_points = [&](std::size_t first, std::size_t count, Moduli* a) {
      for (std::size_t q = 0; q < count; ++q) a[q] = moduli(kept, b, first + q, here, steps, rule);
    };
    for (; b < cells_->size(); ++b) {
      here = ends.of(b);
      visit(b, of_points);
    }
  }

  /// It has no linear part: the elasticity beside it applies that.
  class Action final : public KeptAction<Space> {
   public:
    explicit Action(const MaxwellTerm& term) : KeptAction<Space>(*term.cells_), term_(term) {}

    void linearize(const Segment& segment, const Rule& rule, Tangent, const LinearPart&) override {
      check(rule);
      const PointData& kept = term_.kept(segment.histories);
      const Steps& steps = term_.steps_of(segment);
      const ModuliProduct<Cells::D> product;
      BatchEnds<Space> ends(*term_.cells_, segment);
      std::vector<Moduli> moduli(term_.cells_->points());
      this->keep(PointProduct<Cells::D>(product), [&](std::size_t b, NarrowPack* data) {
        const PointEnds<Pack, G> here = ends.of(b);
        for (std::size_t q = 0; q < moduli.size(); ++q) moduli[q] = term_.moduli(kept, b, q, here, steps, rule);
        product.keep_moduli(moduli.size(), moduli.data(), term_.cells_->space_points(b), data);
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
    Gradients h(cells_->points());
    for (std::size_t b = 0; b < cells_->size(); ++b) {
      cells_->gradients(b, u, h.data());
      for (std::size_t q = 0; q < h.size(); ++q) sum += cells_->owned(b) * cells_->weight(b, q) * density(b, q, h[q]);
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
    const auto mean = mean_over(cells_->points(), cells_->weights(b), value);
    for (std::size_t lane = 0; lane < cells_->lanes(b); ++lane) visit(Cells::number(b, lane), lane, mean);
  }

  HistoryUpdate update_;
  std::unique_ptr<Cells> cells_;
  Points points_;
  Steps frozen_;  ///< of length 0
};

}  // namespace

std::unique_ptr<Viscoelasticity> make_maxwell_term(const LocalMesh& mesh, const LocalBlock& block,
                                                   const Pattern& pattern, const std::vector<MaxwellBranch>& branches,
                                                   HistoryUpdate update, int points) {
  return in_space_of(mesh, [&](auto space) -> std::unique_ptr<Viscoelasticity> {
    return std::make_unique<MaxwellTerm<decltype(space)>>(block, make_body_cells(space, mesh, block, pattern, points),
                                                          branches, update);
  });
}

}  // namespace ixos
