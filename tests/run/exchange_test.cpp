// A run whose simulation is exchanged for another one, of another scheme or mesh, in the middle.
#include <gtest/gtest.h>

#include <cmath>

#include "model/model.hpp"
#include "run/restart_fixture.hpp"
#include "state/moved.hpp"
#include "study/common/history_table.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using test::count;
using test::drawn;
using test::steps;
using test::word;
using test::world;

constexpr double switch_time = 0.5;

std::string integrator(const std::string& scheme, double step, double end = 1) {
  return word("Type", scheme) + steps(step, end);
}

class ExchangeTest : public test::RestartTest {
 protected:
  using Next = std::function<std::shared_ptr<Simulation>(Simulation&)>;

  /// Runs the scene, and what `next` returns at the switch.
  RunResult run_with(const std::string& scene, const Next& next, const std::string& restart = "") {
    Simulation simulation(test::scene(scene), world());
    RunOptions options;
    options.folder = folder_;
    options.overwrite = true;
    options.restart = restart;
    bool done = false;
    options.exchange = [&](Simulation& present) -> std::shared_ptr<Simulation> {
      if (done || present.integrator().time() < switch_time - 1e-9) return nullptr;
      done = true;
      return next(present);
    };
    return run(simulation, options);
  }
  /// Returns the same body with another integrator, in the state of the present one.
  static std::shared_ptr<Simulation> with_scheme(Simulation& present, const std::string& scene) {
    auto next = std::make_shared<Simulation>(test::scene(scene), world());
    next->integrator().resume(present.integrator().state(), present.integrator().works());
    return next;
  }
  HistoryTable table() const { return HistoryTable(folder_ + "/history.csv"); }
  bool exists(const std::string& name) const { return test::fs::exists(folder_ + "/" + name); }
};

TEST_F(ExchangeTest, AnotherSchemeGoesOnWithTheBitsOfItsIntegrator) {
  const std::string first = drawn(integrator("Newmark", 0.05)), second = drawn(integrator("Average Vector Field", 0.1));
  std::shared_ptr<Simulation> last;
  const RunResult result = run_with(first, [&](Simulation& present) { return last = with_scheme(present, second); });
  EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
  EXPECT_EQ(result.steps, 15);
  Simulation one(test::scene(first), world()), other(test::scene(second), world());
  for (int step = 0; step < 10; ++step) ASSERT_TRUE(one.integrator().step(0.05).converged);
  other.integrator().resume(one.integrator().state(), one.integrator().works());
  for (int step = 0; step < 5; ++step) ASSERT_TRUE(other.integrator().step(0.1).converged);
  EXPECT_EQ(last->integrator().state().u, other.integrator().state().u);
  EXPECT_EQ(last->integrator().state().v, other.integrator().state().v);
  EXPECT_EQ(last->integrator().works().external, other.integrator().works().external);
  EXPECT_EQ(last->integrator().works().dissipated, other.integrator().works().dissipated);
}

TEST_F(ExchangeTest, RowsAndTheEnergyBalanceGoOn) {
  const std::string second = drawn(integrator("Average Vector Field", 0.01));
  run_with(drawn(integrator("Average Vector Field", 0.02)),
           [&](Simulation& present) { return with_scheme(present, second); });
  const HistoryTable rows = table();
  const std::vector<double>&t = rows.column("time"), &step = rows.column("step"), &work = rows.column("external_work"),
        &lost = rows.column("dissipated_energy"), &total = rows.column("total_energy");
  ASSERT_EQ(rows.rows(), 1U + 25U + 50U);
  for (std::size_t k = 1; k < t.size(); ++k) {
    EXPECT_NEAR(t[k] - t[k - 1], k <= 25 ? 0.02 : 0.01, 1e-12) << k;
    EXPECT_EQ(step[k], step[k - 1] + 1);
    // At the exchange, prescribed velocities become those of their motion, which the scheme's are to second order.
    const std::size_t first = k <= 25 ? 0 : 26;
    const auto balance = [&](std::size_t row) { return total[row] - work[row] + lost[row]; };
    EXPECT_NEAR(balance(k), balance(first), 2e-5 * std::abs(total[0])) << k;
    EXPECT_NEAR(balance(k), total[0], 5e-4 * std::abs(total[0])) << k;
  }
  EXPECT_GT(std::abs(work.back()), 0.01 * std::abs(total[0]));
}

/// The linear functions of a coarse box at the nodes of one with halved cells, on one rank.
StateSource from_coarse_box(const Model& coarse, const Model& fine) {
  const auto near = [](double a, double b) { return std::abs(a - b) < 1e-9; };
  const std::vector<double>&from = coarse.mesh().coordinates, &to = fine.mesh().coordinates;
  StateSource source;
  source.dimension = 2;
  for (std::size_t node = 0; node < to.size() / 2; ++node) {
    std::vector<NodeShare>& shares = source.nodes.emplace_back();
    // Cells of 2/6 by 1/3: each coarse node within one cell length has a share.
    for (std::size_t other = 0; other < from.size() / 2; ++other) {
      const double x = std::abs(to[2 * node] - from[2 * other]) * 3,
                   y = std::abs(to[2 * node + 1] - from[2 * other + 1]) * 3;
      const double weight = std::max(0.0, 1 - x) * std::max(0.0, 1 - y);
      if (!near(weight, 0)) shares.push_back({other, near(weight, 1) ? 1.0 : weight});
    }
  }
  return source;
}

class ExchangeSerialTest : public ExchangeTest {};

TEST_F(ExchangeSerialTest, AFinerMeshGoesOnAndHasFramesOfItsOwn) {
  const std::string frames = count("Fields Interval", 5);
  const std::string coarse = drawn(integrator("Newmark", 0.05), frames);
  std::string fine = coarse;
  const std::string divisions = test::counts("Divisions", {6, 3});
  fine.replace(fine.find(divisions), divisions.size(), test::counts("Divisions", {12, 6}));
  std::vector<double> before;
  const RunResult result = run_with(coarse, [&](Simulation& present) {
    auto next = std::make_shared<Simulation>(test::scene(fine), world());
    const State& state = present.integrator().state();
    before = present.probes().front().point.value(present.model().space(), state.u);
    next->integrator().resume(
        moved(state, from_coarse_box(present.model(), next->model()), next->model().create_histories()),
        present.integrator().works());
    const std::vector<double> after =
        next->probes().front().point.value(next->model().space(), next->integrator().state().u);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(after[i], before[i], 1e-14);
    return next;
  });
  EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
  EXPECT_EQ(table().rows(), 21U);
  EXPECT_TRUE(exists("fields.e"));
  EXPECT_TRUE(exists("fields-2.e"));
  // A later run into the folder leaves no frames of this one.
  run_with(drawn(integrator("Newmark", 0.05)), [](Simulation&) { return nullptr; });
  EXPECT_FALSE(exists("fields.e"));
  EXPECT_FALSE(exists("fields-2.e"));
}

TEST_F(ExchangeTest, ARestartAfterTheExchangeGoesOnBitForBit) {
  const std::string first = drawn(integrator("Newmark", 0.05), count("Fields Interval", 4) + test::checkpoints(3, 9)),
                    second = drawn(integrator("Average Vector Field", 0.1),
                                   count("Fields Interval", 4) + test::checkpoints(3, 9));
  std::shared_ptr<Simulation> whole;
  run_with(first, [&](Simulation& present) { return whole = with_scheme(present, second); });
  const std::vector<double> t = table().column("time"), x = table().column("Edge_ux"),
                            work = table().column("external_work");
  Simulation again(test::scene(second), world());
  RunOptions options;
  options.folder = folder_;
  options.restart = folder_ + "/checkpoint-12.h5";
  const RunResult result = run(again, options);
  EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
  EXPECT_EQ(table().column("time"), t);
  EXPECT_EQ(table().column("Edge_ux"), x);
  EXPECT_EQ(table().column("external_work"), work);
  EXPECT_EQ(again.integrator().state().u, whole->integrator().state().u);
}

TEST_F(ExchangeTest, AnotherTimeAndOtherColumnsAreRefused) {
  const std::string scene = drawn(integrator("Newmark", 0.05));
  const auto refusal = [&](const Next& next) { return test::refusal([&] { run_with(scene, next); }); };
  test::expect_contains(refusal([&](Simulation&) { return std::make_shared<Simulation>(test::scene(scene), world()); }),
                        "stands at t = 0 T0, but the run at 0.5 T0");
  std::string other = scene;
  const std::string probe = "\"Edge\"";
  other.replace(other.find(probe), probe.size(), "\"Corner\"");
  test::expect_contains(refusal([&](Simulation& present) { return with_scheme(present, other); }),
                        "history.csv cannot go on with the columns of another simulation");
}

}  // namespace
}  // namespace ixos
