// Constant stress through enriched elements with a free contact side under traction: equilibrium finds the affine
// state.
#include <gtest/gtest.h>

#include <cmath>

#include "material/linear_elastic.hpp"
#include "mesh/enrich.hpp"
#include "mesh/generators.hpp"
#include "model/nodal_measure.hpp"
#include "support/comparison.hpp"
#include "support/scene_text.hpp"
#include "time/integrator.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

using test::world;

void run(ContactElement element) {
  BoxShape shape;
  shape.lengths = {4, 3, 0};
  shape.divisions = {4, 3, 1};
  Mesh mesh = box(shape);
  mesh.coordinates[2] += 0.3;  // uneven sides
  mesh.coordinates[2 * 6] += 0.2;
  mesh.coordinates[2 * 6 + 1] -= 0.15;
  enrich(mesh, "bottom", element);
  const Comm comm = world();
  Material rubber;
  rubber.block = "body";
  rubber.law = ElasticLaw::Linear;
  rubber.lame = lame_constants(1.0, 0.3);
  Model model(localize(mesh, partition_nodes(mesh, comm->getSize()), comm->getRank(), comm->getSize()), comm, {rubber},
              Inertia::None);
  const LocalMesh& local = model.mesh();

  // Pulled down at the bottom by p, up at the top: u_y = p y/(Lambda + 2 mu), u_x = 0 held on the sides.
  const double p = 0.02;
  for (const auto& [set, sign] : {std::pair{"bottom", -1.0}, std::pair{"top", 1.0}}) {
    std::vector<double> measure(static_cast<std::size_t>(local.nodes()), 0.0), force(2 * measure.size(), 0.0);
    add_side_measure(local, local.side_sets[local.side_set(set)], measure);
    for (std::size_t n = 0; n < measure.size(); ++n) force[2 * n + 1] = sign * p * measure[n];
    model.loads().add(force, constant(1.0));
  }
  for (const char* set : {"left", "right"})
    for (int node : local.node_sets[local.node_set(set)]) model.constraints().add(2 * node, 1.0, nullptr);
  for (int node = 0; node < local.nodes(); ++node) {
    const auto n = static_cast<std::size_t>(node);
    const bool corner = !local.is_derivative(n) && local.coordinates[2 * n] == 0 && local.coordinates[2 * n + 1] == 0;
    if (corner) model.constraints().add(2 * node + 1, 1.0, nullptr);
  }
  Teuchos::ParameterList linear;
  linear.set("Linear Solver Type", "Direct").set("Preconditioner Type", "None");
  Integrator integrator(model, static_equilibrium(), std::make_shared<LinearSolverFactory>(linear), {});
  std::vector<double> u(static_cast<std::size_t>(model.space().local()), 0.0);
  integrator.initialize(u, u, 0.0);
  const StepResult result = integrator.step(1.0);
  ASSERT_TRUE(result.converged) << result.reason;
  const double strain = p / (rubber.lame.lambda + 2 * rubber.lame.mu);
  for (std::size_t n = 0; n < u.size() / 2; ++n) u[2 * n + 1] = strain * local.coordinates[2 * n + 1];
  EXPECT_LT(test::distance(integrator.state().u, u), 1e-14);
}

TEST(EnrichedPatchTest, ConstantStressThroughAFreeContactSide) {
  for (ContactElement element :
       {ContactElement::Q1C1, ContactElement::Q1C2, ContactElement::Q1C3, ContactElement::Q1C4, ContactElement::Q1CH})
    run(element);
}

}  // namespace
}  // namespace ixos
