#include "base/phase_timer.hpp"

#include <gtest/gtest.h>

#include <Teuchos_TimeMonitor.hpp>
#include <chrono>
#include <set>
#include <stdexcept>
#include <thread>

namespace ixos {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Sleeps, and returns for how long.
double sleep() {
  const auto start = Clock::now();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  return seconds_since(start);
}

double spent(const PhaseSeconds& before, Phase phase) {
  const auto i = static_cast<std::size_t>(phase);
  return phase_seconds()[i] - before[i];
}

/// The timers may read another clock.
constexpr double slack = 1e-3;

TEST(PhaseTimerTest, ScopesOfAPhaseAddUp) {
  const PhaseSeconds before = phase_seconds();
  const auto start = Clock::now();
  double asleep = 0;
  for (int k = 0; k < 2; ++k) {
    const TimedScope timed(Phase::Tangent);
    asleep += sleep();
  }
  EXPECT_GE(spent(before, Phase::Tangent), asleep - slack);
  EXPECT_LE(spent(before, Phase::Tangent), seconds_since(start) + slack);
}

TEST(PhaseTimerTest, OtherPhasesStandStill) {
  const PhaseSeconds before = phase_seconds();
  {
    const TimedScope timed(Phase::Factorization);
    const NamedScope named("not timed");
    sleep();
  }
  sleep();  // outside all phases
  for (Phase phase : {Phase::Residual, Phase::Tangent, Phase::LinearSolve, Phase::Output})
    EXPECT_EQ(spent(before, phase), 0.0);
}

TEST(PhaseTimerTest, APhaseInsideAnotherCountsForBoth) {
  const PhaseSeconds before = phase_seconds();
  double outside = 0, inside = 0;
  {
    const TimedScope outer(Phase::LinearSolve);
    outside = sleep();
    const TimedScope inner(Phase::Residual);
    inside = sleep();
  }
  EXPECT_GE(spent(before, Phase::Residual), inside - slack);
  EXPECT_GE(spent(before, Phase::LinearSolve), outside + inside - slack);
  EXPECT_GE(spent(before, Phase::LinearSolve) - spent(before, Phase::Residual), outside - slack);
}

TEST(PhaseTimerTest, APhaseInsideItselfCountsOnce) {
  const PhaseSeconds before = phase_seconds();
  const auto start = Clock::now();
  double asleep = 0;
  {
    const TimedScope outer(Phase::Tangent);
    asleep += sleep();
    {
      const TimedScope inner(Phase::Tangent);
      const TimedScope innermost(Phase::Tangent);
      asleep += sleep();
    }
    EXPECT_TRUE(phase_timer(Phase::Tangent).isRunning());
    EXPECT_STREQ(current_phase(), "tangent");
    asleep += sleep();
  }
  EXPECT_FALSE(phase_timer(Phase::Tangent).isRunning());
  EXPECT_GE(spent(before, Phase::Tangent), asleep - slack);
  EXPECT_LE(spent(before, Phase::Tangent), seconds_since(start) + slack);
}

TEST(PhaseTimerTest, TheCurrentPhaseIsTheInnermost) {
  EXPECT_EQ(current_phase(), nullptr);
  {
    const NamedScope named("set-up");
    EXPECT_STREQ(current_phase(), "set-up");
    {
      const TimedScope timed(Phase::LinearSolve);
      EXPECT_STREQ(current_phase(), "linear solve");
      {
        const TimedScope inner(Phase::Residual);
        EXPECT_STREQ(current_phase(), "residual");
      }
      EXPECT_STREQ(current_phase(), "linear solve");
    }
    EXPECT_STREQ(current_phase(), "set-up");
  }
  EXPECT_EQ(current_phase(), nullptr);
}

TEST(PhaseTimerTest, AnExceptionEndsThePhase) {
  try {
    const TimedScope timed(Phase::Output);
    EXPECT_TRUE(phase_timer(Phase::Output).isRunning());
    throw std::runtime_error("disk full");
  } catch (const std::runtime_error&) {
    EXPECT_EQ(current_phase(), nullptr);
  }
  EXPECT_FALSE(phase_timer(Phase::Output).isRunning());
}

TEST(PhaseTimerTest, EachPhaseHasATimerOfItsName) {
  ASSERT_EQ(phase_names.size(), static_cast<std::size_t>(Phase::Output) + 1);
  std::set<const Teuchos::Time*> timers;
  for (std::size_t i = 0; i < phase_names.size(); ++i) {
    const Teuchos::Time& timer = phase_timer(static_cast<Phase>(i));
    EXPECT_TRUE(timers.insert(&timer).second) << i;
    EXPECT_EQ(Teuchos::TimeMonitor::lookupCounter(std::string("Ixos: ") + phase_names[i]).get(), &timer);
  }
}

}  // namespace
}  // namespace ixos
