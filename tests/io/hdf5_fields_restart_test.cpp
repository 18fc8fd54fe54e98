// An HDF5 file of fields that a run goes on with: whole whatever interrupted it, and refused where it is another.
#include <gtest/gtest.h>

#include <hdf5_hl.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>

#include "io/hdf5_fields_fixture.hpp"
#include "support/file_limit.hpp"
#include "support/files.hpp"

namespace ixos::test {
namespace {

TEST_F(Hdf5FieldsTest, ItIsGoneOnWithAndLaterFramesAreDropped) {
  const Mesh mesh = two_blocks(3, false);
  FieldLength at_two;
  {
    Writer writer(mesh, world(), path("whole.e"));
    writer.file().create();
    writer.write(0, 2);
    writer.file().sync();
    at_two = writer.file().length();
    writer.write(2, 4);
  }
  const std::string whole = contents(path("whole.e"));
  write_alone(mesh, "two.e", 2);
  // As it stood at the second frame; with two more; by another number of ranks, which knows no length.
  for (const auto& [start, bytes] : {std::pair<std::string, double>{"two.e", at_two.bytes},
                                     {"whole.e", at_two.bytes},
                                     {"whole.e", 0.0},
                                     {"two.e", 0.0}}) {
    on_first_rank(world(), [&, from = path(start)] {
      std::filesystem::copy_file(from, path("parts.e"), std::filesystem::copy_options::overwrite_existing);
    });
    {
      Writer writer(mesh, world(), path("parts.e"));
      writer.file().verify({2, bytes});
      writer.file().resume({2, bytes});
      writer.write(2, 4);
    }
    EXPECT_TRUE(contents(path("parts.e")) == whole) << start << bytes;
    world()->barrier();
  }
}

TEST_F(Hdf5FieldsTest, AFrameWithoutRoomFailsOnAllRanksAndTheFramesBeforeAreGoneOnWith) {
  const Mesh mesh = two_blocks(2, false);
  FieldLength at_two;
  {
    Writer writer(mesh, world(), path("full.e"));
    writer.file().create();
    writer.write(0, 2);
    at_two = writer.file().length();
    const FileLimit limit(static_cast<rlim_t>(at_two.bytes) + 64);
    std::string message;
    try {
      writer.write(2, 3);
    } catch (const FileError& error) {
      message = error.what();
    }
    EXPECT_NE(message.find("full.e: cannot be written: File too large"), std::string::npos) << message;
    EXPECT_EQ(writer.file().length().frames, 2);
  }
  {
    Writer writer(mesh, world(), path("full.e"));
    writer.file().verify(at_two);
    writer.file().resume(at_two);
    writer.write(2, 3);
  }
  write_alone(mesh, "room.e", 3);
  EXPECT_TRUE(contents(path("full.e")) == contents(path("room.e")));
  {
    const FileLimit limit(4096);
    Writer writer(mesh, world(), path("none.e"));
    EXPECT_THROW(writer.file().create(), FileError);
  }
}

TEST_F(Hdf5FieldsTest, WhatDoesNotFitIsRefused) {
  const Mesh mesh = two_blocks(2, false);
  write_alone(mesh, "two.e", 2);
  const auto size = static_cast<double>(std::filesystem::file_size(path("two.e")));
  const auto refusal = [&](const Mesh& other, const std::string& name, const FieldLength& keep) {
    Writer writer(other, world(), path(name));
    try {
      writer.file().verify(keep);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refusal(mesh, "two.e", {2, size}), "accepted");
  EXPECT_NE(refusal(mesh, "two.e", {3, size}).find("the file should have this mesh, these fields and 3 frames"),
            std::string::npos);
  EXPECT_NE(refusal(mesh, "two.e", {2, size + 1}).find("cannot resume: the file should have this mesh"),
            std::string::npos);
  EXPECT_NE(refusal(two_blocks(2, true), "two.e", {2, size}).find("cannot resume: the file should have this mesh"),
            std::string::npos);
  EXPECT_NE(refusal(mesh, "nowhere.e", {2, size}).find("cannot resume: "), std::string::npos);
  // Of the other format, both ways.
  const LocalMesh local = localize(mesh, partition_nodes(mesh, 1), 0, 1);
  on_first_rank(world(), [&] {
    const FieldContents contents{OutputMesh(local, 1), names, "test"};
    const auto exodus = exodus_fields(path("two.e"), contents, alone());
    EXPECT_THROW(exodus->verify({2, size}), InputError);
    exodus_fields(path("classic.e"), contents, alone())->create();
    EXPECT_NO_THROW(exodus_fields(path("classic.e"), contents, alone())->verify({0, 0}));
  });
  EXPECT_NE(refusal(mesh, "classic.e", {0, 0}).find("cannot resume: the file should have this mesh"),
            std::string::npos);
}

/// Two rows in the place of the set "vals_nod_var1".
void replace_set(hid_t file, hid_t type, bool compressed, bool written) {
  const hid_t old = H5Dopen2(file, "vals_nod_var1", H5P_DEFAULT), old_space = H5Dget_space(old);
  std::array<hsize_t, 2> size{};
  H5Sget_simple_extent_dims(old_space, size.data(), nullptr);
  H5Sclose(old_space);
  H5Dclose(old);
  H5Ldelete(file, "vals_nod_var1", H5P_DEFAULT);
  const std::array<hsize_t, 2> chunk{1, size[1]}, most{H5S_UNLIMITED, size[1]};
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE), space = H5Screate_simple(2, size.data(), most.data());
  H5Pset_chunk(creation, 2, chunk.data());
  if (compressed) H5Pset_deflate(creation, 9);
  const hid_t made = H5Dcreate2(file, "vals_nod_var1", type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  for (unsigned axis = 0; axis < 2; ++axis) {
    const hid_t scale = H5Dopen2(file, axis == 0 ? "time_step" : "num_nodes", H5P_DEFAULT);
    ASSERT_GE(H5DSattach_scale(made, scale, axis), 0);
    H5Dclose(scale);
  }
  const std::vector<double> values(size[0] * size[1], 1.0);
  if (written) H5Dwrite(made, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Dclose(made);
  H5Sclose(space);
  H5Pclose(creation);
}

TEST_F(Hdf5FieldsSerialTest, SetsThatAreNotAsTheyWereMadeAreRefused) {
  const Mesh mesh = two_blocks(2, false);
  const std::vector<std::pair<std::string, std::function<void(hid_t)>>> changes{
      {"nothing", [](hid_t) {}},
      {"as it was made", [](hid_t file) { replace_set(file, H5T_IEEE_F64LE, false, true); }},
      {"single precision", [](hid_t file) { replace_set(file, H5T_IEEE_F32LE, false, true); }},
      {"compressed", [](hid_t file) { replace_set(file, H5T_IEEE_F64LE, true, true); }},
      {"rows that are nowhere", [](hid_t file) { replace_set(file, H5T_IEEE_F64LE, false, false); }},
      {"a row too few", [](hid_t file) {
         const hid_t set = H5Dopen2(file, "vals_nod_var1", H5P_DEFAULT);
         const std::array<hsize_t, 2> size{1, 15};
         ASSERT_GE(H5Dset_extent(set, size.data()), 0);
         H5Dclose(set);
       }}};
  for (std::size_t k = 0; k < changes.size(); ++k) {
    const std::string name = path("changed.e");
    {
      Writer writer(mesh, alone(), name);
      writer.file().create();
      writer.write(0, 2);
    }
    const hid_t file = H5Fopen(name.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    ASSERT_GE(file, 0);
    changes[k].second(file);
    H5Fclose(file);
    std::string message = "accepted";
    try {
      Writer(mesh, alone(), name).file().verify({2, 0});
    } catch (const InputError& error) {
      message = error.what();
    }
    if (k < 2)
      EXPECT_EQ(message, "accepted") << changes[k].first;
    else
      EXPECT_EQ(message, name + ": the frames of \"vals_nod_var1\" are missing or damaged") << changes[k].first;
  }
  EXPECT_EQ(H5Lis_registered(H5L_TYPE_EXTERNAL), 0) << "a set could be one of another file";
}

/// Where HDF5's metadata that differ begin: object headers, and the parts of extensible arrays.
std::vector<std::size_t> changed_entries(const std::string& before, const std::string& after) {
  std::vector<std::size_t> all;
  for (const char* signature : {"OHDR", "EAHD", "EAIB", "EADB", "EASB"})
    for (auto at = after.find(signature); at != std::string::npos; at = after.find(signature, at + 1))
      all.push_back(at);
  std::sort(all.begin(), all.end());
  all.push_back(after.size());
  std::vector<std::size_t> changed;
  for (std::size_t i = 0; i + 1 < all.size(); ++i)
    if (before.compare(all[i], all[i + 1] - all[i], after, all[i], all[i + 1] - all[i]) != 0) changed.push_back(all[i]);
  return changed;
}

// A killed run leaves any part of what HDF5 writes for a frame, entry by entry, mostly by their places in the file: the
// frames before it are there all the same.
TEST_F(Hdf5FieldsSerialTest, AFrameThatIsHalfWrittenHarmsNoOther) {
  const Mesh mesh = two_blocks(2, false);
  // The fifth frame begins the first block of each set's index.
  for (int kept : {1, 4, 9}) {
    std::vector<std::string> states;  // with the frames to keep, and one more
    {
      Writer writer(mesh, alone(), path("grows.e"));
      writer.file().create();
      writer.write(0, kept);
      states.push_back(contents(path("grows.e")));
      writer.write(kept, kept + 1);
      states.push_back(contents(path("grows.e")));
    }
    std::string before = states[0];
    const std::string& after = states[1];
    const auto bytes = static_cast<double>(before.size());
    before.resize(after.size());
    const std::vector<std::size_t> starts = changed_entries(before, after);
    ASSERT_GT(starts.size(), 8U);
    int tried = 0;
    for (std::size_t k = 0; k < starts.size(); k += 1 + starts.size() / 5)
      for (bool front : {true, false}) {
        const std::string& first = front ? after : before;
        const std::string& second = front ? before : after;
        std::ofstream(path("half.e"), std::ios::binary) << first.substr(0, starts[k]) << second.substr(starts[k]);
        Writer writer(mesh, alone(), path("half.e"));
        ASSERT_NO_THROW(writer.file().verify({kept, bytes})) << kept << " " << starts[k];
        writer.file().resume({kept, bytes});
        writer.write(kept, kept + 1);
        EXPECT_TRUE(contents(path("half.e")) == after) << kept << " " << starts[k] << front;
        ++tried;
      }
    EXPECT_GT(tried, 6);
  }
}

}  // namespace
}  // namespace ixos::test
