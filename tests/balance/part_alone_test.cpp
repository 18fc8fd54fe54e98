// A model is any part of the cells, with any communicator: one body of two, solved alone on one rank, is the
// body in the whole, which all ranks solve together.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/van_der_waals.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/joined_parts.hpp"
#include "mesh/partition.hpp"
#include "model/conditions.hpp"
#include "model/surface_interaction.hpp"
#include "support/comparison.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"
#include "time/catalogue.hpp"

namespace ixos {
namespace {

using Values = std::vector<double>;

const std::vector<std::string> parts = {"left", "right"};

/// Two blocks side by side with different cells.
Mesh two_blocks() {
  BoxShape left;
  left.dimension = 2;
  left.lengths = {2, 1, 1};
  left.divisions = {4, 2, 1};
  left.lower = {-3, 0.4, 0};
  BoxShape right = left;
  right.divisions = {5, 3, 1};
  right.lower = {1, 0.3, 0};
  return joined_parts({{"left", box(left)}, {"right", box(right)}});
}

/// The parts that the mesh has, each held at its top, sticking to a wall below and pulled along it.
std::unique_ptr<Model> model_of(const Mesh& mesh, const Comm& comm) {
  std::vector<Material> materials;
  std::vector<std::string> present;
  for (const std::string& part : parts) {
    if (std::none_of(mesh.blocks.begin(), mesh.blocks.end(),
                     [&](const ElementBlock& block) { return is_in_part(part, block.name); }))
      continue;
    present.push_back(part);
    materials.push_back(test::elastic(neo_hooke, 0.3));
    materials.back().block = name_in_part(part, "body");
    materials.back().density = part == "left" ? 1 : 0.6;
    materials.back().stiffness_damping = 0.01;
  }
  const int ranks = comm->getSize();
  auto model = std::make_unique<Model>(localize(mesh, partition_nodes(mesh, ranks), comm->getRank(), ranks), comm,
                                       materials, Inertia::Consistent);
  for (const std::string& part : present) {
    SurfaceInteraction wall;
    wall.side_set = name_in_part(part, "bottom");
    wall.name = part;
    wall.law = gap_law(VanDerWaals(2.5, 25));
    wall.obstacle = make_obstacle("Half-Space", 2, {});
    add_interaction(*model, wall);
    prescribe(*model, name_in_part(part, "top"), "y", rate_ramp(0.05, 0, 0.2, RampShape::Quintic));
    add_traction(*model, name_in_part(part, "right"), {0.05, 0.02}, value_ramp(1, 0, 0.3, RampShape::Cosine));
  }
  return model;
}

/// Returns the displacement after some steps, by node of the mesh.
Values after_steps(Model& model, const std::string& name) {
  const Scheme& chosen = scheme(name);
  Integrator integrator = test::direct(model, chosen.table(chosen.parameters), 1e-13);
  const Values none = test::at_rest(model);
  integrator.initialize(none, none, 0);
  for (int step = 0; step < 12; ++step) {
    const StepResult result = integrator.step(0.05);
    EXPECT_TRUE(result.converged) << result.reason;
  }
  return test::gathered(model, integrator.state().u);
}

TEST(PartAloneTest, ABodySolvedAloneOnOneRankIsTheBodyInTheWhole) {
  const Mesh mesh = two_blocks();
  const Comm all = test::world();
  for (const char* name : {"Newmark", "Average Vector Field"}) {
    const auto whole = model_of(mesh, all);
    const Values together = after_steps(*whole, name);
    // Each rank takes a part; a single rank takes one after the other.
    const Comm mine = all->split(all->getRank(), 0);
    ASSERT_EQ(mine->getSize(), 1);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (all->getSize() > 1 && static_cast<int>(k) != all->getRank() % 2) continue;
      std::vector<int> old;
      const auto alone = model_of(part_of_joined(mesh, parts[k], old), mine);
      const Values own = after_steps(*alone, name);
      double largest = 0, change = 0;
      for (std::size_t node = 0; node < old.size(); ++node)
        for (std::size_t i = 0; i < 2; ++i) {
          const double there = together[2 * static_cast<std::size_t>(old[node]) + i];
          largest = std::max(largest, std::abs(there));
          change = std::max(change, std::abs(there - own[2 * node + i]));
        }
      EXPECT_GT(largest, 0.01);
      EXPECT_LT(change, 1e-11 * largest) << parts[k] << ", " << name;
    }
  }
}

}  // namespace
}  // namespace ixos
