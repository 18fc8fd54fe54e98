/// Handles and error checks for all users of the HDF5 library. Included by lib/io only.
#pragma once
#include <hdf5.h>

#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/memory.hpp"

namespace ixos::hdf5 {

/// An identifier of HDF5. The destructor closes it and ignores the status: release() what was written.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  ~Handle() { release(); }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle& operator=(Handle&&) = delete;

  operator hid_t() const { return id_; }  // NOLINT: passed to the C interface as it is
  herr_t release() {
    const herr_t status = id_ >= 0 ? close_(id_) : -1;
    id_ = H5I_INVALID_HID;
    return status;
  }

 private:
  hid_t id_;
  Close close_;
};

/// Throws MemoryError if a call failed that works in memory only.
inline void require(bool good, const std::string& what) {
  if (good) return;
  note_failed_allocation(0);
  throw MemoryError(out_of_memory() + ": HDF5: " + what);
}

/// Throws MemoryError.
inline Handle property_list(hid_t kind) {
  Handle list(H5Pcreate(kind), H5Pclose);
  require(list >= 0, "a property list");
  return list;
}

/// Prepares the library before any file is opened: it no longer prints its errors, which are statuses here, and a file
/// leads to no other file and to no plug-in that would decode it.
inline void prepare() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  static const bool alone = H5Lunregister(H5L_TYPE_EXTERNAL) >= 0 && H5PLset_loading_state(0) >= 0;
  (void)alone;
}

}  // namespace ixos::hdf5
