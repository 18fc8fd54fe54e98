// Google Benchmark: element kernels and assembly, in cells (or sides) a second.
#include <benchmark/benchmark.h>

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Core.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <cmath>

#include "interaction/van_der_waals.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "model/model.hpp"
#include "term/surface_terms.hpp"

namespace {

ixos::Mesh block(int dimension, int divisions) {
  ixos::BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {10, 10, 10};
  shape.divisions = {divisions, divisions, divisions};
  return ixos::box(shape);
}

/// A block of neo-Hookean cells, its bottom 0.3 above a wall, and a wavy displacement.
struct Fixture {
  Fixture(int dimension, int divisions, ixos::Formulation formulation = ixos::Formulation::Standard)
      : comm(Tpetra::getDefaultComm()),
        mesh(block(dimension, divisions)),
        model(ixos::localize(mesh, ixos::partition_nodes(mesh, 1), 0, 1), comm,
              {{"body", ixos::neo_hooke(ixos::lame_constants(1, 0.3)), 1.0, 0, 0, 0, 0, formulation}}),
        u(static_cast<std::size_t>(model.space().local())),
        f(u.size()),
        matrix(model.pattern().create_matrix(model.space())) {
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = 0.01 * std::sin(0.37 * static_cast<double>(i));
    ixos::HalfSpace wall;
    wall.normal = {0, dimension == 2 ? 1.0 : 0.0, dimension == 2 ? 0.0 : 1.0};
    wall.point = {0, dimension == 2 ? -0.3 : 0.0, dimension == 2 ? 0.0 : -0.3};
    const ixos::LocalMesh& local = model.mesh();
    for (auto& term : ixos::make_surface_terms(local, local.side_sets[local.side_set("bottom")], model.pattern(),
                                               ixos::gap_law(ixos::VanDerWaals(2.5, 25)), ixos::flat_wall(wall), {}))
      model.add_interaction(std::move(term), "Wall");
  }
  ixos::Segment here() const { return {u.data(), nullptr, u.data()}; }

  ixos::Comm comm;
  ixos::Mesh mesh;
  ixos::Model model;
  std::vector<double> u, f;
  Teuchos::RCP<ixos::CrsMatrix> matrix;
};

ixos::Formulation formulation(const benchmark::State& state) { return static_cast<ixos::Formulation>(state.range(2)); }

int divisions(const benchmark::State& state) { return state.range(0) == 2 ? 100 : 22; }

void elastic_force(benchmark::State& state) {
  Fixture x(static_cast<int>(state.range(0)), divisions(state), formulation(state));
  const ixos::Rule rule = state.range(1) == 1 ? ixos::end_rule() : ixos::gauss_rule(static_cast<int>(state.range(1)));
  for (auto _ : state) benchmark::DoNotOptimize(x.model.force(ixos::Part::Elastic, x.here(), rule, x.f.data()));
  state.SetItemsProcessed(state.iterations() * x.mesh.cells());
}

void elastic_tangent(benchmark::State& state) {
  Fixture x(static_cast<int>(state.range(0)), divisions(state), formulation(state));
  const ixos::Rule rule = state.range(1) == 1 ? ixos::end_rule() : ixos::gauss_rule(static_cast<int>(state.range(1)));
  double* values = x.matrix->getLocalMatrixHost().values.data();
  for (auto _ : state) x.model.add_tangent(ixos::Part::Elastic, x.here(), rule, ixos::Tangent::Exact, values);
  state.SetItemsProcessed(state.iterations() * x.mesh.cells());
}

void interaction_force(benchmark::State& state) {
  Fixture x(static_cast<int>(state.range(0)), divisions(state));
  const ixos::Rule rule = ixos::gauss_rule(static_cast<int>(state.range(1)));
  for (auto _ : state) benchmark::DoNotOptimize(x.model.force(ixos::Part::Interaction, x.here(), rule, x.f.data()));
  state.SetItemsProcessed(state.iterations() *
                          static_cast<long>(x.model.mesh().side_sets[x.model.mesh().side_set("bottom")].size()));
}

BENCHMARK(elastic_force)->ArgNames({"D", "points", "formulation"})->ArgsProduct({{2, 3}, {1, 4}, {0, 1, 2}});
BENCHMARK(elastic_tangent)->ArgNames({"D", "points", "formulation"})->ArgsProduct({{2, 3}, {1, 4}, {0, 1, 2}});
BENCHMARK(interaction_force)->ArgNames({"D", "points"})->ArgsProduct({{2, 3}, {1, 8}});

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard guard(&argc, &argv);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
