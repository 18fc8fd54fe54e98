#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cstdio>
#include <utility>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "base/gather.hpp"
#include "io/disk_file.hpp"
#include "io/hdf5_file.hpp"
#include "io/hdf5_image.hpp"
#include "io/hdf5_types.hpp"

namespace ixos {

using hdf5::Handle;
using hdf5::in_memory;
using hdf5::on_disk;
using hdf5::property_list;
using hdf5::scalar_space;
using hdf5::text_type;
using hdf5::whole;

struct Hdf5Output::Implementation {
  Implementation(const std::string& file_path, const Comm& ranks, std::uint64_t user_block)
      : path(file_path), comm(ranks), beginning(user_block) {}

  bool first() const { return comm->getRank() == 0; }
  /// HDF5 meets no disk here: it fails for want of memory only, and is not to be used any more then.
  void check(bool good, const char* what) const {
    image.check();
    hdf5::require(good, path + ": " + what);
  }
  /// Runs a write, whose FileError stays on this rank until close().
  template <class Function>
  void attempt(const Function& function) {
    if (!problem.empty()) return;
    try {
      function();
    } catch (const FileError& error) {
      problem = error.what();
    }
  }
  hid_t here() const { return groups.empty() ? hid_t(*file) : hid_t(groups.back()); }

  FilePiece write(std::uint64_t position, const void* data, std::size_t size) const {
    disk->write_at(position, data, size);
    return {position, size, checksum(data, size)};
  }

  /// Makes a data set that has its room in the file at once. First rank only.
  Handle create(const char* name, hid_t type, hid_t space) {
    const Handle creation = property_list(H5P_DATASET_CREATE);
    check(H5Pset_obj_track_times(creation, false) >= 0 && H5Pset_alloc_time(creation, H5D_ALLOC_TIME_EARLY) >= 0 &&
              H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER) >= 0,
          name);
    Handle set(H5Dcreate2(here(), name, type, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose);
    check(set >= 0, name);
    return set;
  }

  template <class T>
  void put(const char* name, const T* values, const Slab& slab) {
    static_assert(sizeof(T) == 8 && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__);
    long long place = 0;  // no data set begins there
    if (first()) {
      Handle set = create(name, on_disk(values), whole(slab));
      const haddr_t offset = slab.total > 0 ? H5Dget_offset(set) : 0;
      check(set.release() >= 0 && offset != HADDR_UNDEF, name);
      place = static_cast<long long>(offset);
    }
    if (slab.total == 0) return;
    if (comm->getSize() > 1) Teuchos::broadcast(*comm, 0, &place);
    if (slab.count == 0) return;
    attempt([&] {
      pieces.push_back(
          write(static_cast<std::uint64_t>(place) + sizeof(T) * slab.offset, values, sizeof(T) * slab.count));
    });
  }

  /// Writes what HDF5 kept in memory, and zeros between the pieces: then the whole file is known. First rank only.
  std::vector<FilePiece> complete(std::vector<FilePiece> known) {
    for (const auto& [position, bytes] : image.pieces()) known.push_back(write(position, bytes.data(), bytes.size()));
    std::sort(known.begin(), known.end(),
              [](const FilePiece& a, const FilePiece& b) { return a.position < b.position; });
    const std::uint64_t file_end = image.end();
    known.push_back({file_end, 0, {}});
    std::vector<FilePiece> all;
    std::uint64_t end = beginning;
    for (const FilePiece& piece : known) {
      if (piece.position < end) throw FileError(path + ": HDF5 allocated one place twice");
      const std::vector<char> zeros(piece.position - end);
      if (!zeros.empty()) all.push_back(write(end, zeros.data(), zeros.size()));
      all.push_back(piece);
      end = piece.position + piece.length;
    }
    all.pop_back();
    disk->set_length(file_end);
    return all;
  }

  /// Returns the pieces of all ranks on the first one.
  std::vector<FilePiece> gathered_pieces() const {
    std::vector<std::uint64_t> numbers;
    for (const FilePiece& piece : pieces)
      numbers.insert(numbers.end(), {piece.position, piece.length, piece.checksum[0], piece.checksum[1]});
    numbers = gather(numbers, comm);
    std::vector<FilePiece> all;
    for (std::size_t i = 0; i < numbers.size(); i += 4)
      all.push_back({numbers[i], numbers[i + 1], {numbers[i + 2], numbers[i + 3]}});
    return all;
  }

  std::string path;
  Comm comm;
  std::uint64_t beginning;         ///< of the HDF5 data
  std::unique_ptr<DiskFile> disk;  ///< this rank's
  std::vector<FilePiece> pieces;   ///< that this rank wrote
  hdf5::Image image;               ///< the first rank's
  std::unique_ptr<Handle> file;    ///< in the image
  std::vector<Handle> groups;
  std::string problem;  ///< the first on this rank
};

Hdf5Output::Hdf5Output(const std::string& path, const Comm& comm, int user_block, unsigned long long size)
    : implementation_(std::make_unique<Implementation>(path, comm, static_cast<std::uint64_t>(user_block))) {
  Implementation& self = *implementation_;
  on_first_rank(comm, [&] {
    std::remove(path.c_str());  // what an interrupted run left, or a link
    self.disk = std::make_unique<DiskFile>(path, DiskFile::Mode::Create);
    self.disk->reserve(size);
    hdf5::prepare();
    const Handle creation = property_list(H5P_FILE_CREATE);
    const Handle access = self.image.access();
    self.check(H5Pset_userblock(creation, static_cast<hsize_t>(user_block)) >= 0 &&
                   H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST) >= 0,
               "properties");
    self.file = std::make_unique<Handle>(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, access), H5Fclose);
    self.check(*self.file >= 0, "the file");
  });
  if (comm->getSize() > 1)
    together(comm, [&] {
      if (!self.first()) self.disk = std::make_unique<DiskFile>(path, DiskFile::Mode::Change);
    });
}

Hdf5Output::~Hdf5Output() { implementation_->groups.clear(); }

void Hdf5Output::enter(const std::string& group) {
  Implementation& self = *implementation_;
  if (!self.first()) return;
  Handle handle(H5Gcreate2(self.here(), group.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  self.check(handle >= 0, group.c_str());
  self.groups.push_back(std::move(handle));
}

void Hdf5Output::leave() {
  Implementation& self = *implementation_;
  if (!self.first()) return;
  self.check(self.groups.back().release() >= 0, "a group");
  self.groups.pop_back();
}

void Hdf5Output::put(const char* name, double value) {
  Implementation& self = *implementation_;
  if (!self.first()) return;
  Handle attribute(H5Acreate2(self.here(), name, on_disk(&value), scalar_space(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  const bool written = attribute >= 0 && H5Awrite(attribute, in_memory(&value), &value) >= 0;
  self.check(attribute.release() >= 0 && written, name);
}

void Hdf5Output::put(const char* name, const std::string& value) {
  Implementation& self = *implementation_;
  if (!self.first()) return;
  // A data set: attributes end at 64 KiB.
  const Handle type = text_type(value.size());
  Handle set = self.create(name, type, scalar_space());
  const bool written = set >= 0 && H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.c_str()) >= 0;
  self.check(set.release() >= 0 && written, name);
}

void Hdf5Output::put(const char* name, const double* values, const Slab& slab) {
  implementation_->put(name, values, slab);
}

void Hdf5Output::put(const char* name, const long long* values, const Slab& slab) {
  implementation_->put(name, values, slab);
}

std::vector<FilePiece> Hdf5Output::close() {
  Implementation& self = *implementation_;
  self.groups.clear();
  if (self.first()) self.check(self.file->release() >= 0, "its structure");
  std::vector<FilePiece> pieces = self.gathered_pieces();
  self.attempt([&] {
    if (self.first()) pieces = self.complete(std::move(pieces));
    // The first rank's disk keeps the file when it is sealed.
    if (!self.first()) self.disk->sync();
    self.disk->close();
  });
  const std::string problem = first_problem(self.comm, self.problem);
  if (!problem.empty()) throw FileError(problem);
  return pieces;
}

}  // namespace ixos
