// Fields that an output may ask for: stresses of homogeneous states, gaps and pressures before walls.
#include <gtest/gtest.h>

#include <cmath>

#include "discretization/nodal_measure.hpp"
#include "interaction/van_der_waals.hpp"
#include "io/output_mesh.hpp"
#include "mesh/cell_order.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "model/model.hpp"
#include "support/contact_element.hpp"
#include "support/reports.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"
#include "term/wall/surface_terms.hpp"

namespace ixos {
namespace {

using test::at_rest;
using test::elastic;
using test::model_of;
using test::noise;

constexpr double nu = 0.3;
const Lame lame = lame_constants(1, nu);

Mesh block(int dimension, int order = 1) {
  BoxShape shape;
  shape.dimension = dimension;
  shape.lower = {0.1, -0.4, 0.3};
  shape.lengths = {2.0, 1.5, 1.0};
  shape.divisions = {3, 2, 2};
  Mesh mesh = box(shape);
  if (order == 2) raise_order(mesh);
  return mesh;
}

/// Returns `factor` times the first coordinate as the first component of a local array.
std::vector<double> stretched(const Model& model, double factor) {
  std::vector<double> u = at_rest(model);
  const auto d = static_cast<std::size_t>(model.mesh().dimension);
  for (std::size_t i = 0; i < u.size(); i += d) u[i] = factor * model.mesh().coordinates[i];
  return u;
}

/// Expects the stress in all cells of a model of one block.
void expect_stress(const Model& model, const std::vector<double>& u, const std::vector<double>& v,
                   const SymmetricTensor& expected) {
  const auto stress = test::ReportAt(model, u.data(), v.data()).cell_stress();
  ASSERT_EQ(stress.size(), 1U);
  ASSERT_EQ(stress[0].size(), static_cast<std::size_t>(model.mesh().blocks[0].cells()));
  for (const SymmetricTensor& cell : stress[0])
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(cell[i], expected[i], 1e-13) << i;
}

// F = diag(s, 1, 1): sigma_11 = (mu (s^2 - 1) + lambda ln s)/s, sigma_22 = sigma_33 = lambda ln s/s.
TEST(ModelFieldsTest, StressOfAUniaxialStretchIsTheClosedForm) {
  const double s = 1.3, across = lame.lambda * std::log(s) / s, along = lame.mu * (s * s - 1) / s + across;
  for (int dimension : {2, 3})
    for (int order : {1, 2})
      for (Formulation formulation : {Formulation::Standard, Formulation::MeanDilatation, Formulation::Enhanced}) {
        if (order == 2 && formulation == Formulation::Enhanced) continue;
        Material material = elastic(neo_hooke, nu);
        material.formulation = formulation;
        const auto model = model_of(block(dimension, order), material, Inertia::None);
        expect_stress(*model, stretched(*model, s - 1), at_rest(*model), {along, across, across, 0, 0, 0});
      }
}

// The rate of Green's strain is s g: sigma_11 = alpha (2 mu + lambda) s g + ..., see CellMeansTest.
TEST(ModelFieldsTest, ViscosityAddsItsStress) {
  const double s = 1.3, g = 0.2, alpha = 0.4;
  for (int dimension : {2, 3}) {
    Material material = elastic(neo_hooke, nu);
    material.viscosity = alpha;
    const auto model = model_of(block(dimension), material, Inertia::Consistent);
    const double side = lame.lambda * std::log(s) / s, elastic_part = lame.mu * (s * s - 1) / s + side;
    const double along = alpha * (2 * lame.mu + lame.lambda) * s * s * g, across = alpha * lame.lambda * g;
    expect_stress(*model, stretched(*model, s - 1), stretched(*model, g),
                  {elastic_part + along, side + across, side + across, 0, 0, 0});
    expect_stress(*model, stretched(*model, s - 1), at_rest(*model), {elastic_part, side, side, 0, 0, 0});
  }
}

TEST(ModelFieldsTest, TheTraceOfTheStressIsTheFirstInvariant) {
  for (int dimension : {2, 3})
    for (Formulation formulation : {Formulation::Standard, Formulation::MeanDilatation, Formulation::Enhanced}) {
      Material material = elastic(neo_hooke, nu);
      material.formulation = formulation;
      const auto model = model_of(block(dimension), material, Inertia::None);
      const std::vector<double> u = noise(*model, 0.03);
      const auto stress = test::ReportAt(*model, u.data(), u.data()).cell_stress();
      const std::vector<double> invariant =
          test::ReportAt(*model, u.data()).cell_fields()[0].stress_invariant;  // E is 1
      for (std::size_t cell = 0; cell < invariant.size(); ++cell) {
        EXPECT_NEAR(stress[0][cell][0] + stress[0][cell][1] + stress[0][cell][2], invariant[cell], 1e-14);
        EXPECT_GT(std::abs(stress[0][cell][3]), 1e-6);
      }
    }
}

TEST(ModelFieldsTest, TheFirstInvariantHasTheStressOfViscosityAndBranches) {
  for (int dimension : {2, 3})
    for (const bool viscous : {false, true})
      for (Formulation formulation : {Formulation::Standard, Formulation::MeanDilatation}) {
        if (viscous && formulation != Formulation::Standard) continue;  // not offered
        Material material = elastic(neo_hooke, nu);
        material.formulation = formulation;
        if (viscous)
          material.viscosity = 0.4;
        else
          material.branches = {{0.5, 0.1}, {0.2, 3}};
        const auto model = model_of(block(dimension), material, Inertia::Consistent);
        const std::vector<double> u = noise(*model, 0.03), v = stretched(*model, 0.2);
        const auto stress = test::ReportAt(*model, u.data(), v.data()).cell_stress();
        const std::vector<double> invariant =
                                      test::ReportAt(*model, u.data(), v.data()).cell_fields()[0].stress_invariant,
                                  elastic_part = test::ReportAt(*model, u.data()).cell_fields()[0].stress_invariant;
        double most = 0;
        for (std::size_t cell = 0; cell < invariant.size(); ++cell) {
          EXPECT_NEAR(stress[0][cell][0] + stress[0][cell][1] + stress[0][cell][2], invariant[cell], 1e-14);
          most = std::max(most, std::abs(invariant[cell] - elastic_part[cell]));
        }
        // The stress of branches has no trace.
        if (viscous) {
          EXPECT_GT(model->space().maximum(most), 1e-2);
        } else {
          EXPECT_LT(model->space().maximum(most), 1e-14);
        }
      }
}

constexpr ContactElement elements[] = {ContactElement::Q1C1, ContactElement::Q1C2, ContactElement::Q1C3,
                                       ContactElement::Q1C4, ContactElement::Q1CH, ContactElement::Q2C2,
                                       ContactElement::Q2C4};
const HalfSpace tilted{{0.3, -0.9, -0.6}, {0.48, 0.6, 0.64}}, tilted_2d{{0.3, -1.2, 0}, {-0.28, 0.96, 0}};
const VanDerWaals law(2.5, 25);

/// A block whose lowest side, enriched, is before a wall.
struct Wall {
  Wall(int dimension, ContactElement element, bool flat = true)
      : Wall(dimension == 2 ? tilted_2d : tilted, dimension, element, flat) {}
  Wall(const HalfSpace& wall, int dimension, ContactElement element, bool flat) : plane(wall) {
    Mesh mesh = block(dimension);
    test::give_contact_element(mesh, set, element);
    model = model_of(mesh, elastic(neo_hooke, nu), Inertia::None);
    add(flat, plane, set);
  }
  /// Adds a flat wall before a side set, in the scalar path or in the general one.
  void add(bool flat, const HalfSpace& wall, const std::string& before) {
    const LocalMesh& local = model->mesh();
    const auto& sides = local.side_sets[local.side_set(before)];
    auto terms = flat ? make_flat_terms(local, sides, model->pattern(), gap_law(law), wall, {})
                      : make_curved_terms(local, sides, model->pattern(), gap_law(law), flat_wall(wall), {});
    for (auto& term : terms) model->add_interaction(std::move(term));
  }

  const std::string set = "bottom";
  HalfSpace plane;
  std::unique_ptr<Model> model;
};

/// Small, so that no point crosses the wall.
std::vector<double> displacement(const Model& model) { return noise(model, 0.01); }

template <class Check>
void for_walls(const Check& check) {
  for (int dimension : {2, 3})
    for (ContactElement element : elements) check(Wall(dimension, element));
}

// The gap is linear in the place, so the elements interpolate it without error.
TEST(ModelFieldsTest, GapsBeforeAWallAreDistancesAtAllNodesOfTheOutput) {
  for_walls([](const Wall& wall) {
    const Model& model = *wall.model;
    const auto d = static_cast<std::size_t>(model.mesh().dimension);
    const std::vector<double> u = displacement(model);
    std::vector<double> gap = test::ReportAt(model, u.data()).nodal_gap(), local = at_rest(model);
    for (std::size_t node = 0; node < gap.size(); ++node) local[node * d] = gap[node];
    model.space().update_ghosts(local.data());
    for (std::size_t node = 0; node < gap.size(); ++node) gap[node] = local[node * d];
    const OutputMesh output(model.mesh(), model.space().comm()->getSize());
    const std::vector<double> shown = output.nodal(gap);
    std::vector<std::vector<double>> moved;
    for (std::size_t i = 0; i < d; ++i) {
      std::vector<double> component(gap.size());
      for (std::size_t node = 0; node < gap.size(); ++node) component[node] = u[node * d + i];
      moved.push_back(output.nodal(component));
    }
    double found = 0;
    for (std::size_t node = 0; node < shown.size(); ++node) {
      const double* x = &output.mesh.coordinates[node * d];
      const bool lowest = std::abs(x[d - 1] - (d == 2 ? -0.4 : 0.3)) < 1e-9;
      EXPECT_EQ(std::isnan(shown[node]), !lowest) << node;
      double distance = 0;
      for (std::size_t i = 0; i < d; ++i)
        distance += (x[i] + moved[i][node] - wall.plane.point[i]) * wall.plane.normal[i];
      if (lowest) {
        EXPECT_NEAR(shown[node], distance, 1e-13) << node;
      }
      found += lowest ? 1 : 0;
    }
    model.space().sum(&found, 1);
    EXPECT_GE(found, d == 2 ? 4 : 12);
  });
}

// int N_a T dA over int N_a dA: times the nodal areas it is the whole force, along the normal.
TEST(ModelFieldsTest, PressureTimesAreaIsTheForceOfTheWall) {
  for_walls([](const Wall& wall) {
    const Model& model = *wall.model;
    const LocalMesh& mesh = model.mesh();
    const auto d = static_cast<std::size_t>(mesh.dimension);
    const std::vector<double> u = displacement(model), pressure = test::ReportAt(model, u.data()).contact_pressure();
    const std::vector<double> traction = test::ReportAt(model, u.data()).interaction_traction();
    std::vector<double> area(static_cast<std::size_t>(mesh.nodes()), 0.0);
    add_side_measure(mesh, mesh.side_sets[mesh.side_set(wall.set)], area);
    double force = 0;
    for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.owned_nodes); ++node) {
      double along = 0;
      for (std::size_t i = 0; i < d; ++i) along += traction[node * d + i] * wall.plane.normal[i];
      EXPECT_NEAR(pressure[node], along, 1e-14);
      force += pressure[node] * area[node];
    }
    model.space().sum(&force, 1);
    const InteractionReport report = test::ReportAt(model, u.data()).interaction_report();
    EXPECT_GT(std::abs(force), 1e-6);
    for (std::size_t i = 0; i < d; ++i) EXPECT_NEAR(force * wall.plane.normal[i], report.force[i], 1e-13);
  });
}

// The second wall acts on the whole surface, so the bottom has two interactions: its area counts once.
TEST(ModelFieldsTest, TractionsOfSeveralInteractionsAddUp) {
  for (int dimension : {2, 3})
    for (ContactElement element : elements)
      for (const char* before : {"bottom", "surface"}) {
        Wall wall(dimension, element);
        const Model& model = *wall.model;
        const std::vector<double> u = displacement(model), alone = test::ReportAt(model, u.data()).contact_pressure();
        wall.add(true, wall.plane, before);
        const LocalMesh& mesh = model.mesh();
        const auto d = static_cast<std::size_t>(dimension);
        const std::vector<double> pressure = test::ReportAt(model, u.data()).contact_pressure();
        const std::vector<double> traction = test::ReportAt(model, u.data()).interaction_traction();
        std::vector<double> area(static_cast<std::size_t>(mesh.nodes()), 0.0);
        add_side_measure(mesh, mesh.side_sets[mesh.side_set(before)], area);
        double force = 0;
        for (std::size_t node = 0; node < static_cast<std::size_t>(mesh.owned_nodes); ++node) {
          double along = 0;
          for (std::size_t i = 0; i < d; ++i) along += traction[node * d + i] * wall.plane.normal[i];
          EXPECT_NEAR(pressure[node], along, 1e-14);
          if (before == wall.set) {
            EXPECT_NEAR(pressure[node], 2 * alone[node], 1e-14);
          }
          force += pressure[node] * area[node];
        }
        model.space().sum(&force, 1);
        const InteractionReport report = test::ReportAt(model, u.data()).interaction_report();
        EXPECT_GT(std::abs(force), 1e-6);
        for (std::size_t i = 0; i < d; ++i) EXPECT_NEAR(force * wall.plane.normal[i], report.force[i], 1e-13);
      }
}

// The second wall is farther away and has another normal: neither gaps nor their derivatives may be its own.
TEST(ModelFieldsTest, TheGapIsThatOfTheNearestObstacleInAnyOrder) {
  for (int dimension : {2, 3})
    for (ContactElement element : elements)
      for (bool flat : {true, false}) {
        const Wall near(dimension, element, flat);
        HalfSpace far{{0, -9, 0}, {0, 1, 0}};
        if (dimension == 3) far = {{0, 0, -9}, {0, 0, 1}};
        const std::vector<double> u = displacement(*near.model),
                                  gap = test::ReportAt(*near.model, u.data()).nodal_gap();
        for (bool far_first : {false, true}) {
          Wall both(far_first ? far : near.plane, dimension, element, flat);
          both.add(flat, far_first ? near.plane : far, both.set);
          const std::vector<double> lowest = test::ReportAt(*both.model, u.data()).nodal_gap();
          for (std::size_t node = 0; node < static_cast<std::size_t>(near.model->mesh().owned_nodes); ++node) {
            EXPECT_EQ(std::isnan(lowest[node]), std::isnan(gap[node]));
            if (!std::isnan(gap[node])) {
              EXPECT_EQ(lowest[node], gap[node]);
            }
          }
        }
      }
}

TEST(ModelFieldsTest, TheGeneralPathGivesTheSame) {
  for (int dimension : {2, 3})
    for (ContactElement element : elements) {
      const Wall flat(dimension, element), general(dimension, element, false);
      const std::vector<double> u = displacement(*flat.model);
      const std::vector<double> gap = test::ReportAt(*flat.model, u.data()).nodal_gap(),
                                other = test::ReportAt(*general.model, u.data()).nodal_gap();
      const std::vector<double> pressure = test::ReportAt(*flat.model, u.data()).contact_pressure();
      const std::vector<double> other_pressure = test::ReportAt(*general.model, u.data()).contact_pressure();
      for (std::size_t node = 0; node < static_cast<std::size_t>(flat.model->mesh().owned_nodes); ++node) {
        EXPECT_NEAR(pressure[node], other_pressure[node], 1e-14);
        EXPECT_EQ(std::isnan(gap[node]), std::isnan(other[node]));
        if (!std::isnan(gap[node])) {
          EXPECT_NEAR(gap[node], other[node], 1e-14);
        }
      }
    }
}

/// A sphere of radius 3 far below, with normal and curvature.
class Ball final : public Obstacle {
 public:
  explicit Ball(std::size_t dimension) : center_{1.0, dimension == 2 ? -3.9 : 0.3, dimension == 2 ? 0.0 : -3.2} {}
  ObstacleGap at(const PackPoint& x) const override {
    PackPoint from;
    for (std::size_t i = 0; i < 3; ++i) from[i] = x[i] - center_[i];
    const Pack distance = std::experimental::sqrt(from[0] * from[0] + from[1] * from[1] + from[2] * from[2]);
    ObstacleGap found{distance - 3.0, {}, {}};
    for (std::size_t i = 0; i < 3; ++i) found.normal[i] = from[i] / distance;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        found.bend[i][j] = ((i == j ? 1.0 : 0.0) - found.normal[i] * found.normal[j]) / distance;
    return found;
  }
  double gap(const double* x, std::size_t dimension) const {
    double square = 0;
    for (std::size_t i = 0; i < dimension; ++i) square += (x[i] - center_[i]) * (x[i] - center_[i]);
    return std::sqrt(square) - 3;
  }

 private:
  std::array<double, 3> center_;
};

// A Hermite side carries the gap's derivatives: its cubic is off by h^4/384 times a fourth derivative of about 3/R^3.
// Without the derivatives the error would be of the order h^2/(8 R), 0.02.
TEST(ModelFieldsTest, HermiteSidesInterpolateTheGapToASphere) {
  for (int dimension : {2, 3}) {
    Mesh mesh = block(dimension);
    enrich(mesh, "bottom", ContactElement::Q1CH);
    const auto model = model_of(mesh, elastic(neo_hooke, nu), Inertia::None);
    const LocalMesh& local = model->mesh();
    const auto d = static_cast<std::size_t>(dimension);
    const auto ball = std::make_shared<Ball>(d);
    for (auto& term :
         make_curved_terms(local, local.side_sets[local.side_set("bottom")], model->pattern(), gap_law(law), ball, {}))
      model->add_interaction(std::move(term));
    std::vector<double> gap = test::ReportAt(*model, at_rest(*model).data()).nodal_gap(), values = at_rest(*model);
    for (std::size_t node = 0; node < gap.size(); ++node) values[node * d] = gap[node];
    model->space().update_ghosts(values.data());
    for (std::size_t node = 0; node < gap.size(); ++node) gap[node] = values[node * d];
    const OutputMesh output(local, model->space().comm()->getSize());
    const std::vector<double> shown = output.nodal(gap);
    for (std::size_t node = 0; node < shown.size(); ++node)
      if (!std::isnan(shown[node])) {
        EXPECT_NEAR(shown[node], ball->gap(&output.mesh.coordinates[node * d], d), 1.5e-4) << node;
      }
  }
}

}  // namespace
}  // namespace ixos
