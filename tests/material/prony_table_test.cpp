#include "material/prony_table.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace ixos {
namespace {

class PronyTableTest : public testing::Test {
 protected:
  std::string file(const std::string& text) const {
    std::string path = folder_.path() + "/prony.txt";
    std::ofstream(path) << text;
    return path;
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(PronyTableTest, ALineIsABranch) {
  const std::vector<MaxwellBranch> branches =
      read_prony_table(file("# tau mu\n\n1e-3 0.5\n  0.2,\t0.25  # slow\r\n3e4, 1e-2"));
  ASSERT_EQ(branches.size(), 3U);
  EXPECT_EQ(branches[0].time, 1e-3);
  EXPECT_EQ(branches[0].modulus, 0.5);
  EXPECT_EQ(branches[1].time, 0.2);
  EXPECT_EQ(branches[1].modulus, 0.25);
  EXPECT_EQ(branches[2].time, 3e4);
  EXPECT_EQ(branches[2].modulus, 0.01);
}

TEST_F(PronyTableTest, OtherLinesAreRefused) {
  for (const char* line :
       {"1", "1 2 3", "0 1", "1 -2", "1 nan", "one two", "1,,2", ",1 2", "1 2,", ",", "1 2x", "1e999 1"}) {
    const std::string path = file("1 1\n" + std::string(line) + "\n");
    EXPECT_EQ(test::refusal([&] { read_prony_table(path); }),
              path + ", line 2: \"" + line + "\" is not a relaxation time and a modulus, two numbers greater than 0");
  }
  const std::string empty = file("# nothing\n");
  EXPECT_EQ(test::refusal([&] { read_prony_table(empty); }),
            empty + ": has no line with a relaxation time and a modulus");
  EXPECT_EQ(test::refusal([&] { read_prony_table(empty + "x"); }), empty + "x: cannot be read");
}

}  // namespace
}  // namespace ixos
