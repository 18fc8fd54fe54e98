// Measures, for each unknown of a block with hanging nodes, of two tied blocks, and of a block without ties, in turns:
// a residual, an assembled tangent, W x as a matrix and matrix-free, an iteration of CG with a preconditioner of MueLu,
// and a Newton iteration (residual, tangent, hierarchy, CG to 1e-3). tie_times [divisions in 3D] [rounds]. The ratio is
// that of the least times for each unknown to those of the block without ties.
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
#include <limits>
#include <memory>
#include <vector>

#include "balance/tangent_operator.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/joined_parts.hpp"
#include "mesh/mortar/tied_surfaces.hpp"
#include "mesh/partition.hpp"
#include "mesh/splitting/refine.hpp"
#include "model/model.hpp"
#include "solve/choice/linear_solver.hpp"
#include "solve/choice/linear_solver_defaults.hpp"
#include "solve/choice/problem_size.hpp"
#include "support/conjugate_gradients.hpp"

namespace {

constexpr std::array<const char*, 6> works{
    "residual",        "assembled tangent", "product, matrix", "product, matrix-free", "CG iteration, MueLu",
    "Newton iteration"};

ixos::BoxShape block(int dimension, int divisions) {
  ixos::BoxShape shape;
  shape.dimension = dimension;
  shape.divisions.fill(divisions);
  return shape;
}

ixos::Mesh with_hanging_nodes(int dimension, int divisions) {
  ixos::Mesh mesh = ixos::box(block(dimension, divisions * 2 / 3));
  ixos::RefinedRegion half;
  half.upper.assign(static_cast<std::size_t>(dimension), 2);
  half.upper[0] = 0.3;
  ixos::refine(mesh, {{"half", half}}, 1);
  return mesh;
}

ixos::Mesh of_two_parts(int dimension, int divisions) {
  ixos::BoxShape lower = block(dimension, divisions), upper = block(dimension, divisions - 3);
  const auto up = static_cast<std::size_t>(dimension - 1);
  lower.divisions[up] = divisions / 2;
  lower.lengths[up] = upper.lengths[up] = 0.5;
  upper.divisions[up] = divisions / 2;
  upper.lower[up] = 0.5;
  ixos::Mesh mesh = ixos::joined_parts({{"lower", ixos::box(lower)}, {"upper", ixos::box(upper)}});
  for (ixos::ElementBlock& own : mesh.blocks) own.name = "body";
  ixos::tie_surfaces(mesh, "upper_bottom", "lower_top", 0);
  return mesh;
}

/// A body at the end of a step to a small deformation.
class Body {
 public:
  Body(const ixos::Comm& comm, const ixos::Mesh& mesh)
      : model_(ixos::localize(mesh, ixos::partition_nodes(mesh, comm->getSize()), comm->getRank(), comm->getSize()),
               comm, {{"body", ixos::neo_hooke(ixos::lame_constants(1, 0.3)), 1.0}}),
        balance_(model_),
        u_(static_cast<std::size_t>(model_.space().local())),
        force_(u_.size()),
        tangent_(model_, [this](double* values) { assemble(values); }) {
    for (std::size_t i = 0; i < u_.size(); ++i) u_[i] = 0.01 * std::sin(3 * model_.mesh().coordinates[i]);
    model_.space().interpolate_tied(u_.data());
    tangent_.linearize(point(), weights_, ixos::Tangent::Exact, 1.0);
    matrix_ = tangent_.matrix();
    in_ = std::make_unique<ixos::Vector>(matrix_->getDomainMap());
    out_ = std::make_unique<ixos::Vector>(matrix_->getRangeMap());
    in_->randomize();
    balance_.evaluate(point());
    balance_.sum(point(), nullptr, force_.data());
    const auto b = in_->getLocalViewHost(Tpetra::Access::ReadWrite);
    for (std::size_t i = 0; i < b.extent(0); ++i) b(i, 0) = force_[i];
    Teuchos::ParameterList list;
    list.set("Linear Solver Type", "Belos").set("Preconditioner Type", "MueLu").set("Operator", "Assembled");
    const ixos::LinearSolverFactory factory(ixos::completed_linear_solver(list, ixos::problem_size(model_)), &model_);
    space_ = ixos::vector_space(model_.space().owned_map());
    preconditioner_ = factory.preconditioner();
    compute_preconditioner();
    least_.fill(std::numeric_limits<double>::infinity());
  }

  void work(std::size_t which) {
    const auto start = std::chrono::steady_clock::now();
    const bool all = which == 5;  // but for products of its own
    if (which == 0 || all) {
      balance_.evaluate(point());
      balance_.sum(point(), nullptr, force_.data());
    }
    if (which == 1 || all) {
      const auto values = matrix_->getLocalMatrixHost().values;
      std::fill_n(values.data(), values.extent(0), 0.0);
      assemble(values.data());
    }
    if (all) compute_preconditioner();
    if (which == 2) matrix_->apply(*in_, *out_);
    if (which == 3) tangent_.apply(*in_, *out_);
    if (which == 4 || all)
      iterations_ = ixos::test::conjugate_gradients(*matrix_, *preconditioner_->getUnspecifiedPrecOp(), space_, *in_,
                                                    1e-3, *out_);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    least_[which] = std::min(least_[which], which == 4 ? seconds / iterations_ : seconds);
  }

  double per_unknown(std::size_t which) const { return least_[which] / static_cast<double>(model_.space().global()); }
  long long unknowns() const { return model_.space().global(); }
  long long tied() const { return model_.mesh().global_tied; }
  int iterations() const { return iterations_; }  ///< of CG

 private:
  void compute_preconditioner() {
    preconditioner_->compute(ixos::const_linear_op(Teuchos::RCP<const ixos::Operator>(matrix_), space_));
  }
  ixos::BalancePoint point() const {
    const ixos::Segment here{nullptr, nullptr, u_.data()};
    ixos::BalancePoint at;
    at.elastic = at.interaction = here;
    at.elastic_rule = at.interaction_rule = &rule_;
    return at;
  }
  void assemble(double* values) { balance_.tangent(point(), weights_, ixos::Tangent::Exact, nullptr, values); }

  const ixos::Rule rule_ = ixos::end_rule();
  const ixos::TangentWeights weights_{4.0, 0.0, 1.0};
  ixos::Model model_;
  ixos::Balance balance_;
  std::vector<double> u_, force_;
  ixos::TangentOperator tangent_;
  Teuchos::RCP<ixos::CrsMatrix> matrix_;
  std::unique_ptr<ixos::Vector> in_, out_;
  ixos::VectorSpace space_;
  Teuchos::RCP<ixos::OperatorPreconditioner> preconditioner_;
  std::array<double, works.size()> least_;
  int iterations_ = 1;
};

void measure(const ixos::Comm& comm, int dimension, int divisions, int rounds) {
  Body plain(comm, ixos::box(block(dimension, divisions))), hanging(comm, with_hanging_nodes(dimension, divisions)),
      tied(comm, of_two_parts(dimension, divisions));
  const std::array<Body*, 3> bodies{&plain, &hanging, &tied};
  for (int round = 0; round < rounds; ++round)
    for (std::size_t which = 0; which < works.size(); ++which)
      for (Body* body : bodies) body->work(which);
  fmt::print("\n{}D: {} unknowns without ties; {} and {} nodes that hang; {} and {} tied nodes\n\n", dimension,
             plain.unknowns(), hanging.unknowns(), hanging.tied(), tied.unknowns(), tied.tied());
  fmt::print("CG iterations to 1e-3: {}, {} and {}\n\n", plain.iterations(), hanging.iterations(), tied.iterations());
  fmt::print(
      "| for each unknown | without ties, ns | hanging nodes, ratio | tied surfaces, ratio |\n|---|---|---|---|\n");
  for (std::size_t which = 0; which < works.size(); ++which)
    fmt::print("| {}D, {} | {:.1f} | {:.3f} | {:.3f} |\n", dimension, works[which], 1e9 * plain.per_unknown(which),
               hanging.per_unknown(which) / plain.per_unknown(which),
               tied.per_unknown(which) / plain.per_unknown(which));
}

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard guard(&argc, &argv);
  const int divisions = argc > 1 ? std::atoi(argv[1]) : 30, rounds = argc > 2 ? std::atoi(argv[2]) : 20;
  measure(Tpetra::getDefaultComm(), 2, 9 * divisions, rounds);
  measure(Tpetra::getDefaultComm(), 3, divisions, rounds);
  return 0;
}
