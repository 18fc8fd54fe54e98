// Identifiers of HDF5, which are closed once, and what the library may do after prepare().
#include "io/hdf5_handle.hpp"

#include <gtest/gtest.h>

#include <type_traits>
#include <vector>

namespace ixos::hdf5 {
namespace {

static_assert(!std::is_copy_constructible_v<Handle> && !std::is_copy_assignable_v<Handle> &&
              !std::is_move_assignable_v<Handle>);

/// The identifiers that were closed, in their order.
std::vector<hid_t> closed;

constexpr herr_t status = 3;

herr_t note(hid_t id) {
  closed.push_back(id);
  return status;
}

class Hdf5HandleSerialTest : public testing::Test {
 protected:
  void SetUp() override { closed.clear(); }
};

TEST_F(Hdf5HandleSerialTest, TheDestructorCloses) {
  {
    const Handle handle(7, note);
    EXPECT_EQ(hid_t{handle}, 7);
    EXPECT_TRUE(closed.empty());
  }
  EXPECT_EQ(closed, std::vector<hid_t>{7});
}

TEST_F(Hdf5HandleSerialTest, ReleaseClosesOnceAndReturnsTheStatus) {
  {
    Handle handle(7, note);
    EXPECT_EQ(handle.release(), status);
    EXPECT_EQ(hid_t{handle}, H5I_INVALID_HID);
    EXPECT_LT(handle.release(), 0) << "there is nothing to close";
  }
  EXPECT_EQ(closed, std::vector<hid_t>{7});
}

TEST_F(Hdf5HandleSerialTest, AMoveHandsTheIdentifierOver) {
  {
    Handle from(7, note);
    {
      const Handle to(std::move(from));
      EXPECT_EQ(hid_t{to}, 7);
      EXPECT_EQ(hid_t{from}, H5I_INVALID_HID);
    }
    EXPECT_EQ(closed, std::vector<hid_t>{7});
  }
  EXPECT_EQ(closed, std::vector<hid_t>{7});
}

TEST_F(Hdf5HandleSerialTest, IdentifiersAreClosedInReverseOrder) {
  { const Handle first(7, note), second(8, note); }
  EXPECT_EQ(closed, (std::vector<hid_t>{8, 7}));
}

TEST_F(Hdf5HandleSerialTest, AnInvalidIdentifierIsNotClosed) {
  {
    const Handle none(H5I_INVALID_HID, note);
    EXPECT_LT(hid_t{none}, 0);
  }
  EXPECT_TRUE(closed.empty());
}

TEST(Hdf5PropertyListSerialTest, APropertyListLivesAsLongAsItsHandle) {
  hid_t id = H5I_INVALID_HID;
  {
    const Handle list = property_list(H5P_FILE_ACCESS);
    id = list;
    EXPECT_GT(H5Iis_valid(id), 0);
    EXPECT_GT(H5Pisa_class(id, H5P_FILE_ACCESS), 0);
    EXPECT_EQ(H5Pisa_class(id, H5P_DATASET_CREATE), 0);
  }
  EXPECT_EQ(H5Iis_valid(id), 0);
}

// In memory, HDF5 fails for want of memory only.
TEST(Hdf5PropertyListSerialTest, AFailureIsAWantOfMemory) {
  prepare();  // the library would print its error
  EXPECT_THROW(property_list(H5I_INVALID_HID), MemoryError);
  EXPECT_NO_THROW(require(true, "a data type"));
  std::string message;
  try {
    require(false, "a data type");
  } catch (const MemoryError& error) {
    message = error.what();
  }
  EXPECT_EQ(message, out_of_memory() + ": HDF5: a data type");
  EXPECT_TRUE(memory_ran_out());
}

TEST(Hdf5PrepareSerialTest, FilesLeadToNoOtherFileAndToNoPlugIn) {
  for (int time = 0; time < 2; ++time) {  // the second time changes nothing
    prepare();
    EXPECT_EQ(H5Lis_registered(H5L_TYPE_EXTERNAL), 0);
    unsigned plug_ins = ~0U;
    EXPECT_GE(H5PLget_loading_state(&plug_ins), 0);
    EXPECT_EQ(plug_ins, 0U);
    H5E_auto2_t print = nullptr;
    void* data = nullptr;
    EXPECT_GE(H5Eget_auto2(H5E_DEFAULT, &print, &data), 0);
    EXPECT_TRUE(print == nullptr) << "errors are statuses here";
  }
}

}  // namespace
}  // namespace ixos::hdf5
