/// Types of numbers and texts, and extents of data sets, in HDF5's terms. Included by lib/io only.
#pragma once
#include <algorithm>
#include <cstddef>

#include "io/hdf5_file.hpp"
#include "io/hdf5_handle.hpp"

namespace ixos::hdf5 {

inline Handle scalar_space() { return {H5Screate(H5S_SCALAR), H5Sclose}; }

inline hid_t in_memory(const double*) { return H5T_NATIVE_DOUBLE; }
inline hid_t in_memory(const long long*) { return H5T_NATIVE_LLONG; }
inline hid_t on_disk(const double*) { return H5T_IEEE_F64LE; }
inline hid_t on_disk(const long long*) { return H5T_STD_I64LE; }

inline Handle text_type(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  require(H5Tset_size(type, std::max<std::size_t>(length, 1)) >= 0, "a text's type");
  return type;
}

/// The extent of the data set of which a slab is a part.
inline Handle whole(const Slab& slab) {
  const hsize_t total = slab.total;
  return {H5Screate_simple(1, &total, nullptr), H5Sclose};
}

}  // namespace ixos::hdf5
