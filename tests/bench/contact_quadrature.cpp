// Error of the contact force against the number of surface points, for each contact element: the strip in static
// equilibrium while it peels, its contact force evaluated with other numbers of points at the same displacement.
//   contact_quadrature STRIP.xml [TIME]
#include <fmt/format.h>

#include <Tpetra_Core.hpp>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "interaction/van_der_waals.hpp"
#include "scene/read/parameters.hpp"
#include "scene/scene_file.hpp"
#include "scene/simulation.hpp"
#include "term/wall/surface_terms.hpp"

namespace {

/// Nodal forces of the strip's contact at u, with that many points.
std::vector<double> contact_force(const ixos::Model& model, const std::vector<double>& u, int points) {
  const ixos::LocalMesh& mesh = model.mesh();
  ixos::HalfSpace wall;
  wall.point = {0, 0, 0};
  wall.normal = {0, 1, 0};
  std::vector<double> force(u.size(), 0.0);
  for (const auto& term :
       ixos::make_surface_terms(mesh, mesh.side_sets[mesh.side_set("contact")], model.pattern(),
                                ixos::gap_law(ixos::VanDerWaals(2.5, 25)), ixos::flat_wall(wall), {points, 0.8}))
    term->add_force({nullptr, nullptr, u.data()}, ixos::end_rule(), force.data());
  return force;
}

double norm(const std::vector<double>& x) {
  double sum = 0;
  for (double value : x) sum += value * value;
  return std::sqrt(sum);
}

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard guard(&argc, &argv);
  if (argc < 2) {
    fmt::print(stderr, "contact_quadrature STRIP.xml [TIME]\n");
    return 2;
  }
  const double end = argc > 2 ? std::stod(argv[2]) : 60;
  const std::vector<int> counts{2, 3, 4, 5, 6, 8, 10, 12, 16};
  fmt::print("| element |");
  for (int n : counts) fmt::print(" {} |", n);
  fmt::print("\n|---|");
  for (std::size_t i = 0; i < counts.size(); ++i) fmt::print("---|");
  fmt::print("\n");
  for (const char* element : {"Q1C1", "Q1C2", "Q1C3", "Q1C4", "Q1CH"}) {
    Teuchos::ParameterList scene = ixos::read_scene_file(argv[1]);
    for (const std::string& assignment :
         {std::string("Time Integrator/Type=Static"), std::string("Time Integrator/Time Step Control/Time Step=1"),
          std::string("Interactions/Wall/Contact Element=") + element})
      ixos::set_parameter(scene, ixos::scene_parameters(), assignment);
    ixos::Simulation simulation(scene, Tpetra::getDefaultComm());
    ixos::Integrator& integrator = simulation.integrator();
    while (integrator.time() < end - 0.5)
      if (!integrator.step(1.0).converged) return 3;
    const std::vector<double>& u = integrator.state().u;
    const std::vector<double> exact = contact_force(simulation.model(), u, 64);
    fmt::print("| {} |", element);
    for (int n : counts) {
      std::vector<double> error = contact_force(simulation.model(), u, n);
      for (std::size_t i = 0; i < error.size(); ++i) error[i] -= exact[i];
      fmt::print(" {:.1e} |", norm(error) / norm(exact));
    }
    fmt::print("\n");
  }
  return 0;
}
