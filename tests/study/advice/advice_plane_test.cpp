// Questions on scenes in space that are answered in two dimensions.
#include "study/advice/advice_plane.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "scene/scene_file.hpp"
#include "support/plane_block.hpp"
#include "support/temporary_folder.hpp"

namespace ixos {
namespace {

class AdvicePlaneTest : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_.path() + "/block.xml") << test::plane_block;
    question_.scene = folder_.path() + "/block.xml";
  }
  std::optional<AdvicePlane> plane(const std::vector<const char*>& quantities) {
    question_.quantities.clear();
    for (const char* quantity : quantities) question_.quantities.emplace_back(quantity);
    return plane_question(question_, folder_.path() + "/plane.xml");
  }
  test::TemporaryFolder folder_;
  AdviceQuestion question_;
};

TEST_F(AdvicePlaneTest, QuantitiesHaveOtherNamesAndFactors) {
  const auto found = plane({"peak contact_force_z [0, 0.01]", "final force_uz", "time of peak contact_force_z",
                            "time of first contact", "energy error", "value elastic_energy at 0.01"});
  ASSERT_TRUE(found);
  std::vector<std::string> names;
  for (const AskedQuantity& quantity : found->question.quantities) names.push_back(quantity.text());
  EXPECT_EQ(names, (std::vector<std::string>{"peak contact_force_y [0, 0.01]", "final force_uy",
                                             "time of peak contact_force_y", "time of first contact", "energy error",
                                             "value elastic_energy at 0.01"}));
  EXPECT_EQ(found->factors, (std::vector<double>{3, 1, 1, 1, 1, 3}));
  EXPECT_EQ(found->column_factors, (std::vector<double>{3, 1, 3, 3, 3, 3})) << "columns of times grow, too";
  EXPECT_EQ(found->depth, 3);
}

TEST_F(AdvicePlaneTest, SomeQuantitiesNeedSpace) {
  EXPECT_FALSE(plane({"peak contact_force_y"}));
  EXPECT_FALSE(plane({"final elastic_energy", "final angular_momentum_y"}));
  EXPECT_FALSE(plane({"time of contact_force_z above 2"}));  // the limit is one of the whole depth
  EXPECT_TRUE(plane({"time of force_uz above 2"}));
  question_.common = {"Boundary Conditions/Front/Components=x"};
  EXPECT_FALSE(plane({"final elastic_energy"}));
}

TEST_F(AdvicePlaneTest, TheWrittenSceneHasTheUsersChanges) {
  question_.common = {"Mesh/Box/Divisions={16, 6, 8}", "Time Integrator/Type=Newmark",
                      "Mesh/Box/Lengths={0.002, 0.003, 0.001} um"};
  const auto found = plane({"final elastic_energy"});
  ASSERT_TRUE(found);
  write_plane_scene(question_, *found);
  const Teuchos::ParameterList scene = read_scene_file(found->question.scene);
  EXPECT_EQ(scene.sublist("Mesh").sublist("Box").get<Teuchos::Array<int>>("Divisions").toVector(),
            (std::vector<int>{16, 8}));
  EXPECT_EQ(scene.sublist("Time Integrator").get<std::string>("Type"), "Newmark");
  EXPECT_EQ(scene.sublist("Mesh").sublist("Box").get<Teuchos::Array<double>>("Lengths").toVector(),
            (std::vector<double>{2, 1}))
      << "in units of the scene";
}

}  // namespace
}  // namespace ixos
