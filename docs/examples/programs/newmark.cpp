// Drives the ball's semi-discrete model with a Newmark loop of its own, through Thyra alone, and compares the motion
// with Ixos' own "Newmark" table: newmark SCENE.xml. Exit status 0 where they agree to 1e-10 over 100 steps.
#include <Thyra_LinearOpWithSolveFactoryHelpers.hpp>
#include <Thyra_VectorStdOps.hpp>
#include <Tpetra_Core.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ixos/evaluator.hpp>
#include <ixos/simulation.hpp>

namespace {

using ThyraVector = Teuchos::RCP<Thyra::VectorBase<double>>;

/// Newmark's method with beta = 1/4, gamma = 1/2 on f(a, v, u, t) = 0, unknown u.
class NewmarkLoop {
 public:
  explicit NewmarkLoop(const Thyra::ModelEvaluator<double>& model)
      : model_(model), w_(model.create_W_op()), solver_(model.get_W_factory()->createOp()) {
    for (ThyraVector* x : {&u, &v, &a, &f_, &du_}) {
      *x = Thyra::createMember(model.get_x_space());
      Thyra::assign(x->ptr(), 0.0);
    }
    solve(1.0, 0.0, 0.0, a);  // M a + f(u_0) = 0 is linear in a
  }

  void step(double dt) {
    const ThyraVector u0 = u->clone_v(), v0 = v->clone_v(), a0 = a->clone_v();
    const auto kinematics = [&] {
      Thyra::linear_combination<double>(
          Teuchos::tuple(4 / (dt * dt), -4 / (dt * dt), -4 / dt, -1.0),
          Teuchos::tuple<Teuchos::Ptr<const Thyra::VectorBase<double>>>(u.ptr(), u0.ptr(), v0.ptr(), a0.ptr()), 0.0,
          a.ptr());
      Thyra::linear_combination<double>(
          Teuchos::tuple(2 / dt, -2 / dt, -1.0),
          Teuchos::tuple<Teuchos::Ptr<const Thyra::VectorBase<double>>>(u.ptr(), u0.ptr(), v0.ptr()), 0.0, v.ptr());
    };
    time += dt;
    kinematics();
    for (int iteration = 0; iteration < 12; ++iteration) {
      solve(4 / (dt * dt), 2 / dt, 1.0, u);
      kinematics();
    }
  }

  ThyraVector u, v, a;
  double time = 0;

 private:
  /// target -= W^-1 f with W = mass M + alpha C + beta K.
  void solve(double mass, double alpha, double beta, const ThyraVector& target) {
    auto in = model_.createInArgs();
    in.set_x(u);
    in.set_x_dot(v);
    in.set_x_dot_dot(a);
    in.set_t(time);
    in.set_W_x_dot_dot_coeff(mass);
    in.set_alpha(alpha);
    in.set_beta(beta);
    auto out = model_.createOutArgs();
    out.set_f(f_);
    out.set_W_op(w_);
    model_.evalModel(in, out);
    Thyra::initializeOp<double>(*model_.get_W_factory(), w_, solver_.ptr());
    Thyra::solve<double>(*solver_, Thyra::NOTRANS, *f_, du_.ptr());
    Thyra::Vp_StV(target.ptr(), -1.0, *du_);
  }

  const Thyra::ModelEvaluator<double>& model_;
  Teuchos::RCP<Thyra::LinearOpBase<double>> w_;
  Teuchos::RCP<Thyra::LinearOpWithSolveBase<double>> solver_;
  ThyraVector f_, du_;
};

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard guard(&argc, &argv);
  const ixos::Comm comm = Tpetra::getDefaultComm();
  Teuchos::ParameterList scene = ixos::read_scene_file(argv[argc - 1]);
  ixos::set_parameter(scene, ixos::scene_parameters(), "Time Integrator/Type=Newmark");
  // Near the wall, so that 100 steps meet its adhesion and its repulsion.
  ixos::set_parameter(scene, ixos::scene_parameters(), "Mesh/Disk/Center={0, 5.35}");
  ixos::Simulation simulation(scene, comm);

  Teuchos::ParameterList linear;
  linear.set("Linear Solver Type", "Direct").set("Preconditioner Type", "None");
  const ixos::LinearSolverFactory factory(linear);
  const ixos::SemiDiscreteEvaluator evaluator(simulation.model(), factory.strategy());
  NewmarkLoop loop(evaluator);

  double largest = 0, moved = 0;
  ixos::Vector difference(simulation.model().space().owned_map());
  for (int step = 0; step < 100; ++step) {
    loop.step(0.001);
    if (!simulation.integrator().step(0.001).converged) return 1;
    const auto u = ixos::Extract::getConstTpetraVector(loop.u)->getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t i = 0; i < u.extent(0); ++i) {
      largest = std::max(largest, std::abs(u(i, 0) - simulation.integrator().state().u[i]));
      moved = std::max(moved, std::abs(u(i, 0)));
    }
  }
  largest = simulation.model().space().maximum(largest);
  moved = simulation.model().space().maximum(moved);
  const bool repaired = ixos::klu2_library().rfind("libixos", 0) == 0;
  if (comm->getRank() == 0)
    std::printf("moved %.3g, differs by %.3g; KLU2 from %s\n", moved, largest, ixos::klu2_library().c_str());
  return largest < 1e-10 && moved > 0.01 && repaired ? 0 : 1;
}
