// Triangles, tetrahedra, prisms and pyramids in bodies: patch tests, modes without energy, mass, tangents, mixtures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "balance/balance.hpp"
#include "element/eigenvalue_count.hpp"
#include "fem/cell_info.hpp"
#include "fem/shape_table.hpp"
#include "fem/with_element.hpp"
#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/van_der_waals.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/quality.hpp"
#include "mesh/soundness.hpp"
#include "mesh/turned_cells.hpp"
#include "model/state_report.hpp"
#include "model/surface_interaction.hpp"
#include "support/comparison.hpp"
#include "support/derivative.hpp"
#include "support/refusal.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"
#include "support/simplices.hpp"
#include "support/solids.hpp"
#include "support/tangents.hpp"
#include "time/catalogue.hpp"

namespace ixos {
namespace {

using Values = std::vector<double>;

/// Cells, their order, and whether they have bubbles.
struct Family {
  std::string kind;
  int order;
  bool bubbles;
};
std::ostream& operator<<(std::ostream& out, const Family& family) {
  return out << family.kind << " of order " << family.order << (family.bubbles ? " with bubbles" : "");
}

std::vector<Family> families() {
  std::vector<Family> all;
  for (const char* kind : {"triangles", "quads and triangles", "tetrahedra", "prisms", "pyramids",
                           "hexahedra to tetrahedra", "hexahedra and prisms"})
    for (const auto& [order, bubbles] : {std::pair{1, false}, {2, false}, {2, true}})
      all.push_back({kind, order, bubbles});
  return all;
}

int dimension_of(const Family& family) {
  return family.kind.find("tri") == 0 || family.kind.find("quads") == 0 ? 2 : 3;
}

enum class Shape { Straight, Curved };

/// A body of 2 by 1 (by 1) above 0.3 whose inner nodes are moved.
Mesh body(const Family& family, Shape shape = Shape::Straight) {
  const int d = dimension_of(family);
  BoxShape box_shape;
  box_shape.dimension = d;
  box_shape.lengths = {2, 1, 1};
  box_shape.divisions = {4, 2, 2};
  box_shape.lower = {-1, d == 2 ? 0.3 : -0.5, 0.3};
  Mesh mesh = test::split_cells(box(box_shape), family.kind);
  test::distort(mesh, 0.05);
  if (family.order == 2) raise_order(mesh);
  if (family.order == 2 && shape == Shape::Curved) test::bend(mesh, 0.02);
  if (family.bubbles) add_bubbles(mesh);
  check_cells(mesh);
  return mesh;
}

class SimplexFamilies : public testing::TestWithParam<Family> {
 protected:
  std::unique_ptr<Model> model(Shape shape = Shape::Straight, Inertia inertia = Inertia::None, double nu = 0.3) const {
    Material material = test::elastic(neo_hooke, nu);
    if (GetParam().bubbles && nu > 0.4) material.formulation = Formulation::MeanDilatation;
    return test::model_of(body(GetParam(), shape), material, inertia);
  }
  std::size_t d() const { return static_cast<std::size_t>(dimension_of(GetParam())); }
};

/// u_i = sum_j A_ij x_j.
Values affine(const Model& model, double size) {
  Values u = test::at_rest(model);
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  for (std::size_t k = 0; k < u.size(); ++k)
    for (std::size_t j = 0; j < d; ++j)
      u[k] += size * std::sin(1.0 + 3.0 * static_cast<double>(k % d) + static_cast<double>(j)) *
              model.mesh().coordinates[k - k % d + j];
  return u;
}

void expect_no_force_inside(const Model& model) {
  const Values u = affine(model, 0.2);
  Balance balance(model);
  ASSERT_TRUE(balance.evaluate(Part::Elastic, {nullptr, nullptr, u.data()}, end_rule()));
  const Values& x = model.mesh().coordinates;
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  double within = 0, outside = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(model.space().owned()); ++k) {
    const double* place = &x[k - k % d];
    bool inside = std::abs(place[0]) < 1 - 1e-9 && place[d - 1] > 0.3 + 1e-9 && place[d - 1] < 1.3 - 1e-9;
    if (d == 3) inside = inside && std::abs(place[1]) < 0.5 - 1e-9;
    double& largest = inside ? within : outside;
    largest = std::max(largest, std::abs(balance.force(Part::Elastic)[k]));
  }
  within = model.space().maximum(within);
  outside = model.space().maximum(outside);
  EXPECT_GT(outside, 0.005);
  EXPECT_LT(within, 1e-12 * std::max(0.1, outside));  // of nearly incompressible bodies the stresses are large
}

TEST_P(SimplexFamilies, AConstantStrainHasNoForceInside) {
  for (const Shape shape : {Shape::Straight, Shape::Curved}) {
    expect_no_force_inside(*model(shape));
    if (GetParam().bubbles) expect_no_force_inside(*model(shape, Inertia::None, 0.4999));
  }
}

TEST_P(SimplexFamilies, TheMassOfALinearFieldIsExact) {
  // The points of curved quadrilaterals and hexahedra are those of their stress.
  const bool has_cubes = GetParam().kind.find("quads") == 0 || GetParam().kind.find("hexahedra") == 0;
  for (const Shape shape : {Shape::Straight, Shape::Curved}) {
    if (shape == Shape::Curved && has_cubes) continue;
    const auto own = model(shape, Inertia::Consistent);
    Values v = own->mesh().coordinates, p = test::at_rest(*own);
    own->mass()->multiply(v.data(), p.data());
    double sum = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(own->space().owned()); ++k) sum += v[k] * p[k];
    own->space().sum(&sum, 1);
    const double high = (std::pow(1.3, 3) - std::pow(0.3, 3)) / 3;
    EXPECT_NEAR(sum, d() == 2 ? 2.0 / 3 + 2 * high : 2.0 / 3 + 2.0 / 12 + 2 * high, 1e-12);
  }
}

TEST_P(SimplexFamilies, TheLumpedMassIsPositiveAndWhole) {
  if (GetParam().order == 2 && !GetParam().bubbles) {
    test::expect_contains(test::refusal([&] { model(Shape::Straight, Inertia::Lumped); }),
                          "cells have no lumped mass as accurate as their displacements");
    return;
  }
  for (const Shape shape : {Shape::Straight, Shape::Curved}) {
    const auto own = model(shape, Inertia::Lumped);
    Values diagonal(static_cast<std::size_t>(own->space().local()), 0.0);
    own->mass()->add_diagonal(1, diagonal.data());
    double sum = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(own->space().owned()); ++k) {
      EXPECT_GT(diagonal[k], 0);
      sum += diagonal[k];
    }
    own->space().sum(&sum, 1);
    EXPECT_NEAR(sum, 2 * static_cast<double>(d()), 1e-12);
  }
}

TEST_P(SimplexFamilies, TheTangentIsTheDerivativeOfTheForce) {
  for (const double nu : {0.3, 0.4999}) {
    const auto own = model(Shape::Curved, Inertia::None, nu);
    const Values from = test::smooth_field(*own, 0.02), to = test::smooth_field(*own, -0.03),
                 way = test::noise(*own, 1);
    for (const Rule& rule : {end_rule(), gauss_rule(2)}) {
      const auto force = [&](double s) {
        Balance balance(*own);
        const Values u = test::moved(to, s, way);
        EXPECT_TRUE(balance.evaluate(Part::Elastic, {from.data(), nullptr, u.data()}, rule));
        return balance.force(Part::Elastic);
      };
      Values values = test::no_values(*own);
      TermSums(*own).add_tangent(Part::Elastic, {from.data(), nullptr, to.data()}, rule, Tangent::Exact, values.data());
      const Values product = test::matrix_product(*own, values.data(), way);
      const double step = 1e-5;
      const Values above = force(step), below = force(-step);
      double largest = 0;
      for (const double own_product : product) largest = std::max(largest, std::abs(own_product));
      largest = own->space().maximum(largest);
      for (std::size_t k = 0; k < product.size(); ++k)
        EXPECT_NEAR((above[k] - below[k]) / (2 * step), product[k], 1e-6 * largest) << k;
    }
  }
}

/// A material whose points are those of quadrilaterals has those that the cells need, also with one point a direction.
TEST_P(SimplexFamilies, TwoPointsADirectionAreTheCellsOwn) {
  if (GetParam().kind.find("quads") == 0 || GetParam().kind.find("hexahedra") == 0) return;
  const auto energy = [&](int points) {
    Material material = test::elastic(neo_hooke, 0.3);
    material.points = points;
    const auto own = test::model_of(body(GetParam(), Shape::Curved), material, Inertia::None);
    const Values u = test::smooth_field(*own, 0.1);
    return StateReport(*own, Place{u.data()}).energy(Part::Elastic);
  };
  EXPECT_EQ(energy(2), energy(0));
  EXPECT_EQ(energy(1), energy(0));
  if (GetParam().order == 2) {
    EXPECT_NE(energy(3), energy(0)) << "linear cells may have the same by chance";
  }
}

/// A surface above a wall: the energy per area is that of the gap, the force its slope.
TEST_P(SimplexFamilies, TheBottomFeelsAWallAsAPlaneDoes) {
  const auto own = model();
  SurfaceInteraction wall;
  wall.side_set = "bottom";
  wall.law = gap_law(VanDerWaals(2.5, 25));
  wall.obstacle = make_obstacle("Half-Space", dimension_of(GetParam()), {});
  add_interaction(*own, wall);
  const Values u = test::at_rest(*own);
  const StateReport report(*own, Place{u.data()});
  const Pack gap = 0.3;
  EXPECT_NEAR(report.energy(Part::Interaction), 2 * wall.law->energy(gap)[0], 1e-12);
  const Values traction = test::ReportAt(*own, u.data()).interaction_traction();
  for (std::size_t node = 0; node < static_cast<std::size_t>(own->mesh().owned_nodes); ++node) {
    const bool below = own->mesh().coordinates[node * d() + d() - 1] < 0.3 + 1e-9;
    EXPECT_NEAR(traction[node * d() + d() - 1], below ? wall.law->traction(gap)[0] : 0.0, 1e-11) << node;
  }
  double force = 0;
  const Values forces = report.nodal_force(Part::Interaction);
  for (std::size_t k = d() - 1; k < static_cast<std::size_t>(own->space().owned()); k += d()) force += forces[k];
  own->space().sum(&force, 1);
  EXPECT_NEAR(std::abs(force), 2 * std::abs(wall.law->traction(gap)[0]), 1e-12);
}

TEST_P(SimplexFamilies, MirroredCellsAreTurned) {
  Mesh mesh = body(GetParam());
  const Mesh original = mesh;
  for (std::size_t k = 0; k < mesh.coordinates.size(); k += d()) mesh.coordinates[k] *= -1;
  EXPECT_NE(test::refusal([&] { check_cells(mesh); }).find("inverted or degenerate"), std::string::npos);
  turn_cells(mesh);
  EXPECT_NO_THROW(check_cells(mesh));
  const auto energy = [](const Mesh& own) {
    const auto turned = test::model_of(own, test::elastic(neo_hooke, 0.3), Inertia::None);
    Values u = test::at_rest(*turned);
    const auto d = static_cast<std::size_t>(own.dimension);
    for (std::size_t k = 0; k < u.size(); k += d) {  // even in x, along x odd
      const double x = turned->mesh().coordinates[k], y = turned->mesh().coordinates[k + 1];
      u[k] = 0.1 * std::sin(x) * y;
      u[k + 1] = 0.1 * std::cos(2 * x) * y;
    }
    return StateReport(*turned, Place{u.data()}).energy(Part::Elastic);
  };
  EXPECT_NEAR(energy(mesh), energy(original), 1e-13);
  for (const SideSet& set : mesh.side_sets) EXPECT_NO_THROW(require_outer_sides(mesh, set));
}

INSTANTIATE_TEST_SUITE_P(All, SimplexFamilies, testing::ValuesIn(families()), [](const auto& test) {
  std::string name = test.param.kind + std::to_string(test.param.order) + (test.param.bubbles ? "Bubbles" : "");
  name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
  return name;
});

/// The stiffness of one undeformed cell has no more modes without energy than rigid motions.
TEST(SimplicesSerialTest, OneCellHasOnlyRigidMotionsWithoutEnergy) {
  if (test::world()->getSize() > 1) return;
  for (const CellInfo& info : cell_infos()) {
    if (is_cube(info.type)) continue;
    Mesh mesh;
    mesh.dimension = info.dimension;
    ElementBlock block{"body", info.type, {}};
    with_element(info.type, [&](auto tag) {
      using Element = typename decltype(tag)::type;
      if constexpr (HasRule<Element>::value)
        for (std::size_t a = 0; a < Element::nodes; ++a) {
          for (const double x : Element::place(a)) mesh.coordinates.push_back(x);
          block.nodes.push_back(static_cast<int>(a));
        }
    });
    mesh.blocks = {block};
    for (const Formulation formulation : {Formulation::Standard, Formulation::MeanDilatation}) {
      if (formulation == Formulation::MeanDilatation && !info.bubbles) continue;
      Material material = test::elastic(neo_hooke, 0.3);
      material.formulation = formulation;
      const auto model = test::model_of(mesh, material, Inertia::None);
      const Values u = test::at_rest(*model);
      Values values = test::no_values(*model);
      TermSums(*model).add_tangent(Part::Elastic, {nullptr, nullptr, u.data()}, end_rule(), Tangent::Exact,
                                   values.data());
      const int zero = with_element(info.type, [&](auto tag) {
        using Element = typename decltype(tag)::type;
        Small<double, std::size_t{Element::nodes} * Element::dimension> k{};
        for (std::size_t column = 0; column < k.size(); ++column) {
          Values unit = u;
          unit[column] = 1;
          const Values product = test::matrix_product(*model, values.data(), unit);
          for (std::size_t row = 0; row < k.size(); ++row) k[row][column] = product[row];
        }
        return test::eigenvalues_below(k, 1e-9);
      });
      EXPECT_EQ(zero, info.dimension == 2 ? 3 : 6) << info.name;
    }
  }
}

TEST(SimplicesTest, MixturesThatDoNotConformAreRefused) {
  Mesh mesh = body({"hexahedra to tetrahedra", 2, false});
  mesh.blocks.push_back({"body", CellType::Tet15, {}});
  Mesh both = mesh;
  add_bubbles(both);
  EXPECT_NO_THROW(require_one_order(both));
  both.blocks.push_back(mesh.blocks[0]);
  for (const ElementBlock& block : mesh.blocks)
    if (block.type == CellType::Tet10) both.blocks.push_back(block);
  test::expect_contains(test::refusal([&] { require_one_order(both); }), "which do not conform");
  // Tetrahedra beside a hexahedron's face.
  BoxShape shape;
  shape.dimension = 3;
  shape.divisions = {2, 1, 1};
  const Mesh cubes = box(shape);
  Mesh halves = test::split_cells(cubes, "tetrahedra");
  ElementBlock left{"body", CellType::Hex8, {cubes.blocks[0].nodes.begin(), cubes.blocks[0].nodes.begin() + 8}};
  halves.blocks[0].nodes.erase(halves.blocks[0].nodes.begin(), halves.blocks[0].nodes.begin() + 24);
  halves.blocks.push_back(left);
  test::expect_contains(test::refusal([&] { refuse_split_faces(halves); }), "a pyramid must stand between");
  EXPECT_NO_THROW(refuse_split_faces(body({"hexahedra to tetrahedra", 1, false})));
}

TEST(SimplicesTest, BubblesStandWhereTheQuadraticMapPutsThem) {
  for (const char* kind : {"triangles", "tetrahedra", "prisms", "pyramids"}) {
    Mesh mesh = body({kind, 2, true}, Shape::Curved);
    EXPECT_NO_THROW(require_placed_bubbles(mesh)) << kind;
    const Mesh right = mesh;
    mesh.coordinates.back() += 0.01;  // the last node is one
    test::expect_contains(test::refusal([&] { require_placed_bubbles(mesh); }), "place_bubbles() moves such nodes");
    place_bubbles(mesh);
    EXPECT_NO_THROW(require_placed_bubbles(mesh)) << kind;
    for (std::size_t k = 0; k < mesh.coordinates.size(); ++k)
      EXPECT_NEAR(mesh.coordinates[k], right.coordinates[k], 1e-14);
  }
}

TEST(SimplicesTest, QualityIsOneForRegularCells) {
  const auto quality = [](CellType type, int dimension, const Values& x) {
    Mesh mesh;
    mesh.dimension = dimension;
    mesh.coordinates = x;
    ElementBlock block{"body", type, {}};
    for (int a = 0; a < nodes_per_cell(type); ++a) block.nodes.push_back(a);
    mesh.blocks = {block};
    const MeshQuality found = mesh_quality(mesh);
    EXPECT_NEAR(found.largest_aspect_ratio, 1, 1e-14);
    return std::pair(found.least_scaled_jacobian, found.volume);
  };
  const double h = std::sqrt(0.75), r = std::sqrt(0.5);
  const auto expect = [](const std::pair<double, double>& found, double volume) {
    EXPECT_NEAR(found.first, 1, 1e-14);
    EXPECT_NEAR(found.second, volume, 1e-14);
  };
  expect(quality(CellType::Tet4, 3, {0, 0, 0, 1, 0, 0, 0.5, h, 0, 0.5, h / 3, std::sqrt(2.0 / 3)}),
         1 / (6 * std::sqrt(2.0)));
  expect(quality(CellType::Prism6, 3, {0, 0, 0, 1, 0, 0, 0.5, h, 0, 0, 0, 1, 1, 0, 1, 0.5, h, 1}), h / 2);
  expect(quality(CellType::Pyr5, 3, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, r}), r / 3);
}

TEST(SimplicesTest, FormulationsThatDoNotServeAreRefused) {
  const auto refusal = [](const Family& family, Formulation formulation) {
    return test::refusal([&] {
      Material material = test::elastic(neo_hooke, 0.3);
      material.formulation = formulation;
      test::model_of(body(family), material, Inertia::None);
    });
  };
  for (const char* kind : {"triangles", "tetrahedra"}) {
    test::expect_contains(refusal({kind, 1, false}, Formulation::MeanDilatation), "the strain of T");
    test::expect_contains(refusal({kind, 1, false}, Formulation::Enhanced), "have no Enhanced formulation");
    test::expect_contains(refusal({kind, 2, false}, Formulation::MeanDilatation), "too few nodes for Mean Dilatation");
  }
  test::expect_contains(refusal({"prisms", 1, false}, Formulation::MeanDilatation), "Cell Order 2");
  test::expect_contains(refusal({"prisms", 2, true}, Formulation::Enhanced), "quadratic cells do not lock");
}

}  // namespace
}  // namespace ixos
