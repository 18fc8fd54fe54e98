// Two bodies that collide off centre.
#pragma once
#include <cmath>
#include <string>

#include "scene/simulation.hpp"
#include "support/comparison.hpp"
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
            const std::string& primary = "b_surface", double angle = 0)
      : simulation_(scene_of("a_body", "b_body", secondary, primary, time_integrator(scheme, step, 1, options), pair),
                    bodies, world()) {
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
  Momenta momenta() {
    return simulation_.model().momenta(simulation_.integrator().state().u.data(),
                                       simulation_.integrator().state().v.data());
  }
  double least_gap() {
    return simulation_.model().interaction_report(simulation_.integrator().state().u.data()).least_gap;
  }
  static constexpr double speed = 15;

 private:
  Simulation simulation_;
};

}  // namespace ixos::test
