#include "term/body/viscous_term.hpp"

#include <array>
#include <memory>
#include <stdexcept>
#include <vector>

#include "base/scratch.hpp"
#include "element/cell_means.hpp"
#include "element/viscous_point.hpp"
#include "material/hooke.hpp"
#include "state/history.hpp"
#include "term/body/body_cells.hpp"

namespace ixos {
namespace {

/// Returns whether the row is a multiple of the change of the displacement since the step's start.
bool is_difference(const Row& row) {
  for (std::size_t j = 0; j < row.known.size(); ++j) {
    const Row::Known& k = row.known[j];
    if (k.v != 0 || k.a != 0 || (j > 0 && k.u != 0)) return false;
  }
  return true;
}

template <class Space>
class ViscousTerm final : public Viscosity {
  static constexpr std::size_t G = Space::G;
  using Cells = BodyCells<Space>;
  using Matrix = typename Cells::Gradient;
  using Matrices = std::vector<Matrix>;
  using Moduli = Small<Pack, G * G>;
  using Point = ViscousPoint<G, Pack>;

 public:
  ViscousTerm(const LocalMesh& mesh, const LocalBlock& block, std::unique_ptr<Cells> cells, const Hooke& law)
      : law_(law),
        mesh_(mesh),
        block_(block),
        owned_dofs_(static_cast<std::size_t>(mesh.owned_nodes) * Cells::D),
        local_dofs_(static_cast<std::size_t>(mesh.nodes()) * Cells::D),
        cells_(std::move(cells)),
        nothing_(block, cells_->points(), 1) {}

  bool is_gradient(RateForm form) const override { return form == RateForm::End; }

  void place(const Pattern& pattern) override { cells_->place(pattern); }
  void initialize(const KnownState&, TermHistories& histories) const override {
    histories.of(slot()) = create_history();
  }

  void begin_stage(const StageStart& start, StepMemories& step) const override {
    auto& stage = step.of<Memory>(slot());
    stage.form = start.rate_form;
    stage.unknown = stage.form == RateForm::End ? start.velocity->unknown : 1.0;
    stage.inverse_dt = 1 / start.dt;
    stage.end_weight = 1 - start.start_weight;
    stage.has_mean_rate = stage.form == RateForm::End && start.length == start.dt && is_difference(*start.velocity);
    stage.from = start.known.front().u;
    if (stage.form == RateForm::End) freeze_strains(*start.velocity, start.known, start.dt, stage.known);
    stage.kept.clear();
    if (start.start_weight == 0) return;
    stage.kept.assign(local_dofs_, 0.0);
    add_force_at(start.start_weight, stage.from, start.known.front().v, stage.kept.data());
    mesh_.ties.condense(stage.kept.data(), Cells::D);
  }

  void add_force(const Place& at, double* f) const override {
    const Memory& stage = memory(at.step);
    for (std::size_t i = 0; i < stage.kept.size(); ++i) f[i] += stage.kept[i];
    Matrices p(cells_->points());
    for (std::size_t b = 0; b < cells_->size(); ++b) {
      for_each_point(stage, b, at.u, [&](std::size_t q, const Point& point) {
        p[q] = point.stress();
        scale(stage.end_weight, p[q]);
      });
      cells_->add_forces(b, p.data(), f);
    }
  }

  void add_tangent(const Place& at, double* values) const override {
    const Memory& stage = memory(at.step);
    std::vector<Moduli> all(cells_->points());
    const typename Cells::ModuliOf moduli = of(all);
    for (std::size_t b = 0; b < cells_->size(); ++b) {
      for_each_point(stage, b, at.u, [&](std::size_t q, const Point& point) {
        all[q] = {};
        point.add_moduli(Pack(stage.end_weight), all[q]);
      });
      cells_->add_tangent(b, true, moduli, values);
    }
  }

  double potential(const Place& at) const override {
    const Memory& stage = memory(at.step);
    double sum = 0;
    if (!stage.kept.empty())
      for (std::size_t i = 0; i < owned_dofs_; ++i) sum += stage.kept[i] * (at.u[i] - stage.from[i]);
    Pack cells = 0.0;
    for (std::size_t b = 0; b < cells_->size(); ++b)
      for_each_point(stage, b, at.u, [&](std::size_t q, const Point& point) {
        cells += cells_->owned(b) * cells_->weight(b, q) * stage.end_weight * point.energy();
      });
    return sum + total(cells);
  }

  void add_force_at(double factor, const double* u, const double* v, double* f) const override {
    Matrices displacement(cells_->points()), velocity(cells_->points()), p(cells_->points());
    for (std::size_t b = 0; b < cells_->size(); ++b) {
      cells_->gradients(b, u, displacement.data());
      cells_->gradients(b, v, velocity.data());
      for (std::size_t q = 0; q < p.size(); ++q) {
        p[q] = stress_at(displacement[q], velocity[q]);
        scale(factor, p[q]);
      }
      cells_->add_forces(b, p.data(), f);
    }
  }

  void add_tangent_at(double by_velocity, double by_displacement, const double* u, const double* v,
                      double* values) const override {
    Matrices displacement(cells_->points()), velocity(cells_->points());
    std::vector<Moduli> all(cells_->points());
    const typename Cells::ModuliOf moduli = of(all);
    for (std::size_t b = 0; b < cells_->size(); ++b) {
      cells_->gradients(b, u, displacement.data());
      cells_->gradients(b, v, velocity.data());
      for (std::size_t q = 0; q < all.size(); ++q) {
        const Matrix f = deformation_gradient(displacement[q]), g = velocity[q];
        const Matrix s = law_.stress(symmetric_product(f, g));
        all[q] = {};
        law_.add_moduli(f, f, s, Pack(by_displacement), Pack(by_velocity), all[q]);
        law_.add_moduli(f, g, s, Pack(0.0), Pack(by_displacement), all[q]);
      }
      cells_->add_tangent(b, false, moduli, values);
    }
  }

  void add_row_sums(const double* u, double* sums) const override {
    Matrices displacement(cells_->points());
    std::vector<Moduli> all(cells_->points());
    const typename Cells::ModuliOf moduli = of(all);
    for (std::size_t b = 0; b < cells_->size(); ++b) {
      cells_->gradients(b, u, displacement.data());
      for (std::size_t q = 0; q < all.size(); ++q) {
        const Matrix f = deformation_gradient(displacement[q]);
        all[q] = {};
        law_.add_moduli(f, f, Matrix{}, Pack(0.0), Pack(1.0), all[q]);
      }
      cells_->add_row_sums(b, moduli, sums);
    }
  }

  StepWork accept(const AcceptedStep& step, TermHistories& histories) const override {
    TermHistory& history = histories.of(slot());
    PointData& dissipated = history.points.front().values;
    Pack sum = 0.0;
    for (std::size_t b = 0; b < cells_->size(); ++b)
      for_each_work(b, step, [&](std::size_t q, const Pack& work) {
        dissipated(b, q) += work;
        sum += cells_->owned(b) * cells_->weight(b, q) * work;
      });
    keep_rates(step, history);
    return {total(sum), 0};
  }

  bool has_state() const override { return true; }
  void transfer(Record& record, TermHistories& histories) override {
    TermHistory& history = histories.of(slot());
    history.points.front().values.transfer(record);
    bool keeps = has_rates(history);
    record.number("has a mean rate", keeps);
    if (!keeps) return drop_rates(history);
    const Record::Section section(record, "mean rate");
    rates(history).transfer(record);
  }

  void cell_dissipation(const TermHistories& histories, std::vector<double>& density) const override {
    const PointData& dissipated = histories.of(slot()).points.front().values;
    density.resize(cells_->cells());
    for (std::size_t b = 0; b < cells_->size(); ++b) {
      const auto mean = mean_over(cells_->points(), cells_->weights(b),
                                  [&](std::size_t q) { return std::array<Pack, 1>{dissipated(b, q)}; });
      for (std::size_t lane = 0; lane < cells_->lanes(b); ++lane) density[Cells::number(b, lane)] = mean[0][lane];
    }
  }

  void add_cell_stress(const Place& at, std::vector<SymmetricTensor>& stress) const override {
    const bool has_kept = at.histories != nullptr && has_rates(at.histories->of(slot()));
    Matrices displacement(cells_->points()), velocity(cells_->points());
    const PointData* const kept = has_kept ? &at.histories->of(slot()).points.back().values : nullptr;
    for (std::size_t b = 0; b < cells_->size(); ++b) {
      cells_->gradients(b, at.u, displacement.data());
      cells_->gradients(b, at.v, velocity.data());
      const auto mean = mean_over(cells_->points(), cells_->weights(b), [&](std::size_t q) {
        return kept != nullptr ? viscous_cauchy_stress_at(law_, displacement[q], kept_rate(*kept, b, q))
                               : viscous_cauchy_stress(law_, displacement[q], velocity[q]);
      });
      for (std::size_t lane = 0; lane < cells_->lanes(b); ++lane)
        for (std::size_t i = 0; i < mean.size(); ++i) stress[Cells::number(b, lane)][i] += mean[i][lane];
    }
  }

 protected:
  TermHistory create_history() const override {
    return {{{{{"dissipated", ColumnKind::Growing, 1}}, nothing_, cells_->places()}}, {}, {}};
  }
  std::unique_ptr<StepMemory> create_memory() const override { return std::make_unique<Memory>(); }

 private:
  /// A stage.
  struct Memory final : StepMemory {
    RateForm form = RateForm::End;
    double unknown = 0, inverse_dt = 0, end_weight = 1;
    const double* from = nullptr;  ///< u at the step's start
    bool has_mean_rate = false;    ///< the force has the mean rate of strain of the step
    std::vector<Matrix> known;     ///< the row's known part, by batch and point; End only
    std::vector<double> kept;      ///< the force at the step's start, weighted; empty if its weight is 0
  };
  const Memory& memory(const StepMemories* step) const { return step->of<Memory>(slot()); }

  /// Calls visit(point number, point) for the points of a batch at the displacement u of the stage's end.
  template <class Visit>
  void for_each_point(const Memory& stage, std::size_t b, const double* u, const Visit& visit) const {
    Scratch<Matrix> start(cells_->points()), change(cells_->points());
    cells_->gradients(b, stage.from, start.data());
    cells_->gradients_of_change(b, stage.from, u, change.data());
    const bool row = stage.form == RateForm::End;
    for (std::size_t q = 0; q < start.size(); ++q)
      visit(q, Point{law_, stage.form, stage.unknown, stage.inverse_dt, start[q], change[q],
                     row ? stage.known[b * start.size() + q] : Matrix{}});
  }

  /// Returns what BodyCells asks for of moduli between all components.
  static typename Cells::ModuliOf of(const std::vector<Moduli>& all) {
    return [&all](std::size_t first, std::size_t count, typename Cells::Moduli* a) {
      for (std::size_t q = 0; q < count; ++q) copy_moduli(all[first + q], a[q]);
    };
  }
  static void scale(double factor, Matrix& m) {
    for (auto& row : m)
      for (Pack& value : row) value *= factor;
  }

  /// Evaluates the row on Green's strain of the known states: E' = sym(F^T grad v), E'' = sym(F^T grad a) +
  /// grad v^T grad v.
  void freeze_strains(const Row& row, const std::vector<KnownState>& states, double dt,
                      std::vector<Matrix>& all) const {
    const std::size_t points = cells_->points();
    all.assign(cells_->size() * points, Matrix{});
    Matrices start(points), here(points), velocity(points), acceleration(points);
    for (std::size_t j = 0; j < row.known.size(); ++j) {
      const Row::Known& k = row.known[j];
      if (k.u == 0 && k.v == 0 && k.a == 0) continue;
      const KnownState& state = states[j];
      for (std::size_t b = 0; b < cells_->size(); ++b) {
        cells_->gradients(b, states[0].u, start.data());
        cells_->gradients(b, state.u, here.data());
        cells_->gradients(b, state.v, velocity.data());
        if (k.a != 0) cells_->gradients(b, state.a, acceleration.data());
        for (std::size_t q = 0; q < points; ++q) {
          const Matrix &h = here[q], &h0 = start[q], &g = velocity[q], f = deformation_gradient(h);
          Matrix& known = all[b * points + q];
          if (k.u != 0 && j > 0) add(k.u, change_of_strain(h0, difference(h, h0)), known);
          if (k.v != 0) add(k.v * dt, symmetric_product(f, g), known);
          if (k.a == 0) continue;
          add(k.a * dt * dt, symmetric_product(f, acceleration[q]), known);
          add(k.a * dt * dt, symmetric_product(g, g), known);
        }
      }
    }
  }

  /// Calls visit(point, work per reference volume in the step) for a batch.
  template <class Visit>
  void for_each_work(std::size_t b, const AcceptedStep& step, const Visit& visit) const {
    const KnownState& start = step.states.front();
    const KnownState& end = step.states.back();
    const std::size_t points = cells_->points();
    Matrices u0(points), v0(points);
    if (step.work->form == WorkSum::Form::Stages) {
      std::vector<Pack> work(points, Pack(0.0));
      for (std::size_t i = 0; i < step.states.size(); ++i) {
        cells_->gradients(b, step.states[i].u, u0.data());
        cells_->gradients(b, step.states[i].v, v0.data());
        for (std::size_t q = 0; q < points; ++q) {
          const Matrix rate = symmetric_product(deformation_gradient(u0[q]), v0[q]);
          work[q] += step.dt * step.work->weights[i] * contraction(law_.stress(rate), rate);
        }
      }
      for (std::size_t q = 0; q < points; ++q) visit(q, work[q]);
      return;
    }
    cells_->gradients(b, start.u, u0.data());
    cells_->gradients(b, start.v, v0.data());
    if (step.work->form == WorkSum::Form::EndMean) {
      Matrices u1(points), v1(points);
      cells_->gradients(b, end.u, u1.data());
      cells_->gradients(b, end.v, v1.data());
      for (std::size_t q = 0; q < points; ++q) {
        const Matrix change = difference(u1[q], u0[q]);
        visit(q,
              0.5 * contraction(stress_at(u0[q], v0[q]), change) + 0.5 * contraction(stress_at(u1[q], v1[q]), change));
      }
      return;
    }
    const Memory& stage = memory(step.step);
    for_each_point(stage, b, end.u, [&](std::size_t q, const Point& point) {
      if (stage.form != RateForm::End) return visit(q, point.dissipated());
      Pack work = stage.end_weight * contraction(point.stress(), point.change);
      if (stage.end_weight != 1) work += (1 - stage.end_weight) * contraction(stress_at(u0[q], v0[q]), point.change);
      visit(q, work);
    });
  }

  static bool has_rates(const TermHistory& history) { return history.points.size() > 1; }
  static void drop_rates(TermHistory& history) {
    if (has_rates(history)) history.points.pop_back();
  }
  /// Returns the rates of Green's strain in the accepted step, which it adds if there are none [1/T0].
  PointData& rates(TermHistory& history) const {
    if (!has_rates(history))
      history.points.push_back({{{"mean rate", ColumnKind::Scalar, G * G}}, {block_, cells_->points(), G * G}});
    return history.points.back().values;
  }
  /// Keeps the rates of strain of the step, if the force has their mean, for reports.
  void keep_rates(const AcceptedStep& step, TermHistory& history) const {
    const Memory* const stage = step.step != nullptr ? &memory(step.step) : nullptr;
    if (stage == nullptr || !stage->has_mean_rate) return drop_rates(history);
    PointData& kept = rates(history);
    for (std::size_t b = 0; b < cells_->size(); ++b)
      for_each_point(*stage, b, step.states.back().u, [&](std::size_t q, const Point& point) {
        const Matrix rate = point.rate();
        for (std::size_t k = 0; k < G * G; ++k) kept(b, q, k) = rate[k / G][k % G];
      });
  }
  static Matrix kept_rate(const PointData& kept, std::size_t b, std::size_t q) {
    Matrix rate;
    for (std::size_t k = 0; k < G * G; ++k) rate[k / G][k % G] = kept(b, q, k);
    return rate;
  }

  /// Returns P of a displacement gradient and that of its velocity.
  Matrix stress_at(const Matrix& h, const Matrix& g) const {
    const Matrix f = deformation_gradient(h);
    return product(f, law_.stress(symmetric_product(f, g)));
  }

  static Matrix difference(Matrix a, const Matrix& b) {
    for (std::size_t i = 0; i < G; ++i)
      for (std::size_t j = 0; j < G; ++j) a[i][j] -= b[i][j];
    return a;
  }
  static void add(double factor, const Matrix& a, Matrix& sum) {
    for (std::size_t i = 0; i < G; ++i)
      for (std::size_t j = 0; j < G; ++j) sum[i][j] += factor * a[i][j];
  }

  Hooke law_;  ///< of rates of strain [E0 T0]
  const LocalMesh& mesh_;
  const LocalBlock& block_;  ///< of the mesh
  std::size_t owned_dofs_, local_dofs_;
  std::unique_ptr<Cells> cells_;
  PointData nothing_;  ///< a zero at each point
};

}  // namespace

std::unique_ptr<Viscosity> make_viscous_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                             const Hooke& law, int points) {
  return in_space_of(mesh, [&](auto space) -> std::unique_ptr<Viscosity> {
    return std::make_unique<ViscousTerm<decltype(space)>>(mesh, block,
                                                          make_body_cells(space, mesh, block, pattern, points), law);
  });
}

}  // namespace ixos
