#include "scene/examine/steep_laws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "parameters/validation.hpp"
#include "scene/read/parameters.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::list;
using test::number;
using test::word;

/// Returns what `use` makes of the interactions of a scene whose wall has that law.
template <class Use>
auto with_law(const std::string& name, const std::string& parameters, const Use& use) {
  const std::string own = parameters.empty() ? "" : list(name, parameters);
  const Teuchos::ParameterList scene = validated(
      test::scene(list("Mesh", word("Type", "Box") + list("Box", "")) + list("Materials", list("Rubber", "")) +
                  list("Interactions", list("Wall", word("Side Set", "bottom") + word("Law", name) + own)) +
                  test::time_integrator("Newmark", 0.1, 1)),
      scene_parameters());
  return use(read_interactions(SceneNode(scene, "").sublist("Interactions")));
}
double fall(const std::string& name, const std::string& parameters = "") {
  return with_law(name, parameters, [](const auto& all) { return fall_of_attraction(*all.at(0).law); });
}
std::string hint(const std::string& name, const std::string& parameters = "") {
  return with_law(name, parameters, [](const auto& all) { return steep_law_hint(all); });
}

// The ramp t^2 (3 - 2t) is 0.1 at t = 0.195800, and 0.9 at 1 - t; it is 2 w = 2 s h0 long, and ends at h0 + w.
TEST(SteepLawsTest, TheFallOfSmoothDugdaleIsThatOfItsRamp) {
  for (const double s : {0.01, 0.1, 0.2, 1.0})
    EXPECT_NEAR(fall("Smooth Dugdale", number("Smoothing", s)), (1 - 2 * 0.195800) * 2 * s / (1 + s), 1.1e-3) << s;
}

TEST(SteepLawsTest, TheFallOfATriangleIsThatOfItsFlank) {
  const auto flank = [](double peak) {
    return fall("Triangle",
                word("Constants", "Range") + number("Strength", 0.1) + number("Range", 2) + number("Peak Gap", peak));
  };
  EXPECT_NEAR(flank(1), 0.8 * 0.5, 1.1e-3);
  EXPECT_NEAR(flank(1.9), 0.8 * 0.05, 1.1e-3);
}

TEST(SteepLawsTest, LawsWithoutARangeOrAnAttractionHaveNone) {
  EXPECT_TRUE(std::isinf(fall("Van der Waals")));
  EXPECT_TRUE(std::isinf(fall("Morse")));
  EXPECT_TRUE(std::isinf(fall("Penalty")));
}

TEST(SteepLawsTest, SteepOnesAreToldOfWithTheRemedy) {
  EXPECT_EQ(hint("Van der Waals"), "");
  EXPECT_EQ(hint("Smooth Dugdale", number("Smoothing", 0.2)), "");
  const std::string steep = hint("Smooth Dugdale", number("Smoothing", 0.01));
  test::expect_contains(steep, "Interactions/Wall: the attraction falls within ");
  test::expect_contains(steep, "the law \"Smooth Dugdale\" with a Smoothing of 0.2 or more");
}

}  // namespace
}  // namespace ixos
