// A static solve of a cube's elasticity, all displacements of its surface given: from the tangent to a relative
// residual of 1e-8, set-up included. static_solve [DIVISIONS...] [xREPEATS] [CELLS...]: cells of block_cells.hpp, Hex8
// and Hex27 if none are named; MueLu with an assembled tangent, MueLu with products without it, and Two-Level, in
// turns. Least times of the repeats. The exact displacement is the gradient of a harmonic function, which needs no body
// force; the error is relative, in L2.
#include <fmt/format.h>

#include <Tpetra_Core.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "bench/block_cells.hpp"
#include "discretization/cell_quadrature.hpp"
#include "embedding/semi_discrete_tangent.hpp"
#include "fem/with_element.hpp"
#include "model/conditions.hpp"
#include "model/model.hpp"
#include "solve/choice/linear_solver.hpp"
#include "solve/choice/linear_solver_defaults.hpp"
#include "solve/choice/problem_size.hpp"
#include "support/conjugate_gradients.hpp"

namespace {

using ixos::Vector;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// The gradient of cosh(sqrt(2) k x) sin(k y) sin(k z).
std::array<double, 3> exact(const double* x) {
  const double k = 4, r = std::sqrt(2.0) * k, scale = 1 / std::cosh(r);
  const double c = scale * std::cosh(r * x[0]), s = scale * std::sinh(r * x[0]);
  return {r * s * std::sin(k * x[1]) * std::sin(k * x[2]), k * c * std::cos(k * x[1]) * std::sin(k * x[2]),
          k * c * std::sin(k * x[1]) * std::cos(k * x[2])};
}

/// Returns the relative error in L2 of a local array, by a rule of four points along each edge. All cells have one
/// size.
template <class Element>
double error_of(const ixos::Model& model, const std::vector<double>& u) {
  std::array<double, Element::nodes> shape;
  std::array<std::array<double, 3>, Element::nodes> gradient;
  const ixos::LocalBlock& block = model.mesh().blocks.front();
  const ixos::QuadratureRule<3> rule = ixos::cell_rule<Element>(block, 5 - ixos::CellTraits<Element>::order);
  std::array<double, 2> sums{};
  for (std::size_t p = 0; p < rule.points.size(); ++p) {
    Element::evaluate(rule.points[p], shape, gradient);
    const double weight = rule.weights[p];
    for (int cell = 0; cell < block.cells(); ++cell) {
      if (block.owned[static_cast<std::size_t>(cell)] == 0) continue;
      std::array<double, 3> x{}, found{};
      for (std::size_t a = 0; a < shape.size(); ++a) {
        const auto node = static_cast<std::size_t>(
            block.nodes[ixos::cell_entry(cell, static_cast<int>(shape.size()), static_cast<int>(a))]);
        for (std::size_t d = 0; d < 3; ++d) {
          x[d] += shape[a] * model.mesh().coordinates[3 * node + d];
          found[d] += shape[a] * u[3 * node + d];
        }
      }
      const std::array<double, 3> right = exact(x.data());
      for (std::size_t d = 0; d < 3; ++d) {
        sums[0] += weight * (found[d] - right[d]) * (found[d] - right[d]);
        sums[1] += weight * right[d] * right[d];
      }
    }
  }
  model.space().sum(sums.data(), 2);
  return std::sqrt(sums[0] / sums[1]);
}

struct Result {
  double setup = 1e300, total = 1e300, error = 0;
  int iterations = 0;
  std::string solver;
};

class Problem {
 public:
  Problem(const ixos::Comm& comm, int divisions, const ixos::test::BlockCells& cells)
      : model_(ixos::local_part(ixos::test::block_of(cells, divisions, 1), comm), comm,
               {{"body", ixos::neo_hooke(ixos::lame_constants(1, 0.3)), 1.0, 0, 0}}) {
    for (const int node : model_.mesh().node_sets[model_.mesh().node_set("surface")])
      for (int i = 0; i < 3; ++i) model_.constraints().add(3 * node + i, 0.0, nullptr);
    model_.close();
    model_.do_without_matrices();
  }

  long long dofs() const { return model_.space().global(); }

  Result solve(const std::string& preconditioner, bool assembled) {
    Teuchos::ParameterList list;
    list.set("Linear Solver Type", "Belos").set("Preconditioner Type", preconditioner);
    list.set("Operator", assembled ? "Assembled" : "Matrix-Free");
    list = ixos::completed_linear_solver(list, ixos::problem_size(model_));
    Result result;
    result.solver = ixos::linear_solver_in_words(list);
    const ixos::LinearSolverFactory factory(list, &model_);
    const std::vector<double> rest(static_cast<std::size_t>(model_.space().local()), 0.0);
    const double start = now();
    const auto w = Teuchos::rcp(new ixos::SemiDiscreteOperator(model_));
    w->linearize({0, 0, 1}, {rest.data()});
    Teuchos::RCP<const ixos::Operator> op = w;
    if (assembled) op = w->matrix();
    const auto space = ixos::vector_space(model_.space().owned_map());
    const auto m = factory.preconditioner();
    m->compute(ixos::const_linear_op(op, space));
    result.setup = now() - start;
    std::vector<double> u = given();
    Vector b(model_.space().owned_map()), x(model_.space().owned_map());
    {
      std::vector<double> from_surface(static_cast<std::size_t>(model_.space().owned()));
      w->multiply_constrained_columns(u.data(), from_surface.data());
      const auto view = b.getLocalViewHost(Tpetra::Access::OverwriteAll);
      for (std::size_t i = 0; i < from_surface.size(); ++i) view(i, 0) = -from_surface[i];
    }
    const double begin = now();
    result.iterations = ixos::test::conjugate_gradients(*op, *m->getUnspecifiedPrecOp(), space, b, 1e-8, x);
    result.total = result.setup + now() - begin;
    std::vector<double> inside(u.size());
    model_.space().import(x, inside.data());
    for (std::size_t i = 0; i < u.size(); ++i)
      if (!model_.constraints().holds(static_cast<int>(i))) u[i] = inside[i];
    result.error = ixos::with_solid_element(
        model_.mesh().blocks.front().type, [&](auto tag) { return error_of<typename decltype(tag)::type>(model_, u); });
    return result;
  }

 private:
  /// Returns the exact displacement of constrained degrees of freedom.
  std::vector<double> given() const {
    std::vector<double> u(static_cast<std::size_t>(model_.space().local()), 0.0);
    for (const int dof : model_.constraints().dofs())
      u[static_cast<std::size_t>(dof)] =
          exact(&model_.mesh().coordinates[static_cast<std::size_t>(dof / 3 * 3)])[static_cast<std::size_t>(dof % 3)];
    return u;
  }

  ixos::Model model_;
};

struct Way {
  const char* name;
  const char* preconditioner;
  bool assembled;
};

void measure(const ixos::Comm& comm, int divisions, int repeats, const std::vector<ixos::test::BlockCells>& all) {
  const std::array<Way, 3> ways{
      {{"MueLu, assembled", "MueLu", true}, {"MueLu, matrix-free", "MueLu", false}, {"Two-Level", "Two-Level", false}}};
  for (const ixos::test::BlockCells& cells : all) {
    Problem problem(comm, divisions, cells);
    std::array<Result, ways.size()> best;
    for (int repeat = 0; repeat < repeats; ++repeat)
      for (std::size_t i = 0; i < ways.size(); ++i) {
        const Result result = problem.solve(ways[i].preconditioner, ways[i].assembled);
        const double setup = std::min(best[i].setup, result.setup), total = std::min(best[i].total, result.total);
        best[i] = result;
        best[i].setup = setup;
        best[i].total = total;
      }
    if (comm->getRank() != 0) continue;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const Result& r = best[i];
      fmt::print("| {} | {}^3 | {} | {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.2f} | {:.2e} |\n", cells.name,
                 divisions / cells.order, problem.dofs(), ways[i].name, r.iterations, r.setup, r.total - r.setup,
                 r.total, best[0].total / r.total, r.error);
    }
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard guard(&argc, &argv);
  const ixos::Comm comm = Tpetra::getDefaultComm();
  std::vector<int> divisions;
  std::vector<ixos::test::BlockCells> cells;
  int repeats = 3;
  for (int i = 1; i < argc; ++i)
    if (argv[i][0] == 'x')
      repeats = std::atoi(argv[i] + 1);
    else if (std::isdigit(static_cast<unsigned char>(argv[i][0])) != 0)
      divisions.push_back(std::atoi(argv[i]));
    else
      cells.push_back(ixos::test::block_cells_named(argv[i]));
  if (divisions.empty()) divisions = {48};
  if (cells.empty()) cells = {ixos::test::block_cells_named("Hex8"), ixos::test::block_cells_named("Hex27")};
  if (comm->getRank() == 0)
    fmt::print(
        "| cells | | degrees of freedom | preconditioner | CG | set-up, s | CG, s | total, s | faster | error |\n"
        "|---|---|---|---|---|---|---|---|---|---|\n");
  for (const int n : divisions) measure(comm, n, repeats, cells);
  return 0;
}
