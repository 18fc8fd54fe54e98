// What a scene does not ask for is neither allocated nor called.
#include <gtest/gtest.h>
#include <malloc.h>

#include <filesystem>
#include <memory>

#include "run/run.hpp"
#include "run/run_measures.hpp"
#include "support/bodies.hpp"
#include "support/scene_text.hpp"
#include "support/silent_interaction.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::numbers;
using test::word;
using test::world;

/// An interaction that does nothing but count who asks it what.
class CountingTerm final : public test::SilentInteraction {
 public:
  struct Calls {
    long force = 0, tangent = 0, row_sums = 0, energy = 0, report = 0, gap_ratio = 0, nodal_gap = 0, normal = 0,
         pressure = 0, lowest_point = 0;
  };
  explicit CountingTerm(Calls& calls) : calls_(calls) {}
  bool add_force(const Segment&, const Rule&, double*) const override { return ++calls_.force > 0; }
  void add_tangent(const Segment&, const Rule&, Tangent, double*) const override { ++calls_.tangent; }
  bool add_row_sums(const Segment&, double*) const override { return ++calls_.row_sums > 0; }
  double energy(const Place&) const override {
    ++calls_.energy;
    return 0;
  }
  double gap_ratio(const Segment&) const override {
    ++calls_.gap_ratio;
    return 1;
  }
  void report(const Place&, InteractionReport&) const override { ++calls_.report; }
  bool needs_positive_gaps() const override { return true; }
  LowestPoint lowest_point(const Place&) const override {
    ++calls_.lowest_point;
    return {};
  }
  bool has(SurfaceNumber number) const override { return number == SurfaceNumber::Pressure; }
  void add_nodal(SurfaceNumber, const Place&, double*) const override { ++calls_.pressure; }
  void lower_nodal_gap(const Place&, double*) const override { ++calls_.nodal_gap; }
  void set_nodal_normal(const Place&, double*) const override { ++calls_.normal; }

 private:
  Calls& calls_;
};

std::string off(const std::string& name) { return R"(<Parameter name=")" + name + R"(" type="bool" value="false"/>)"; }

/// A block that flies past a wall, 20 steps.
std::string flight(const std::string& integrator, const std::string& output) {
  return test::block_2d(0.2) +
         list("Interactions", list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -2}))) +
         (integrator.empty() ? test::time_integrator("Newmark", 0.05, 1) : integrator) + list("Output", output);
}

struct Flight {
  CountingTerm::Calls calls;
  RunResult result;
};

Flight fly(const std::string& integrator, const std::string& output) {
  Flight flight_;
  Simulation s(test::scene(flight(integrator, output)), world());
  const_cast<Model&>(s.model()).add_interaction(std::make_unique<CountingTerm>(flight_.calls));
  RunOptions options;
  options.folder = testing::TempDir() + "costs";
  options.overwrite = true;  // a test that was killed leaves results
  flight_.result = run(s, options);
  std::filesystem::remove_all(options.folder);
  EXPECT_EQ(flight_.result.status, RunStatus::Completed);
  return flight_;
}

TEST(CostsTest, ColumnsThatAreOffAreNotEvaluated) {
  const Flight all = fly("", "");
  EXPECT_EQ(all.calls.energy, 21);
  EXPECT_EQ(all.calls.report, 21);
  const Flight none = fly("", off("Energies") + off("Momenta") + off("Interaction"));
  EXPECT_EQ(none.calls.energy, 0) << "neither for history.csv nor by the line search of a smooth problem";
  EXPECT_EQ(none.calls.report, 0);
  EXPECT_EQ(none.calls.gap_ratio, 0);
  EXPECT_EQ(none.calls.row_sums, 0);
  EXPECT_EQ(none.calls.force, all.calls.force);
  EXPECT_EQ(fly("", test::count("History Interval", 10)).calls.energy, 3);
}

TEST(CostsTest, FieldsThatAreNotListedAreNotEvaluated) {
  const std::string frames = test::count("Fields Interval", 5);
  const Flight usual = fly("", frames);
  EXPECT_EQ(usual.calls.pressure, 0);
  EXPECT_EQ(usual.calls.nodal_gap, 0);
  const auto listed = [&](const std::string& names) {
    return fly("", frames + test::texts("Fields", "{" + names + "}"));
  };
  const Flight gap = listed("displacement, gap");
  EXPECT_EQ(gap.calls.pressure, 0);
  EXPECT_EQ(gap.calls.nodal_gap, 5) << "frames";
  EXPECT_EQ(gap.calls.force, usual.calls.force - 5) << "the interaction traction is left out";
  const Flight both = listed("default, contact_pressure");
  EXPECT_EQ(both.calls.pressure, 5);
  EXPECT_EQ(both.calls.force, usual.calls.force);
}

TEST(CostsTest, ExplicitSchemesMakeNoTangent) {
  const Flight flight = fly(test::time_integrator("Central Difference", 0.05, 1), "");
  EXPECT_EQ(flight.calls.tangent, 0);
  EXPECT_EQ(flight.calls.force, 20) << "one evaluation a step";
  EXPECT_GT(flight.calls.row_sums, 20);
  EXPECT_EQ(flight.result.newton_iterations, 0);
}

TEST(CostsTest, OnlyAdaptiveRunsJudge) {
  const Flight flight =
      fly(list("Time Integrator", list("Time Step Control", word("Type", "Adaptive") + number("Time Step", 0.05) +
                                                                number("Final Time", 1) +
                                                                list("Adaptive", number("Maximum Gap Ratio", 1.5)))),
          "");
  EXPECT_EQ(flight.calls.gap_ratio, flight.result.steps + flight.result.rejected_steps);
}

TEST(CostsTest, EachAttemptLooksForTheLowestPointOnce) {
  for (const char* scheme : {"Newmark", "Bathe Composite", "Central Difference"}) {
    const Flight flight = fly(test::time_integrator(scheme, 0.05, 1), "");
    EXPECT_EQ(flight.calls.lowest_point, flight.result.steps + flight.result.rejected_steps) << scheme;
  }
}

/// Returns the steps up to `last` after which a run looks at the deformation of cells.
std::vector<long> looks_at_cells(const std::string& scheme, long last) {
  Simulation s(test::scene(flight(test::time_integrator(scheme, 0.05, 1), "")), world());
  History history(s);
  auto& u = const_cast<std::vector<double>&>(s.integrator().state().u);
  const std::vector<double> rest = u, &places = s.model().mesh().coordinates;
  std::vector<long> steps;
  for (long step = 1; step <= last; ++step) {
    RunMeasures measures(s);
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = 0.5 * places[i];  // J = 2.25, for this step only
    measures.step(step, 0.05);
    u = rest;
    if (measures.finish(history).strains.largest_jacobian > 2) steps.push_back(step);
  }
  return steps;
}

TEST(CostsTest, CellsAreLookedAtNowAndThen) {
  EXPECT_EQ(looks_at_cells("Newmark", 60), (std::vector<long>{20, 40, 60}));
  EXPECT_EQ(looks_at_cells("Central Difference", 1000), (std::vector<long>{500, 1000}));
}

/// Bytes on the heap, the libraries' included; 0 where a sanitizer's allocator does not say.
long long heap() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<long long>(info.uordblks + info.hblkhd);
}

/// Bytes that the scene holds.
long long bytes(const std::string& scene) {
  const auto parsed = test::scene(scene);
  { Simulation warm(parsed, test::self()); }  // what is made once for the process
  const long long before = heap();
  const Simulation s(parsed, test::self());
  return heap() - before;
}

std::string large(const std::string& scheme, const std::string& material = "", const std::string& interactions = "") {
  return list("Mesh",
              word("Type", "Box") + list("Box", numbers("Lengths", {3, 2}) + test::counts("Divisions", {60, 40}))) +
         list("Materials", list("Rubber", number("Density", 1) + material)) +
         (interactions.empty() ? "" : list("Interactions", interactions)) + test::time_integrator(scheme, 0.05, 1);
}

TEST(CostsTest, WhatIsOffIsNotAllocated) {
  if (heap() == 0) GTEST_SKIP() << "this allocator does not say how much the heap holds";
  // Node pairs of a grid of n x m cells: (3n + 1)(3m + 1).
  const long long pairs = (3LL * 60 + 1) * (3 * 40 + 1), number_size = sizeof(double);
  const long long newmark = bytes(large("Newmark"));
  EXPECT_GT(bytes(large("Newmark", number("Mass Damping", 0.1))), newmark + 4 * pairs * number_size * 9 / 10);
  EXPECT_LT(bytes(large("Static")), newmark - pairs * number_size * 9 / 10) << "no mass";
  EXPECT_LT(bytes(large("Central Difference")), newmark - 8 * pairs * number_size) << "no tangent, no solver";
  const std::string wall = list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -2}));
  EXPECT_GT(bytes(large("Newmark", "", wall)), newmark);
}

TEST(CostsTest, LinearMaterialsAreNotDearer) {
  if (heap() == 0) GTEST_SKIP() << "this allocator does not say how much the heap holds";
  EXPECT_LE(bytes(large("Newmark", word("Model", "Linear Elastic"))), bytes(large("Newmark")) + 100000);
}

}  // namespace
}  // namespace ixos
