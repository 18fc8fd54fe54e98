#include "term/body/viscous_term.hpp"

#include <memory>
#include <stdexcept>

#include "element/elastic_kernel.hpp"
#include "element/viscous_point.hpp"
#include "fem/with_element.hpp"
#include "material/linear_elastic.hpp"
#include "state/history.hpp"
#include "term/body/block_cells.hpp"

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

template <class Element>
class ViscousTerm final : public Viscosity {
  using Kernel = ElasticKernel<Element, LinearElastic>;  // for its geometry; also that of rings
  static constexpr std::size_t D = Kernel::D;
  static constexpr std::size_t N = Kernel::N;
  static constexpr std::size_t G = Kernel::G;
  using Gradients = CellGradients<Kernel>;
  using Nodal = typename BlockCells<Kernel>::Nodal;
  using CellTangent = typename BlockCells<Kernel>::CellTangent;
  using Matrix = Small<Pack, G>;
  using Moduli = Small<Pack, G * G>;
  using Point = ViscousPoint<G, Pack>;

 public:
  ViscousTerm(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern, const Hooke& law, int points)
      : law_(law),
        block_(block),
        owned_dofs_(static_cast<std::size_t>(mesh.owned_nodes) * D),
        local_dofs_(static_cast<std::size_t>(mesh.nodes()) * D),
        cells_(mesh, block, pattern, points),
        nothing_(block, cells_.table.size(), 1) {}

  bool is_gradient(RateForm form) const override { return form == RateForm::End; }

  void place(const Pattern& pattern) override { cells_.batches.place(pattern); }
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
  }

  void add_force(const Place& at, double* f) const override {
    const Memory& stage = memory(at.step);
    for (std::size_t i = 0; i < stage.kept.size(); ++i) f[i] += stage.kept[i];
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      Nodal force{};
      for_each_point(stage, b, at.u, [&](std::size_t q, const Point& point) {
        add_nodal(b, q, point.stress(), stage.end_weight, force);
      });
      cells_.batches.scatter_force(b, force, f);
    }
  }

  void add_tangent(const Place& at, double* values) const override {
    const Memory& stage = memory(at.step);
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      CellTangent tangent{};
      for_each_point(stage, b, at.u, [&](std::size_t q, const Point& point) {
        Moduli moduli{};
        point.add_moduli(cells_.geometry[b].points[q].weight * stage.end_weight, moduli);
        add_cell_tangent<true>(b, q, moduli, tangent);
      });
      cells_.batches.scatter_tangent(b, tangent, values);
    }
  }

  double potential(const Place& at) const override {
    const Memory& stage = memory(at.step);
    double sum = 0;
    if (!stage.kept.empty())
      for (std::size_t i = 0; i < owned_dofs_; ++i) sum += stage.kept[i] * (at.u[i] - stage.from[i]);
    Pack cells = 0.0;
    for (std::size_t b = 0; b < cells_.size(); ++b)
      for_each_point(stage, b, at.u, [&](std::size_t q, const Point& point) {
        cells += cells_.owned[b] * cells_.geometry[b].points[q].weight * stage.end_weight * point.energy();
      });
    return sum + total(cells);
  }

  void add_force_at(double factor, const double* u, const double* v, double* f) const override {
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      const Gradients displacement(cells_, b, u), velocity(cells_, b, v);
      Nodal force{};
      for (std::size_t q = 0; q < cells_.table.size(); ++q)
        add_nodal(b, q, stress_at(displacement(q), velocity(q)), factor, force);
      cells_.batches.scatter_force(b, force, f);
    }
  }

  void add_tangent_at(double by_velocity, double by_displacement, const double* u, const double* v,
                      double* values) const override {
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      const Gradients displacement(cells_, b, u), velocity(cells_, b, v);
      CellTangent tangent{};
      for (std::size_t q = 0; q < cells_.table.size(); ++q) {
        const Matrix f = deformation_gradient(displacement(q)), g = velocity(q);
        const Matrix s = law_.stress(symmetric_product(f, g));
        const Pack& weight = cells_.geometry[b].points[q].weight;
        Moduli moduli{};
        law_.add_moduli(f, f, s, Pack(by_displacement * weight), Pack(by_velocity * weight), moduli);
        law_.add_moduli(f, g, s, Pack(0.0), Pack(by_displacement * weight), moduli);
        add_cell_tangent<false>(b, q, moduli, tangent);
      }
      cells_.batches.scatter_tangent(b, tangent, values);
    }
  }

  void add_row_sums(const double* u, double* sums) const override {
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      const Gradients displacement(cells_, b, u);
      CellTangent tangent{};
      for (std::size_t q = 0; q < cells_.table.size(); ++q) {
        const Matrix f = deformation_gradient(displacement(q));
        Moduli moduli{};
        law_.add_moduli(f, f, Matrix{}, Pack(0.0), cells_.geometry[b].points[q].weight, moduli);
        add_cell_tangent<true>(b, q, moduli, tangent);
      }
      cells_.scatter_row_sums(b, tangent, sums);
    }
  }

  StepWork accept(const AcceptedStep& step, TermHistories& histories) const override {
    TermHistory& history = histories.of(slot());
    PointData& dissipated = history.points.front().values;
    Pack sum = 0.0;
    for (std::size_t b = 0; b < cells_.size(); ++b)
      for_each_work(b, step, [&](std::size_t q, const Pack& work) {
        dissipated(b, q) += work;
        sum += cells_.owned[b] * cells_.geometry[b].points[q].weight * work;
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
    density.resize(cells_.batches.cells());
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      Pack energy = 0.0, volume = 0.0;
      for (std::size_t q = 0; q < cells_.table.size(); ++q) {
        energy += cells_.geometry[b].points[q].weight * dissipated(b, q);
        volume += cells_.geometry[b].points[q].weight;
      }
      for (std::size_t lane = 0; lane < cells_.batches.lanes(b); ++lane)
        density[cells_.number(b, lane)] = energy[lane] / volume[lane];
    }
  }

  void add_cell_stress(const Place& at, std::vector<SymmetricTensor>& stress) const override {
    const bool has_kept = at.histories != nullptr && has_rates(at.histories->of(slot()));
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      const Gradients displacement(cells_, b, at.u), velocity(cells_, b, at.v);
      const auto mean = mean_over_points(
          cells_.geometry[b].points, [](std::size_t q) { return q; },
          [&](std::size_t q) {
            return has_kept ? viscous_cauchy_stress_at(law_, displacement(q),
                                                       kept_rate(at.histories->of(slot()).points.back().values, b, q))
                            : viscous_cauchy_stress(law_, displacement(q), velocity(q));
          });
      for (std::size_t lane = 0; lane < cells_.batches.lanes(b); ++lane)
        for (std::size_t i = 0; i < mean.size(); ++i) stress[cells_.number(b, lane)][i] += mean[i][lane];
    }
  }

 protected:
  TermHistory create_history() const override {
    return {{{{{"dissipated", ColumnKind::Growing, 1}}, nothing_}}, {}, {}};
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
    const Nodal start = cells_.gathered(b, stage.from);
    Nodal change = cells_.gathered(b, u);
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t i = 0; i < D; ++i) change[a][i] -= start[a][i];
    const Gradients of_start(cells_, b, start), of_change(cells_, b, change);
    for (std::size_t q = 0; q < cells_.table.size(); ++q) {
      const bool row = stage.form == RateForm::End;
      visit(q, Point{law_, stage.form, stage.unknown, stage.inverse_dt, of_start(q), of_change(q),
                     row ? stage.known[b * cells_.table.size() + q] : Matrix{}});
    }
  }

  /// Evaluates the row on Green's strain of the known states: E' = sym(F^T grad v), E'' = sym(F^T grad a) +
  /// grad v^T grad v.
  void freeze_strains(const Row& row, const std::vector<KnownState>& states, double dt,
                      std::vector<Matrix>& all) const {
    all.assign(cells_.size() * cells_.table.size(), Matrix{});
    for (std::size_t j = 0; j < row.known.size(); ++j) {
      const Row::Known& k = row.known[j];
      if (k.u == 0 && k.v == 0 && k.a == 0) continue;
      const KnownState& state = states[j];
      for (std::size_t b = 0; b < cells_.size(); ++b) {
        const Gradients start(cells_, b, states[0].u), here(cells_, b, state.u), velocity(cells_, b, state.v);
        const Gradients acceleration(cells_, b, k.a != 0 ? state.a : state.v);
        for (std::size_t q = 0; q < cells_.table.size(); ++q) {
          const Matrix h = here(q), h0 = start(q), g = velocity(q), f = deformation_gradient(h);
          Matrix& known = all[b * cells_.table.size() + q];
          if (k.u != 0 && j > 0) add(k.u, change_of_strain(h0, difference(h, h0)), known);
          if (k.v != 0) add(k.v * dt, symmetric_product(f, g), known);
          if (k.a == 0) continue;
          add(k.a * dt * dt, symmetric_product(f, acceleration(q)), known);
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
    if (step.work->form == WorkSum::Form::Stages) {
      std::vector<Pack> work(cells_.table.size(), Pack(0.0));
      for (std::size_t i = 0; i < step.states.size(); ++i) {
        const Gradients displacement(cells_, b, step.states[i].u), velocity(cells_, b, step.states[i].v);
        for (std::size_t q = 0; q < work.size(); ++q) {
          const Matrix rate = symmetric_product(deformation_gradient(displacement(q)), velocity(q));
          work[q] += step.dt * step.work->weights[i] * contraction(law_.stress(rate), rate);
        }
      }
      for (std::size_t q = 0; q < work.size(); ++q) visit(q, work[q]);
      return;
    }
    if (step.work->form == WorkSum::Form::EndMean) {
      const Gradients u0(cells_, b, start.u), v0(cells_, b, start.v), u1(cells_, b, end.u), v1(cells_, b, end.v);
      for (std::size_t q = 0; q < cells_.table.size(); ++q) {
        const Matrix change = difference(u1(q), u0(q));
        visit(q,
              0.5 * contraction(stress_at(u0(q), v0(q)), change) + 0.5 * contraction(stress_at(u1(q), v1(q)), change));
      }
      return;
    }
    const Memory& stage = memory(step.step);
    const Gradients u0(cells_, b, start.u), v0(cells_, b, start.v);
    for_each_point(stage, b, end.u, [&](std::size_t q, const Point& point) {
      if (stage.form != RateForm::End) return visit(q, point.dissipated());
      Pack work = stage.end_weight * contraction(point.stress(), point.change);
      if (stage.end_weight != 1) work += (1 - stage.end_weight) * contraction(stress_at(u0(q), v0(q)), point.change);
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
      history.points.push_back({{{"mean rate", ColumnKind::Scalar, G * G}}, {block_, cells_.table.size(), G * G}});
    return history.points.back().values;
  }
  /// Keeps the rates of strain of the step, if the force has their mean, for reports.
  void keep_rates(const AcceptedStep& step, TermHistory& history) const {
    const Memory* const stage = step.step != nullptr ? &memory(step.step) : nullptr;
    if (stage == nullptr || !stage->has_mean_rate) return drop_rates(history);
    PointData& kept = rates(history);
    for (std::size_t b = 0; b < cells_.size(); ++b)
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

  void add_nodal(std::size_t b, std::size_t q, Matrix p, double factor, Nodal& force) const {
    const Pack weight = factor * cells_.geometry[b].points[q].weight;
    for (auto& row : p)
      for (Pack& value : row) value *= weight;
    add_nodal_forces(p, Kernel::shape_gradients(cells_.geometry[b], q), force);
  }

  template <bool symmetric>
  void add_cell_tangent(std::size_t b, std::size_t q, const Moduli& moduli, CellTangent& tangent) const {
    const auto dn = Kernel::shape_gradients(cells_.geometry[b], q);
    add_contraction<symmetric>(dn, dn, moduli, tangent);
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

  Hooke law_;                ///< of rates of strain [E0 T0]
  const LocalBlock& block_;  ///< of the mesh
  std::size_t owned_dofs_, local_dofs_;
  BlockCells<Kernel> cells_;
  PointData nothing_;  ///< a zero at each point
};

}  // namespace

std::unique_ptr<Viscosity> make_viscous_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                             const Hooke& law, int points) {
  if (mesh.axisymmetric)
    return with_plane_element(block.type, [&](auto element) -> std::unique_ptr<Viscosity> {
      using Ring = Revolved<typename decltype(element)::type>;
      return std::make_unique<ViscousTerm<Ring>>(mesh, block, pattern, law, points);
    });
  return with_element(block.type, [&](auto element) -> std::unique_ptr<Viscosity> {
    return std::make_unique<ViscousTerm<typename decltype(element)::type>>(mesh, block, pattern, law, points);
  });
}

}  // namespace ixos
