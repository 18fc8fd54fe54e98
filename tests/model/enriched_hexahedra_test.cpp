// Hexahedra with enriched contact faces in the model, with tied edges and free ones: mass, energies, forces, tangents,
// surfaces, loads, probes.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <tuple>

#include "discretization/material_point.hpp"
#include "discretization/nodal_measure.hpp"
#include "interaction/van_der_waals.hpp"
#include "mesh/enrichment/enrich.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/partition.hpp"
#include "mesh/selection.hpp"
#include "model/model.hpp"
#include "support/contact_element.hpp"
#include "term/wall/surface_terms.hpp"

#include <Tpetra_Core.hpp>
#include "model/term_sums.hpp"
#include "support/reports.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

const ContactElement elements[] = {ContactElement::Q1C1, ContactElement::Q1C2, ContactElement::Q1C3,
                                   ContactElement::Q1C4, ContactElement::Q1CH, ContactElement::Q2C2,
                                   ContactElement::Q2C4};
const VanDerWaals law(2.5, 25);

/// A box of 4 by 3 by 2, the bottom enriched up to x = 2: its rim is tied there and free elsewhere.
LocalMesh body(ContactElement element, bool distorted) {
  BoxShape shape;
  shape.dimension = 3;
  shape.lengths = {4, 3, 2};
  shape.divisions = {4, 3, 2};
  Mesh mesh = box(shape);
  for (std::size_t k = 0; k < mesh.coordinates.size() && distorted; ++k) {
    double& x = mesh.coordinates[k];
    if (x > 0 && x < shape.lengths[k % 3]) x += 0.15 * std::sin(7.0 * static_cast<double>(k));
  }
  add_side_set(mesh, "patch", "bottom", {{}, {2.5, 3, 2}});
  test::give_contact_element(mesh, "patch", element);
  const Comm comm = Tpetra::getDefaultComm();
  return localize(mesh, partition_nodes(mesh, comm->getSize()), comm->getRank(), comm->getSize());
}

Material rubber(test::ElasticLawOfConstants elastic) {
  Material material;
  material.block = "body";
  material.law = elastic(lame_constants(1.0, 0.3));
  material.density = 1.5;
  return material;
}

std::unique_ptr<Model> model_of(ContactElement element, bool distorted, test::ElasticLawOfConstants elastic = neo_hooke,
                                Formulation formulation = Formulation::Standard) {
  Material material = rubber(elastic);
  material.formulation = formulation;
  return std::make_unique<Model>(body(element, distorted), Tpetra::getDefaultComm(), std::vector{material});
}

/// Lets the set interact with a wall at that distance in the direction of an axis.
void add_wall(Model& model, const std::string& set, std::size_t axis, double gap) {
  HalfSpace wall;
  wall.normal = {};
  wall.normal[axis] = 1;
  wall.point[axis] = -gap;
  const LocalMesh& mesh = model.mesh();
  for (auto& term : make_surface_terms(mesh, mesh.side_sets[mesh.side_set(set)], model.pattern(), gap_law(law),
                                       flat_wall(wall), SurfaceOptions{}))
    model.add_interaction(std::move(term));
}

/// G X, per local node.
std::vector<double> affine(const LocalMesh& mesh, const double (&g)[3][3]) {
  std::vector<double> field(mesh.coordinates.size(), 0.0);
  for (std::size_t k = 0; k < field.size(); ++k)
    for (std::size_t j = 0; j < 3; ++j) field[k] += g[k % 3][j] * mesh.coordinates[k - k % 3 + j];
  return field;
}

/// Values without any order, the same on all ranks.
std::vector<double> noise(const LocalMesh& mesh, double amplitude, double phase) {
  std::vector<double> field(mesh.coordinates.size());
  for (std::size_t k = 0; k < field.size(); ++k)
    field[k] = amplitude * std::sin(12.9898 * (3.0 * mesh.original_ids[k / 3] + static_cast<double>(k % 3)) + phase);
  return field;
}

std::vector<double> sum(const std::vector<double>& a, double factor, const std::vector<double>& b) {
  std::vector<double> result(a);
  for (std::size_t k = 0; k < a.size(); ++k) result[k] += factor * b[k];
  return result;
}

/// Owned rows of the matrix of these values times x.
std::vector<double> product(const Pattern& pattern, const std::vector<double>& values, const std::vector<double>& x) {
  std::vector<double> result;
  std::size_t next = 0;
  for (std::size_t row = 0; row < static_cast<std::size_t>(pattern.rows()); ++row)
    for (int i = 0; i < 3; ++i) {
      double entry = 0;
      for (auto p = static_cast<std::size_t>(pattern.row_start()[row]);
           p < static_cast<std::size_t>(pattern.row_start()[row + 1]); ++p)
        for (std::size_t j = 0; j < 3; ++j)
          entry += values[next++] * x[3 * static_cast<std::size_t>(pattern.columns()[p]) + j];
      result.push_back(entry);
    }
  return result;
}

TEST(EnrichedHexahedraTest, MassAndMomentaOfAnAffineVelocityAreExact) {
  const double g[3][3] = {{0.1, -0.7, 0.3}, {0.7, -0.2, -0.4}, {-0.3, 0.4, 0.15}};
  for (ContactElement element : elements) {
    const auto model = model_of(element, false);
    const std::vector<double> v = affine(model->mesh(), g), u(v.size(), 0.0);
    const Momenta momenta = test::ReportAt(*model, u.data(), v.data()).momenta();
    const double mass = 1.5 * 24, centre[3] = {2, 1.5, 1};
    double second[3][3];  // means of X_i X_j
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) second[i][j] = centre[i] * centre[j] * (i == j ? 4.0 / 3.0 : 1.0);
    double energy = 0;
    for (int i = 0; i < 3; ++i) {
      double mean = 0, angular = 0;
      for (int j = 0; j < 3; ++j) {
        mean += g[i][j] * centre[j];
        angular += second[(i + 1) % 3][j] * g[(i + 2) % 3][j] - second[(i + 2) % 3][j] * g[(i + 1) % 3][j];
        for (int k = 0; k < 3; ++k) energy += 0.5 * mass * g[i][j] * g[i][k] * second[j][k];
      }
      EXPECT_NEAR(momenta.linear[static_cast<std::size_t>(i)], mass * mean, 1e-11);
      EXPECT_NEAR(momenta.angular[static_cast<std::size_t>(i)], mass * angular, 1e-11);
    }
    EXPECT_NEAR(momenta.kinetic_energy, energy, 1e-11);
  }
}

TEST(EnrichedHexahedraTest, AStateOfConstantStressBalancesUniformTractionsOnAllSides) {
  // Sides beside the contact face carry loads on their edge's extra nodes too.
  const double e = 0.01;
  const double g[3][3] = {{e, 0, 0}, {0, e, 0}, {0, 0, e}};
  for (ContactElement element : elements) {
    const auto model = model_of(element, true, linear_elastic);
    const LocalMesh& mesh = model->mesh();
    std::vector<double> force(mesh.coordinates.size()), load(force.size(), 0.0);
    const std::vector<double> u = affine(mesh, g);
    TermSums(*model).force(Part::Elastic, {nullptr, nullptr, u.data()}, end_rule(), force.data());
    const Lame lame = lame_constants(1.0, 0.3);
    const double pressure = (3 * lame.lambda + 2 * lame.mu) * e;
    const std::tuple<const char*, std::size_t, double> sides[] = {{"left", 0, -1}, {"right", 0, 1},   {"front", 1, -1},
                                                                  {"back", 1, 1},  {"bottom", 2, -1}, {"top", 2, 1}};
    for (const auto& [set, axis, sign] : sides) {
      std::vector<double> measure(static_cast<std::size_t>(mesh.nodes()), 0.0);
      add_side_measure(mesh, mesh.side_sets[mesh.side_set(set)], measure);
      for (std::size_t n = 0; n < measure.size(); ++n) load[3 * n + axis] += sign * pressure * measure[n];
    }
    for (std::size_t k = 0; k < 3 * static_cast<std::size_t>(mesh.owned_nodes); ++k)
      EXPECT_NEAR(force[k], load[k], 1e-14);
  }
}

TEST(EnrichedHexahedraTest, NodalVolumesSumToTheVolume) {
  for (ContactElement element : elements) {
    const auto model = model_of(element, true);
    const LocalMesh& mesh = model->mesh();
    std::vector<double> measure(static_cast<std::size_t>(mesh.nodes()), 0.0);
    for (const LocalBlock& block : mesh.blocks) add_block_measure(mesh, block, measure);
    double volume = 0;
    for (std::size_t n = 0; n < static_cast<std::size_t>(mesh.owned_nodes); ++n) {
      if (mesh.is_derivative(n)) continue;
      EXPECT_GT(measure[n], 0);
      volume += measure[n];
    }
    model->space().sum(&volume, 1);
    EXPECT_NEAR(volume, 24, 1e-12);
  }
}

TEST(EnrichedHexahedraTest, GapAndForceOfParallelSidesAreThoseOfTheLaw) {
  for (ContactElement element : elements)
    for (const auto& [set, axis, area] : {std::tuple{"patch", 2, 6.0}, std::tuple{"left", 0, 6.0}}) {
      const auto model = model_of(element, true);
      add_wall(*model, set, static_cast<std::size_t>(axis), 0.28);
      const std::vector<double> rest(model->mesh().coordinates.size(), 0.0);
      const InteractionReport report = test::ReportAt(*model, rest.data()).interaction_report();
      EXPECT_NEAR(report.least_gap, 0.28, 1e-14) << set;
      EXPECT_NEAR(report.measure, area, 0.5) << set;  // its edge x = 2 is not straight
      EXPECT_NEAR(report.force[static_cast<std::size_t>(axis)], report.measure * law.traction(0.28), 1e-12) << set;
      EXPECT_NEAR(test::ReportAt(*model, rest.data()).energy(Part::Interaction), report.measure * law.energy(0.28),
                  1e-12)
          << set;
    }
}

TEST(EnrichedHexahedraTest, ForcesAreGradientsOfEnergiesAndTangentsOfForces) {
  const double h = 1e-5;
  const auto check = [h](ContactElement element, Formulation formulation) {
    const auto model = model_of(element, true, neo_hooke, formulation);
    add_wall(*model, "patch", 2, 0.35);
    add_wall(*model, "left", 0, 0.35);
    const LocalMesh& mesh = model->mesh();
    const std::size_t owned = 3 * static_cast<std::size_t>(mesh.owned_nodes);
    const std::vector<double> u = noise(mesh, 0.02, 1), direction = noise(mesh, 1, 2);
    const std::vector<double> ahead = sum(u, h, direction), behind = sum(u, -h, direction);
    const auto compare = [&](const char* what, const auto& energy, const auto& force, const auto& tangent) {
      std::vector<double> f(u.size()), after(f), before(f);
      ASSERT_TRUE(force(u, f) && force(ahead, after) && force(behind, before)) << what;
      double work = 0;
      for (std::size_t k = 0; k < owned; ++k) work += f[k] * direction[k];
      model->space().sum(&work, 1);
      const double slope = (energy(ahead) - energy(behind)) / (2 * h);
      EXPECT_NEAR(work, slope, 1e-7 * (1 + std::abs(slope))) << what;
      std::vector<double> values(9 * static_cast<std::size_t>(model->pattern().pairs()), 0.0);
      tangent(values);
      const std::vector<double> change = product(model->pattern(), values, direction);
      for (std::size_t k = 0; k < owned; ++k)
        EXPECT_NEAR(change[k], (after[k] - before[k]) / (2 * h), 1e-6 * (1 + std::abs(change[k]))) << what;
    };
    const Rule rule = end_rule();
    compare(
        "elastic", [&](const auto& x) { return test::ReportAt(*model, x.data()).energy(Part::Elastic); },
        [&](const auto& x, auto& f) {
          return TermSums(*model).force(Part::Elastic, {nullptr, nullptr, x.data()}, rule, f.data());
        },
        [&](auto& k) {
          TermSums(*model).add_tangent(Part::Elastic, {nullptr, nullptr, u.data()}, rule, Tangent::Exact, k.data());
        });
    compare(
        "interaction", [&](const auto& x) { return test::ReportAt(*model, x.data()).energy(Part::Interaction); },
        [&](const auto& x, auto& f) {
          return TermSums(*model).force(Part::Interaction, {nullptr, nullptr, x.data()}, rule, f.data());
        },
        [&](auto& k) {
          TermSums(*model).add_tangent(Part::Interaction, {nullptr, nullptr, u.data()}, rule, Tangent::Exact, k.data());
        });
  };
  for (ContactElement element : elements)
    for (Formulation formulation : {Formulation::Standard, Formulation::MeanDilatation}) check(element, formulation);
}

TEST(EnrichedHexahedraTest, EveryNodeResists) {
  // No row of mass or stiffness is empty: a tied edge leaves no node behind.
  for (ContactElement element : elements) {
    const auto model = model_of(element, true);
    const Pattern& pattern = model->pattern();
    std::vector<double> stiffness(9 * static_cast<std::size_t>(pattern.pairs()), 0.0), mass(stiffness);
    const std::vector<double> rest(model->mesh().coordinates.size(), 0.0);
    TermSums(*model).add_tangent(Part::Elastic, {nullptr, nullptr, rest.data()}, end_rule(), Tangent::Exact,
                                 stiffness.data());
    model->mass()->add_to(1.0, mass.data());
    for (int row = 0; row < pattern.rows(); ++row)
      for (int i = 0; i < 3; ++i) {
        const auto diagonal = static_cast<std::size_t>(pattern.offset(row, row) + pattern.stride(row) * i + i);
        EXPECT_GT(stiffness[diagonal], 1e-3);
        EXPECT_GT(mass[diagonal], 1e-4);
      }
  }
}

TEST(EnrichedHexahedraTest, AProbeInterpolatesAnAffineField) {
  const double g[3][3] = {{0.1, -0.7, 0.3}, {0.7, -0.2, -0.4}, {-0.3, 0.4, 0.15}};
  for (ContactElement element : elements) {
    const auto model = model_of(element, true);
    const std::vector<double> field = affine(model->mesh(), g);
    for (const std::vector<double>& x :
         {std::vector{0.0, 0.0, 0.0}, {1.2, 0.7, 0.0}, {2.1, 1.4, 0.2}, {0.4, 3.0, 0.6}, {3.9, 0.1, 1.9}}) {
      const auto value = locate(model->mesh(), model->space(), x).value(model->space(), field);
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(value[i], g[i][0] * x[0] + g[i][1] * x[1] + g[i][2] * x[2], 1e-12);
    }
  }
}

}  // namespace
}  // namespace ixos
