// Motions that go from mesh to mesh: what is the same, and what is kept.
#include "adapt/moved_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "adapt/momentum.hpp"
#include "adapt/projection.hpp"
#include "adapt/split_bodies.hpp"
#include "material/elastic_law.hpp"
#include "model/conditions.hpp"
#include "model/state_report.hpp"
#include "support/solids.hpp"

namespace ixos {
namespace {

using test::split_box;

/// A body on a mesh, deformed, turned, and in motion.
struct Moving {
  Moving(SplitMesh own, Inertia inertia = Inertia::Consistent)
      : mesh(std::move(own)), model(test::model_of(mesh.mesh(), test::elastic(neo_hooke, 0.3), inertia)) {}

  void set() {
    state.u = test::smooth_field(*model, 0.1);
    state.v = test::smooth_field(*model, 0.7);
    const auto d = static_cast<std::size_t>(mesh.mesh().dimension);
    for (std::size_t k = 0; k < state.v.size(); k += d) {  // a spin and a drift, and what is no smooth field
      state.v[k] += 0.4 - 1.3 * model->mesh().coordinates[k + 1];
      state.v[k + 1] += 1.3 * model->mesh().coordinates[k];
      state.v[k + d - 1] += 0.2 * std::sin(17.0 * static_cast<double>(model->mesh().original_ids[k / d]));
      state.u[k + d - 1] += 0.01 * std::cos(23.0 * static_cast<double>(model->mesh().original_ids[k / d]));
    }
    model->space().interpolate_tied(state.v.data());
    model->space().interpolate_tied(state.u.data());
  }
  void take(const Moving& before) {
    Motion motion = moved_motion(before.mesh, *before.model, before.state, mesh, *model);
    state.u = std::move(motion.u);
    state.v = std::move(motion.v);
  }
  Momenta momenta() const { return StateReport(*model, state).momenta(); }
  double energy() const { return StateReport(*model, state).energy(Part::Elastic); }

  SplitMesh mesh;
  std::unique_ptr<Model> model;
  State state;
};

void expect_same_momenta(const Momenta& one, const Momenta& other, double tolerance) {
  for (std::size_t i = 0; i < one.linear.size(); ++i) EXPECT_NEAR(other.linear[i], one.linear[i], tolerance);
  for (std::size_t i = 0; i < one.angular.size(); ++i) EXPECT_NEAR(other.angular[i], one.angular[i], tolerance);
}

const std::vector<ContactElement> elements{ContactElement::Q1C1, ContactElement::Q2C2, ContactElement::Q1C2,
                                           ContactElement::Q1C4};

TEST(MovedMotionTest, FinerCellsKeepMomentaAndEnergies) {
  for (const int dimension : {2, 3})
    for (const ContactElement element : {ContactElement::Q1C1, ContactElement::Q2C2}) {
      Moving coarse(split_box(dimension, element, 0)), fine(split_box(dimension, element, 1));
      coarse.set();
      fine.take(coarse);
      const Momenta before = coarse.momenta(), after = fine.momenta();
      EXPECT_GT(before.kinetic_energy, 1);
      EXPECT_NEAR(after.kinetic_energy, before.kinetic_energy, 1e-12 * before.kinetic_energy);
      expect_same_momenta(before, after, 1e-12 * before.kinetic_energy);
    }
}

TEST(MovedMotionTest, OtherCellsKeepBothMomenta) {
  for (const int dimension : {2, 3})
    for (const ContactElement element : elements)
      for (const Inertia inertia : {Inertia::Consistent, Inertia::Lumped}) {
        if (inertia == Inertia::Lumped && element != ContactElement::Q1C1) continue;
        SCOPED_TRACE(testing::Message() << dimension << "D, element " << static_cast<int>(element));
        Moving one(split_box(dimension, element, 1), inertia), other(split_box(dimension, element, 2), inertia);
        one.set();
        other.take(one);
        const Momenta before = one.momenta(), after = other.momenta();
        expect_same_momenta(before, after, 2e-12 * before.kinetic_energy);
        EXPECT_NE(after.kinetic_energy, before.kinetic_energy);  // its fine waves are gone
        EXPECT_NEAR(after.kinetic_energy, before.kinetic_energy, 0.05 * before.kinetic_energy);
      }
}

TEST(MovedMotionTest, SimplicesAndCellsBesideThemKeepWhatTheyShould) {
  for (const test::SimplexKind& cells : test::simplex_kinds()) {
    SCOPED_TRACE(testing::Message() << cells.cells << ", order " << cells.order << (cells.bubbles ? ", bubbles" : ""));
    const auto body = [&](int kind) {
      return Moving(test::split_simplices(cells.cells, cells.order, cells.bubbles, kind));
    };
    Moving coarse = body(0), fine = body(1), other = body(2);
    coarse.set();
    fine.take(coarse);
    const Momenta before = coarse.momenta(), after = fine.momenta();
    if (cells.bubbles) {  // their functions are none of their parts
      EXPECT_NEAR(after.kinetic_energy, before.kinetic_energy, 0.01 * before.kinetic_energy);
    } else {
      EXPECT_NEAR(after.kinetic_energy, before.kinetic_energy, 1e-12 * before.kinetic_energy);
    }
    expect_same_momenta(before, after, 2e-12 * before.kinetic_energy);
    other.take(fine);
    expect_same_momenta(before, other.momenta(), 4e-12 * before.kinetic_energy);
  }
}

TEST(MovedMotionTest, AThousandChangesOfTrianglesKeepBothMomenta) {
  Moving present(test::split_simplices("triangles", 2, false, 1));
  present.set();
  const Momenta before = present.momenta();
  for (int n = 0; n < 1000; ++n) {
    Moving next(test::split_simplices("triangles", 2, false, n % 4));
    next.take(present);
    present = std::move(next);
  }
  expect_same_momenta(before, present.momenta(), 1e-11 * before.kinetic_energy);
}

TEST(MovedMotionTest, AThousandChangesKeepBothMomenta) {
  for (const int dimension : {2, 3}) {
    Moving present(split_box(dimension, ContactElement::Q1C1, 1));
    present.set();
    const Momenta before = present.momenta();
    const int changes = dimension == 2 ? 1000 : 20;
    for (int n = 0; n < changes; ++n) {
      Moving next(split_box(dimension, ContactElement::Q1C1, n % 4));
      next.take(present);
      present = std::move(next);
    }
    expect_same_momenta(before, present.momenta(), 1e-11 * before.kinetic_energy);
  }
}

// A velocity that is linear in the place is a function of every mesh, so its projection is itself.
TEST(MovedMotionTest, ARigidMotionStaysOne) {
  for (const ContactElement element : elements) {
    Moving fine(split_box(2, element, 1)), coarse(split_box(2, element, 0));
    fine.state.u = test::at_rest(*fine.model);
    fine.state.v = fine.state.u;
    const auto velocity = [](const double* x) { return std::array<double, 2>{0.4 - 1.3 * x[1], 0.1 + 1.3 * x[0]}; };
    for (std::size_t k = 0; k < fine.state.v.size(); k += 2) {
      const auto v = velocity(&fine.model->mesh().coordinates[k]);
      fine.state.v[k] = v[0];
      fine.state.v[k + 1] = v[1];
    }
    coarse.take(fine);
    for (std::size_t k = 0; k < coarse.state.v.size(); k += 2)
      for (const std::size_t i : {0U, 1U})
        EXPECT_NEAR(coarse.state.v[k + i], velocity(&coarse.model->mesh().coordinates[k])[i], 1e-12);
  }
}

TEST(MovedMotionTest, ElasticEnergyOfFinerCellsDiffersByQuadratureAlone) {
  double error[2];
  for (const int kind : {0, 1}) {
    Moving coarse(split_box(2, ContactElement::Q1C1, 0)), fine(split_box(2, ContactElement::Q1C1, 2));
    coarse.set();
    if (kind == 1)
      for (double& u : coarse.state.u) u /= 2;
    fine.take(coarse);
    error[kind] = std::abs(fine.energy() - coarse.energy()) / coarse.energy();
  }
  // Gauss points integrate the quadratic part of the energy; what remains is of third order in the strain.
  EXPECT_LT(error[0], 0.05);
  EXPECT_GT(error[0], 0);
  EXPECT_LT(error[1], 0.6 * error[0]);
}

TEST(MovedMotionTest, HeldPartsGetNoRigidMotion) {
  Moving fine(split_box(2, ContactElement::Q1C1, 1)), coarse(split_box(2, ContactElement::Q1C1, 0));
  for (Moving* body : {&fine, &coarse}) prescribe(*body->model, "left", "all");
  fine.set();
  coarse.take(fine);
  const LocalMesh& mesh = coarse.model->mesh();
  // The projection leaves the held nodes what they have at their places.
  for (const int dof : coarse.model->constraints().dofs()) {
    if (dof >= coarse.model->space().owned()) continue;
    const auto node = static_cast<std::size_t>(dof / 2);
    for (std::size_t other = 0; other < fine.model->mesh().original_ids.size(); ++other)
      if (fine.model->mesh().original_ids[other] == mesh.original_ids[node]) {
        EXPECT_EQ(coarse.state.v[static_cast<std::size_t>(dof)],
                  fine.state.v[2 * other + static_cast<std::size_t>(dof % 2)]);
      }
  }
}

// A held body keeps the integral of its velocity with each function that both meshes have and that the support holds.
TEST(MovedMotionTest, JoinedCellsOfAHeldBodyKeepItsWeightedMomenta) {
  for (const int dimension : {2, 3})
    for (const ContactElement element : {ContactElement::Q1C1, ContactElement::Q1C2, ContactElement::Q2C2}) {
      // Some cells stay split, so that nodes of theirs hang that did not.
      Moving fine(split_box(dimension, element, 1)), coarse(split_box(dimension, element, 3));
      for (Moving* body : {&fine, &coarse}) prescribe(*body->model, "right", "all");
      fine.set();
      const LocalMesh& mesh = fine.model->mesh();
      const auto d = static_cast<std::size_t>(dimension);
      for (std::size_t k = 0; k < fine.state.v.size(); ++k)
        if (mesh.coordinates[k / d * d] == 3) fine.state.v[k] = 0;
      coarse.take(fine);
      for (int power = 0; power < 2; ++power)
        for (std::size_t i = 0; i < d; ++i) {
          double sums[2] = {0, 0};
          for (const Moving* body : {&fine, &coarse}) {
            const LocalMesh& own = body->model->mesh();
            std::vector<double> p(static_cast<std::size_t>(body->model->space().owned()));
            body->model->mass()->multiply(body->state.v.data(), p.data());
            for (std::size_t node = 0; node < static_cast<std::size_t>(own.owned_nodes); ++node)
              sums[body == &coarse] +=
                  (3 - own.coordinates[node * d]) * std::pow(own.coordinates[node * d + 1], power) * p[node * d + i];
          }
          fine.model->space().sum(sums, 2);
          EXPECT_NEAR(sums[1], sums[0], 1e-11) << dimension << "D, element " << static_cast<int>(element);
        }
    }
}

}  // namespace
}  // namespace ixos
