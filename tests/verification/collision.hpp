// Two bodies that collide off centre.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "scene/simulation.hpp"
#include "support/comparison.hpp"
#include "support/reports.hpp"
#include "support/two_bodies.hpp"
#include "time/integrator.hpp"

namespace ixos::test {

inline std::string material(const std::string& block) {
  return list(block, word("Block", block) + number("Young's Modulus", 1) + number("Poisson's Ratio", 0.2) +
                         number("Density", 5e-7));
}

/// The scene of two bodies of the blocks first and second; `pair`: more entries of the interaction.
inline Teuchos::ParameterList scene_of(const std::string& first, const std::string& second,
                                       const std::string& secondary, const std::string& primary,
                                       const std::string& time, const std::string& pair = "",
                                       const std::string& more = "") {
  return scene(list("Materials", material(first) + material(second)) +
               list("Interactions", list("Pair", word("Side Set", secondary) + word("Primary Side Set", primary) +
                                                     number("Gamma L", 2.5) + number("Gamma W", 25) + pair)) +
               time + list("Nonlinear Solver", number("Tolerance", 1e-12)) + more);
}

/// Two disks, or balls, of radius 3 that approach each other off centre, in a frame that is turned by an angle in the
/// plane of the first two directions: the bodies' mesh has to be turned so.
class Collision {
 public:
  Collision(const std::string& scheme, double step, const std::string& options = "", const std::string& pair = "",
            const Mesh& bodies = two_disks(3, {6.1, 2.4}), const std::string& secondary = "a_surface",
            const std::string& primary = "b_surface", double angle = 0, const Comm& comm = world())
      : simulation_(scene_of("a_body", "b_body", secondary, primary, time_integrator(scheme, step, 1, options), pair),
                    bodies, comm) {
    const LocalMesh& mesh = simulation_.model().mesh();
    std::vector<double> u = at_rest(simulation_.model()), v = u;
    const double c = std::cos(angle), s = std::sin(angle);
    for (std::size_t k = 0; k < v.size(); k += static_cast<std::size_t>(mesh.dimension)) {
      const double towards = c * mesh.coordinates[k] + s * mesh.coordinates[k + 1] > 3.05 ? -speed : speed;
      v[k] = c * towards;
      v[k + 1] = s * towards;
    }
    simulation_.integrator().initialize(u, v, 0);
  }
  Simulation& simulation() { return simulation_; }
  Momenta momenta() { return test::report_of(simulation_).momenta(); }
  double least_gap() { return test::report_of(simulation_).interaction_report().least_gap; }
  static constexpr double speed = 15;
  static constexpr double work_of_adhesion = 0.01549567;  ///< of the law [E0 L0]

 private:
  Simulation simulation_;
};

/// The largest changes of the energy, over W L0, of the linear momentum, over the sum of m |v| at the start, and of the
/// angular one, over that times the radius 3; the number of steps that change the angular one by more than 1e-12 of
/// this; and the least gap.
struct KeptErrors {
  double energy = 0, linear = 0, angular = 0;
  int turned = 0;
  double least_gap = 1;
};

/// Takes steps; stops with a failure if one does not converge. Collective.
inline KeptErrors kept_errors(Collision& collision, double dt, int steps) {
  const double energy = total_energy(collision.simulation());
  const Momenta before = collision.momenta();
  Momenta last = before;
  const double size = 2 * before.kinetic_energy / Collision::speed;  // all nodes have this speed
  KeptErrors errors;
  for (int step = 0; step < steps; ++step) {
    const StepResult result = collision.simulation().integrator().step(dt);
    if (!result.converged) {
      ADD_FAILURE() << step << ": " << result.reason;
      break;
    }
    const Momenta now = collision.momenta();
    errors.energy =
        std::max(errors.energy, std::abs(total_energy(collision.simulation()) - energy) / Collision::work_of_adhesion);
    errors.linear = std::max(errors.linear, distance(now.linear, before.linear) / size);
    errors.angular = std::max(errors.angular, distance(now.angular, before.angular) / (3 * size));
    if (distance(now.angular, last.angular) > 1e-12 * (3 * size)) ++errors.turned;
    last = now;
    errors.least_gap = std::min(errors.least_gap, collision.least_gap());
  }
  return errors;
}

/// Expects that the errors stay below these bounds, and that the bodies meet.
inline void expect_kept(Collision& collision, double dt, int steps, double energy, double linear, double angular) {
  const KeptErrors errors = kept_errors(collision, dt, steps);
  EXPECT_LT(errors.energy, energy);
  EXPECT_LT(errors.linear, linear);
  EXPECT_LT(errors.angular, angular);
  EXPECT_LT(errors.least_gap, 0.25);
}

}  // namespace ixos::test
