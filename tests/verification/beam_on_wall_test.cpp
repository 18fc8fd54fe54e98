// The strip as a beam on the wall: the beam against closed forms, and its pull-off against the balance of energy.
#include "support/beam_on_wall.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace ixos {
namespace {

using test::BeamOnWall;
using test::peel;
using test::PullOff;

const VanDerWaals law(2.5, 25);
const double work_of_adhesion = -law.energy(law.equilibrium_gap());

double bending_stiffness(const BeamOnWall& beam) {
  const double nu = beam.poissons_ratio;
  return beam.youngs_modulus / (1 - nu * nu) * std::pow(beam.height, 3) / 12;
}

double shear_stiffness(const BeamOnWall& beam) {
  return beam.shear_correction * beam.youngs_modulus / (2 * (1 + beam.poissons_ratio)) * beam.height;
}

/// The force over a small displacement: an arm that rises from a half-infinite beam on springs k. There, with w = A
/// exp(x/l), EI theta'' + S (w' - theta) = 0 and S (w' - theta)' = k w give EI/l^4 - (EI k/S)/l^2 + k = 0.
double initial_stiffness(const BeamOnWall& beam, double k) {
  using Complex = std::complex<double>;
  const double a = beam.length - beam.adhering, bending = bending_stiffness(beam), shear = shear_stiffness(beam);
  const Complex root = std::sqrt(Complex(std::pow(k / shear / 2, 2) - k / bending));
  Complex rotation[2], deflection[2], force[2];  // of the end and at it, by either exponential
  for (int i = 0; i < 2; ++i) {
    const Complex rate = std::sqrt(k / shear / 2 + (i == 0 ? root : -root));
    const Complex theta = rate - k / (shear * rate), moment = bending * rate * theta;
    force[i] = k / rate;
    rotation[i] = theta + moment * a / bending - force[i] * a * a / (2 * bending);
    deflection[i] = 1.0 + theta * a + moment * a * a / (2 * bending) - force[i] * std::pow(a, 3) / (6 * bending) +
                    force[i] * a / shear;
  }
  const Complex share = -rotation[0] / rotation[1];
  return ((force[0] + share * force[1]) / (deflection[0] + share * deflection[1])).real();
}

PullOff strongest(const std::vector<PullOff>& states) {
  return *std::max_element(states.begin(), states.end(),
                           [](const PullOff& a, const PullOff& b) { return a.force < b.force; });
}

double energy(const PullOff& state) { return state.elastic_energy + state.interaction_energy; }

TEST(BeamOnWallTest, StiffWallClampsASlenderCantilever) {
  // Its end moves without rotation: P = 12 EI/a^3 w. The wall is 2.5e10 times stiffer than the others'.
  const VanDerWaals stiff(2.5, 1e-9);
  for (double height : {1.0, 10.0}) {
    BeamOnWall beam;
    beam.height = height;
    beam.shear_correction = std::numeric_limits<double>::infinity();
    for (double arm : {20.0, 50.0}) {
      beam.adhering = beam.length - arm;
      const PullOff pulled = peel(beam, stiff, 1e-4, 1e-4).back();
      const double force = 12 * bending_stiffness(beam) / std::pow(arm, 3) * 1e-4;
      EXPECT_NEAR(pulled.force, force, 1e-6 * force) << height << " " << arm;
      EXPECT_NEAR(pulled.elastic_energy, 1e-4 * force / 2, 1e-10 * force) << height << " " << arm;
    }
  }
}

// The error is of second order in the mesh with the shear strain constant in an element, of fourth without shear.
TEST(BeamOnWallTest, SmallDisplacementsSeeAnElasticFoundation) {
  const double w = 1e-7, k = law.stiffness(law.equilibrium_gap());
  for (double height : {2.0, 5.0, 10.0})
    for (double shear_correction : {0.2, 5.0 / 6, std::numeric_limits<double>::infinity()}) {
      BeamOnWall beam;
      beam.height = height;
      beam.shear_correction = shear_correction;
      const double exact = initial_stiffness(beam, k);
      double before = 1;
      for (int elements : {640, 1280, 2560}) {
        beam.elements = elements;
        const double error = std::abs(peel(beam, law, w, w).back().force / (exact * w) - 1);
        EXPECT_LT(error, std::max(before / 3.3, 1e-7)) << height << " " << shear_correction << " " << elements;
        before = error;
      }
      EXPECT_LT(before, std::isinf(shear_correction) ? 1e-7 : 1e-4) << height << " " << shear_correction;
    }
}

TEST(BeamOnWallTest, ForceIsTheDerivativeOfTheEnergyAndBalancesTheWall) {
  const double step = 0.05;
  const std::vector<PullOff> states = peel(BeamOnWall(), law, step, 110);
  for (std::size_t i = 1; i + 1 < states.size(); ++i) {
    const double slope = (energy(states[i + 1]) - energy(states[i - 1])) / (2 * step);
    EXPECT_NEAR(states[i].force, slope, 2e-6) << states[i].displacement;
    EXPECT_NEAR(states[i].force, -states[i].wall_force, 1e-11) << states[i].displacement;
  }
}

TEST(BeamOnWallTest, PeakForceConvergesToSecondOrderInTheMesh) {
  BeamOnWall beam;
  double forces[3];
  for (int i = 0; i < 3; ++i) {
    beam.elements = 320 << i;
    forces[i] = strongest(peel(beam, law, 0.05, 13)).force;
  }
  EXPECT_NEAR((forces[0] - forces[1]) / (forces[1] - forces[2]), 4, 0.5);
  EXPECT_NEAR(forces[1], forces[2], 1e-5 * forces[2]);
}

/// Returns the force P of Griffith's balance for an arm on a rigid foundation, in which the rotation decays over
/// d = sqrt(EI/S): P (arm + d)/2 = sqrt(2 EI work of adhesion).
double griffith_force(const BeamOnWall& beam, double arm) {
  const double decay = std::sqrt(bending_stiffness(beam) / shear_stiffness(beam));
  return 2 * std::sqrt(2 * bending_stiffness(beam) * work_of_adhesion) / (arm + decay);
}

/// Returns the displacement of the end of that arm. The end does not rotate; the root rotates by M d/EI, where
/// M = P arm^2/(2 (arm + d)) is the moment there.
double arm_displacement(const BeamOnWall& beam, double arm, double force) {
  const double bending = bending_stiffness(beam), d = std::sqrt(bending / shear_stiffness(beam));
  const double moment = force * arm * arm / (2 * (arm + d));
  return (moment * (d * arm + arm * arm / 2) - force * std::pow(arm, 3) / 6 + force * arm * d * d) / bending;
}

TEST(BeamOnWallTest, PeelingSpendsTheWorkOfAdhesion) {
  const double step = 0.5;
  const BeamOnWall beam;
  const std::vector<PullOff> states = peel(beam, law, step, 100);
  double work = 0;
  const std::size_t first = 80;  // w = 40
  for (std::size_t i = first; i + 1 < states.size(); ++i) work += step * (states[i].force + states[i + 1].force) / 2;
  const PullOff &a = states[first], &b = states.back();
  const double spent = work_of_adhesion * (a.contact_length - b.contact_length);
  EXPECT_GT(spent, 1);
  EXPECT_NEAR(work - (b.elastic_energy - a.elastic_energy), spent, 2e-3 * spent);

  for (std::size_t i = first; i < states.size(); ++i) {
    const double arm = beam.length - states[i].contact_length, force = griffith_force(beam, arm);
    EXPECT_NEAR(states[i].force, force, 5e-3 * force) << states[i].displacement;
    EXPECT_NEAR(states[i].displacement, arm_displacement(beam, arm, force), 0.02 * states[i].displacement);
  }
}

TEST(BeamOnWallTest, ShortContactSnapsOffToItsCorner) {
  const BeamOnWall beam;
  const std::vector<PullOff> states = peel(beam, law, 0.5, 120);
  const auto snap = std::adjacent_find(states.begin(), states.end(), [](const PullOff& a, const PullOff& b) {
    return b.contact_length < a.contact_length - 5;
  });
  ASSERT_NE(snap, states.end());
  const double arm = beam.length - snap->contact_length;
  const double displacement = arm_displacement(beam, arm, griffith_force(beam, arm));
  EXPECT_NEAR(snap->displacement, displacement, 0.03 * displacement);
  EXPECT_LT(energy(snap[1]), energy(snap[0]));
  EXPECT_LT(states.back().contact_length, beam.length / beam.elements);
  EXPECT_NEAR(states.back().force, -states.back().wall_force, 1e-11);
}

}  // namespace
}  // namespace ixos
