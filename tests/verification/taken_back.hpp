// Steps that are taken back.
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/snapshot.hpp"
#include "scene/simulation.hpp"
#include "support/reports.hpp"
#include "time/integrator.hpp"

namespace ixos::test {

/// Takes steps of the length dt until the interaction has slipped, and some more, which it takes back. Expects that the
/// same steps then repeat their results to the last bit, also after attempts of the length `other` that nobody accepts.
inline void expect_no_slip_of_steps_taken_back(Simulation& s, const std::string& interaction, double dt, double other) {
  Integrator& integrator = s.integrator();
  const auto slip = [&] { return test::report_of(s).interaction(interaction).mean(SurfaceNumber::Slip); };
  for (int n = 0; n < 40; ++n) ASSERT_TRUE(integrator.step(dt).converged);
  const double before = integrator.dissipated_energy();
  ASSERT_GT(before, 0);
  Snapshot snapshot([&](Record& record) { integrator.transfer(record); });
  snapshot.save();
  for (int n = 0; n < 6; ++n) ASSERT_TRUE(integrator.step(dt).converged);
  const std::vector<double> u = integrator.state().u, slipped = slip();
  const double lost = integrator.dissipated_energy();
  EXPECT_GT(lost, before);
  snapshot.restore();
  EXPECT_EQ(integrator.dissipated_energy(), before);
  for (int n = 0; n < 6; ++n) {
    ASSERT_TRUE(integrator.attempt(other).converged);  // nobody accepts it
    ASSERT_TRUE(integrator.step(dt).converged);
  }
  EXPECT_EQ(integrator.state().u, u);
  EXPECT_EQ(slip(), slipped);
  EXPECT_EQ(integrator.dissipated_energy(), lost);
}

}  // namespace ixos::test
