// Couples a block, which Ixos moves, to a stage, which a solver of this program moves: a partitioned coupling. The
// block hangs above an adhesive wall on the stage, a mass on a spring. The block's top follows the stage; the stage
// feels the block's reaction. In each coupling step the two iterate to a common motion (fixed point with Aitken's
// relaxation). Ixos takes two steps in it, the stage's solver eight; both go back to the beginning of the coupling step
// before each iteration.
//
// Checks:
// - the total energy of body and stage, and what the viscosity dissipates, stays constant: to 3e-3 of the energy of the
//   stage's spring, and almost four times better with half the step, as both second-order solvers promise;
// - a plain simulation with the stage's motion as its history, which takes each step once, moves the body alike: to
//   1e-9 over 80 steps;
// - a coupling step that is repeated has the same bits;
// - so has a run that stops in the middle and resumes from a checkpoint, with the stage's state beside Ixos'.
// Usage: partitioned [FILE], where FILE is the checkpoint. Exit status 0 if all of this holds.
#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_XMLParameterListHelpers.hpp>
#include <Tpetra_Core.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ixos/checkpoint.hpp>
#include <ixos/integrator.hpp>
#include <ixos/model.hpp>
#include <ixos/simulation.hpp>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "stage.hpp"

namespace {

const char* const scene = R"xml(
<ParameterList name="Block on a stage">
  <ParameterList name="Mesh">
    <Parameter name="Type" type="string" value="Box"/>
    <ParameterList name="Box">
      <Parameter name="Lengths" type="Array(double)" value="{2, 1}"/>
      <Parameter name="Divisions" type="Array(int)" value="{8, 4}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Materials">
    <ParameterList name="Rubber">
      <Parameter name="Density" type="double" value="1"/>
      <Parameter name="Viscosity" type="double" value="0.05"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Interactions">
    <ParameterList name="Wall">
      <Parameter name="Side Set" type="string" value="bottom"/>
      <Parameter name="Point" type="Array(double)" value="{0, -1}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Boundary Conditions">
    <ParameterList name="Stage">
      <Parameter name="Node Set" type="string" value="top"/>
      <Parameter name="Components" type="string" value="y"/>
      <!-- a function of this program: no list Histories has it -->
      <Parameter name="History" type="string" value="Stage"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Time Integrator">
    <Parameter name="Type" type="string" value="Newmark"/>
    <ParameterList name="Time Step Control">
      <Parameter name="Time Step" type="double" value="0.05"/>
      <Parameter name="Final Time" type="double" value="4"/>
    </ParameterList>
  </ParameterList>
</ParameterList>)xml";

/// Body and stage, and how they find their common motion.
class Coupling {
 public:
  explicit Coupling(const ixos::Comm& comm)
      : top_(std::make_shared<ixos::Waveform>()),
        simulation_(*Teuchos::getParametersFromXmlString(scene), comm, ".", {{"Stage", top_}}),
        start_([this](ixos::Record& record) { simulation_.integrator().transfer(record); }) {
    // Both start from rest with one acceleration: the reaction is linear in that of the block's top.
    const double at_rest = reaction_at(0), added_mass = reaction_at(1) - at_rest;
    stage_.motion.acceleration = (stage_.stiffness * stage_.rest - at_rest) / (stage_.mass + added_mass);
    stage_.force = reaction_at(stage_.motion.acceleration);
  }

  /// Takes a coupling step: iterates until the motion that the body felt is the one that the stage makes of its forces.
  void step(double dt) {
    const double time = simulation_.integrator().time();
    const Stage before = stage_;
    const auto& [y, v, a] = before.motion;
    ixos::TimeValue guess{y + dt * (v + dt / 2 * a), v + dt * a, a}, last_residual;
    double relaxation = 0.5;
    begin_ = before.motion;
    start_.save();
    for (int iteration = 0;; ++iteration) {
      if (iteration == 50) throw std::runtime_error("the coupling iteration does not converge");
      if (iteration > 0) start_.restore();
      top_->set(time, before.motion, time + dt, guess);
      stage_ = before;
      const Forces forces = advance_body(dt);
      stage_.advance(dt, forces);
      ++iterations_;
      const ixos::TimeValue residual = difference(stage_.motion, guess);
      if (std::sqrt(product(residual, residual, dt)) < 1e-12) break;
      if (iteration > 0) {
        const ixos::TimeValue change = difference(residual, last_residual);
        relaxation *= -product(last_residual, change, dt) / product(change, change, dt);
      }
      guess = {guess.value + relaxation * residual.value, guess.rate + relaxation * residual.rate,
               guess.acceleration + relaxation * residual.acceleration};
      last_residual = residual;
    }
    stage_.motion = top_->last();  // the two agree to the bit
  }

  /// Repeats the last coupling step, with a wrong motion in between. Returns whether the bits are the same.
  bool repeats(double dt) {
    const std::vector<double> u = state().u, v = state().v, a = state().a;
    const ixos::TimeValue end = top_->last();
    start_.restore();
    const double time = simulation_.integrator().time();
    top_->set(time, begin_, time + dt, {begin_.value + 0.01, 0, 0});
    advance_body(dt / 3);
    start_.restore();
    top_->set(time, begin_, time + dt, end);
    advance_body(dt);
    return u == state().u && v == state().v && a == state().a;
  }

  double energy() const {
    const ixos::StateReport now(simulation_.model(), state());
    return stage_.energy() + now.momenta().kinetic_energy + now.energy(ixos::Part::Elastic) +
           now.energy(ixos::Part::Interaction) + simulation_.integrator().dissipated_energy();
  }
  void write(const std::string& path) { ixos::write_checkpoint(path, simulation_, {stage_state()}); }
  void read(const std::string& path) { ixos::read_checkpoint(path, simulation_, {stage_state()}); }
  const ixos::State& state() const { return simulation_.integrator().state(); }
  const Stage& stage() const { return stage_; }
  const ixos::Waveform& top() const { return *top_; }
  int iterations() const { return iterations_; }

 private:
  /// Starts the body anew with that acceleration of its top.
  double reaction_at(double acceleration) {
    top_->set(0, {0, 0, acceleration}, 1, {});
    const std::vector<double> zero(state().u.size(), 0.0);
    simulation_.integrator().initialize(zero, zero, 0);
    return reaction();
  }
  Forces advance_body(double dt) {
    Forces forces{stage_.force};
    for (std::size_t k = 1; k < forces.size(); ++k) {
      const ixos::StepResult step = simulation_.integrator().step(dt / body_steps);
      if (!step.converged) throw std::runtime_error("a step of the body failed: " + step.reason);
      forces[k] = reaction();
    }
    return forces;
  }
  double reaction() const { return ixos::set_reaction(simulation_.model(), state().reaction, "top")[1]; }
  ixos::ProgramState stage_state() {
    return {"stage", [this](ixos::Record& record) {
              stage_.transfer(record);
              const ixos::Record::Section section(record, "top");
              top_->transfer(record);
            }};
  }

  static ixos::TimeValue difference(const ixos::TimeValue& a, const ixos::TimeValue& b) {
    return {a.value - b.value, a.rate - b.rate, a.acceleration - b.acceleration};
  }
  /// All parts in L0.
  static double product(const ixos::TimeValue& a, const ixos::TimeValue& b, double dt) {
    return a.value * b.value + dt * dt * (a.rate * b.rate + dt * dt * a.acceleration * b.acceleration);
  }

  std::shared_ptr<ixos::Waveform> top_;
  ixos::Simulation simulation_;
  ixos::Snapshot start_;
  Stage stage_;
  ixos::TimeValue begin_;  ///< of the last coupling step
  int iterations_ = 0;
};

/// Returns the largest change of the energy over the first one of the stage's spring.
double energy_error(const ixos::Comm& comm, int steps) {
  Coupling coupling(comm);
  const double first = coupling.energy(), spring = coupling.stage().energy();
  double largest = 0;
  for (int step = 0; step < steps; ++step) {
    coupling.step(4.0 / steps);
    largest = std::max(largest, std::abs(coupling.energy() - first));
  }
  if (comm->getRank() == 0)
    std::printf("%d steps: %.1f iterations a step, energy error %.3g, stage at %.6f\n", steps,
                static_cast<double>(coupling.iterations()) / steps, largest / spring, coupling.stage().motion.value);
  return largest / spring;
}

bool same(const ixos::TimeValue& a, const ixos::TimeValue& b) {
  return a.value == b.value && a.rate == b.rate && a.acceleration == b.acceleration;
}

/// Returns whether the body moves as in a simulation that takes each step once and follows the stage's motion.
bool agrees_with_simulation(const ixos::Comm& comm) {
  const double dt = 0.1;
  std::vector<ixos::Waveform> motion;  // in each coupling step
  const auto replay = [&](double time) {
    return motion[std::min(static_cast<std::size_t>(time / dt), motion.size() - 1)].at(time);
  };
  Coupling coupling(comm);
  std::vector<std::vector<double>> coupled;
  for (int step = 0; step < 40; ++step) {
    coupling.step(dt);
    motion.push_back(coupling.top());
    coupled.push_back(coupling.state().u);
  }
  ixos::Simulation simulation(*Teuchos::getParametersFromXmlString(scene), comm, ".",
                              {{"Stage", ixos::function_of_time(replay)}});
  double differs = 0, moved = 0;
  for (const std::vector<double>& u : coupled) {
    for (int step = 0; step < body_steps; ++step)
      if (!simulation.integrator().step(dt / body_steps).converged) throw std::runtime_error("a plain step failed");
    for (std::size_t i = 0; i < u.size(); ++i) {
      differs = std::max(differs, std::abs(u[i] - simulation.integrator().state().u[i]));
      moved = std::max(moved, std::abs(u[i]));
    }
  }
  differs = simulation.model().space().maximum(differs);
  moved = simulation.model().space().maximum(moved);
  if (comm->getRank() == 0) std::printf("moved %.3g, differs from a plain simulation by %.3g\n", moved, differs);
  return differs < 1e-9 && moved > 0.1;
}

/// Returns whether a run that resumes in the middle has the bits of one that does not stop.
bool resumes(const ixos::Comm& comm, const std::string& path) {
  Coupling whole(comm), first(comm), second(comm);
  bool repeats = true;
  for (int step = 0; step < 20; ++step) {
    whole.step(0.1);
    if (step < 10) first.step(0.1);
    if (step == 5) repeats = first.repeats(0.1);
  }
  first.write(path);
  second.read(path);
  comm->barrier();
  if (comm->getRank() == 0) std::remove(path.c_str());
  for (int step = 10; step < 20; ++step) second.step(0.1);
  const bool resumed = second.state().u == whole.state().u && second.state().v == whole.state().v &&
                       same(second.stage().motion, whole.stage().motion);
  if (comm->getRank() == 0)
    std::printf("repeated steps %s, a resumed run %s\n", repeats ? "agree" : "differ", resumed ? "agrees" : "differs");
  return repeats && resumed;
}

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard guard(&argc, &argv);
  const ixos::Comm comm = Tpetra::getDefaultComm();
  const std::string path = argc > 1 ? argv[1] : "partitioned-" + std::to_string(comm->getSize()) + ".h5";
  int good = 0;
  try {
    const double coarse = energy_error(comm, 40), fine = energy_error(comm, 80);
    good = coarse < 3e-3 && fine < coarse / 3.5 && agrees_with_simulation(comm) && resumes(comm, path) ? 1 : 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  int all = 0;
  Teuchos::reduceAll(*comm, Teuchos::REDUCE_MIN, 1, &good, &all);
  return all == 1 ? 0 : 1;
}
