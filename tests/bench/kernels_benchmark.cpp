// Google Benchmark: element kernels and assembly, in cells (or sides) a second.
#include <benchmark/benchmark.h>

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Core.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "interaction/catalogue.hpp"
#include "interaction/van_der_waals.hpp"
#include "material/catalogue.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "model/model.hpp"
#include "model/term_sums.hpp"
#include "term/body/maxwell_term.hpp"
#include "term/wall/surface_terms.hpp"

namespace {

/// `divisions`: steps from node to node along each edge.
ixos::Mesh block(int dimension, int divisions, int order) {
  ixos::BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {10, 10, 10};
  shape.divisions.fill(divisions / order);
  ixos::Mesh mesh = ixos::box(shape);
  if (order == 2) ixos::raise_order(mesh);
  return mesh;
}

/// The file of heights for bodies of that dimension: a profile, or a field of 10 by 10 heights.
std::filesystem::path heights(int dimension) {
  return std::filesystem::temp_directory_path() / (dimension == 2 ? "ixos-profile.txt" : "ixos-heights.txt");
}

void write_heights(int dimension) {
  std::ofstream file(heights(dimension));
  for (int row = 0; row < (dimension == 2 ? 1 : 10); ++row)
    for (int column = 0; column < 10; ++column)
      file << 0.025 * (std::cos(0.2 * M_PI * row) + std::cos(0.2 * M_PI * column)) << (column < 9 ? ' ' : '\n');
}

/// Obstacles by number, their tops at the height -0.3 of the last coordinate.
std::shared_ptr<const ixos::Obstacle> obstacle(int kind, int dimension) {
  const auto d = static_cast<std::size_t>(dimension);
  const auto at = [&](double height) {
    std::vector<double> place(d, 0.0);
    place.back() = height;
    return place;
  };
  if (kind == 1) return ixos::make_obstacle("Sphere", d, {{"Radius", 1e3}, {"Center", at(-1e3 - 0.3)}});
  if (kind == 2)
    return ixos::make_obstacle("Sine Wall", d, {{"Amplitude", 0.05}, {"Period", 10.0}, {"Point", at(-0.35)}});
  if (kind == 3)
    return ixos::make_obstacle(
        "Height Field", d,
        {{"File", heights(dimension).c_str()}, {"Spacing", {1.0, 1.0}}, {"Periodic", true}, {"Point", at(-0.35)}});
  ixos::HalfSpace wall;
  wall.normal = {0, dimension == 2 ? 1.0 : 0.0, dimension == 2 ? 0.0 : 1.0};
  wall.point = {0, dimension == 2 ? -0.3 : 0.0, dimension == 2 ? 0.0 : -0.3};
  return ixos::flat_wall(wall);
}

/// A block of elastic cells, its bottom 0.3 above an obstacle, and a wavy displacement.
struct Fixture {
  Fixture(int dimension, int divisions, ixos::Formulation formulation = ixos::Formulation::Standard, int kind = 0,
          const std::shared_ptr<const ixos::ElasticLaw>& law = ixos::neo_hooke(ixos::lame_constants(1, 0.3)),
          const std::vector<ixos::MaxwellBranch>& branches = {}, int order = 1)
      : comm(Tpetra::getDefaultComm()),
        mesh(block(dimension, divisions, order)),
        model(ixos::localize(mesh, ixos::partition_nodes(mesh, 1), 0, 1), comm,
              {{"body", law, 1.0, 0, 0, 0, 0, formulation, branches}}),
        u(static_cast<std::size_t>(model.space().local())),
        before(u.size()),
        f(u.size()) {
    for (std::size_t i = 0; i < u.size(); ++i) {
      u[i] = 0.01 * std::sin(0.37 * static_cast<double>(i));
      before[i] = 0.9 * u[i];
    }
    const ixos::LocalMesh& local = model.mesh();
    for (auto& term :
         ixos::make_surface_terms(local, local.side_sets[local.side_set("bottom")], model.pattern(),
                                  ixos::gap_law(ixos::VanDerWaals(2.5, 25)), obstacle(kind, dimension), {}))
      model.add_interaction(std::move(term), "Wall");
    model.close();
    matrix = model.pattern().create_matrix(model.space());
  }
  ixos::Segment here() const { return {u.data(), nullptr, u.data()}; }
  /// A step that ends here; without its start if the rule has one point, its end.
  ixos::Segment step_of(const ixos::Rule& rule) const {
    return {rule.uses_start() ? before.data() : nullptr, nullptr, u.data()};
  }

  ixos::Comm comm;
  ixos::Mesh mesh;
  ixos::Model model;
  std::vector<double> u, before, f;
  Teuchos::RCP<ixos::CrsMatrix> matrix;
};

ixos::Formulation formulation(const benchmark::State& state) { return static_cast<ixos::Formulation>(state.range(2)); }

int divisions(const benchmark::State& state) { return state.range(0) == 2 ? 100 : 22; }

ixos::Rule time_points(const benchmark::State& state) {
  return state.range(1) == 1 ? ixos::end_rule() : ixos::gauss_rule(static_cast<int>(state.range(1)));
}

void elastic_force(benchmark::State& state) {
  Fixture x(static_cast<int>(state.range(0)), divisions(state), formulation(state));
  const ixos::Rule rule = time_points(state);
  const ixos::Segment step = x.step_of(rule);
  for (auto _ : state)
    benchmark::DoNotOptimize(ixos::TermSums(x.model).force(ixos::Part::Elastic, step, rule, x.f.data()));
  state.SetItemsProcessed(state.iterations() * x.mesh.cells());
}

void elastic_tangent(benchmark::State& state) {
  Fixture x(static_cast<int>(state.range(0)), divisions(state), formulation(state));
  const ixos::Rule rule = time_points(state);
  const ixos::Segment step = x.step_of(rule);
  double* values = x.matrix->getLocalMatrixHost().values.data();
  for (auto _ : state)
    ixos::TermSums(x.model).add_tangent(ixos::Part::Elastic, step, rule, ixos::Tangent::Exact, values);
  state.SetItemsProcessed(state.iterations() * x.mesh.cells());
}

/// Force and assembled tangent as an iteration of Newton's method needs them, see interaction_kept().
void elastic_kept(benchmark::State& state) {
  Fixture x(static_cast<int>(state.range(0)), divisions(state), formulation(state));
  const ixos::Rule rule = time_points(state);
  const ixos::Segment step = x.step_of(rule);
  double* values = x.matrix->getLocalMatrixHost().values.data();
  ixos::KeptForces kept = ixos::TermSums(x.model).create_kept();
  for (auto _ : state) {
    benchmark::DoNotOptimize(ixos::TermSums(x.model).force_and_keep(ixos::Part::Elastic, step, rule, kept, x.f.data()));
    ixos::TermSums(x.model).add_kept_tangent(ixos::Part::Elastic, step, rule, ixos::Tangent::Exact, kept, values);
  }
  state.SetItemsProcessed(state.iterations() * x.mesh.cells());
}

/// The elastic law of that number in the catalogue, with its defaults.
struct LawFixture : Fixture {
  explicit LawFixture(benchmark::State& state, int order = 1)
      : Fixture(static_cast<int>(state.range(0)), divisions(state), ixos::Formulation::Standard, 0,
                ixos::make_elastic_law(entry(state).name), {}, order) {
    state.SetLabel(entry(state).name);
  }
  static const ixos::ElasticEntry& entry(const benchmark::State& state) {
    return ixos::elastic_laws().entries().at(static_cast<std::size_t>(state.range(1)));
  }
};

void law_force(benchmark::State& state) {
  LawFixture x(state, static_cast<int>(state.range(2)));
  for (auto _ : state)
    benchmark::DoNotOptimize(
        ixos::TermSums(x.model).force(ixos::Part::Elastic, x.here(), ixos::end_rule(), x.f.data()));
  state.SetItemsProcessed(state.iterations() * x.mesh.cells());
}

void law_tangent(benchmark::State& state) {
  LawFixture x(state, static_cast<int>(state.range(2)));
  double* values = x.matrix->getLocalMatrixHost().values.data();
  for (auto _ : state)
    ixos::TermSums(x.model).add_tangent(ixos::Part::Elastic, x.here(), ixos::end_rule(), ixos::Tangent::Exact, values);
  state.SetItemsProcessed(state.iterations() * x.mesh.cells());
}

void count_degrees_of_freedom(benchmark::State& state, const Fixture& x) {
  state.counters["dofs"] =
      benchmark::Counter(static_cast<double>(x.u.size()), benchmark::Counter::kIsIterationInvariantRate);
}

/// The product of the tangent and a vector, without a matrix.
void law_product(benchmark::State& state) {
  LawFixture x(state, static_cast<int>(state.range(2)));
  std::unique_ptr<ixos::TangentAction> action;
  for (const ixos::NamedForceTerm& named : x.model.force_terms())
    if (named.term->part() == ixos::Part::Elastic) action = named.term->create_action();
  action->linearize(x.here(), ixos::end_rule(), ixos::Tangent::Exact, {0, 0});
  for (auto _ : state) action->add_product(x.u.data(), x.f.data());
  state.SetItemsProcessed(state.iterations() * x.mesh.cells());
  count_degrees_of_freedom(state, x);
}

/// Maxwell branches without the elastic law beside them.
struct BranchFixture : Fixture {
  explicit BranchFixture(benchmark::State& state)
      : Fixture(static_cast<int>(state.range(0)), divisions(state), ixos::Formulation::Standard, 0,
                ixos::neo_hooke(ixos::lame_constants(1, 0.3)),
                std::vector<ixos::MaxwellBranch>(static_cast<std::size_t>(state.range(2)), {0.3, 0.1})),
        rule(time_points(state)),
        histories(model.create_histories()),
        memories(model.create_memories()) {
    for (const ixos::NamedForceTerm& named : model.force_terms())
      if (dynamic_cast<const ixos::Viscoelasticity*>(named.term) != nullptr) term = named.term;
    ixos::StageStart start;
    start.length = start.mean_time = 0.05;
    start.histories = &histories;
    model.begin_stage(start, memories);
  }
  ixos::Segment step() const { return {u.data(), nullptr, u.data(), 0, 0.05, &histories, &memories}; }

  ixos::Rule rule;
  ixos::TermHistories histories;
  ixos::StepMemories memories;
  const ixos::ForceTerm* term = nullptr;
};

void maxwell_force(benchmark::State& state) {
  BranchFixture x(state);
  for (auto _ : state) benchmark::DoNotOptimize(x.term->add_force(x.step(), x.rule, x.f.data()));
  state.SetItemsProcessed(state.iterations() * x.mesh.cells());
}

void maxwell_tangent(benchmark::State& state) {
  BranchFixture x(state);
  double* values = x.matrix->getLocalMatrixHost().values.data();
  for (auto _ : state) x.term->add_tangent(x.step(), x.rule, ixos::Tangent::Exact, values);
  state.SetItemsProcessed(state.iterations() * x.mesh.cells());
}

/// The product of an assembled tangent and a vector, to compare with.
void matrix_product(benchmark::State& state) {
  Fixture x(static_cast<int>(state.range(0)), divisions(state), ixos::Formulation::Standard, 0,
            ixos::neo_hooke(ixos::lame_constants(1, 0.3)), {}, static_cast<int>(state.range(1)));
  double* values = x.matrix->getLocalMatrixHost().values.data();
  ixos::TermSums(x.model).add_tangent(ixos::Part::Elastic, x.here(), ixos::end_rule(), ixos::Tangent::Exact, values);
  ixos::Vector in(x.matrix->getDomainMap()), out(x.matrix->getRangeMap());
  in.randomize();
  for (auto _ : state) x.matrix->apply(in, out);
  state.SetItemsProcessed(state.iterations() * x.mesh.cells());
  count_degrees_of_freedom(state, x);
}

/// Force and tangent, each by itself.
void interaction(benchmark::State& state) {
  Fixture x(static_cast<int>(state.range(0)), divisions(state), ixos::Formulation::Standard,
            static_cast<int>(state.range(2)));
  const ixos::Rule rule = ixos::gauss_rule(static_cast<int>(state.range(1)));
  double* values = x.matrix->getLocalMatrixHost().values.data();
  for (auto _ : state) {
    benchmark::DoNotOptimize(ixos::TermSums(x.model).force(ixos::Part::Interaction, x.here(), rule, x.f.data()));
    ixos::TermSums(x.model).add_tangent(ixos::Part::Interaction, x.here(), rule, ixos::Tangent::Exact, values);
  }
  state.SetItemsProcessed(state.iterations() *
                          static_cast<long>(x.model.mesh().side_sets[x.model.mesh().side_set("bottom")].size()));
}

/// Force and assembled tangent as an iteration of Newton's method needs them: the tangent follows from what the force
/// kept.
void interaction_kept(benchmark::State& state) {
  Fixture x(static_cast<int>(state.range(0)), divisions(state), ixos::Formulation::Standard,
            static_cast<int>(state.range(2)));
  const ixos::Rule rule = ixos::gauss_rule(static_cast<int>(state.range(1)));
  double* values = x.matrix->getLocalMatrixHost().values.data();
  ixos::KeptForces kept = ixos::TermSums(x.model).create_kept();
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        ixos::TermSums(x.model).force_and_keep(ixos::Part::Interaction, x.here(), rule, kept, x.f.data()));
    ixos::TermSums(x.model).add_kept_tangent(ixos::Part::Interaction, x.here(), rule, ixos::Tangent::Exact, kept,
                                             values);
  }
  state.SetItemsProcessed(state.iterations() *
                          static_cast<long>(x.model.mesh().side_sets[x.model.mesh().side_set("bottom")].size()));
}

BENCHMARK(elastic_force)->ArgNames({"D", "points", "formulation"})->ArgsProduct({{2, 3}, {1, 4}, {0, 1, 2}});
BENCHMARK(elastic_tangent)->ArgNames({"D", "points", "formulation"})->ArgsProduct({{2, 3}, {1, 4}, {0, 1, 2}});
BENCHMARK(elastic_kept)->ArgNames({"D", "points", "formulation"})->ArgsProduct({{2, 3}, {1, 4}, {0, 1, 2}});
BENCHMARK(law_force)->ArgNames({"D", "law", "order"})->ArgsProduct({{2, 3}, {0, 1, 2, 3, 4, 5, 6}, {1, 2}});
BENCHMARK(law_tangent)->ArgNames({"D", "law", "order"})->ArgsProduct({{2, 3}, {0, 1, 2, 3, 4, 5, 6}, {1, 2}});
BENCHMARK(law_product)->ArgNames({"D", "law", "order"})->ArgsProduct({{2, 3}, {0, 1, 2, 3, 4, 5, 6}, {1, 2}});
BENCHMARK(maxwell_force)->ArgNames({"D", "points", "branches"})->ArgsProduct({{2, 3}, {1, 4}, {1, 2, 4}});
BENCHMARK(maxwell_tangent)->ArgNames({"D", "points", "branches"})->ArgsProduct({{2, 3}, {1, 4}, {1, 2, 4}});
BENCHMARK(matrix_product)->ArgNames({"D", "order"})->ArgsProduct({{2, 3}, {1, 2}});
BENCHMARK(interaction)->ArgNames({"D", "points", "obstacle"})->ArgsProduct({{2, 3}, {1, 8}, {0, 1, 2, 3}});
BENCHMARK(interaction_kept)->ArgNames({"D", "points", "obstacle"})->ArgsProduct({{2, 3}, {1, 8}, {0, 1, 2, 3}});

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard guard(&argc, &argv);
  for (int dimension : {2, 3}) write_heights(dimension);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  for (int dimension : {2, 3}) std::filesystem::remove(heights(dimension));
  return 0;
}
