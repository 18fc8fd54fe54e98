// Drives the ball's semi-discrete model with a Newmark loop (newmark_loop.hpp), through Thyra alone, and compares the
// motion with Ixos' own "Newmark" table: newmark SCENE.xml. Exit status 0 where they agree to 1e-10 over 100 steps.
#include <Thyra_VectorStdOps.hpp>
#include <Tpetra_Core.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <ixos/evaluator.hpp>
#include <ixos/simulation.hpp>
#include <memory>
#include <string>

#include "newmark_loop.hpp"

namespace {

int compare(const ixos::Comm& comm, const char* path) {
  Teuchos::ParameterList scene = ixos::read_scene_file(path);
  ixos::set_parameter(scene, ixos::scene_parameters(), "Time Integrator/Type=Newmark");
  // Near the wall, so that 100 steps meet its adhesion and its repulsion.
  ixos::set_parameter(scene, ixos::scene_parameters(), "Mesh/Disk/Center={0, 5.35}");
  ixos::Simulation simulation(scene, comm);

  const ixos::Model& model = simulation.model();
  Teuchos::ParameterList list;  // as a scene's "Linear Solver"
  list.set("Linear Solver Type", "Belos").set("Preconditioner Type", "MueLu");
  const auto solvers = std::make_shared<ixos::LinearSolverFactory>(
      ixos::completed_linear_solver(list, ixos::problem_size(model)), &model);
  const ixos::SemiDiscreteEvaluator body(model, solvers);
  const auto at_rest = Thyra::createMember(body.get_x_space());
  Thyra::assign(at_rest.ptr(), 0.0);
  NewmarkLoop loop(body, at_rest);

  double largest = 0, moved = 0;
  for (int step = 0; step < 100; ++step) {
    loop.step(0.001);
    if (!simulation.integrator().step(0.001).converged) return 1;
    const auto u = ixos::Extract::getConstTpetraVector(loop.u)->getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t i = 0; i < u.extent(0); ++i) {
      largest = std::max(largest, std::abs(u(i, 0) - simulation.integrator().state().u[i]));
      moved = std::max(moved, std::abs(u(i, 0)));
    }
  }
  largest = model.space().maximum(largest);
  moved = model.space().maximum(moved);
  const std::string klu2 = ixos::klu2_library();
  const bool sound = klu2.empty() || klu2.rfind("libixos", 0) == 0;  // empty: this Trilinos needs no repair
  if (comm->getRank() == 0)
    std::printf("moved %.3g, differs by %.3g; KLU2 from %s\n", moved, largest,
                klu2.empty() ? "Trilinos" : klu2.c_str());
  return largest < 1e-10 && moved > 0.01 && sound ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard guard(&argc, &argv);
  if (argc != 2) {
    std::fprintf(stderr, "usage: newmark SCENE.xml\n");
    return 2;
  }
  try {
    return compare(Tpetra::getDefaultComm(), argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "newmark: %s\n", error.what());
    return 2;
  }
}
