/// What all users of the HDF5 library share. Included by lib/io only.
#pragma once
#include <hdf5.h>

#include <Teuchos_DefaultMpiComm.hpp>
#include <utility>

#include "base/tpetra.hpp"

namespace ixos::hdf5 {

/// An identifier of HDF5 that is closed when it goes.
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

inline Handle property_list(hid_t kind) { return {H5Pcreate(kind), H5Pclose}; }

/// Before any file is opened: failures are statuses here, which HDF5 would also print; and a file leads to no other,
/// and to no plug-in that would decode it.
inline void prepare() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  static const bool alone = H5Lunregister(H5L_TYPE_EXTERNAL) >= 0 && H5PLset_loading_state(0) >= 0;
  (void)alone;
}

/// See Hdf5Output::left_open().
inline bool some_left_open = false;

/// Opens files by all ranks together.
inline void share(hid_t access, const Comm& comm) {
  H5Pset_fapl_mpio(access, *dynamic_cast<const Teuchos::MpiComm<int>&>(*comm).getRawMpiComm(), MPI_INFO_NULL);
}

/// Transfers that all ranks make together, in a file that is shared.
inline Handle collective_transfer() {
  Handle transfer = property_list(H5P_DATASET_XFER);
  H5Pset_dxpl_mpio(transfer, H5FD_MPIO_COLLECTIVE);
  return transfer;
}

}  // namespace ixos::hdf5
