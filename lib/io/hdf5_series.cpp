#include "io/hdf5_series.hpp"

#include <hdf5_hl.h>

#include <array>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "io/disk_file.hpp"
#include "io/hdf5_handle.hpp"

namespace ixos {
namespace {

using hdf5::Handle;
using hdf5::property_list;

/// What a frame may add to the file beside its numbers: pages of the indices, of each set.
constexpr unsigned long long index_bytes = 1 << 15;

constexpr hsize_t numbers_in_chunk = 512;  ///< of sets without a width

Handle open_set(hid_t file, const std::string& name) { return {H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose}; }

using Extent = std::array<hsize_t, 2>;

int rank_of(const Hdf5Series::Set& set) { return set.scale.empty() ? 1 : 2; }

/// The rows that are stored together.
Extent chunk_of(const Hdf5Series::Set& set) { return {set.scale.empty() ? numbers_in_chunk : 1, set.width}; }

/// Whether a data set has rows of that width; how many goes to `frames`.
bool has_rows(hid_t data, const Hdf5Series::Set& set, hsize_t& frames) {
  const Handle space(H5Dget_space(data), H5Sclose);
  Extent size{};
  if (space < 0 || H5Sget_simple_extent_ndims(space) != rank_of(set) ||
      H5Sget_simple_extent_dims(space, size.data(), nullptr) < 0)
    return false;
  frames = size[0];
  return rank_of(set) == 1 || size[1] == set.width;
}

/// Whether a data set's numbers stand in the file as they are: doubles in chunks, without filters.
bool is_plain(hid_t data, const Hdf5Series::Set& set) {
  const Handle type(H5Dget_type(data), H5Tclose), creation(H5Dget_create_plist(data), H5Pclose);
  Extent chunk{};
  const int rank = rank_of(set);
  return type >= 0 && H5Tequal(type, H5T_IEEE_F64LE) > 0 && creation >= 0 && H5Pget_nfilters(creation) == 0 &&
         H5Pget_layout(creation) == H5D_CHUNKED && H5Pget_chunk(creation, 2, chunk.data()) == rank &&
         chunk[0] == chunk_of(set)[0] && (rank == 1 || chunk[1] == set.width);
}

/// Whether a data set's first frames are stored. (H5Dget_chunk_info_by_coord would say where, but looks through all
/// chunks before; a place beyond the file's end fails when it is read.)
bool has_frames(hid_t data, const Hdf5Series::Set& set, hsize_t frames) {
  const Extent chunk = chunk_of(set);
  const hsize_t bytes = 8 * chunk[0] * (rank_of(set) == 1 ? 1 : chunk[1]);
  for (Extent place{0, 0}; place[0] < frames; place[0] += chunk[0]) {
    hsize_t stored = 0;
    if (H5Dget_chunk_storage_size(data, place.data(), &stored) < 0 || stored != bytes) return false;
  }
  return true;
}

/// Where the file has a set of that name, it goes.
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
  const Handle made(H5Dcreate2(file, set.name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT),
                    H5Dclose);
  if (made < 0 || H5DSattach_scale(made, frames, 0) < 0) return false;
  return rank == 1 || H5DSattach_scale(made, open_set(file, set.scale), 1) >= 0;
}

}  // namespace

struct Hdf5Series::Implementation {
  std::string path;
  Comm comm;
  std::vector<Set> descriptions;
  std::unique_ptr<Handle> file{};
  std::vector<Handle> sets{};
  Handle transfer = hdf5::collective_transfer();
  std::string problem{};  ///< the first on this rank

  void check(bool good, const std::string& what) {
    if (!good && problem.empty()) problem = path + ": " + what + " cannot be written";
  }
  void open(unsigned mode) {
    const Handle access = property_list(H5P_FILE_ACCESS);
    hdf5::share(access, comm);
    // Without HDF5's own reserves, places in the file depend on the frames alone: not on where a run was interrupted.
    H5Pset_meta_block_size(access, 0);
    H5Pset_small_data_block_size(access, 0);
    file = std::make_unique<Handle>(H5Fopen(path.c_str(), mode, access), H5Fclose);
    if (*file < 0) throw InputError(path + ": HDF5 cannot open it");
    sets.reserve(descriptions.size());
    for (const Set& set : descriptions) {
      sets.push_back(open_set(*file, set.name));
      hsize_t frames = 0;
      if (!has_rows(sets.back(), set, frames)) throw InputError(path + ": has no \"" + set.name + "\" of this mesh");
    }
  }
  /// Calls back with the selections, in memory and in the file, of a part of a row.
  template <class Call>
  herr_t with_part(std::size_t set, unsigned long long frame, const Slab& slab, const Call& call) const {
    const Handle space(H5Dget_space(sets[set]), H5Sclose);
    const Extent start{frame, slab.offset}, count{1, slab.count};
    const bool part =
        slab.count > 0 && H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) >= 0;
    if (!part) H5Sselect_none(space);
    const auto selected = static_cast<hsize_t>(H5Sget_select_npoints(space));
    const Handle memory(H5Screate_simple(1, &selected, nullptr), H5Sclose);
    const herr_t status = call(memory, space);
    return selected == slab.count ? status : -1;
  }
};

void Hdf5Series::add(const std::string& path, const std::string& frames, const std::vector<Set>& sets) {
  hdf5::prepare();
  const Handle access = property_list(H5P_FILE_ACCESS);
  H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);  // for the extensible arrays
  Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, access), H5Fclose);
  bool good = file >= 0;
  if (good) {
    const Handle scale = open_set(file, frames);
    good = scale >= 0;
    for (const Set& set : sets) good = good && remove_set(file, scale, set) && add_set(file, scale, set);
  }
  if (file.release() < 0 || !good) throw FileError(path + ": its data sets cannot be written");
}

void Hdf5Series::check(const std::string& path, const std::vector<Set>& sets, unsigned long long frames) {
  hdf5::prepare();
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (file < 0) throw InputError(path + ": HDF5 cannot open it");
  for (const Set& set : sets) {
    const Handle data = open_set(file, set.name);
    hsize_t rows = 0;
    if (data < 0 || !has_rows(data, set, rows) || rows < frames || !is_plain(data, set) ||
        !has_frames(data, set, frames))
      throw InputError(path + ": the frames of \"" + set.name + "\" to go on with are not there, or damaged");
  }
}

Hdf5Series::Hdf5Series(const std::string& path, const Comm& comm, const std::vector<Set>& sets, Mode mode)
    : implementation_(std::make_unique<Implementation>(Implementation{path, comm, sets})) {
  hdf5::prepare();
  together<InputError>(comm, [&] { implementation_->open(mode == Mode::Read ? H5F_ACC_RDONLY : H5F_ACC_RDWR); });
}

Hdf5Series::~Hdf5Series() {
  Implementation& self = *implementation_;
  self.sets.clear();
  if (self.file->release() < 0) hdf5::some_left_open = true;
}

void Hdf5Series::grow(unsigned long long frames) {
  Implementation& self = *implementation_;
  on_first_rank(self.comm, [&] {
    DiskFile file(self.path, DiskFile::Mode::Change);
    unsigned long long bytes = file.length();
    for (const Set& set : self.descriptions)
      bytes += 8 * std::max<unsigned long long>(set.width, numbers_in_chunk) + index_bytes;
    file.lengthen(bytes);
  });
  for (std::size_t s = 0; s < self.sets.size(); ++s) {
    const Extent size{frames, self.descriptions[s].width};
    self.check(H5Dset_extent(self.sets[s], size.data()) >= 0, self.descriptions[s].name);
  }
}

void Hdf5Series::write(std::size_t set, unsigned long long frame, const double* values, const Slab& slab) {
  Implementation& self = *implementation_;
  const herr_t status = self.with_part(set, frame, slab, [&](hid_t memory, hid_t space) {
    return H5Dwrite(self.sets[set], H5T_NATIVE_DOUBLE, memory, space, self.transfer, values);
  });
  self.check(status >= 0, self.descriptions[set].name);
}

std::vector<double> Hdf5Series::read(std::size_t set, unsigned long long frame, const Slab& slab) const {
  const Implementation& self = *implementation_;
  std::vector<double> values(slab.count);
  const herr_t status = self.with_part(set, frame, slab, [&](hid_t memory, hid_t space) {
    return H5Dread(self.sets[set], H5T_NATIVE_DOUBLE, memory, space, self.transfer, values.data());
  });
  together<InputError>(self.comm, [&] {
    if (status < 0) throw InputError(self.path + ": a frame to go on with cannot be read");
  });
  return values;
}

void Hdf5Series::flush() {
  Implementation& self = *implementation_;
  self.check(H5Fflush(*self.file, H5F_SCOPE_GLOBAL) >= 0, "a frame");
  const std::string problem = first_problem(self.comm, self.problem);
  if (!problem.empty()) throw FileError(problem);
}

}  // namespace ixos
