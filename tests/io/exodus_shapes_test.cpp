#include "io/exodus_shapes.hpp"

#include <gtest/gtest.h>

#include "io/exodus_mesh.hpp"
#include "support/refusal.hpp"
#include "test_folders.hpp"

namespace ixos {
namespace {

// The cells of its second side set have the dimension of the sixth, which is longer.
TEST(ExodusShapesTest, ASetLongerThanItsHeaderIsRefused) {
  const std::string file = IXOS_TEST_DIRECTORY "/fuzz/corpus/exodus/set-lengths";
  EXPECT_EQ(test::refusal([&] { read_tried_exodus_mesh(file); }),
            file + ": is damaged: \"elem_ss2\" has not the dimension num_side_ss2");
}

}  // namespace
}  // namespace ixos
