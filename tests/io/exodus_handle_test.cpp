// Files that the Exodus library has open, as the system counts them.
#include "io/exodus_handle.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <system_error>
#include <type_traits>

namespace ixos {
namespace {

namespace fs = std::filesystem;

static_assert(!std::is_copy_constructible_v<ExodusHandle> && !std::is_copy_assignable_v<ExodusHandle>);

class ExodusHandleTest : public testing::Test {
 protected:
  void TearDown() override { fs::remove(path_); }
  /// Makes an empty file. Returns the library's number for it.
  int make() const {
    int word = 8, stored = 8;
    return ex_create(path_.c_str(), EX_CLOBBER, &word, &stored);
  }
  /// Returns how many descriptors of this process lead to the file.
  int descriptors() const {
    int count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator("/proc/self/fd")) {
      std::error_code gone;
      if (fs::read_symlink(entry.path(), gone) == path_) ++count;
    }
    return count;
  }

  fs::path path_ = fs::canonical(testing::TempDir()) / "exodus_handle.e";
};

TEST_F(ExodusHandleTest, StandsForTheLibrarysNumber) {
  const int id = make();
  ASSERT_GE(id, 0);
  const ExodusHandle file(id, path_.string());
  EXPECT_EQ(static_cast<int>(file), id);
  EXPECT_EQ(file.path(), path_.string());
  EXPECT_GE(ex_put_init(file, "title", 2, 4, 1, 1, 0, 0), 0) << "the C interface takes it";
  EXPECT_EQ(ex_inquire_int(file, EX_INQ_NODES), 4);
}

TEST_F(ExodusHandleTest, TheDestructorClosesTheFile) {
  {
    const ExodusHandle file(make(), path_.string());
    EXPECT_EQ(descriptors(), 1);
  }
  EXPECT_EQ(descriptors(), 0);
}

TEST_F(ExodusHandleTest, AFileIsClosedOnce) {
  ExodusHandle file(make(), path_.string());
  const int id = file;
  EXPECT_EQ(file.close(), 0);
  EXPECT_EQ(descriptors(), 0);
  EXPECT_LT(static_cast<int>(file), 0);
  EXPECT_EQ(file.path(), path_.string());
  // The library gives the number away again; the old handle must not close the new file.
  const ExodusHandle next(make(), path_.string());
  EXPECT_EQ(static_cast<int>(next), id);
  EXPECT_EQ(file.close(), 0);
  EXPECT_EQ(descriptors(), 1);
}

TEST_F(ExodusHandleTest, AFailureToCloseIsReportedOnce) {
  const int id = make();
  ExodusHandle file(id, path_.string());
  ASSERT_EQ(ex_close(id), 0);
  EXPECT_LT(file.close(), 0);
  EXPECT_EQ(file.close(), 0);
}

TEST_F(ExodusHandleTest, AFileThatCouldNotBeOpenedNeedsNoClosing) {
  ExodusHandle none(-1, "nowhere.e");
  EXPECT_EQ(none.close(), 0);
  EXPECT_EQ(none.path(), "nowhere.e");
}

}  // namespace
}  // namespace ixos
