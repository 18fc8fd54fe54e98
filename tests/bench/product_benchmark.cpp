// Google Benchmark: W x of a distorted block's tangent with mass, as a matrix, matrix-free, and matrix-free with
// stiffness damping; on as many ranks as it is started on. Degrees of freedom a second of all ranks together.
#include <benchmark/benchmark.h>

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Core.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <chrono>
#include <cmath>

#include "mesh/generators.hpp"
#include "model/model.hpp"
#include "solve/tangent_operator.hpp"

namespace {

ixos::Mesh distorted_block(int divisions) {
  ixos::BoxShape shape;
  shape.dimension = 3;
  shape.lengths = {10, 10, 10};
  shape.divisions = {divisions, divisions, divisions};
  ixos::Mesh mesh = ixos::box(shape);
  for (std::size_t i = 0; i < mesh.coordinates.size(); ++i)
    mesh.coordinates[i] += 1.5 / divisions * std::sin(1.7 * static_cast<double>(i));
  return mesh;
}

enum Kind { Assembled, MatrixFree, MatrixFreeWithDamping };

void product(benchmark::State& state) {
  const auto kind = static_cast<Kind>(state.range(1));
  const ixos::Comm comm = Tpetra::getDefaultComm();
  const ixos::Mesh mesh = distorted_block(static_cast<int>(state.range(0)));
  const double damping = kind == MatrixFreeWithDamping ? 0.01 : 0;
  ixos::Model model(
      ixos::localize(mesh, ixos::partition_nodes(mesh, comm->getSize()), comm->getRank(), comm->getSize()), comm,
      {{"body", ixos::ElasticLaw::NeoHooke, ixos::lame_constants(1, 0.3), 1.0, 0, damping}});
  model.do_without_matrices();
  std::vector<double> u(static_cast<std::size_t>(model.space().local()));
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = 0.01 * std::sin(model.mesh().coordinates[i]);
  const ixos::Rule rule = ixos::end_rule();
  const ixos::Segment here{nullptr, nullptr, u.data()};
  ixos::TangentOperator tangent(model, [&](double* values) {
    model.add_elastic_tangent(here, rule, values);
    model.mass()->add_to(4.0, values);
  });
  ixos::TangentPoint point;
  point.elastic = point.interaction = here;
  point.elastic_rule = point.interaction_rule = &rule;
  point.mass = 4.0;
  point.damping = 2.0;
  tangent.linearize(point);
  const Teuchos::RCP<ixos::CrsMatrix> matrix = kind == Assembled ? tangent.matrix() : Teuchos::null;
  ixos::Vector in(model.space().owned_map()), out(model.space().owned_map());
  in.randomize();
  for (auto _ : state) {
    comm->barrier();
    const auto start = std::chrono::steady_clock::now();
    if (kind == Assembled)
      matrix->apply(in, out);
    else
      tangent.apply(in, out);
    comm->barrier();
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<long>(in.getGlobalLength()));
}

// A given number of iterations: ranks must not differ in it.
BENCHMARK(product)
    ->ArgNames({"divisions", "kind"})
    ->ArgsProduct({{48}, {Assembled, MatrixFree, MatrixFreeWithDamping}})
    ->Iterations(60)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard guard(&argc, &argv);
  benchmark::Initialize(&argc, argv);
  benchmark::ConsoleReporter report;
  struct Nothing : benchmark::BenchmarkReporter {
    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>&) override {}
  } nothing;
  const bool first = Tpetra::getDefaultComm()->getRank() == 0;
  if (first)
    benchmark::RunSpecifiedBenchmarks(&report);
  else
    benchmark::RunSpecifiedBenchmarks(&nothing);
  return 0;
}
