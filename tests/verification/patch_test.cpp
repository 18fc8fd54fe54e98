// Motions affine in space and time, u = t G X: every scheme and every distorted mesh reproduces them exactly.
#include <gtest/gtest.h>

#include <cmath>

#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "mesh/selection.hpp"
#include "support/comparison.hpp"
#include "support/contact_element.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"
#include "time/integrator.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

using test::world;

/// Moves the nodes from number `first` on that are inside a box of 3 by 3 (by 3), at most that far.
void distort(Mesh& mesh, int first, double size) {
  const auto d = static_cast<std::size_t>(mesh.dimension);
  for (auto n = static_cast<std::size_t>(first); n < static_cast<std::size_t>(mesh.nodes()); ++n) {
    bool inside = true;
    for (std::size_t i = 0; i < d; ++i)
      inside = inside && mesh.coordinates[n * d + i] > 0 && mesh.coordinates[n * d + i] < 3;
    if (!inside) continue;
    for (std::size_t i = 0; i < d; ++i)
      mesh.coordinates[n * d + i] += size * std::sin(7.0 * static_cast<double>(n) + 2.0 * static_cast<double>(i));
  }
}

/// A box whose inner nodes are moved off the grid; its bottom, of uneven sides, with that contact element. In 3D only
/// where x <= 2: a tied rim. Quadratic cells are curved.
Mesh distorted_box(int dimension, ContactElement element) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {3, 3, 3};
  shape.divisions = {3, 3, 3};
  Mesh mesh = box(shape);
  const auto d = static_cast<std::size_t>(dimension);
  distort(mesh, 0, 0.25);
  if (element != ContactElement::Q1C1) mesh.coordinates[d] += 0.2;
  if (dimension == 3) add_side_set(mesh, "patch", "bottom", {{}, {2.5, 3, 3}});
  test::give_contact_element(mesh, dimension == 2 ? "bottom" : "patch", element);
  if (mesh.linear_nodes >= 0) distort(mesh, mesh.linear_nodes, 0.05);
  return mesh;
}

void run_patch(int dimension, test::ElasticLawOfConstants law, const Table& table,
               ContactElement element = ContactElement::Q1C1, Formulation formulation = Formulation::Standard) {
  const Mesh mesh = distorted_box(dimension, element);
  const Comm comm = world();
  Material rubber;
  rubber.block = "body";
  rubber.law = law(lame_constants(1.0, 0.3));
  rubber.density = 1.0;
  rubber.formulation = formulation;
  Model model(localize(mesh, partition_nodes(mesh, comm->getSize()), comm->getRank(), comm->getSize()), comm, {rubber});
  const LocalMesh& local = model.mesh();
  const auto d = static_cast<std::size_t>(dimension);
  const double g[3][3] = {{0.2, -0.1, 0.05}, {0.15, -0.12, 0.1}, {-0.05, 0.08, 0.1}};
  std::vector<double> velocity(static_cast<std::size_t>(model.space().local()), 0.0);
  for (std::size_t n = 0; n < velocity.size() / d; ++n)
    for (std::size_t i = 0; i < d; ++i)
      for (std::size_t j = 0; j < d; ++j) velocity[n * d + i] += g[i][j] * local.coordinates[n * d + j];
  const auto unit_rate = rate_ramp(1.0, 0.0, 0.0, RampShape::Linear);  // u = t
  for (int node : local.node_sets[local.node_set("surface")])
    for (int i = 0; i < dimension; ++i) {
      const int dof = node * dimension + i;
      model.constraints().add(dof, velocity[static_cast<std::size_t>(dof)], unit_rate);
    }

  Teuchos::ParameterList linear;
  linear.set("Linear Solver Type", "Direct").set("Preconditioner Type", "None");
  Integrator integrator(model, table, std::make_shared<LinearSolverFactory>(linear), {});
  integrator.initialize(std::vector<double>(velocity.size(), 0.0), velocity, 0.0);
  for (int step = 0; step < 4; ++step) ASSERT_TRUE(integrator.step(0.25).converged) << table.name;
  EXPECT_LT(test::distance(integrator.state().u, velocity), 1e-11) << table.name << ", " << dimension << "D";
  EXPECT_LT(test::distance(integrator.state().v, velocity), 1e-10) << table.name << ", " << dimension << "D";
  const std::vector<double> zero(velocity.size(), 0.0);
  EXPECT_LT(test::distance(integrator.acceleration(), zero), 1e-9) << table.name << ", " << dimension << "D";
}

TEST(PatchTest, AffineMotionIsReproduced) {
  for (int dimension : {2, 3})
    for (const Table& table : {newmark(0.25, 0.5), bathe_composite(0.0, 0.5),
                               gautam_sauer_composite(0.25, 0.5, 5, Path::Linear), average_vector_field(4, 8)})
      run_patch(dimension, neo_hooke, table);
}

TEST(PatchTest, AffineMotionIsReproducedThroughEnrichedElements) {
  for (ContactElement element : {ContactElement::Q1C2, ContactElement::Q1C3, ContactElement::Q1C4, ContactElement::Q1CH,
                                 ContactElement::Q2C2, ContactElement::Q2C4})
    for (const Table& table : {newmark(0.25, 0.5), bathe_composite(0.0, 0.5),
                               gautam_sauer_composite(0.25, 0.5, 5, Path::Linear), average_vector_field(4, 8)})
      run_patch(2, neo_hooke, table, element);
  for (ContactElement element : {ContactElement::Q1C2, ContactElement::Q1C3, ContactElement::Q1C4, ContactElement::Q1CH,
                                 ContactElement::Q2C2, ContactElement::Q2C4})
    run_patch(3, neo_hooke, average_vector_field(4, 8), element);
}

TEST(PatchTest, AffineMotionIsReproducedByCurvedCellsWithMeanDilatation) {
  for (ContactElement element : {ContactElement::Q2C2, ContactElement::Q2C4}) {
    run_patch(2, neo_hooke, average_vector_field(4, 8), element, Formulation::MeanDilatation);
    run_patch(2, linear_elastic, newmark(0.25, 0.5), element, Formulation::MeanDilatation);
  }
  run_patch(3, neo_hooke, newmark(0.25, 0.5), ContactElement::Q2C4, Formulation::MeanDilatation);
}

TEST(PatchTest, AffineMotionOfALinearMaterialIsReproduced) {
  for (int dimension : {2, 3}) run_patch(dimension, linear_elastic, newmark(0.25, 0.5));
}

}  // namespace
}  // namespace ixos
