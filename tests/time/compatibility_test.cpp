#include "time/compatibility.hpp"

#include <gtest/gtest.h>

#include "interaction/catalogue.hpp"
#include "interaction/gap_law.hpp"
#include "interaction/half_space.hpp"
#include "interaction/van_der_waals.hpp"
#include "mesh/generators/shapes.hpp"
#include "mesh/local_mesh.hpp"
#include "model/surface_interaction.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"
#include "support/solids.hpp"
#include "time/schemes.hpp"

namespace ixos {
namespace {

/// A plate of 3 by 2 L0 whose bottom is at y = 0.4. The last rank owns the nodes of the top only, so that on several
/// ranks it has no side of the bottom.
std::unique_ptr<Model> plate(const Material& material) {
  BoxShape shape;
  shape.lower = {0, 0.4, 0};
  shape.lengths = {3, 2, 0};
  shape.divisions = {6, 4, 1};
  const Mesh mesh = box(shape);
  const Comm comm = test::world();
  std::vector<int> owner;
  for (std::size_t i = 1; i < mesh.coordinates.size(); i += 2)
    owner.push_back(mesh.coordinates[i] > 2.3 ? comm->getSize() - 1 : 0);
  Material body = material;
  body.block = "body";
  return std::make_unique<Model>(local_part(mesh, owner, comm), comm, std::vector<Material>{body});
}

SurfaceInteraction wall(double cutoff) {
  SurfaceInteraction wall;
  wall.side_set = "bottom";
  wall.law = gap_law(VanDerWaals(2.5, 25));
  wall.obstacle = flat_wall({});
  wall.cutoff = cutoff;
  wall.name = "floor";
  return wall;
}

std::string refusal(Model& model, const Table& table) {
  return test::refusal([&] { const Integrator integrator = test::direct(model, table); });
}

TEST(CompatibleModelTest, AnExactMeanAllowsACutoff) {
  const auto model = plate(test::elastic(neo_hooke, 0.2));
  add_interaction(*model, wall(2));
  if (model->space().comm()->getSize() == 2 && model->space().comm()->getRank() == 1) {
    EXPECT_TRUE(model->mesh().side_sets[model->mesh().side_set("bottom")].empty());
  }
  SurfaceInteraction sphere = wall(2);
  sphere.obstacle = make_obstacle("Sphere", 2, {{"Center", {1.5, -1.0}}, {"Radius", 1.0}});
  add_interaction(*model, sphere);
  EXPECT_EQ(refusal(*model, average_vector_field(4, 0)), "");
  EXPECT_EQ(refusal(*model, energy_momentum()), "");
}

TEST(CompatibleModelTest, EnergyMomentumNeedsADiscreteGradient) {
  for (const Formulation formulation : {Formulation::MeanDilatation, Formulation::Enhanced}) {
    Material material = test::elastic(neo_hooke, 0.2);
    material.formulation = formulation;
    const auto model = plate(material);
    EXPECT_EQ(refusal(*model, energy_momentum()),
              "the scheme \"Energy-Momentum\" needs a discrete gradient, and the formulation of block \"body\" has "
              "none; use another one, or the scheme \"Average Vector Field\"");
    EXPECT_EQ(refusal(*model, average_vector_field(4, 8)), "");
  }
}

TEST(CompatibleModelTest, EnhancedElementsNeedTwoPoints) {
  Material material = test::elastic(neo_hooke, 0.2);
  material.formulation = Formulation::Enhanced;
  material.points = 1;
  EXPECT_NE(test::refusal([&] { plate(material); }), "");
  material.points = 2;
  EXPECT_EQ(test::refusal([&] { plate(material); }), "");
}

}  // namespace
}  // namespace ixos
