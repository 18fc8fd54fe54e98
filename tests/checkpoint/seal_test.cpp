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
    const std::size_t bytes = contents.size() - seal_bytes;
    seal(path_, {{seal_bytes, bytes, checksum(contents.data() + seal_bytes, bytes)}});
    sealed_ = test::contents(path_);
    ASSERT_GT(sealed_.size(), contents.size());  // and the table
  }
  void TearDown() override { std::filesystem::remove(path_); }
  void write(const std::string& contents) const { std::ofstream(path_) << contents; }

  std::string path_ = testing::TempDir() + "seal.h5";
  std::string sealed_;
};

TEST_F(SealTest, AWholeFileIsSound) { EXPECT_EQ(seal_problem(path_), ""); }

TEST_F(SealTest, EveryFlippedBitIsNoticed) {
  // Every byte of the seal, then every fourth of what it covers; the checksums treat those alike.
  for (std::size_t byte = 0; byte < sealed_.size(); byte += byte < 512 ? 1 : 4)
    for (int bit = 0; bit < 8; ++bit) {
      if (byte > 64 && static_cast<int>(byte / 4 % 8) != bit) continue;
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
  const std::size_t length = sealed_.size();
  EXPECT_NE(seal_problem(path_).find("it has " + std::to_string(length + 1) + " bytes, and was written with " +
                                     std::to_string(length)),
            std::string::npos)
      << seal_problem(path_);
}

TEST_F(SealTest, ChecksumsAreOfWhatWasMeantNotOfWhatIsOnTheDisk) {
  const std::string meant(1000, 'm');
  write(std::string(seal_bytes, '\0') + meant + meant);
  const FilePiece first{seal_bytes, 1000, checksum(meant.data(), meant.size())};
  FilePiece second{seal_bytes + 1000, 1000, first.checksum};
  seal(path_, {first, second});
  EXPECT_EQ(seal_problem(path_), "");
  const std::string lost = meant.substr(1) + 'l';  // the disk has something else
  second.checksum = checksum(lost.data(), lost.size());
  seal(path_, {first, second});
  EXPECT_NE(seal_problem(path_).find("checksum"), std::string::npos) << seal_problem(path_);
}

TEST_F(SealTest, PiecesThatLeaveAGapAreNotSound) {
  write(std::string(seal_bytes + 2000, 'x'));
  const std::string part(900, 'x');
  const Checksum sum = checksum(part.data(), part.size());
  seal(path_, {{seal_bytes, 900, sum}, {seal_bytes + 1100, 900, sum}});
  EXPECT_NE(seal_problem(path_), "");
}

TEST_F(SealTest, OtherFilesAreNamedForWhatTheyAre) {
  write("step,time\n");
  EXPECT_EQ(seal_problem(path_), "is not a checkpoint of Ixos");
  write("");
  EXPECT_EQ(seal_problem(path_), "is not a checkpoint of Ixos");
  std::string later = sealed_;
  later[16] = 7;
  write(later);
  EXPECT_EQ(seal_problem(path_), "is a checkpoint of format 7, and this version reads format 6");
  EXPECT_NE(seal_problem("/nowhere/checkpoint.h5").find("cannot be opened"), std::string::npos);
  EXPECT_THROW(seal("/nowhere/checkpoint.h5", {}), FileError);
}

}  // namespace
}  // namespace ixos
