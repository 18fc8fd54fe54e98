#include "solve/newton/nox_vector.hpp"

#include <gtest/gtest.h>

#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

#include "support/scene_text.hpp"

namespace ixos {
namespace {

// Numbers of every length from 0 to 9 on each rank: 1, 2, 3, ... times their squares sum to (n (n + 1)/2)^2.
TEST(NoxVectorTest, TheInnerProductIsThatOfAllRanks) {
  const Comm comm = test::world();
  for (std::size_t mine = 0; mine < 10; ++mine) {
    const auto map = Teuchos::rcp(new Map(-1, mine, 0, comm));
    Vector a(map), b(map);
    for (std::size_t i = 0; i < mine; ++i) {
      const auto n = static_cast<double>(map->getGlobalElement(static_cast<LocalId>(i)) + 1);
      a.replaceLocalValue(static_cast<LocalId>(i), n);
      b.replaceLocalValue(static_cast<LocalId>(i), n * n);
    }
    const double n = static_cast<double>(mine) * comm->getSize();
    EXPECT_EQ(inner_product(a, b), n * (n + 1) / 2 * (n * (n + 1) / 2)) << mine;
  }
}

}  // namespace
}  // namespace ixos
