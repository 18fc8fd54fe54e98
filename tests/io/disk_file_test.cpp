#include "io/disk_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "base/error.hpp"
#include "support/file_limit.hpp"
#include "support/files.hpp"
#include "support/refusal.hpp"

namespace ixos {
namespace {

using Mode = DiskFile::Mode;
using test::contents;
using test::file_failure;

std::string failure_to_open(const std::string& path, Mode mode) {
  return file_failure([&] { DiskFile file(path, mode); });
}

class DiskFileTest : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directory(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string path(const std::string& name) const { return folder_ + "/" + name; }
  std::string file_with(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  std::string folder_ = testing::TempDir() + "disk_file";
};

TEST_F(DiskFileTest, BytesStandWhereTheyWereWritten) {
  DiskFile file(path("new"), Mode::Create);
  EXPECT_EQ(file.length(), 0U);
  file.write_at(5, "abc", 3);
  EXPECT_EQ(file.length(), 8U);
  std::string bytes(20, '?');
  EXPECT_EQ(file.read_at(0, bytes.data(), bytes.size()), 8U) << "as far as the file goes";
  EXPECT_EQ(bytes, std::string(5, '\0') + "abc" + std::string(12, '?'));
  EXPECT_EQ(file.read_at(6, bytes.data(), 1), 1U);
  EXPECT_EQ(bytes[0], 'b');
  EXPECT_EQ(file.read_at(8, bytes.data(), 1), 0U);
  EXPECT_EQ(file.read_at(100, bytes.data(), 1), 0U);
  file.sync();
  file.close();
  EXPECT_EQ(contents(path("new")), std::string(5, '\0') + "abc");
}

TEST_F(DiskFileTest, OneModeKeepsWhatIsThereAndAnotherEmptiesIt) {
  const std::string old = file_with("old", "old");
  {
    DiskFile file(old, Mode::Change);
    file.write_at(1, "d", 1);
    file.close();
  }
  EXPECT_EQ(contents(old), "odd");
  const DiskFile read(old, Mode::Read);
  EXPECT_EQ(read.length(), 3U);
  EXPECT_EQ(file_failure([&] { DiskFile(old, Mode::Read).write_at(0, "x", 1); }),
            old + ": cannot be written: " + std::strerror(EBADF));
  DiskFile(old, Mode::Create).close();
  EXPECT_EQ(contents(old), "");
}

TEST_F(DiskFileTest, ReservedRoomIsNoLength) {
  const std::string name = file_with("room", "abc");
  DiskFile file(name, Mode::Change);
  file.reserve(1 << 20);
  EXPECT_EQ(file.length(), 3U);
  file.lengthen(10);
  EXPECT_EQ(contents(name), "abc" + std::string(7, '\0'));
  file.lengthen(5);
  EXPECT_EQ(file.length(), 10U) << "it never cuts";
  file.set_length(2);
  EXPECT_EQ(contents(name), "ab");
  file.set_length(4);
  EXPECT_EQ(contents(name), std::string("ab\0\0", 4)) << "what was cut does not come back";
}

TEST_F(DiskFileTest, WhatIsNoFileIsRefused) {
  const std::string pipe = path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);  // nobody is at its other end: an ordinary reader would wait
  for (const std::string& name : {pipe, std::string("/dev/null")}) {
    for (Mode mode : {Mode::Read, Mode::Change, Mode::Create})
      EXPECT_EQ(failure_to_open(name, mode), name + ": is not a file");
    EXPECT_FALSE(is_file(name));
    EXPECT_FALSE(open_text(name).is_open());
  }
  EXPECT_FALSE(is_file(folder_));
  EXPECT_EQ(failure_to_open(folder_, Mode::Read), "");
  EXPECT_EQ(file_failure([&] { sync_to_disk(folder_); }), "");
  const std::string is_folder = std::string(": ") + std::strerror(EISDIR);
  EXPECT_EQ(failure_to_open(folder_, Mode::Change), folder_ + ": cannot be opened" + is_folder);
  EXPECT_EQ(failure_to_open(folder_, Mode::Create), folder_ + ": cannot be written" + is_folder);
}

TEST_F(DiskFileTest, WhatIsMissingIsNamed) {
  const std::string none = path("none"), deep = path("none/file");
  const std::string missing = std::string(": ") + std::strerror(ENOENT);
  EXPECT_FALSE(is_file(none));
  EXPECT_FALSE(open_text(none).is_open());
  EXPECT_EQ(failure_to_open(none, Mode::Read), none + ": cannot be opened" + missing);
  EXPECT_EQ(failure_to_open(none, Mode::Change), none + ": cannot be opened" + missing);
  EXPECT_EQ(failure_to_open(deep, Mode::Create), deep + ": cannot be written" + missing);
  EXPECT_EQ(file_failure([&] { sync_to_disk(none); }), none + ": cannot be opened" + missing);
  EXPECT_FALSE(std::filesystem::exists(none)) << "nothing was made";
}

TEST_F(DiskFileTest, ANewFileTakesThePlaceOfALinkAndSparesItsTarget) {
  const std::string target = file_with("target", "precious"), link = path("link");
  std::filesystem::create_symlink(target, link);
  EXPECT_TRUE(is_file(link));
  std::string word;
  open_text(link) >> word;
  EXPECT_EQ(word, "precious");
  {
    DiskFile file(link, Mode::Create);
    file.write_at(0, "new", 3);
    file.close();
  }
  EXPECT_EQ(contents(target), "precious");
  EXPECT_EQ(contents(link), "new");
  EXPECT_FALSE(std::filesystem::is_symlink(link));
  remove_link(link);
  EXPECT_EQ(contents(link), "new") << "it is no link any more";
  std::filesystem::create_symlink(path("nowhere"), path("dangling"));
  remove_link(path("dangling"));
  EXPECT_FALSE(std::filesystem::is_symlink(path("dangling")));
}

TEST_F(DiskFileTest, NamesAreThoseInTheFolder) {
  for (const char* name : {"b", ".hidden", "a"}) file_with(name, "");
  std::vector<std::string> names = names_in(folder_);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{".hidden", "a", "b"}));
  EXPECT_TRUE(names_in(path("none")).empty());
  EXPECT_TRUE(names_in(path("a")).empty()) << "a file";
  std::filesystem::create_symlink("circle", path("circle"));
  EXPECT_EQ(file_failure([&] { names_in(path("circle")); }),
            path("circle") + ": cannot be read: " + std::strerror(ELOOP));
}

TEST_F(DiskFileTest, WholeFilesReplaceTheOldOne) {
  const std::string name = path("whole"), target = file_with("target", "precious");
  write_whole_file(name, "first");
  EXPECT_EQ(contents(name), "first");
  write_whole_file(name, "2nd");
  EXPECT_EQ(contents(name), "2nd");
  std::filesystem::create_symlink(target, path("link"));
  std::filesystem::create_symlink(target, beside(path("link")));
  write_whole_file(path("link"), "third");
  EXPECT_EQ(contents(path("link")), "third");
  EXPECT_EQ(contents(target), "precious");
  EXPECT_EQ(names_in(folder_).size(), 3U) << "nothing unfinished is left";
}

TEST_F(DiskFileTest, AFailureLeavesTheOldFileAndNothingUnfinished) {
  const std::string name = file_with("whole", "old");
  std::string message;
  {
    // The first four bytes can be written, the others cannot.
    const test::FileLimit limit(4);
    message = file_failure([&] { write_whole_file(name, "a longer text"); });
  }
  EXPECT_EQ(message, beside(name) + ": cannot be written: " + std::strerror(EFBIG));
  EXPECT_EQ(contents(name), "old");
  EXPECT_FALSE(std::filesystem::exists(beside(name)));

  const std::string taken = path("taken");
  std::filesystem::create_directory(taken);
  EXPECT_EQ(file_failure([&] { write_whole_file(taken, "text"); }),
            taken + ": cannot be written: " + std::strerror(EISDIR));
  EXPECT_TRUE(std::filesystem::is_directory(taken));
  EXPECT_FALSE(std::filesystem::exists(beside(taken)));
}

TEST_F(DiskFileTest, AFinishedFileIsRenamed) {
  const std::string finished = file_with("finished", "new"), name = file_with("name", "old");
  replace_file(finished, name);
  EXPECT_EQ(contents(name), "new");
  EXPECT_FALSE(std::filesystem::exists(finished));
  EXPECT_EQ(file_failure([&] { replace_file(finished, name); }),
            name + ": cannot be written: " + std::strerror(ENOENT));
  EXPECT_EQ(contents(name), "new");
}

}  // namespace
}  // namespace ixos
