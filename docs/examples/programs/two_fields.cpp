// A ball meets a wall that stands on a spring: a monolithic system of two blocks, the ball's displacements x relative
// to the wall, which are Ixos' unknowns, and the wall's displacement q, which is the program's own. With e the unit
// translation along y, M the ball's mass, m and k the wall's mass and spring,
//
//   M (x'' + e q'') + f_el(x) + f_c(x) = 0,    e.M (x'' + e q'') + m q'' + k q = 0,
//
// the equations of Lagrange for the kinetic energy 1/2 (x' + e q').M (x' + e q') + 1/2 m q'^2 and the potential energy
// Pi(x) + 1/2 k q^2. The program solves both with Newmark's method; each Newton step takes GMRES with a preconditioner
// by blocks, of which the ball's is Ixos' own. The ball must be free: no conditions, no damping by mass.
//
//   two_fields SCENE.xml
//
// Exit status 0 if
// - on a spring of 1e12 the ball moves as before Ixos' fixed wall ("Newmark" table), to 1e-10 over 100 steps;
// - on a soft spring the wall obeys its own balance m q'' + k q + F = 0, F the force on the ball from Ixos' response
//   "contact_force_y", which the coupled equations do not use, to 1e-8 of the largest F;
// - the total momentum changes by the spring's impulse, to 1e-10 of the ball's largest momentum;
// - the total energy stays within 3 % of the largest kinetic energy, and half the step makes the error at least 3 times
//   smaller;
// - the wall moves so far that the ball's motion is another one.
#include <Thyra_BelosLinearOpWithSolveFactory.hpp>
#include <Thyra_DefaultProductVector.hpp>
#include <Thyra_DefaultProductVectorSpace.hpp>
#include <Thyra_DefaultScaledAdjointLinearOp.hpp>
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

#include "block_operators.hpp"
#include "newmark_loop.hpp"

namespace {

using Base = Thyra::ModelEvaluatorBase;
using ThyraVector = Teuchos::RCP<Thyra::VectorBase<double>>;
using ConstVector = Teuchos::RCP<const Thyra::VectorBase<double>>;
using Factory = Teuchos::RCP<const Thyra::LinearOpWithSolveFactoryBase<double>>;

struct Wall {
  double mass, spring;
};

/// Both fields as one Thyra model evaluator, whose vectors are pairs (x, q).
class BallOnSpring final : public Thyra::StateFuncModelEvaluatorBase<double> {
 public:
  BallOnSpring(const ixos::SemiDiscreteEvaluator& ball, const Wall& wall)
      : ball_(ball), wall_(wall), e_(Thyra::createMembers(ball.get_x_space(), 1)), momentum_(e_->clone_mv()) {
    const auto unit = ixos::Extract::getTpetraMultiVector(e_)->getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < unit.extent(0); ++i) unit(i, 0) = i % 2 == 1 ? 1.0 : 0.0;
    Thyra::apply<double>(*ball.mass(), Thyra::NOTRANS, *e_, momentum_.ptr());
    ball_mass_ = Thyra::dot(*e_->col(0), *momentum_->col(0));
    space_ = Thyra::productVectorSpace<double>(Teuchos::tuple<Space>(ball.get_x_space(), e_->domain()));
    Teuchos::ParameterList list;
    list.set("Solver Type", "Block GMRES");
    list.sublist("Solver Types").sublist("Block GMRES").set("Maximum Iterations", 100).set("Num Blocks", 100);
    const auto belos = Teuchos::rcp(new Thyra::BelosLinearOpWithSolveFactory<double>);
    belos->setParameterList(Teuchos::rcp(new Teuchos::ParameterList(list)));
    belos->setVerbLevel(Teuchos::VERB_NONE);
    solver_ = belos;
    Base::InArgsSetup<double> in(ball.createInArgs());
    in_ = in;
    Base::OutArgsSetup<double> out;
    for (const auto argument : {Base::OUT_ARG_f, Base::OUT_ARG_W_op, Base::OUT_ARG_W_prec}) out.setSupports(argument);
    out_ = out;
  }

  Space get_x_space() const override { return space_; }
  Space get_f_space() const override { return space_; }
  Base::InArgs<double> createInArgs() const override { return in_; }
  Factory get_W_factory() const override { return solver_; }
  LinearOp create_W_op() const override {
    const LinearOp op = blocks(space_);
    const Columns coupling = momentum_->clone_mv();
    as_blocks(op).setNonconstBlock(0, 0, ball_.create_W_op());
    as_blocks(op).setNonconstBlock(0, 1, coupling);
    as_blocks(op).setNonconstBlock(1, 0, Thyra::nonconstAdjoint<double>(coupling));
    as_blocks(op).setNonconstBlock(1, 1, Thyra::createMembers(e_->domain(), 1));
    as_blocks(op).endBlockFill();
    return op;
  }
  Preconditioner create_W_prec() const override {
    return Teuchos::rcp(new BlockPreconditioner(ball_.create_W_prec(), space_, e_->domain()));
  }

  /// The ball's InArgs: its inertia is that of its absolute motion.
  Base::InArgs<double> of_ball(const Base::InArgs<double>& in) const {
    auto ball = ball_.createInArgs();
    ball.set_x(block(in.get_x(), 0));
    ball.set_x_dot(absolute(in.get_x_dot()));
    ball.set_x_dot_dot(absolute(in.get_x_dot_dot()));
    ball.set_t(in.get_t());
    ball.set_alpha(in.get_alpha());
    ball.set_beta(in.get_beta());
    ball.set_W_x_dot_dot_coeff(in.get_W_x_dot_dot_coeff());
    return ball;
  }
  static ConstVector block(const ConstVector& pair, int number) {
    return Teuchos::rcp_dynamic_cast<const Thyra::ProductVectorBase<double>>(pair, true)->getVectorBlock(number);
  }
  static double of_wall(const ConstVector& pair) { return Thyra::get_ele(*block(pair, 1), 0); }

 private:
  Base::OutArgs<double> createOutArgsImpl() const override { return out_; }

  ConstVector absolute(const ConstVector& pair) const {
    const auto sum = block(pair, 0)->clone_v();
    Thyra::Vp_StV(sum.ptr(), of_wall(pair), *e_->col(0));
    return sum;
  }

  void evalModelImpl(const Base::InArgs<double>& in, const Base::OutArgs<double>& out) const override {
    const auto ball_in = of_ball(in);
    auto ball_out = ball_.createOutArgs();
    const double inertia = in.get_W_x_dot_dot_coeff();
    if (const ThyraVector f = out.get_f(); nonnull(f)) {
      const auto pair = Teuchos::rcp_dynamic_cast<Thyra::ProductVectorBase<double>>(f, true);
      ball_out.set_f(pair->getNonconstVectorBlock(0));
      const double force = Thyra::dot(*momentum_->col(0), *ball_in.get_x_dot_dot()) +
                           wall_.mass * of_wall(in.get_x_dot_dot()) + wall_.spring * of_wall(in.get_x());
      Thyra::assign(pair->getNonconstVectorBlock(1).ptr(), force);
    }
    if (const LinearOp w = out.get_W_op(); nonnull(w)) {
      ball_out.set_W_op(as_blocks(w).getNonconstBlock(0, 0));
      const auto columns = [&](int i, int j) {
        return Teuchos::rcp_dynamic_cast<Thyra::MultiVectorBase<double>>(as_blocks(w).getNonconstBlock(i, j), true);
      };
      Thyra::assign(columns(0, 1).ptr(), 0.0);  // the block (1, 0) is its transpose
      Thyra::update(inertia, *momentum_, columns(0, 1).ptr());
      Thyra::assign(columns(1, 1).ptr(), inertia * (wall_.mass + ball_mass_) + in.get_beta() * wall_.spring);
    }
    const auto prec = Teuchos::rcp_dynamic_cast<BlockPreconditioner>(out.get_W_prec());
    if (nonnull(prec)) ball_out.set_W_prec(prec->ball());
    ball_.evalModel(ball_in, ball_out);
    // W e is nearly `inertia` M e: the Schur complement loses the ball's mass.
    if (nonnull(prec)) prec->set(inertia * wall_.mass + in.get_beta() * wall_.spring);
  }

  const ixos::SemiDiscreteEvaluator& ball_;
  Wall wall_;
  Columns e_, momentum_;  ///< e and M e, one column each
  double ball_mass_ = 0;
  Space space_;
  Factory solver_;
  Base::InArgs<double> in_;
  Base::OutArgs<double> out_;
};

/// The ball starts with the simulation's velocity, the wall at rest.
NewmarkLoop start(const BallOnSpring& model, const ixos::Simulation& simulation) {
  const ThyraVector v = Thyra::createMember(model.get_x_space());
  Thyra::assign(v.ptr(), 0.0);
  const auto ball = Teuchos::rcp_dynamic_cast<Thyra::ProductVectorBase<double>>(v, true)->getNonconstVectorBlock(0);
  const auto view = ixos::Extract::getTpetraVector(ball)->getLocalViewHost(Tpetra::Access::OverwriteAll);
  std::copy_n(simulation.integrator().state().v.data(), view.extent(0), view.data());
  return {model, v};
}

/// The largest difference of the ball's displacements from those of the simulation.
double distance(const NewmarkLoop& loop, const ixos::Simulation& simulation) {
  const auto x = ixos::Extract::getConstTpetraVector(BallOnSpring::block(loop.u, 0));
  const auto view = x->getLocalViewHost(Tpetra::Access::ReadOnly);
  double largest = 0;
  for (std::size_t i = 0; i < view.extent(0); ++i)
    largest = std::max(largest, std::abs(view(i, 0) - simulation.integrator().state().u[i]));
  return simulation.model().space().maximum(largest);
}

/// The largest errors over a motion, absolute, and the scales to compare them with.
struct Errors {
  double balance = 0, momentum = 0, energy = 0;
  double force = 0, ball_momentum = 0, kinetic_energy = 0, wall_motion = 0;
};

Errors follow(const ixos::SemiDiscreteEvaluator& ball, const BallOnSpring& model, const Wall& wall, NewmarkLoop& loop,
              double dt, int steps) {
  Errors errors;
  double first_energy = 0, momentum = 0, impulse = 0, spring_force = 0;
  for (int n = 0; n <= steps; ++n) {
    if (n > 0) loop.step(dt);
    auto g = ball.createOutArgs();
    for (int j = 0; j < 3; ++j) g.set_g(j, Thyra::createMember(ball.get_g_space(j)));
    ball.evalModel(model.of_ball(loop.state()), g);
    const double q = BallOnSpring::of_wall(loop.u), v = BallOnSpring::of_wall(loop.v),
                 a = BallOnSpring::of_wall(loop.a);
    const double kinetic = Thyra::get_ele(*g.get_g(0), 0) + 0.5 * wall.mass * v * v;
    const double energy =
        kinetic + Thyra::get_ele(*g.get_g(0), 1) + Thyra::get_ele(*g.get_g(0), 2) + 0.5 * wall.spring * q * q;
    const double ball_momentum = Thyra::get_ele(*g.get_g(1), 1), force = Thyra::get_ele(*g.get_g(2), 1);
    const double before = momentum;
    momentum = ball_momentum + wall.mass * v;
    impulse = -0.5 * dt * (spring_force + wall.spring * q);
    spring_force = wall.spring * q;
    if (n == 0) first_energy = energy;
    if (n > 0) errors.momentum = std::max(errors.momentum, std::abs(momentum - before - impulse));
    errors.balance = std::max(errors.balance, std::abs(wall.mass * a + wall.spring * q + force));
    errors.energy = std::max(errors.energy, std::abs(energy - first_energy));
    errors.force = std::max(errors.force, std::abs(force));
    errors.ball_momentum = std::max(errors.ball_momentum, std::abs(ball_momentum));
    errors.kinetic_energy = std::max(errors.kinetic_energy, kinetic);
    errors.wall_motion = std::max(errors.wall_motion, std::abs(q));
  }
  return errors;
}

int couple(const ixos::Comm& comm, const char* path) {
  Teuchos::ParameterList scene = ixos::read_scene_file(path);
  for (const char* assignment : {"Time Integrator/Type=Newmark", "Mesh/Disk/Core Divisions=6", "Mesh/Disk/Rings=4",
                                 "Mesh/Disk/Center={0, 5.35}", "Initial Conditions/Velocity={0, -30}",
                                 "Linear Solver/Linear Solver Type=Belos", "Linear Solver/Preconditioner Type=Direct"})
    ixos::set_parameter(scene, ixos::scene_parameters(), assignment);
  ixos::Simulation simulation(scene, comm);
  const auto solvers = std::make_shared<ixos::LinearSolverFactory>(simulation.parameters().sublist("Linear Solver"),
                                                                   &simulation.model());
  const ixos::SemiDiscreteEvaluator ball(simulation.model(), solvers);

  const double dt = 0.0005;
  const Wall stiff{4e-5, 1e12}, soft{4e-5, 2};
  const BallOnSpring on_stiff(ball, stiff), on_soft(ball, soft);
  NewmarkLoop fixed = start(on_stiff, simulation), coarse = start(on_soft, simulation),
              fine = start(on_soft, simulation);
  const Errors errors = follow(ball, on_soft, soft, coarse, dt, 100),
               half = follow(ball, on_soft, soft, fine, dt / 2, 200);
  double differs = 0;
  for (int n = 0; n < 100; ++n) {
    fixed.step(dt);
    if (!simulation.integrator().step(dt).converged) return 1;
    differs = std::max(differs, distance(fixed, simulation));
  }
  const double other = distance(coarse, simulation);
  if (comm->getRank() == 0) {
    std::printf("stiff spring: differs from a fixed wall by %.3g\n", differs);
    std::printf("soft spring: the wall moved %.3g, the ball differs by %.3g\n", errors.wall_motion, other);
    std::printf("balance of the wall %.3g of %.3g, momentum %.3g of %.3g, energy %.3g and %.3g of %.3g\n",
                errors.balance, errors.force, errors.momentum, errors.ball_momentum, errors.energy, half.energy,
                errors.kinetic_energy);
  }
  const bool agrees = differs < 1e-10;
  const bool coupled = errors.wall_motion > 0.05 && other > 0.05;
  const bool conserves = errors.balance < 1e-8 * errors.force && errors.momentum < 1e-10 * errors.ball_momentum &&
                         errors.energy < 0.03 * errors.kinetic_energy && 3 * half.energy < errors.energy;
  return agrees && coupled && conserves ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard guard(&argc, &argv);
  if (argc != 2) {
    std::fprintf(stderr, "usage: two_fields SCENE.xml\n");
    return 2;
  }
  try {
    return couple(Tpetra::getDefaultComm(), argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "two_fields: %s\n", error.what());
    return 2;
  }
}
