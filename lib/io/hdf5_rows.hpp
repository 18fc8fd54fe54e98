/// The data sets of an Hdf5Series inside its file. Included by lib/io only.
#pragma once
#include <array>
#include <string>

#include "io/hdf5_handle.hpp"
#include "io/hdf5_series.hpp"

namespace ixos::hdf5 {

/// Rows and columns; of a set without a scale only the first counts.
using Extent = std::array<hsize_t, 2>;

/// Opens a data set; the handle is negative if there is none.
Handle open_set(hid_t file, const std::string& name);

/// Returns the rows that are stored together, and their width.
Extent chunk_of(const Hdf5Series::Set& set);
/// Returns the length of such a chunk in bytes.
hsize_t chunk_bytes(const Hdf5Series::Set& set);

/// Returns whether a data set has rows of that width, and sets `frames` to their number.
bool has_rows(hid_t data, const Hdf5Series::Set& set, hsize_t& frames);

/// Returns whether a data set's numbers stand in the file as they are: doubles in chunks, without filters.
bool is_plain(hid_t data, const Hdf5Series::Set& set);

/// Returns whether a data set's first frames are stored.
bool has_frames(hid_t data, const Hdf5Series::Set& set, hsize_t frames);

/// Removes what the file has under the set's name. Returns false if HDF5 fails. `frames` is the scale of its rows.
bool remove_set(hid_t file, hid_t frames, const Hdf5Series::Set& set);

/// Adds the set without rows. Returns false if HDF5 fails.
bool add_set(hid_t file, hid_t frames, const Hdf5Series::Set& set);

}  // namespace ixos::hdf5
