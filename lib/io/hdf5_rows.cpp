#include "io/hdf5_rows.hpp"

#include <hdf5_hl.h>

namespace ixos::hdf5 {
namespace {

constexpr hsize_t numbers_in_chunk = 512;  ///< of sets without a width

int rank_of(const Hdf5Series::Set& set) { return set.scale.empty() ? 1 : 2; }

}  // namespace

Handle open_set(hid_t file, const std::string& name) { return {H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose}; }

Extent chunk_of(const Hdf5Series::Set& set) { return {set.scale.empty() ? numbers_in_chunk : 1, set.width}; }

hsize_t chunk_bytes(const Hdf5Series::Set& set) {
  const Extent chunk = chunk_of(set);
  return 8 * chunk[0] * (rank_of(set) == 1 ? 1 : chunk[1]);
}

bool has_rows(hid_t data, const Hdf5Series::Set& set, hsize_t& frames) {
  const Handle space(H5Dget_space(data), H5Sclose);
  Extent size{};
  if (space < 0 || H5Sget_simple_extent_ndims(space) != rank_of(set) ||
      H5Sget_simple_extent_dims(space, size.data(), nullptr) < 0)
    return false;
  frames = size[0];
  return rank_of(set) == 1 || size[1] == set.width;
}

bool is_plain(hid_t data, const Hdf5Series::Set& set) {
  const Handle type(H5Dget_type(data), H5Tclose), creation(H5Dget_create_plist(data), H5Pclose);
  Extent chunk{};
  const int rank = rank_of(set);
  return type >= 0 && H5Tequal(type, H5T_IEEE_F64LE) > 0 && creation >= 0 && H5Pget_nfilters(creation) == 0 &&
         H5Pget_layout(creation) == H5D_CHUNKED && H5Pget_chunk(creation, 2, chunk.data()) == rank &&
         chunk[0] == chunk_of(set)[0] && (rank == 1 || chunk[1] == set.width);
}

// H5Dget_chunk_info_by_coord would say where, but looks through all chunks before. A place beyond the file's end fails
// when it is read.
bool has_frames(hid_t data, const Hdf5Series::Set& set, hsize_t frames) {
  for (Extent place{0, 0}; place[0] < frames; place[0] += chunk_of(set)[0]) {
    hsize_t stored = 0;
    if (H5Dget_chunk_storage_size(data, place.data(), &stored) < 0 || stored != chunk_bytes(set)) return false;
  }
  return true;
}

bool remove_set(hid_t file, hid_t frames, const Hdf5Series::Set& set) {
  if (H5Lexists(file, set.name.c_str(), H5P_DEFAULT) <= 0) return true;
  {
    const Handle old = open_set(file, set.name);
    H5DSdetach_scale(old, frames, 0);
    if (!set.scale.empty()) H5DSdetach_scale(old, open_set(file, set.scale), 1);
  }
  return H5Ldelete(file, set.name.c_str(), H5P_DEFAULT) >= 0;
}

bool add_set(hid_t file, hid_t frames, const Hdf5Series::Set& set) {
  const int rank = rank_of(set);
  const Extent size{0, set.width}, limit{H5S_UNLIMITED, set.width}, chunk = chunk_of(set);
  const Handle creation = property_list(H5P_DATASET_CREATE);
  H5Pset_obj_track_times(creation, false);
  H5Pset_chunk(creation, rank, chunk.data());
  H5Pset_alloc_time(creation, H5D_ALLOC_TIME_EARLY);  // as parallel HDF5 demands
  H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER);
  const Handle space(H5Screate_simple(rank, size.data(), limit.data()), H5Sclose);
  Handle made(H5Dcreate2(file, set.name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose);
  if (made < 0 || H5DSattach_scale(made, frames, 0) < 0) return false;
  return (rank == 1 || H5DSattach_scale(made, open_set(file, set.scale), 1) >= 0) && made.release() >= 0;
}

}  // namespace ixos::hdf5
