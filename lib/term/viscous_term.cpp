#include "term/viscous_term.hpp"

#include <stdexcept>

#include "discretization/cell_quadrature.hpp"
#include "discretization/element_batches.hpp"
#include "discretization/point_data.hpp"
#include "element/elastic_kernel.hpp"
#include "element/viscous_point.hpp"
#include "fem/with_element.hpp"
#include "material/linear_elastic.hpp"

namespace ixos {
namespace {

template <class Element>
class ViscousTerm final : public Viscosity {
  using Kernel = ElasticKernel<Element, LinearElastic>;  // for its geometry
  static constexpr std::size_t D = Kernel::D;
  static constexpr std::size_t N = Kernel::N;
  using Nodal = typename Kernel::template Nodal<Pack>;
  using CellTangent = typename Kernel::template Tangent<Pack>;
  using Matrix = Small<Pack, D>;
  using Moduli = Small<Pack, D * D>;
  using Point = ViscousPoint<D, Pack>;

 public:
  ViscousTerm(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern, const KelvinVoigt& law,
              int points)
      : law_(law),
        owned_dofs_(static_cast<std::size_t>(mesh.owned_nodes) * D),
        local_dofs_(static_cast<std::size_t>(mesh.nodes()) * D),
        batches_(block.nodes, pattern, node_scales(block)),
        table_(cell_points<Element>(block, points), block.tied),
        dissipated_(block, table_.size(), 1) {
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      Nodal x;
      batches_.gather(b, mesh.coordinates.data(), x);
      geometry_.push_back(Kernel::geometry(table_, x));
      owned_.emplace_back([&](auto lane) {
        const std::size_t cell = b * static_cast<std::size_t>(pack_width) + lane;
        return lane < batches_.lanes(b) && block.owned[cell] != 0 ? 1.0 : 0.0;
      });
    }
  }

  bool is_gradient(RateForm form) const override { return form == RateForm::End; }

  void place(const Pattern& pattern) override { batches_.place(pattern); }
  void initialize() override { dissipated_.clear(); }

  void begin_stage(const StageStart& start) override {
    form_ = start.rate_form;
    unknown_ = form_ == RateForm::End ? start.velocity->unknown : 1.0;
    inverse_dt_ = 1 / start.dt;
    end_weight_ = 1 - start.start_weight;
    from_ = start.known.front().u;
    if (form_ == RateForm::End) freeze_strains(*start.velocity, start.known, start.dt);
    kept_.clear();
    if (start.start_weight == 0) return;
    kept_.assign(local_dofs_, 0.0);
    add_force_at(start.start_weight, from_, start.known.front().v, kept_.data());
  }

  void add_force(const double* u, double* f) const override {
    for (std::size_t i = 0; i < kept_.size(); ++i) f[i] += kept_[i];
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      const Ends ends(*this, b, u);
      Nodal force{};
      for (std::size_t q = 0; q < table_.size(); ++q) add_nodal(b, q, ends.point(q).stress(), end_weight_, force);
      batches_.scatter_force(b, force, f);
    }
  }

  void add_tangent(const double* u, double* values) const override {
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      const Ends ends(*this, b, u);
      CellTangent tangent{};
      for (std::size_t q = 0; q < table_.size(); ++q) {
        Moduli moduli{};
        ends.point(q).add_moduli(geometry_[b].points[q].weight * end_weight_, moduli);
        add_cell_tangent(true, b, q, moduli, tangent);
      }
      batches_.scatter_tangent(b, tangent, values);
    }
  }

  double potential(const double* u) const override {
    double sum = 0;
    if (!kept_.empty())
      for (std::size_t i = 0; i < owned_dofs_; ++i) sum += kept_[i] * (u[i] - from_[i]);
    Pack cells = 0.0;
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      const Ends ends(*this, b, u);
      for (std::size_t q = 0; q < table_.size(); ++q)
        cells += owned_[b] * geometry_[b].points[q].weight * end_weight_ * ends.point(q).energy();
    }
    return sum + total(cells);
  }

  void add_force_at(double factor, const double* u, const double* v, double* f) const override {
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      const Gradients displacement(*this, b, u), velocity(*this, b, v);
      Nodal force{};
      for (std::size_t q = 0; q < table_.size(); ++q)
        add_nodal(b, q, stress_at(displacement(q), velocity(q)), factor, force);
      batches_.scatter_force(b, force, f);
    }
  }

  void add_tangent_at(double by_velocity, double by_displacement, const double* u, const double* v,
                      double* values) const override {
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      const Gradients displacement(*this, b, u), velocity(*this, b, v);
      CellTangent tangent{};
      for (std::size_t q = 0; q < table_.size(); ++q) {
        const Matrix f = deformation_gradient(displacement(q)), g = velocity(q);
        const Matrix s = law_.stress(symmetric_product(f, g));
        const Pack& weight = geometry_[b].points[q].weight;
        Moduli moduli{};
        law_.add_moduli(f, f, s, Pack(by_displacement * weight), Pack(by_velocity * weight), moduli);
        law_.add_moduli(f, g, s, Pack(0.0), Pack(by_displacement * weight), moduli);
        add_cell_tangent(false, b, q, moduli, tangent);
      }
      batches_.scatter_tangent(b, tangent, values);
    }
  }

  void add_row_sums(const double* u, double* sums) const override {
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      const Gradients displacement(*this, b, u);
      CellTangent tangent{};
      for (std::size_t q = 0; q < table_.size(); ++q) {
        const Matrix f = deformation_gradient(displacement(q));
        Moduli moduli{};
        law_.add_moduli(f, f, Matrix{}, Pack(0.0), geometry_[b].points[q].weight, moduli);
        add_cell_tangent(true, b, q, moduli, tangent);
      }
      Nodal rows{};
      for (std::size_t r = 0; r < N * D; ++r)
        for (std::size_t c = 0; c < N * D; ++c) rows[r / D][r % D] += std::experimental::abs(tangent[r][c]);
      batches_.scatter_force(b, rows, sums);
    }
  }

  double accept(const AcceptedStep& step) override {
    Pack sum = 0.0;
    for (std::size_t b = 0; b < batches_.size(); ++b)
      for_each_work(b, step, [&](std::size_t q, const Pack& work) {
        dissipated_(b, q) += work;
        sum += owned_[b] * geometry_[b].points[q].weight * work;
      });
    return total(sum);
  }

  bool has_state() const override { return true; }
  void transfer(Record& record) override { dissipated_.transfer(record); }

  void cell_dissipation(std::vector<double>& density) const override {
    density.resize(batches_.cells());
    for (std::size_t cell = 0; cell < density.size(); ++cell) {
      const std::size_t b = cell / static_cast<std::size_t>(pack_width),
                        lane = cell % static_cast<std::size_t>(pack_width);
      double energy = 0, volume = 0;
      for (std::size_t q = 0; q < table_.size(); ++q) {
        const double weight = double(geometry_[b].points[q].weight[lane]);
        energy += weight * double(dissipated_(b, q)[lane]);
        volume += weight;
      }
      density[cell] = energy / volume;
    }
  }

  void add_cell_stress(const double* u, const double* v, std::vector<SymmetricTensor>& stress) const override {
    for (std::size_t b = 0; b < batches_.size(); ++b) {
      const Gradients displacement(*this, b, u), velocity(*this, b, v);
      const auto mean = mean_over_points(
          geometry_[b].points, [](std::size_t q) { return q; },
          [&](std::size_t q) { return viscous_cauchy_stress(law_, displacement(q), velocity(q)); });
      for (std::size_t lane = 0; lane < batches_.lanes(b); ++lane)
        for (std::size_t i = 0; i < mean.size(); ++i)
          stress[b * static_cast<std::size_t>(pack_width) + lane][i] += mean[i][lane];
    }
  }

 private:
  /// Gradients of a local array at the points of a batch.
  class Gradients {
   public:
    Gradients(const ViscousTerm& term, std::size_t b, const double* local) : term_(term), b_(b) {
      term.batches_.gather(b, local, nodal_);
    }
    Matrix operator()(std::size_t q) const {
      return Kernel::gradient(nodal_, Kernel::shape_gradients(term_.geometry_[b_], q));
    }

   private:
    const ViscousTerm& term_;
    std::size_t b_;
    Nodal nodal_;
  };

  /// The displacements at the step's start and at the stage's end, in a batch.
  class Ends {
   public:
    Ends(const ViscousTerm& term, std::size_t b, const double* u) : term_(term), b_(b) {
      term.batches_.gather(b, term.from_, start_);
      term.batches_.gather(b, u, change_);
      for (std::size_t a = 0; a < N; ++a)
        for (std::size_t i = 0; i < D; ++i) change_[a][i] -= start_[a][i];
    }
    Point point(std::size_t q) const {
      const Nodal dn = Kernel::shape_gradients(term_.geometry_[b_], q);
      const bool row = term_.form_ == RateForm::End;
      return {term_.law_,
              term_.form_,
              term_.unknown_,
              term_.inverse_dt_,
              Kernel::gradient(start_, dn),
              Kernel::gradient(change_, dn),
              row ? term_.known_[b_ * term_.table_.size() + q] : Matrix{}};
    }

   private:
    const ViscousTerm& term_;
    std::size_t b_;
    Nodal start_, change_;
  };

  /// Evaluates the row on Green's strain of the known states: E' = sym(F^T grad v), E'' = sym(F^T grad a) +
  /// grad v^T grad v.
  void freeze_strains(const Row& row, const std::vector<KnownState>& states, double dt) {
    known_.assign(batches_.size() * table_.size(), Matrix{});
    for (std::size_t j = 0; j < row.known.size(); ++j) {
      const Row::Known& k = row.known[j];
      if (k.u == 0 && k.v == 0 && k.a == 0) continue;
      const KnownState& state = states[j];
      for (std::size_t b = 0; b < batches_.size(); ++b) {
        const Gradients start(*this, b, states[0].u), here(*this, b, state.u), velocity(*this, b, state.v);
        const Gradients acceleration(*this, b, k.a != 0 ? state.a : state.v);
        for (std::size_t q = 0; q < table_.size(); ++q) {
          const Matrix h = here(q), h0 = start(q), g = velocity(q), f = deformation_gradient(h);
          Matrix& known = known_[b * table_.size() + q];
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
      std::vector<Pack> work(table_.size(), Pack(0.0));
      for (std::size_t i = 0; i < step.states.size(); ++i) {
        const Gradients displacement(*this, b, step.states[i].u), velocity(*this, b, step.states[i].v);
        for (std::size_t q = 0; q < work.size(); ++q) {
          const Matrix rate = symmetric_product(deformation_gradient(displacement(q)), velocity(q));
          work[q] += step.dt * step.work->weights[i] * contraction(law_.stress(rate), rate);
        }
      }
      for (std::size_t q = 0; q < work.size(); ++q) visit(q, work[q]);
      return;
    }
    if (step.work->form == WorkSum::Form::EndMean) {
      const Gradients u0(*this, b, start.u), v0(*this, b, start.v), u1(*this, b, end.u), v1(*this, b, end.v);
      for (std::size_t q = 0; q < table_.size(); ++q) {
        const Matrix change = difference(u1(q), u0(q));
        visit(q,
              0.5 * contraction(stress_at(u0(q), v0(q)), change) + 0.5 * contraction(stress_at(u1(q), v1(q)), change));
      }
      return;
    }
    const Ends ends(*this, b, end.u);
    const Gradients u0(*this, b, start.u), v0(*this, b, start.v);
    for (std::size_t q = 0; q < table_.size(); ++q) {
      const Point point = ends.point(q);
      if (form_ != RateForm::End) {
        visit(q, point.dissipated());
        continue;
      }
      Pack work = end_weight_ * contraction(point.stress(), point.change);
      if (end_weight_ != 1) work += (1 - end_weight_) * contraction(stress_at(u0(q), v0(q)), point.change);
      visit(q, work);
    }
  }

  /// Returns P of a displacement gradient and that of its velocity.
  Matrix stress_at(const Matrix& h, const Matrix& g) const {
    const Matrix f = deformation_gradient(h), s = law_.stress(symmetric_product(f, g));
    Matrix p{};
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j)
        for (std::size_t k = 0; k < D; ++k) p[i][j] += f[i][k] * s[k][j];
    return p;
  }

  void add_nodal(std::size_t b, std::size_t q, const Matrix& p, double factor, Nodal& force) const {
    const Nodal dn = Kernel::shape_gradients(geometry_[b], q);
    const Pack weight = factor * geometry_[b].points[q].weight;
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = 0; j < D; ++j) force[a][i] += weight * p[i][j] * dn[a][j];
  }

  void add_cell_tangent(bool symmetric, std::size_t b, std::size_t q, const Moduli& moduli,
                        CellTangent& tangent) const {
    const Nodal dn = Kernel::shape_gradients(geometry_[b], q);
    if (symmetric)
      add_contraction<true>(dn, dn, moduli, tangent);
    else
      add_contraction<false>(dn, dn, moduli, tangent);
  }

  static Matrix difference(Matrix a, const Matrix& b) {
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) a[i][j] -= b[i][j];
    return a;
  }
  static void add(double factor, const Matrix& a, Matrix& sum) {
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = 0; j < D; ++j) sum[i][j] += factor * a[i][j];
  }

  KelvinVoigt law_;
  std::size_t owned_dofs_, local_dofs_;
  ElementBatches<N, D> batches_;
  typename Kernel::Table table_;
  std::vector<typename Kernel::template Geometry<Pack>> geometry_;
  std::vector<Pack> owned_;  ///< 1 for cells whose energy counts here
  PointData dissipated_;     ///< energy per reference volume [E0]

  RateForm form_ = RateForm::End;
  double unknown_ = 0, inverse_dt_ = 0, end_weight_ = 1;
  const double* from_ = nullptr;  ///< u at the step's start
  std::vector<Matrix> known_;     ///< the row's known part, by batch and point; End only
  std::vector<double> kept_;      ///< the force at the step's start, weighted; empty if its weight is 0
};

}  // namespace

std::unique_ptr<Viscosity> make_viscous_term(const LocalMesh& mesh, const LocalBlock& block, const Pattern& pattern,
                                             const KelvinVoigt& law, int points) {
  return with_element(block.type, [&](auto element) -> std::unique_ptr<Viscosity> {
    return std::make_unique<ViscousTerm<typename decltype(element)::type>>(mesh, block, pattern, law, points);
  });
}

}  // namespace ixos
