// Builds a body from a distributed mesh with ids and a dof map of the program's own, without a scene, and drives it
// with an integrator of Ixos: an adhesive wall holds a block, whose top is pulled off. For comparison, the scene
// block.xml runs beside it: own_mesh block.xml. The exit status is 0 if both motions agree to 1e-9 over 100 steps.
#include <Tpetra_Core.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <ixos/integrator.hpp>
#include <ixos/mesh.hpp>
#include <ixos/model.hpp>
#include <ixos/simulation.hpp>
#include <vector>

namespace {

constexpr int columns = 8, rows = 4;  // of cells, each 0.5 by 0.5

/// The program numbers its nodes column by column, with gaps, and its unknowns component by component.
long long node_id(int i, int j) { return 1000 + 7 * (i * (rows + 1) + j); }
long long dof_id(long long node, int component) { return component * 1000000LL + node; }

/// Each rank has a share of the columns of nodes, and the cells to the right of each of its nodes.
ixos::DistributedMesh own_share(int rank, int ranks) {
  ixos::DistributedMesh mesh;
  mesh.blocks = {{"rubber", {}}};
  mesh.side_sets = {{"bottom", {}}};
  mesh.node_sets = {{"top", {}}};
  int cells = 0;
  for (int i = (columns + 1) * rank / ranks; i < (columns + 1) * (rank + 1) / ranks; ++i)
    for (int j = 0; j <= rows; ++j) {
      mesh.nodes.push_back(node_id(i, j));
      mesh.coordinates.insert(mesh.coordinates.end(), {0.5 * i, 0.5 * j});
      if (j == rows) mesh.node_sets[0].nodes.push_back(node_id(i, j));
      if (i == columns || j == rows) continue;
      const auto corners = {node_id(i, j), node_id(i + 1, j), node_id(i + 1, j + 1), node_id(i, j + 1)};
      mesh.blocks[0].nodes.insert(mesh.blocks[0].nodes.end(), corners);
      if (j == 0) mesh.side_sets[0].sides.push_back({0, cells, 0});
      ++cells;
    }
  return mesh;
}

Teuchos::RCP<const ixos::Map> own_map(const ixos::DistributedMesh& mesh, const ixos::Comm& comm) {
  std::vector<ixos::GlobalId> ids;
  for (int component = 0; component < 2; ++component)
    for (const long long node : mesh.nodes) ids.push_back(dof_id(node, component));
  return Teuchos::rcp(new ixos::Map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(),
                                    Teuchos::ArrayView<const ixos::GlobalId>(ids), 0, comm));
}

/// The motion of the top: 0.3 (10 s^3 - 15 s^4 + 6 s^5), s = t/0.04, and its derivatives.
ixos::TimeValue pull(double t) {
  const double length = 0.04, s = t < length ? t / length : 1;
  return {0.3 * s * s * s * (10 + s * (6 * s - 15)), 0.3 * 30 * s * s * (1 - s) * (1 - s) / length,
          0.3 * 60 * s * (1 - s) * (1 - 2 * s) / (length * length)};
}

int compare(const ixos::Comm& comm, const char* scene) {
  const ixos::DistributedMesh mesh = own_share(comm->getRank(), comm->getSize());
  ixos::Material rubber;
  rubber.block = "rubber";
  rubber.law = ixos::make_elastic_law("Neo-Hooke", {{"Young's Modulus", 1.0}, {"Poisson's Ratio", 0.2}});
  rubber.density = 5e-7;
  ixos::Model model(ixos::local_part(mesh, comm), comm, {rubber});

  ixos::SurfaceInteraction wall;
  wall.side_set = "bottom";
  wall.law = ixos::make_gap_law("Van der Waals", {{"Gamma L", 2.5}, {"Gamma W", 25.0}});
  wall.obstacle = ixos::make_obstacle("Half-Space", 2, {{"Point", {0.0, -0.26}}});
  ixos::add_interaction(model, wall);
  ixos::prescribe(model, "top", "y", ixos::function_of_time(pull));

  const ixos::Table table = ixos::average_vector_field(4, 8);
  ixos::Integrator integrator(model, table, ixos::default_linear_solver(model, table, 0.0005), {});
  const std::vector<double> rest(static_cast<std::size_t>(model.space().local()), 0.0);
  integrator.initialize(rest, rest, 0.0);

  ixos::Simulation simulation(ixos::read_scene_file(scene), comm);

  // Both motions in the program's own map. The box of the scene numbers its nodes row by row.
  const auto map = own_map(mesh, comm);
  const ixos::DofExchange own(model.mesh(), model.space(), map, dof_id);
  const ixos::DofExchange box(
      simulation.model().mesh(), simulation.model().space(), map, [](ixos::GlobalId node, int component) {
        return dof_id(node_id(static_cast<int>(node % (columns + 1)), static_cast<int>(node / (columns + 1))),
                      component);
      });
  ixos::Vector u(map), u_scene(map);
  double largest = 0, moved = 0, energy_error = 0, start = 0;
  for (int step = 0; step < 100; ++step) {
    if (!integrator.step(0.0005).converged || !simulation.integrator().step(0.0005).converged) return 1;
    own.to_program(integrator.state().u, u);
    box.to_program(simulation.integrator().state().u, u_scene);
    u_scene.update(-1.0, u, 1.0);
    largest = std::max(largest, u_scene.normInf());
    moved = std::max(moved, u.normInf());

    const ixos::StateReport now(model, integrator.state());
    const double energy = now.momenta().kinetic_energy + now.energy(ixos::Part::Elastic) +
                          now.energy(ixos::Part::Interaction) - integrator.external_work();
    if (step == 0) start = energy;
    energy_error = std::max(energy_error, std::abs(energy - start));
  }
  const ixos::InteractionReport contact = ixos::StateReport(model, integrator.state()).interaction_report();
  const std::vector<double> top = ixos::set_reaction(model, integrator.state().reaction, "top");
  if (comm->getRank() == 0)
    std::printf("moved %.3g, differs by %.3g; energy drifts by %.3g; force on wall %.6g, on top %.6g, gap %.6g\n",
                moved, largest, energy_error, -contact.force[1], top[1], contact.least_gap);
  return largest < 1e-9 && moved > 0.1 && energy_error < 1e-9 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard guard(&argc, &argv);
  if (argc != 2) {
    std::fprintf(stderr, "usage: own_mesh SCENE.xml\n");
    return 2;
  }
  try {
    return compare(Tpetra::getDefaultComm(), argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "own_mesh: %s\n", error.what());
    return 2;
  }
}
