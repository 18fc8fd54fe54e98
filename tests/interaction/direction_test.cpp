#include "interaction/direction.hpp"

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>

#include "support/refusal.hpp"

namespace ixos {
namespace {

std::array<double, 3> read(const std::vector<double>& given, std::size_t dimension) {
  Teuchos::ParameterList list;
  list.set("Axis", Teuchos::Array<double>(given));
  return unit_vector(SceneNode(list, "Wall"), "Axis", dimension, last_axis(dimension), "it must point somewhere");
}

TEST(DirectionTest, HasUnitLength) {
  EXPECT_EQ(read({3, 0, 4}, 3), (std::array<double, 3>{0.6, 0, 0.8}));
  EXPECT_EQ(read({0, -7}, 2), (std::array<double, 3>{0, -1, 0}));
  EXPECT_EQ(read({1e-300, 0, 0}, 3), (std::array<double, 3>{1, 0, 0})) << "no square may underflow";
}

TEST(DirectionTest, AnEmptyListIsTheFallback) {
  EXPECT_EQ(read({}, 2), (std::array<double, 3>{0, 1, 0}));
  EXPECT_EQ(read({}, 3), (std::array<double, 3>{0, 0, 1}));
}

TEST(DirectionTest, APlaceIsTheOriginByDefault) {
  Teuchos::ParameterList list;
  list.set("Center", Teuchos::Array<double>(Teuchos::tuple<double>(2, -3)));
  list.set("Tip", Teuchos::Array<double>());
  EXPECT_EQ(place_of(SceneNode(list, "Wall"), "Center", 2), (std::array<double, 3>{2, -3, 0}));
  EXPECT_EQ(place_of(SceneNode(list, "Wall"), "Tip", 3), (std::array<double, 3>{}));
}

TEST(DirectionTest, ZeroIsRefused) {
  test::expect_contains(test::refusal([] { read({0, 0}, 2); }), "Wall/Axis is zero: it must point somewhere");
}

}  // namespace
}  // namespace ixos
