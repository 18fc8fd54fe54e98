#include "io/hdf5_series.hpp"

#include <hdf5_hl.h>

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <array>
#include <cstdint>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "io/disk_file.hpp"
#include "io/hdf5_image.hpp"

namespace ixos {
namespace {

using hdf5::Handle;
using hdf5::property_list;

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
  Handle made(H5Dcreate2(file, set.name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose);
  if (made < 0 || H5DSattach_scale(made, frames, 0) < 0) return false;
  return (rank == 1 || H5DSattach_scale(made, open_set(file, set.scale), 1) >= 0) && made.release() >= 0;
}

}  // namespace

struct Hdf5Series::Implementation {
  std::string path;
  Comm comm;
  std::vector<Set> descriptions;
  Mode mode;
  std::unique_ptr<DiskFile> disk{};      ///< each rank's own
  std::unique_ptr<hdf5::Image> image{};  ///< to write: on the first rank only
  std::unique_ptr<Handle> file{};        ///< in the image
  std::vector<Handle> sets{};            ///< where the file is open
  unsigned long long frames = 0;
  std::vector<std::uint64_t> chunks{};  ///< by set: where the chunk of the last row begins
  std::uint64_t end = 0;                ///< of the file that the disk has

  bool first() const { return comm->getRank() == 0; }

  /// Throws `Error` unless HDF5 succeeded. If the disk or the memory was to blame, throws what the image knows of that.
  template <class Error>
  void require(bool good, const std::string& problem) const {
    image->check();
    if (!good) throw Error(path + ": " + problem);
  }

  void open() {
    const bool writes = mode == Mode::Write;
    disk = std::make_unique<DiskFile>(path, writes ? DiskFile::Mode::Change : DiskFile::Mode::Read);
    if (writes && !first()) return;
    hdf5::prepare();
    image = std::make_unique<hdf5::Image>(disk.get());
    const Handle access = image->access();
    // Without HDF5's own reserves, places in the file depend on the frames alone: not on where a run was interrupted.
    H5Pset_meta_block_size(access, 0);
    H5Pset_small_data_block_size(access, 0);
    file = std::make_unique<Handle>(H5Fopen(path.c_str(), writes ? H5F_ACC_RDWR : H5F_ACC_RDONLY, access), H5Fclose);
    require<InputError>(*file >= 0, "HDF5 cannot open it");
    end = disk->length();
    for (const Set& set : descriptions) {
      sets.push_back(open_set(*file, set.name));
      hsize_t rows = 0;
      // A frame whose writing failed may have rows in some sets only; nothing is added to such a file.
      const bool fits =
          has_rows(sets.back(), set, rows) && (!writes || &set == &descriptions.front() || rows == frames);
      require<InputError>(fits, "has no \"" + set.name + "\" of this mesh");
      frames = rows;
      chunks.push_back(writes && rows % chunk_of(set)[0] != 0 ? place_of_row<InputError>(sets.back(), rows - 1) : 0);
    }
    image->new_raw_data();
  }

  /// Returns where the chunk of a row begins. Throws `Error` if the row is not stored.
  template <class Error>
  std::uint64_t place_of_row(hid_t set, hsize_t row) const {
    const Extent place{row, 0};
    unsigned filters = 0;
    haddr_t address = 0;
    hsize_t bytes = 0;
    const bool found = H5Dget_chunk_info_by_coord(set, place.data(), &filters, &address, &bytes) >= 0;
    require<Error>(found && address != HADDR_UNDEF, "a frame's place cannot be found");
    return address;
  }

  /// Has HDF5 make room for a row in each set. Returns where it begins. First rank only.
  std::vector<std::uint64_t> grow() {
    std::vector<std::uint64_t> places;
    for (std::size_t s = 0; s < sets.size(); ++s) {
      const Set& set = descriptions[s];
      const Extent size{frames + 1, set.width}, chunk = chunk_of(set);
      const hsize_t bytes = 8 * chunk[0] * (rank_of(set) == 1 ? 1 : chunk[1]), row = frames % chunk[0];
      require<FileError>(H5Dset_extent(sets[s], size.data()) >= 0, set.name + " cannot grow");
      if (row == 0) {
        const auto made = image->new_raw_data();
        chunks[s] =
            made.size() == 1 && made[0].second == bytes ? made[0].first : place_of_row<FileError>(sets[s], frames);
      }
      places.push_back(chunks[s] + 8 * row);
    }
    require<FileError>(H5Fflush(*file, H5F_SCOPE_GLOBAL) >= 0, "the structure of a frame cannot be made");
    disk->lengthen(std::max(image->end(), end));
    return places;
  }
};

void Hdf5Series::add(const std::string& path, const std::string& frames, const std::vector<Set>& sets) {
  hdf5::prepare();
  DiskFile disk(path, DiskFile::Mode::Change);
  hdf5::Image image(&disk);
  const Handle access = image.access();
  // The extensible arrays need it.
  hdf5::require(H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST) >= 0, "properties");
  Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, access), H5Fclose);
  bool good = file >= 0;
  if (good) {
    const Handle scale = open_set(file, frames);
    good = scale >= 0;
    for (const Set& set : sets) good = good && remove_set(file, scale, set) && add_set(file, scale, set);
  }
  const bool made = file.release() >= 0 && good;
  image.check();
  if (!made) throw FileError(path + ": HDF5 cannot make its data sets");
  disk.lengthen(image.end());
  image.commit(disk, 0);
  disk.close();
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
      throw InputError(path + ": the frames of \"" + set.name + "\" are missing or damaged");
  }
}

Hdf5Series::Hdf5Series(const std::string& path, const Comm& comm, const std::vector<Set>& sets, Mode mode)
    : implementation_(std::make_unique<Implementation>(Implementation{path, comm, sets, mode})) {
  together<InputError>(comm, [&] { implementation_->open(); });
}

Hdf5Series::~Hdf5Series() = default;

void Hdf5Series::append(const std::vector<std::vector<double>>& values, const std::vector<Slab>& slabs) {
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__);
  Implementation& self = *implementation_;
  std::vector<long long> places(self.descriptions.size());
  on_first_rank(self.comm, [&] {
    const std::vector<std::uint64_t> made = self.grow();
    std::copy(made.begin(), made.end(), places.begin());
  });
  if (self.comm->getSize() > 1) Teuchos::broadcast(*self.comm, 0, static_cast<int>(places.size()), places.data());
  together(self.comm, [&] {
    for (std::size_t s = 0; s < places.size(); ++s)
      self.disk->write_at(static_cast<std::uint64_t>(places[s]) + 8 * slabs[s].offset, values[s].data(),
                          8 * slabs[s].count);
  });
  on_first_rank(self.comm, [&] {
    self.image->commit(*self.disk, self.end);
    self.end = self.disk->length();
  });
  ++self.frames;
}

std::vector<double> Hdf5Series::read(std::size_t set, unsigned long long frame, const Slab& slab) const {
  const Implementation& self = *implementation_;
  std::vector<double> values(slab.count);
  together<InputError>(self.comm, [&] {
    if (slab.count == 0) return;
    const Handle space(H5Dget_space(self.sets[set]), H5Sclose);
    const Extent start{frame, slab.offset}, count{1, slab.count};
    const Handle memory(H5Screate_simple(1, &count[1], nullptr), H5Sclose);
    const bool good = H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) >= 0 &&
                      H5Dread(self.sets[set], H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data()) >= 0;
    self.require<InputError>(good, "an earlier frame cannot be read");
  });
  return values;
}

void Hdf5Series::sync() {
  together(implementation_->comm, [&] { implementation_->disk->sync(); });
}

void Hdf5Series::close() {
  Implementation& self = *implementation_;
  if (self.comm.is_null()) return;
  together(self.comm, [&] {
    if (self.image) {
      bool closed = true;
      for (Handle& set : self.sets) closed = set.release() >= 0 && closed;
      closed = self.file->release() >= 0 && closed;
      self.require<FileError>(closed, "HDF5 cannot close it");
      if (self.mode == Mode::Write) self.image->commit(*self.disk, self.end);
    }
    self.disk->close();
  });
  self.comm = Teuchos::null;
}

}  // namespace ixos
