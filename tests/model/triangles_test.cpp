// Linear triangles beside quadrilaterals in one body: patch test, mass, tangents, energy, and what they refuse.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "balance/balance.hpp"
#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/van_der_waals.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "mesh/quality.hpp"
#include "mesh/turned_cells.hpp"
#include "model/edge_change.hpp"
#include "model/state_report.hpp"
#include "model/surface_interaction.hpp"
#include "support/comparison.hpp"
#include "support/derivative.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"
#include "support/tangents.hpp"
#include "time/catalogue.hpp"

namespace ixos {
namespace {

using Values = std::vector<double>;

/// A plate of 2 by 1 above y = 0.3 whose left half has quadrilaterals, its right half triangles; inner nodes are moved.
Mesh mixed_plate(int cells = 6) {
  BoxShape shape;
  shape.dimension = 2;
  shape.lengths = {2, 1, 1};
  shape.divisions = {cells, cells / 2, 1};
  shape.lower = {-1, 0.3, 0};
  Mesh mesh = box(shape);
  for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.nodes()); ++node) {
    double &x = mesh.coordinates[2 * node], &y = mesh.coordinates[2 * node + 1];
    if (std::abs(x) > 0.99 || y < 0.31 || y > 1.29) continue;
    const double shift = 0.3 / cells;
    x += shift * std::sin(7.0 * static_cast<double>(node));
    y += shift * std::cos(5.0 * static_cast<double>(node));
  }
  ElementBlock quads = mesh.blocks.front(), triangles = quads;
  quads.name = "quads";
  triangles.name = "triangles";
  triangles.type = CellType::Tri3;
  quads.nodes.clear();
  triangles.nodes.clear();
  const std::vector<int>& all = mesh.blocks.front().nodes;
  std::vector<std::pair<int, int>> place;  // by former cell: block and cell
  for (int cell = 0; cell < mesh.blocks.front().cells(); ++cell) {
    const int* n = &all[static_cast<std::size_t>(4 * cell)];
    if (cell % cells < cells / 2) {
      place.emplace_back(0, quads.cells());
      quads.nodes.insert(quads.nodes.end(), n, n + 4);
    } else {
      place.emplace_back(1, triangles.cells());
      triangles.nodes.insert(triangles.nodes.end(), {n[0], n[1], n[2], n[0], n[2], n[3]});
    }
  }
  for (SideSet& set : mesh.side_sets)
    for (Side& side : set.sides) {
      const auto [block, cell] = place[static_cast<std::size_t>(side.cell)];
      // Sides 0 and 1 are those of the first triangle; 2 and 3 are sides 1 and 2 of the second.
      const bool second = side.side > 1;
      side = {block, cell + (block == 1 && second ? 1 : 0), block == 1 && second ? side.side - 1 : side.side};
    }
  mesh.blocks = {quads, triangles};
  return mesh;
}

std::unique_ptr<Model> model_of(const Mesh& mesh, Inertia inertia, Formulation triangles = Formulation::Standard) {
  std::vector<Material> materials(2, test::elastic(neo_hooke, 0.3));
  materials[0].block = "quads";
  materials[1].block = "triangles";
  materials[1].formulation = triangles;
  const Comm comm = test::world();
  const int ranks = comm->getSize();
  return std::make_unique<Model>(localize(mesh, partition_nodes(mesh, ranks), comm->getRank(), ranks), comm, materials,
                                 inertia);
}

/// u = A X.
Values linear_field(const Model& model, const std::array<double, 4>& a) {
  Values u = test::at_rest(model);
  const Values& x = model.mesh().coordinates;
  for (std::size_t k = 0; k < u.size(); k += 2) {
    u[k] = a[0] * x[k] + a[1] * x[k + 1];
    u[k + 1] = a[2] * x[k] + a[3] * x[k + 1];
  }
  return u;
}

double total(const Model& model, const Values& x, const Values& y) {
  double sum = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(model.space().owned()); ++k) sum += x[k] * y[k];
  model.space().sum(&sum, 1);
  return sum;
}

TEST(TrianglesTest, AConstantStrainHasNoForceInside) {
  const auto model = model_of(mixed_plate(), Inertia::None);
  const Values u = linear_field(*model, {0.2, 0.1, -0.05, -0.15});
  Balance balance(*model);
  ASSERT_TRUE(balance.evaluate(Part::Elastic, {nullptr, nullptr, u.data()}, end_rule()));
  const Values& x = model->mesh().coordinates;
  double largest = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(model->space().owned()); ++k) {
    const std::size_t node = k / 2 * 2;
    const bool inside = std::abs(x[node]) < 0.99 && x[node + 1] > 0.31 && x[node + 1] < 1.29;
    if (inside) {
      EXPECT_NEAR(balance.force(Part::Elastic)[k], 0, 1e-14);
    } else {
      largest = std::max(largest, std::abs(balance.force(Part::Elastic)[k]));
    }
  }
  EXPECT_GT(model->space().maximum(largest), 0.01);
}

TEST(TrianglesTest, TheMassOfALinearFieldIsExact) {
  const auto model = model_of(mixed_plate(), Inertia::Consistent);
  const Values v = linear_field(*model, {1, 0, 0, 1});
  Values p = test::at_rest(*model);
  model->mass()->multiply(v.data(), p.data());
  // The integral of x^2 + y^2 over [-1, 1] x [0.3, 1.3].
  EXPECT_NEAR(total(*model, v, p), 2.0 / 3 + 2 * (std::pow(1.3, 3) - std::pow(0.3, 3)) / 3, 1e-13);
  const auto lumped = model_of(mixed_plate(), Inertia::Lumped);
  const Values one = test::moved(test::at_rest(*lumped), 1, Values(v.size(), 1.0));
  lumped->mass()->multiply(one.data(), p.data());
  EXPECT_NEAR(total(*lumped, one, p), 2 * 2, 1e-13) << "the mass 2, along each of two directions";
}

TEST(TrianglesTest, TheTangentIsTheDerivativeOfTheForce) {
  const auto model = model_of(mixed_plate(), Inertia::None);
  const Values from = test::smooth_field(*model, 0.02), to = test::smooth_field(*model, -0.03),
               way = test::noise(*model, 1);
  for (const Rule& rule : {end_rule(), gauss_rule(3)}) {
    const auto force = [&](double s) {
      Balance balance(*model);
      const Values u = test::moved(to, s, way);
      EXPECT_TRUE(balance.evaluate(Part::Elastic, {from.data(), nullptr, u.data()}, rule));
      return balance.force(Part::Elastic);
    };
    Values values = test::no_values(*model);
    TermSums(*model).add_tangent(Part::Elastic, {from.data(), nullptr, to.data()}, rule, Tangent::Exact, values.data());
    const Values product = test::matrix_product(*model, values.data(), way);
    for (std::size_t k = 0; k < product.size(); ++k)
      EXPECT_NEAR(test::derivative([&](double s) { return force(s)[k]; }, 1e-4), product[k], 1e-6) << k;
  }
}

TEST(TrianglesTest, AverageVectorFieldKeepsTheEnergyOnAWall) {
  const auto model = model_of(mixed_plate(), Inertia::Consistent);
  SurfaceInteraction wall;
  wall.side_set = "bottom";
  wall.law = gap_law(VanDerWaals(2.5, 25));
  wall.obstacle = make_obstacle("Half-Space", 2, {});
  add_interaction(*model, wall);
  Table table = scheme("Average Vector Field").table(scheme("Average Vector Field").parameters);
  Integrator integrator = test::direct(*model, table, 1e-12);
  integrator.initialize(linear_field(*model, {0.05, 0.02, -0.03, 0.04}), linear_field(*model, {0, -0.1, 0.1, 0}), 0);
  const auto energy = [&] {
    const StateReport now(*model, integrator.state());
    return now.momenta().kinetic_energy + now.energy(Part::Elastic) + now.energy(Part::Interaction);
  };
  const double first = energy(), kinetic = StateReport(*model, integrator.state()).momenta().kinetic_energy;
  for (int step = 0; step < 30; ++step) ASSERT_TRUE(integrator.step(0.05).converged);
  EXPECT_GT(std::abs(StateReport(*model, integrator.state()).momenta().kinetic_energy - kinetic), 1e-4);
  EXPECT_NEAR(energy(), first, 1e-8 * std::abs(first));
}

TEST(TrianglesTest, SidesOfTrianglesFeelAWallAsThoseOfQuadrilaterals) {
  const auto energy = [](const Mesh& mesh, const std::vector<std::string>& blocks) {
    std::vector<Material> materials;
    for (const std::string& block : blocks) {
      materials.push_back(test::elastic(neo_hooke, 0.3));
      materials.back().block = block;
    }
    const Comm comm = test::world();
    const int ranks = comm->getSize();
    Model model(localize(mesh, partition_nodes(mesh, ranks), comm->getRank(), ranks), comm, materials, Inertia::None);
    SurfaceInteraction wall;
    wall.side_set = "bottom";
    wall.law = gap_law(VanDerWaals(2.5, 25));
    wall.obstacle = make_obstacle("Half-Space", 2, {});
    add_interaction(model, wall);
    const Values u = test::at_rest(model);
    return StateReport(model, Place{u.data()}).energy(Part::Interaction);
  };
  BoxShape shape;
  shape.dimension = 2;
  shape.lengths = {2, 1, 1};
  shape.divisions = {6, 3, 1};
  shape.lower = {-1, 0.3, 0};
  EXPECT_NEAR(energy(mixed_plate(), {"quads", "triangles"}), energy(box(shape), {"body"}), 1e-14);
}

/// Elastic energy and force of the plate under a displacement that follows from the places alone.
std::pair<double, Values> response(const Mesh& mesh) {
  const auto model = model_of(mesh, Inertia::None);
  const Values u = test::smooth_field(*model, 0.05);
  const StateReport report(*model, Place{u.data()});
  return {report.energy(Part::Elastic), test::gathered(*model, report.nodal_force(Part::Elastic))};
}

TEST(TrianglesTest, NodesMayBeTurnedWithinACellAndTheBodyRescaled) {
  Mesh turned = mixed_plate();
  const auto [energy, force] = response(turned);
  EXPECT_GT(energy, 1e-3);
  for (std::size_t first = 0; first < turned.blocks[1].nodes.size(); first += 3)
    std::rotate(turned.blocks[1].nodes.begin() + static_cast<std::ptrdiff_t>(first),
                turned.blocks[1].nodes.begin() + static_cast<std::ptrdiff_t>(first + 1),
                turned.blocks[1].nodes.begin() + static_cast<std::ptrdiff_t>(first + 3));
  turned.side_sets.clear();  // sides would turn, too
  const auto [same, forces] = response(turned);
  EXPECT_NEAR(same, energy, 1e-14);
  EXPECT_LT(test::distance(forces, force), 1e-14);
  // A body of twice the size, moved twice as far, has four times the energy in plane strain.
  Mesh large = mixed_plate();
  for (double& x : large.coordinates) x *= 2;
  const auto model = model_of(large, Inertia::None);
  Values u = test::at_rest(*model);
  const auto small = model_of(mixed_plate(), Inertia::None);
  const Values half = test::smooth_field(*small, 0.05);
  for (std::size_t k = 0; k < u.size(); ++k) u[k] = 2 * half[k];
  EXPECT_NEAR(StateReport(*model, Place{u.data()}).energy(Part::Elastic), 4 * energy, 1e-13);
}

TEST(TrianglesTest, AnInvertedTriangleIsInadmissible) {
  const auto model = model_of(mixed_plate(), Inertia::None);
  const Values u = linear_field(*model, {-2, 0, 0, 0});
  Balance balance(*model);
  const bool admissible = balance.evaluate(Part::Elastic, {nullptr, nullptr, u.data()}, end_rule());
  EXPECT_EQ(model->space().maximum(admissible ? 1 : 0), 0);
  for (const double force : StateReport(*model, Place{u.data()}).nodal_force(Part::Elastic))
    EXPECT_TRUE(std::isnan(force));
}

TEST(TrianglesTest, MirroredTrianglesAreTurnedAndInvertedOnesRefused) {
  Mesh mesh = mixed_plate();
  const Mesh original = mesh;
  for (ElementBlock& block : mesh.blocks) {
    const auto n = static_cast<std::size_t>(nodes_per_cell(block.type));
    for (std::size_t first = 0; first < block.nodes.size(); first += n)
      std::reverse(block.nodes.begin() + static_cast<std::ptrdiff_t>(first + 1),
                   block.nodes.begin() + static_cast<std::ptrdiff_t>(first + n));
  }
  mesh.side_sets.clear();
  turn_cells(mesh);
  EXPECT_NO_THROW(check_cells(mesh));
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) EXPECT_EQ(mesh.blocks[b].nodes, original.blocks[b].nodes);
  std::swap(mesh.blocks[1].nodes[0], mesh.blocks[1].nodes[1]);
  EXPECT_NE(test::refusal([&] { check_cells(mesh); }).find("inverted or degenerate"), std::string::npos);
}

TEST(TrianglesTest, AnEdgeOfATriangleChangesAsFarAsItTurns) {
  const auto model = model_of(mixed_plate(), Inertia::None);
  const Values from = test::at_rest(*model), to = linear_field(*model, {0, -0.1, 0.1, 0});
  // An edge e changes by 0.1 |e|; its mean has the length |e| sqrt(1 + 0.05^2).
  EXPECT_NEAR(edge_change(*model, from.data(), to.data()), 0.1 / std::sqrt(1 + 0.05 * 0.05), 1e-13);
}

TEST(TrianglesTest, QualityIsOneForEquilateralTriangles) {
  Mesh mesh;
  mesh.coordinates = {0, 0, 1, 0, 0.5, std::sqrt(0.75), 1.5, std::sqrt(0.75)};
  mesh.blocks = {{"body", CellType::Tri3, {0, 1, 2, 1, 3, 2}}};
  const MeshQuality quality = mesh_quality(mesh);
  EXPECT_NEAR(quality.least_scaled_jacobian, 1, 1e-14);
}

TEST(TrianglesTest, RemediesForLockingAreRefusedForThem) {
  for (const auto& [remedy, words] : {std::pair(Formulation::MeanDilatation, "the strain of Tri3 cells is constant"),
                                      std::pair(Formulation::Enhanced, "Tri3 cells have no Enhanced formulation")})
    test::expect_contains(test::refusal([&, own = remedy] { model_of(mixed_plate(), Inertia::None, own); }),
                          std::string("block \"triangles\": ") + words);
}

}  // namespace
}  // namespace ixos
