// W x of a distorted block's tangent with mass, as a matrix, matrix-free in double and in single precision, without
// mass, with stiffness damping and with four points in time, in turns, and the exchange of ghosts alone, which is in
// all of them: what overlap with work could hide at most; on as many ranks as it is started on: product_times
// [divisions] [rounds] [cells...]. Least and median time, degrees of freedom in the least time, and how many times
// faster than the matrix. `cells`: of block_cells.hpp, Hex8 and Hex27 if none are named.
#include <fmt/format.h>

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Core.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "balance/tangent_operator.hpp"
#include "bench/block_cells.hpp"
#include "mesh/partition.hpp"
#include "model/model.hpp"
#include "solve/iterative/single_products.hpp"

namespace {

/// The tangent at the end of a step to a small deformation; the model keeps what it was taken of.
class Product {
 public:
  Product(const ixos::Comm& comm, const ixos::Mesh& mesh, double damping, const ixos::Rule& rule = ixos::end_rule(),
          double mass = 4)
      : rule_(rule),
        model_(ixos::localize(mesh, ixos::partition_nodes(mesh, comm->getSize()), comm->getRank(), comm->getSize()),
               comm, {{"body", ixos::neo_hooke(ixos::lame_constants(1, 0.3)), 1.0, 0, damping}}),
        u_(static_cast<std::size_t>(model_.space().local())),
        start_(u_.size()),
        tangent_(model_, [this](double* values) {
          ixos::TermSums(model_).add_tangent(ixos::Part::Elastic, step(), rule_, ixos::Tangent::Exact, values);
          model_.mass()->add_to(4.0, values);
        }) {
    model_.do_without_matrices();
    for (std::size_t i = 0; i < u_.size(); ++i) {
      u_[i] = 0.01 * std::sin(model_.mesh().coordinates[i]);
      start_[i] = 0.9 * u_[i];
    }
    ixos::BalancePoint point;
    point.elastic = point.interaction = step();
    point.elastic_rule = point.interaction_rule = &rule_;
    tangent_.linearize(point, {mass, 2.0, 1.0}, ixos::Tangent::Exact, 1.0);
  }
  const ixos::TangentOperator& tangent() const { return tangent_; }
  const ixos::DofSpace& space() const { return model_.space(); }

 private:
  ixos::Segment step() const { return {start_.data(), nullptr, u_.data()}; }

  const ixos::Rule rule_;
  ixos::Model model_;
  std::vector<double> u_, start_;
  ixos::TangentOperator tangent_;
};

void measure(const ixos::Comm& comm, int divisions, int rounds, const ixos::test::BlockCells& cells) {
  const ixos::Mesh mesh = ixos::test::block_of(cells, divisions, 10, 1.5 / divisions);
  const Product plain(comm, mesh, 0), damped(comm, mesh, 0.01), mean(comm, mesh, 0, ixos::gauss_rule(4)),
      at_rest(comm, mesh, 0, ixos::end_rule(), 0);
  const Teuchos::RCP<ixos::CrsMatrix> matrix = plain.tangent().matrix();
  ixos::Vector in(matrix->getDomainMap()), out(matrix->getRangeMap());
  in.randomize();
  std::vector<double> local(static_cast<std::size_t>(plain.space().local()));
  struct Way {
    const char* name;
    std::function<void()> apply;
    std::vector<double> seconds;
  };
  const auto single = [&] {
    const ixos::SingleProducts precision(plain.tangent());
    plain.tangent().apply(in, out);
  };
  std::array<Way, 7> ways{{{"matrix", [&] { matrix->apply(in, out); }, {}},
                           {"matrix-free", [&] { plain.tangent().apply(in, out); }, {}},
                           {"matrix-free, without mass", [&] { at_rest.tangent().apply(in, out); }, {}},
                           {"matrix-free, single precision", single, {}},
                           {"matrix-free, stiffness damping", [&] { damped.tangent().apply(in, out); }, {}},
                           {"matrix-free, four points in time", [&] { mean.tangent().apply(in, out); }, {}},
                           {"ghosts alone", [&] { plain.space().import(in, local.data()); }, {}}}};
  for (int round = 0; round < rounds; ++round)
    for (Way& way : ways) {
      comm->barrier();
      const auto start = std::chrono::steady_clock::now();
      way.apply();
      comm->barrier();
      way.seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
  if (comm->getRank() != 0) return;
  fmt::print("\n{}, {} degrees of freedom, {} rank(s), {} rounds\n\n", cells.name, in.getGlobalLength(),
             comm->getSize(), rounds);
  fmt::print("| W x | least, ms | median, ms | million a second | faster, by the least | by the median |\n");
  fmt::print("|---|---|---|---|---|---|\n");
  for (Way& way : ways) {
    std::sort(way.seconds.begin(), way.seconds.end());
    const auto& first = ways[0].seconds;
    fmt::print("| {} | {:.2f} | {:.2f} | {:.1f} | {:.2f} | {:.2f} |\n", way.name, 1e3 * way.seconds.front(),
               1e3 * way.seconds[way.seconds.size() / 2],
               1e-6 * static_cast<double>(in.getGlobalLength()) / way.seconds.front(),
               first.front() / way.seconds.front(), first[first.size() / 2] / way.seconds[way.seconds.size() / 2]);
  }
}

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard guard(&argc, &argv);
  std::vector<std::string> names{"Hex8", "Hex27"};
  if (argc > 3) names.assign(argv + 3, argv + argc);
  for (const std::string& name : names)
    measure(Tpetra::getDefaultComm(), argc > 1 ? std::atoi(argv[1]) : 48, argc > 2 ? std::atoi(argv[2]) : 60,
            ixos::test::block_cells_named(name));
  return 0;
}
