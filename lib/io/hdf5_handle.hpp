/// What all users of the HDF5 library share. Included by lib/io only.
#pragma once
#include <hdf5.h>

#include <utility>

namespace ixos::hdf5 {

/// Whether the library could not close some file of this process; see hdf5_left_open().
inline bool some_left_open = false;

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
    if (id_ >= 0 && status < 0 && close_ == H5Fclose) some_left_open = true;
    id_ = H5I_INVALID_HID;
    return status;
  }

 private:
  hid_t id_;
  Close close_;
};

inline Handle property_list(hid_t kind) { return {H5Pcreate(kind), H5Pclose}; }

/// Prepares the library before any file is opened: it no longer prints its errors, which are statuses here, and a file
/// leads to no other file and to no plug-in that would decode it.
inline void prepare() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  static const bool alone = H5Lunregister(H5L_TYPE_EXTERNAL) >= 0 && H5PLset_loading_state(0) >= 0;
  (void)alone;
}

}  // namespace ixos::hdf5
