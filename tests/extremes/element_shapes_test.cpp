// Elements drawn out, skewed and folded: what is exact stays exact, and what is no element is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "mesh/quality.hpp"
#include "support/comparison.hpp"
#include "support/scene_text.hpp"
#include "time/integrator.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

using test::world;

/// A box of 3 x 3 (x 3) cells, inner nodes moved off the grid, its last axis shortened by `aspect`; then each layer is
/// pushed along by `skew` times its height (parallelograms with an angle of 1/skew).
Mesh drawn_out(int dimension, double aspect, double skew, int order = 1) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lengths = {3, 3, 3};
  shape.divisions = {3, 3, 3};
  Mesh mesh = box(shape);
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t n = 0; n < static_cast<std::size_t>(mesh.nodes()); ++n) {
    double* x = &mesh.coordinates[n * d];
    bool inside = true;
    for (std::size_t i = 0; i < d; ++i) inside = inside && x[i] > 0 && x[i] < 3;
    for (std::size_t i = 0; i < d && inside; ++i)
      x[i] += 0.2 * std::sin(7.0 * static_cast<double>(n) + 2.0 * static_cast<double>(i));
    x[d - 1] /= aspect;
    x[0] += skew * x[d - 1];
  }
  if (order == 2) raise_order(mesh);
  return mesh;
}

/// Largest distance of the inner nodes from u = G X, which the surface is given, over the largest u.
double patch_error(const Mesh& mesh, Formulation formulation) {
  const Comm comm = world();
  Material rubber;
  rubber.block = "body";
  rubber.law = neo_hooke(lame_constants(1.0, 0.3));
  rubber.density = 1.0;
  rubber.formulation = formulation;
  Model model(localize(mesh, partition_nodes(mesh, comm->getSize()), comm->getRank(), comm->getSize()), comm, {rubber},
              Inertia::None);
  const LocalMesh& local = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  const double g[3][3] = {{0.2, -0.1, 0.05}, {0.15, -0.12, 0.1}, {-0.05, 0.08, 0.1}};
  std::vector<double> exact(static_cast<std::size_t>(model.space().local()), 0.0);
  double largest = 0;
  for (std::size_t n = 0; n < exact.size() / d; ++n)
    for (std::size_t i = 0; i < d; ++i) {
      for (std::size_t j = 0; j < d; ++j) exact[n * d + i] += g[i][j] * local.coordinates[n * d + j];
      largest = std::max(largest, std::abs(exact[n * d + i]));
    }
  const auto unit_rate = rate_ramp(1.0, 0.0, 0.0, RampShape::Linear);  // u = t
  for (int node : local.node_sets[local.node_set("surface")])
    for (int i = 0; i < mesh.dimension; ++i) {
      const int dof = node * mesh.dimension + i;
      model.constraints().add(dof, exact[static_cast<std::size_t>(dof)], unit_rate);
    }
  Teuchos::ParameterList linear;
  linear.set("Linear Solver Type", "Direct").set("Preconditioner Type", "None");
  Integrator integrator(model, static_equilibrium(), std::make_shared<LinearSolverFactory>(linear), {});
  const std::vector<double> rest(exact.size(), 0.0);
  integrator.initialize(rest, rest, 0.0);
  for (int step = 0; step < 4; ++step) {
    const StepResult result = integrator.step(0.25);
    EXPECT_TRUE(result.converged) << result.reason;
    if (!result.converged) return 1;
  }
  return test::distance(integrator.state().u, exact) / largest;
}

TEST(ElementShapesTest, AffineMotionIsExactForAnyAspectAndSkew) {
  for (int dimension : {2, 3})
    for (Formulation formulation : {Formulation::Standard, Formulation::MeanDilatation, Formulation::Enhanced})
      for (double aspect : {1.0, 30.0, 1000.0})
        for (double skew : {0.0, 10.0, 1000.0}) {
          const double error = patch_error(drawn_out(dimension, aspect, skew), formulation);
          // What rounding costs grows with the elements' condition.
          EXPECT_LT(error, 1e-13 * (1 + aspect + skew * skew)) << dimension << "D " << aspect << ' ' << skew;
        }
}

TEST(ElementShapesTest, AffineMotionOfQuadraticCellsIsExactForAnyAspectAndSkew) {
  for (int dimension : {2, 3})
    for (Formulation formulation : {Formulation::Standard, Formulation::MeanDilatation})
      for (double aspect : {1.0, 30.0, 1000.0})
        for (double skew : {0.0, 10.0, 1000.0}) {
          const double error = patch_error(drawn_out(dimension, aspect, skew, 2), formulation);
          EXPECT_LT(error, 1e-13 * (1 + aspect + skew * skew)) << dimension << "D " << aspect << ' ' << skew;
        }
}

/// A quadrilateral whose third corner is at (t, t), of the square with corners 0 and 1.
Mesh folded(double t) {
  Mesh mesh = box(BoxShape{});
  for (std::size_t n = 0; n < 4; ++n)
    if (mesh.coordinates[2 * n] > 0.5 && mesh.coordinates[2 * n + 1] > 0.5)
      mesh.coordinates[2 * n] = mesh.coordinates[2 * n + 1] = t;
  return mesh;
}

// At (r, s) in the square its Jacobian is 1 - (1 - t)(r + s), least of the Gauss points at r = s = (1 + 1/sqrt 3)/2:
// zero there at t = 1/sqrt 3/(1 + 1/sqrt 3).
TEST(ElementShapesTest, AQuadrilateralIsRefusedWhereItsJacobianVanishesAtAGaussPoint) {
  const double line = 1 / std::sqrt(3.0) / (1 + 1 / std::sqrt(3.0));
  for (double t : {1.0, 0.51, 0.5, line + 1e-9}) EXPECT_NO_THROW(check_cells(folded(t))) << t;
  for (double t : {line - 1e-9, 0.0, -1.0}) EXPECT_THROW(check_cells(folded(t)), InputError) << t;
}

}  // namespace
}  // namespace ixos
