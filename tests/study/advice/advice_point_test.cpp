// Settings and names of points.
#include "study/advice/advice_point.hpp"

#include <gtest/gtest.h>

#include <set>

#include "support/advice_case.hpp"

namespace ixos {
namespace {

TEST(AdvicePointTest, TheSceneAsItIsHasNoSettings) {
  const AdviceDirections directions = test::directions_of_formula();
  const AdvicePoint scene = scene_point(directions);
  EXPECT_TRUE(settings_of(directions, scene).empty());
  EXPECT_EQ(description_of(directions, scene), "N, time step 2, Q1, mesh 16");
}

TEST(AdvicePointTest, SettingsAndDistance) {
  const AdviceDirections directions = test::directions_of_formula();
  const AdvicePoint scene = scene_point(directions), point{{1, 1}, {0, 0}, {1, 0}};
  EXPECT_EQ(settings_of(directions, point), (Assignments{"Scheme=B", "Step=0.500000", "Mesh=4", "Tolerance=1e-6"}));
  EXPECT_EQ(description_of(directions, point), "B, time step 2, Q1, mesh 4, tolerance 1e-6");
  EXPECT_EQ(distance(scene, point), 3U);
  EXPECT_EQ(distance(point, point), 0U);
}

TEST(AdvicePointTest, NamesDiffer) {
  const AdviceDirections directions = test::directions_of_formula();
  std::set<std::string> names;
  std::size_t points = 0;
  for (std::size_t b = 0; b < 2; ++b)
    for (std::size_t step = 0; step < 5; ++step)
      for (std::size_t mesh = 0; mesh < 4; ++mesh)
        for (std::size_t t = 0; t < 2; ++t, ++points) {
          const std::string name = name_of(directions, {{b, step}, {1 - b, mesh}, {t, 0}});
          EXPECT_EQ(name.find_first_of(" /,"), std::string::npos) << name;
          names.insert(name);
        }
  EXPECT_EQ(names.size(), points);
}

}  // namespace
}  // namespace ixos
