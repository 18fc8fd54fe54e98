#include "io/hdf5_series.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cstdint>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "io/disk_file.hpp"
#include "io/hdf5_image.hpp"
#include "io/hdf5_rows.hpp"

namespace ixos {

using hdf5::chunk_bytes;
using hdf5::chunk_of;
using hdf5::Extent;
using hdf5::Handle;
using hdf5::has_rows;
using hdf5::open_set;

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
      const Extent size{frames + 1, set.width};
      const hsize_t row = frames % chunk_of(set)[0];
      require<FileError>(H5Dset_extent(sets[s], size.data()) >= 0, set.name + " cannot grow");
      if (row == 0) {
        const auto made = image->new_raw_data();
        chunks[s] = made.size() == 1 && made[0].second == chunk_bytes(set) ? made[0].first
                                                                           : place_of_row<FileError>(sets[s], frames);
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
    for (const Set& set : sets) good = good && hdf5::remove_set(file, scale, set) && hdf5::add_set(file, scale, set);
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
    if (data < 0 || !has_rows(data, set, rows) || rows < frames || !hdf5::is_plain(data, set) ||
        !hdf5::has_frames(data, set, frames))
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
