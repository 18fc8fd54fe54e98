// Constant stress through enriched elements with a free contact side under traction: equilibrium finds the affine
// state.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <tuple>

#include "discretization/nodal_measure.hpp"
#include "material/elastic_law.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/selection.hpp"
#include "support/comparison.hpp"
#include "support/contact_element.hpp"
#include "support/solids.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

/// A traction on a side, along one axis.
void pull(Model& model, const char* set, std::size_t axis, double traction) {
  const LocalMesh& mesh = model.mesh();
  const auto d = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> measure(static_cast<std::size_t>(mesh.nodes()), 0.0), force(d * measure.size(), 0.0);
  add_side_measure(mesh, mesh.side_sets[mesh.side_set(set)], measure);
  for (std::size_t n = 0; n < measure.size(); ++n) force[d * n + axis] = traction * measure[n];
  model.loads().add(force, constant(1.0));
}

void expect_equilibrium(Model& model, const std::vector<double>& expected, double tolerance) {
  Integrator integrator = test::direct(model, static_equilibrium());
  integrator.initialize(test::at_rest(model), test::at_rest(model), 0.0);
  const StepResult result = integrator.step(1.0);
  ASSERT_TRUE(result.converged) << result.reason;
  EXPECT_LT(test::distance(integrator.state().u, expected), tolerance);
}

void run(ContactElement element) {
  BoxShape shape;
  shape.lengths = {4, 3, 0};
  shape.divisions = {4, 3, 1};
  Mesh mesh = box(shape);
  mesh.coordinates[2] += 0.3;  // uneven sides
  mesh.coordinates[2 * 6] += 0.2;
  mesh.coordinates[2 * 6 + 1] -= 0.15;
  test::give_contact_element(mesh, "bottom", element);
  const Material rubber = test::elastic(linear_elastic, 0.3);
  const auto model = test::model_of(mesh, rubber, Inertia::None);
  const LocalMesh& local = model->mesh();

  // Pulled down at the bottom by p, up at the top: u_y = p y/(Lambda + 2 mu), u_x = 0 held on the sides.
  const double p = 0.02;
  for (const auto& [set, sign] : {std::pair{"bottom", -1.0}, std::pair{"top", 1.0}}) pull(*model, set, 1, sign * p);
  for (const char* set : {"left", "right"})
    for (int node : local.node_sets[local.node_set(set)]) model->constraints().add(2 * node, 1.0, nullptr);
  for (int node = 0; node < local.nodes(); ++node) {
    const auto n = static_cast<std::size_t>(node);
    const bool corner = !local.is_derivative(n) && local.coordinates[2 * n] == 0 && local.coordinates[2 * n + 1] == 0;
    if (corner) model->constraints().add(2 * node + 1, 1.0, nullptr);
  }
  std::vector<double> expected = test::at_rest(*model);
  const double strain = p / (rubber.law->lame().lambda + 2 * rubber.law->lame().mu);
  for (std::size_t n = 0; n < expected.size() / 2; ++n) expected[2 * n + 1] = strain * local.coordinates[2 * n + 1];
  expect_equilibrium(*model, expected, 1e-14);
}

/// A distorted box under the same tension p on all its sides, held in three corners: u = p X/(3 Lambda + 2 mu). Its
/// bottom is enriched, or only a part of it, whose rim is then tied.
void run_hexahedra(ContactElement element, bool patch) {
  const std::array<double, 3> lengths{4, 3, 2};
  BoxShape shape;
  shape.dimension = 3;
  shape.lengths = lengths;
  shape.divisions = {4, 3, 2};
  Mesh mesh = box(shape);
  for (std::size_t k = 0; k < mesh.coordinates.size(); ++k) {
    double& x = mesh.coordinates[k];
    if (x > 0 && x < lengths[k % 3]) x += 0.15 * std::sin(7.0 * static_cast<double>(k));
  }
  if (patch) add_side_set(mesh, "patch", "bottom", {{}, {2.5, 1.5, 2}});
  test::give_contact_element(mesh, patch ? "patch" : "bottom", element);
  const Material rubber = test::elastic(linear_elastic, 0.3);
  const auto model = test::model_of(mesh, rubber, Inertia::None);
  const LocalMesh& local = model->mesh();

  const double p = 0.02;
  const std::tuple<const char*, std::size_t, double> sides[] = {{"left", 0, -1}, {"right", 0, 1},   {"front", 1, -1},
                                                                {"back", 1, 1},  {"bottom", 2, -1}, {"top", 2, 1}};
  for (const auto& [set, axis, sign] : sides) pull(*model, set, axis, sign * p);
  for (int node = 0; node < local.nodes(); ++node) {
    const double* x = &local.coordinates[3 * static_cast<std::size_t>(node)];
    const bool origin = x[0] == 0 && x[1] == 0 && x[2] == 0;
    const bool on_x = x[0] == 4 && x[1] == 0 && x[2] == 0, on_y = x[0] == 0 && x[1] == 3 && x[2] == 0;
    if (origin) model->constraints().add(3 * node, 1.0, nullptr);
    if (origin || on_x) model->constraints().add(3 * node + 1, 1.0, nullptr);
    if (origin || on_x || on_y) model->constraints().add(3 * node + 2, 1.0, nullptr);
  }
  std::vector<double> expected = test::at_rest(*model);
  for (std::size_t k = 0; k < expected.size(); ++k)
    expected[k] = p / (3 * rubber.law->lame().lambda + 2 * rubber.law->lame().mu) * local.coordinates[k];
  expect_equilibrium(*model, expected, 1e-13);
}

TEST(EnrichedPatchTest, UniformTensionThroughFacesAndTiedEdges) {
  for (ContactElement element : {ContactElement::Q1C1, ContactElement::Q1C2, ContactElement::Q1C3, ContactElement::Q1C4,
                                 ContactElement::Q1CH, ContactElement::Q2C2, ContactElement::Q2C4})
    for (bool patch : {false, true}) run_hexahedra(element, patch);
}

TEST(EnrichedPatchTest, ConstantStressThroughAFreeContactSide) {
  for (ContactElement element : {ContactElement::Q1C1, ContactElement::Q1C2, ContactElement::Q1C3, ContactElement::Q1C4,
                                 ContactElement::Q1CH, ContactElement::Q2C2, ContactElement::Q2C4})
    run(element);
}

}  // namespace
}  // namespace ixos
