// The seal of a checkpoint: nothing that happens to a file on the disk goes unnoticed.
#include "checkpoint/seal.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "support/files.hpp"

namespace ixos {
namespace {

class SealTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string contents(seal_bytes, '\0');
    for (int i = 0; i < 5000; ++i) contents += static_cast<char>(i * i);
    write(contents);
    seal(path_);
    sealed_ = test::contents(path_);
    ASSERT_EQ(sealed_.size(), contents.size());
  }
  void TearDown() override { std::filesystem::remove(path_); }
  void write(const std::string& contents) const { std::ofstream(path_) << contents; }

  std::string path_ = testing::TempDir() + "seal.h5";
  std::string sealed_;
};

TEST_F(SealTest, AWholeFileIsSound) { EXPECT_EQ(seal_problem(path_), ""); }

TEST_F(SealTest, EveryFlippedBitIsNoticed) {
  for (std::size_t byte = 0; byte < sealed_.size(); ++byte)
    for (int bit = 0; bit < 8; ++bit) {
      if (byte > 64 && static_cast<int>(byte % 8) != bit) continue;
      std::string damaged = sealed_;
      damaged[byte] = static_cast<char>(damaged[byte] ^ (1 << bit));
      write(damaged);
      ASSERT_NE(seal_problem(path_), "") << "byte " << byte << ", bit " << bit;
    }
}

TEST_F(SealTest, EveryTruncationAndEveryAdditionIsNoticed) {
  for (std::size_t length = 0; length < sealed_.size(); length += 7) {
    write(sealed_.substr(0, length));
    ASSERT_NE(seal_problem(path_), "") << length;
  }
  write(sealed_ + '\0');
  EXPECT_NE(seal_problem(path_).find("it has 5513 bytes, and was written with 5512"), std::string::npos)
      << seal_problem(path_);
}

TEST_F(SealTest, OtherFilesAreNamedForWhatTheyAre) {
  write("step,time\n");
  EXPECT_EQ(seal_problem(path_), "is not a checkpoint of Ixos");
  write("");
  EXPECT_EQ(seal_problem(path_), "is not a checkpoint of Ixos");
  std::string later = sealed_;
  later[16] = 3;
  write(later);
  EXPECT_EQ(seal_problem(path_), "is a checkpoint of format 3, and this version reads format 2");
  EXPECT_NE(seal_problem("/nowhere/checkpoint.h5").find("cannot be opened"), std::string::npos);
  EXPECT_THROW(seal("/nowhere/checkpoint.h5"), FileError);
}

}  // namespace
}  // namespace ixos
