// Rows that all ranks add to the data sets of one HDF5 file, whose structure is made in memory: what the HDF5 library
// itself finds on the disk, and what comes back.
#include "io/hdf5_series.hpp"

#include <gtest/gtest.h>
#include <hdf5_hl.h>

#include <filesystem>
#include <fstream>
#include <utility>

#include "base/agreement.hpp"
#include "support/file_limit.hpp"
#include "support/files.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

namespace ixos {
namespace {

using test::file_failure;
using test::world;
using Mode = Hdf5Series::Mode;

constexpr unsigned long long width = 7;
const std::vector<Hdf5Series::Set> sets{{"time", 1, ""}, {"field", width, "points"}};

double time_of(unsigned long long frame) { return 0.25 * static_cast<double>(frame); }
double field_at(unsigned long long frame, unsigned long long i) {
  return 100 * static_cast<double>(frame) + static_cast<double>(i);
}

/// Returns the share of a rank; on more ranks than numbers some are empty.
Slab share_of(int rank) {
  const auto r = static_cast<unsigned long long>(rank), ranks = static_cast<unsigned long long>(world()->getSize());
  const unsigned long long first = width * r / ranks;
  return {first, width * (r + 1) / ranks - first, width};
}

/// Makes a file that has the two scales and nothing else.
void make_file(const std::string& path) {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_LATEST);
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
  const std::vector<int> numbers(width, 0);
  const hsize_t one = 1, many = width;
  ASSERT_GE(H5LTmake_dataset_int(file, "frames", 1, &one, numbers.data()), 0);
  ASSERT_GE(H5LTmake_dataset_int(file, "points", 1, &many, numbers.data()), 0);
  ASSERT_GE(H5Fclose(file), 0);
  H5Pclose(access);
}

/// A data set as the HDF5 library reads it with its ordinary driver.
struct Found {
  std::vector<hsize_t> size;
  std::vector<double> values;
};

Found read_set(const std::string& path, const char* name) {
  Found found;
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  int rank = 0;
  if (file < 0 || H5LTget_dataset_ndims(file, name, &rank) < 0) {
    ADD_FAILURE() << path << " has no " << name;
    return found;
  }
  found.size.resize(static_cast<std::size_t>(rank));
  H5T_class_t kind{};
  std::size_t bytes = 0, count = 1;
  H5LTget_dataset_info(file, name, found.size.data(), &kind, &bytes);
  EXPECT_EQ(kind, H5T_FLOAT);
  EXPECT_EQ(bytes, 8U);
  for (hsize_t length : found.size) count *= length;
  found.values.resize(count);
  if (count > 0) {
    EXPECT_GE(H5LTread_dataset_double(file, name, found.values.data()), 0);
  }
  H5Fclose(file);
  return found;
}

/// Expects that many frames, on the first rank.
void expect_frames(const std::string& path, unsigned long long frames) {
  on_first_rank(world(), [&] {
    const Found times = read_set(path, "time"), field = read_set(path, "field");
    EXPECT_EQ(times.size, std::vector<hsize_t>{frames});
    EXPECT_EQ(field.size, (std::vector<hsize_t>{frames, width}));
    for (std::size_t k = 0; k < times.values.size(); ++k) EXPECT_EQ(times.values[k], time_of(k)) << k;
    for (std::size_t k = 0; k < field.values.size(); ++k)
      EXPECT_EQ(field.values[k], field_at(k / width, k % width)) << k;
  });
}

void append(Hdf5Series& series, unsigned long long first, unsigned long long end) {
  const int rank = world()->getRank();
  const Slab mine = share_of(rank);
  for (unsigned long long frame = first; frame < end; ++frame) {
    std::vector<std::vector<double>> values(2);
    if (rank == 0) values[0].push_back(time_of(frame));
    for (unsigned long long i = 0; i < mine.count; ++i) values[1].push_back(field_at(frame, mine.offset + i));
    series.append(values, {{0, values[0].size(), 1}, mine});
  }
}

class Hdf5SeriesTest : public testing::Test {
 protected:
  void SetUp() override {
    on_first_rank(world(), [&] {
      make_file(path_);
      Hdf5Series::add(path_, "frames", sets);
    });
  }
  void TearDown() override {
    world()->barrier();
    if (world()->getRank() == 0) std::filesystem::remove(path_);
  }
  /// Opens the file, adds these frames and closes it.
  static void add_frames(const std::string& path, unsigned long long first, unsigned long long end) {
    Hdf5Series series(path, world(), sets, Mode::Write);
    append(series, first, end);
    series.close();
    series.close();  // does nothing
  }

  std::string path_ = testing::TempDir() + "series.h5";
};

TEST_F(Hdf5SeriesTest, EachFrameCanBeReadAsSoonAsItIsAdded) {
  Hdf5Series series(path_, world(), sets, Mode::Write);
  expect_frames(path_, 0);
  for (unsigned long long frame = 0; frame < 6; ++frame) {
    append(series, frame, frame + 1);
    expect_frames(path_, frame + 1);
  }
  series.sync();
  series.close();
  expect_frames(path_, 6);
}

TEST_F(Hdf5SeriesTest, TheSetsGrowAlongTheScales) {
  add_frames(path_, 0, 2);
  on_first_rank(world(), [&] {
    const hid_t file = H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t field = H5Dopen2(file, "field", H5P_DEFAULT), space = H5Dget_space(field);
    hsize_t most[2] = {};
    H5Sget_simple_extent_dims(space, nullptr, most);
    EXPECT_EQ(most[0], H5S_UNLIMITED);
    EXPECT_EQ(most[1], width);
    H5Sclose(space);
    const hid_t time = H5Dopen2(file, "time", H5P_DEFAULT), frames = H5Dopen2(file, "frames", H5P_DEFAULT),
                points = H5Dopen2(file, "points", H5P_DEFAULT);
    EXPECT_GT(H5DSis_attached(time, frames, 0), 0);
    EXPECT_GT(H5DSis_attached(field, frames, 0), 0);
    EXPECT_GT(H5DSis_attached(field, points, 1), 0);
    for (hid_t set : {field, time, frames, points}) H5Dclose(set);
    H5Fclose(file);
  });
}

TEST_F(Hdf5SeriesTest, RanksReadWhatOthersWrote) {
  add_frames(path_, 0, 3);
  Hdf5Series series(path_, world(), sets, Mode::Read);
  const Slab other = share_of(world()->getSize() - 1 - world()->getRank());
  for (unsigned long long frame : {2U, 0U, 1U}) {
    EXPECT_EQ(series.read(0, frame, {0, 1, 1}), std::vector<double>{time_of(frame)});
    const std::vector<double> row = series.read(1, frame, other);
    ASSERT_EQ(row.size(), other.count);
    for (std::size_t i = 0; i < row.size(); ++i) EXPECT_EQ(row[i], field_at(frame, other.offset + i));
  }
  // The first rank alone asks for a frame that is not there.
  const Slab asked{0, world()->getRank() == 0 ? width : 0, width};
  EXPECT_EQ(test::refusal([&] { series.read(1, 3, asked); }), path_ + ": an earlier frame cannot be read");
}

// Times stand in chunks of many frames: a file is opened in the middle of one, and grows beyond its end.
TEST_F(Hdf5SeriesTest, AFileThatWasClosedIsGoneOnWith) {
  constexpr unsigned long long many = 530;
  add_frames(path_, 0, 500);
  add_frames(path_, 500, many);
  expect_frames(path_, many);
  on_first_rank(world(), [&] {
    EXPECT_NO_THROW(Hdf5Series::check(path_, sets, many));
    EXPECT_EQ(test::refusal([&] { Hdf5Series::check(path_, sets, many + 1); }),
              path_ + ": the frames of \"time\" are missing or damaged");
  });
}

TEST_F(Hdf5SeriesTest, BytesDoNotDependOnHowOftenTheFileWasClosed) {
  const std::string parts = testing::TempDir() + "parts.h5";
  // A copy, for the scales keep the time at which they were made.
  on_first_rank(world(), [&] { std::filesystem::copy_file(path_, parts); });
  add_frames(path_, 0, 6);
  for (const auto& [first, end] : {std::pair{0ULL, 1ULL}, std::pair{1ULL, 4ULL}, std::pair{4ULL, 6ULL}})
    add_frames(parts, first, end);
  on_first_rank(world(), [&] {
    EXPECT_TRUE(test::contents(parts) == test::contents(path_));
    std::filesystem::remove(parts);
  });
  expect_frames(path_, 6);
}

TEST_F(Hdf5SeriesTest, AddedSetsTakeThePlaceOfThoseOfTheSameName) {
  add_frames(path_, 0, 3);
  on_first_rank(world(), [&] { Hdf5Series::add(path_, "frames", sets); });
  expect_frames(path_, 0);
  add_frames(path_, 0, 2);
  expect_frames(path_, 2);
}

TEST_F(Hdf5SeriesTest, FilesWithoutTheseSetsAreRefusedOnAllRanks) {
  const auto refusal = [](const std::string& path, const std::vector<Hdf5Series::Set>& wanted, Mode mode) {
    return test::refusal([&] { Hdf5Series(path, world(), wanted, mode); });
  };
  for (Mode mode : {Mode::Read, Mode::Write}) {
    EXPECT_EQ(refusal(path_, sets, mode), "");
    EXPECT_EQ(refusal(path_, {{"field", width + 1, "points"}}, mode), path_ + ": has no \"field\" of this mesh");
    EXPECT_EQ(refusal(path_, {{"field", 1, ""}}, mode), path_ + ": has no \"field\" of this mesh")
        << "one number a row";
    EXPECT_EQ(refusal(path_, {{"absent", 1, ""}}, mode), path_ + ": has no \"absent\" of this mesh");
  }
  const std::string text = testing::TempDir() + "text.h5";
  on_first_rank(world(), [&] { std::ofstream(text) << "no file of HDF5"; });
  EXPECT_EQ(refusal(text, sets, Mode::Write), text + ": HDF5 cannot open it");
  EXPECT_EQ(test::refusal([&] { Hdf5Series::check(text, sets, 0); }), text + ": HDF5 cannot open it");
  EXPECT_THROW(Hdf5Series(text + ".none", world(), sets, Mode::Write), FileError);
}

long long open_in_hdf5() {
  return static_cast<long long>(H5Fget_obj_count(static_cast<hid_t>(H5F_OBJ_ALL), H5F_OBJ_ALL));
}

// The disk's words, and not that HDF5 cannot open the file. A folder opens, but cannot be read.
TEST_F(Hdf5SeriesTest, ADiskThatCannotReadIsNoDamagedFile) {
  EXPECT_EQ(file_failure([&] { Hdf5Series(testing::TempDir(), world(), sets, Mode::Read); }),
            testing::TempDir() + ": cannot be read: Is a directory");
}

/// Puts another data set without rows into the place of "time": in chunks that have no room before they are written,
/// or in one piece that cannot grow.
void replace_times(const std::string& path, bool chunked) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), creation = H5Pcreate(H5P_DATASET_CREATE);
  const hsize_t none = 0, most = chunked ? H5S_UNLIMITED : 0, chunk = 512;
  if (chunked) {
    H5Pset_chunk(creation, 1, &chunk);
    H5Pset_alloc_time(creation, H5D_ALLOC_TIME_INCR);
  }
  const hid_t space = H5Screate_simple(1, &none, &most);
  EXPECT_GE(H5Ldelete(file, "time", H5P_DEFAULT), 0);
  const hid_t set = H5Dcreate2(file, "time", H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  EXPECT_GE(set, 0);
  H5Dclose(set);
  H5Sclose(space);
  H5Pclose(creation);
  EXPECT_GE(H5Fclose(file), 0);
}

// Only the first rank sees it; all of them throw.
TEST_F(Hdf5SeriesTest, SetsThatCannotGrowAreAFailureOfTheFile) {
  const long long before = open_in_hdf5();
  const auto append_to = [&](bool chunked) {
    on_first_rank(world(), [&] { replace_times(path_, chunked); });
    Hdf5Series series(path_, world(), sets, Mode::Write);
    return file_failure([&] { append(series, 0, 1); });
  };
  EXPECT_EQ(append_to(false), path_ + ": time cannot grow");
  EXPECT_EQ(append_to(true), path_ + ": a frame's place cannot be found");
  EXPECT_EQ(open_in_hdf5(), before);
}

// A file that the library could not close would be open to the end of the process, whose exit would then crash.
TEST_F(Hdf5SeriesTest, ADiskWithoutRoomHarmsNeitherTheFramesNorTheLibrary) {
  const long long before = open_in_hdf5();
  add_frames(path_, 0, 2);
  world()->barrier();
  const auto bytes = std::filesystem::file_size(path_);
  unsigned long long frames = 2;
  std::string message;
  {
    Hdf5Series series(path_, world(), sets, Mode::Write);
    const test::FileLimit limit(static_cast<rlim_t>(bytes));
    try {
      for (; frames < 100; ++frames) append(series, frames, frames + 1);
    } catch (const FileError& error) {
      message = error.what();
    }
  }
  EXPECT_EQ(message, path_ + ": cannot be written: File too large") << "on every rank";
  EXPECT_EQ(open_in_hdf5(), before);
  expect_frames(path_, frames);
}

}  // namespace
}  // namespace ixos
