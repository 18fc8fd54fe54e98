// A mesh that follows the front on several ranks: the same forces, and as much work for each.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "run/mesh_follower.hpp"
#include "run/peeled_strip.hpp"
#include "run/restart_fixture.hpp"

namespace ixos::test {
namespace {

/// The forces of a run of the strip, and the unknowns at its end.
struct Ends {
  std::vector<double> force;
  double least = 0, largest = 0;  ///< unknowns of a rank on the last mesh
  long changes = 0;
};

Ends run_strip(const Comm& comm, const std::string& folder) {
  std::string scene = strip("Average Vector Field", adapt(2, number("Part", 0.05)), 0.05, 2);
  const std::string coarse = counts("Divisions", {12, 1});
  scene.replace(scene.find(coarse), coarse.size(), counts("Divisions", {96, 8}));
  Simulation simulation(test::scene(scene), comm);
  RunOptions options;
  options.folder = folder;
  options.overwrite = true;
  std::shared_ptr<Simulation> last;
  options.stage = [&](const std::shared_ptr<Simulation>& next) { last = next; };
  const RunResult result = run(simulation, options);
  EXPECT_EQ(result.status, RunStatus::Completed) << result.reason;
  comm->barrier();
  Ends ends;
  ends.force = HistoryTable(folder + "/history.csv").column("reaction_right_y");
  ends.changes = result.mesh_changes.count;
  const DofSpace& space = last->model().space();
  ends.largest = static_cast<double>(space.maximum(space.owned()));
  ends.least = -static_cast<double>(space.maximum(-space.owned()));
  return ends;
}

using MeshFollowerRanksTest = RestartTest;

TEST_F(MeshFollowerRanksTest, ForcesAreThoseOfOneRankAndUnknownsAreShared) {
  const int rank = world()->getRank();
  const Ends together = run_strip(world(), folder("together"));
  const Ends alone = run_strip(world()->split(rank, 0), folder("alone-" + std::to_string(rank)));
  EXPECT_GT(together.changes, 4);
  EXPECT_EQ(together.changes, alone.changes);
  ASSERT_EQ(together.force.size(), alone.force.size());
  const double scale = std::abs(*std::max_element(alone.force.begin(), alone.force.end()));
  for (std::size_t k = 0; k < alone.force.size(); ++k) EXPECT_NEAR(together.force[k], alone.force[k], 1e-9 * scale);
  EXPECT_LE(together.largest, 1.2 * together.least) << "within 20 %";
}

}  // namespace
}  // namespace ixos::test
