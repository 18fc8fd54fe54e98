#include "io/hdf5_file.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <cstdio>

#include "base/agreement.hpp"
#include "base/error.hpp"
#include "io/disk_file.hpp"
#include "io/hdf5_handle.hpp"

namespace ixos {
namespace {

using hdf5::Handle;
using hdf5::property_list;

Handle scalar_space() { return {H5Screate(H5S_SCALAR), H5Sclose}; }

hid_t in_memory(const double*) { return H5T_NATIVE_DOUBLE; }
hid_t in_memory(const long long*) { return H5T_NATIVE_LLONG; }
hid_t on_disk(const double*) { return H5T_IEEE_F64LE; }
hid_t on_disk(const long long*) { return H5T_STD_I64LE; }

Handle text_type(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, std::max<std::size_t>(length, 1));
  return type;
}

/// The slab as a selection of its data set. An empty one still takes part in collective transfers.
Handle selection(const Slab& slab) {
  const hsize_t total = slab.total, offset = slab.offset, count = slab.count;
  Handle space(H5Screate_simple(1, &total, nullptr), H5Sclose);
  if (count == 0)
    H5Sselect_none(space);
  else
    H5Sselect_hyperslab(space, H5S_SELECT_SET, &offset, nullptr, &count, nullptr);
  return space;
}

Handle memory(const Slab& slab) {
  const hsize_t count = slab.count;
  return {H5Screate_simple(1, &count, nullptr), H5Sclose};
}

}  // namespace

struct Hdf5Output::Implementation {
  Implementation(const std::string& file_path, const Comm& ranks) : path(file_path), comm(ranks) {}

  void check(bool good, const char* what) {
    if (!good && problem.empty()) problem = path + ": " + what + " cannot be written";
  }
  hid_t here() const { return groups.empty() ? hid_t(*file) : hid_t(groups.back()); }
  bool all(bool good) const {
    int mine = good ? 1 : 0, least = mine;
    if (comm->getSize() > 1) Teuchos::reduceAll(*comm, Teuchos::REDUCE_MIN, 1, &mine, &least);
    return least != 0;
  }

  /// Values of a type, from a selection of the memory to one of the data set.
  struct Source {
    const void* values;
    hid_t type;
    hid_t space;
  };
  void put(const char* name, hid_t type, hid_t space, hid_t creation, const Source& source) {
    H5Pset_obj_track_times(creation, false);
    const Handle set(H5Dcreate2(here(), name, type, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose);
    check(set >= 0, name);
    // Nobody may be left alone in the transfer.
    if (H5Sget_simple_extent_npoints(space) == 0 || !all(set >= 0)) return;
    const Handle transfer = comm->getSize() > 1 ? hdf5::collective_transfer() : property_list(H5P_DATASET_XFER);
    check(H5Dwrite(set, source.type, source.space, space, transfer, source.values) >= 0, name);
  }
  template <class T>
  void put(const char* name, const T* values, const Slab& slab) {
    const Handle creation = property_list(H5P_DATASET_CREATE);
    H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER);
    put(name, on_disk(values), selection(slab), creation, {values, in_memory(values), memory(slab)});
  }

  std::string path;
  Comm comm;
  std::unique_ptr<Handle> file;
  std::vector<Handle> groups;
  std::string problem;  ///< the first on this rank
};

Hdf5Output::Hdf5Output(const std::string& path, const Comm& comm, int user_block, unsigned long long size)
    : implementation_(std::make_unique<Implementation>(path, comm)) {
  hdf5::prepare();
  on_first_rank(comm, [&] {
    std::remove(path.c_str());  // what an interrupted run left, or a link
    DiskFile(path, DiskFile::Mode::Create).reserve(size);
  });
  const Handle creation = property_list(H5P_FILE_CREATE);
  H5Pset_userblock(creation, static_cast<hsize_t>(user_block));
  const Handle access = property_list(H5P_FILE_ACCESS);
  H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
  if (comm->getSize() > 1) hdf5::share(access, comm);
  implementation_->file = std::make_unique<Handle>(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, access), H5Fclose);
  together(comm, [&] {
    if (*implementation_->file < 0) {
      hdf5::some_left_open = comm->getSize() > 1;  // where the others could open it
      throw FileError(path + ": cannot be written");
    }
    if (comm->getRank() == 0) DiskFile(path, DiskFile::Mode::Change).reserve(size);  // HDF5 emptied the file
  });
}

bool Hdf5Output::left_open() { return hdf5::some_left_open; }

Hdf5Output::~Hdf5Output() { implementation_->groups.clear(); }

void Hdf5Output::enter(const std::string& group) {
  Implementation& self = *implementation_;
  Handle handle(H5Gcreate2(self.here(), group.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  self.check(handle >= 0, group.c_str());
  self.groups.push_back(std::move(handle));
}

void Hdf5Output::leave() { implementation_->groups.pop_back(); }

void Hdf5Output::put(const char* name, double value) {
  Implementation& self = *implementation_;
  const Handle attribute(H5Acreate2(self.here(), name, on_disk(&value), scalar_space(), H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  self.check(attribute >= 0 && H5Awrite(attribute, in_memory(&value), &value) >= 0, name);
}

void Hdf5Output::put(const char* name, const std::string& value) {
  // A data set: attributes end at 64 KiB.
  const Handle type = text_type(value.size());
  const Handle space = scalar_space();
  if (implementation_->comm->getRank() != 0) H5Sselect_none(space);  // one rank writes, all call
  implementation_->put(name, type, space, property_list(H5P_DATASET_CREATE), {value.c_str(), type, space});
}

void Hdf5Output::put(const char* name, const double* values, const Slab& slab) {
  implementation_->put(name, values, slab);
}

void Hdf5Output::put(const char* name, const long long* values, const Slab& slab) {
  implementation_->put(name, values, slab);
}

void Hdf5Output::close() {
  Implementation& self = *implementation_;
  self.groups.clear();
  // Each rank's own writes are on the disk before the file is sealed.
  if (self.comm->getSize() > 1) self.check(H5Fflush(*self.file, H5F_SCOPE_GLOBAL) >= 0, "its end");
  const bool closed = self.file->release() >= 0;
  hdf5::some_left_open = hdf5::some_left_open || !closed;
  self.check(closed, "its end");
  const std::string problem = first_problem(self.comm, self.problem);
  if (!problem.empty()) throw FileError(problem);
}

struct Hdf5Input::Implementation {
  explicit Implementation(const std::string& file_path)
      : path(file_path), file(H5Fopen(file_path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose) {
    if (file >= 0) H5Fget_filesize(file, &file_bytes);
  }

  hid_t here() const { return groups.empty() ? hid_t(file) : hid_t(groups.back()); }
  [[noreturn]] void missing(const char* name) const {
    throw InputError(path + ": has no readable \"" + name + "\": it is not a checkpoint of this version");
  }
  Handle data_set(const char* name) const {
    Handle set(H5Dopen2(here(), name, H5P_DEFAULT), H5Dclose);
    if (set < 0) missing(name);
    return set;
  }
  unsigned long long length(const char* name) const {
    const Handle set = data_set(name);
    const Handle space(H5Dget_space(set), H5Sclose);
    if (H5Sget_simple_extent_ndims(space) != 1) missing(name);
    return static_cast<unsigned long long>(H5Sget_simple_extent_npoints(space));
  }
  template <class T>
  std::vector<T> values(const char* name, const Slab& slab) const {
    const Handle set = data_set(name);
    const unsigned long long total = length(name);
    if (slab.count > total || slab.offset > total - slab.count) missing(name);
    if (total > file_bytes / sizeof(T)) missing(name);
    std::vector<T> result(slab.count);
    if (slab.count == 0) return result;
    const Handle space = selection({slab.offset, slab.count, total});
    if (H5Dread(set, in_memory(result.data()), memory(slab), space, H5P_DEFAULT, result.data()) < 0) missing(name);
    return result;
  }

  std::string path;
  Handle file;
  hsize_t file_bytes = 0;  ///< more than that no data set of ours holds, whatever it says
  std::vector<Handle> groups;
};

Hdf5Input::Hdf5Input(const std::string& path) {
  hdf5::prepare();
  implementation_ = std::make_unique<Implementation>(path);
  if (implementation_->file < 0) throw InputError(path + ": HDF5 cannot read it");
}

Hdf5Input::~Hdf5Input() { implementation_->groups.clear(); }

void Hdf5Input::enter(const std::string& group) {
  Handle handle(H5Gopen2(implementation_->here(), group.c_str(), H5P_DEFAULT), H5Gclose);
  if (handle < 0) implementation_->missing(group.c_str());
  implementation_->groups.push_back(std::move(handle));
}

void Hdf5Input::leave() { implementation_->groups.pop_back(); }

double Hdf5Input::number(const char* name) const {
  const Handle attribute(H5Aopen(implementation_->here(), name, H5P_DEFAULT), H5Aclose);
  if (attribute < 0) implementation_->missing(name);
  const Handle space(H5Aget_space(attribute), H5Sclose);
  double value = 0;
  if (H5Sget_simple_extent_npoints(space) != 1 || H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0)
    implementation_->missing(name);
  return value;
}

std::string Hdf5Input::text(const char* name) const {
  const Handle set = implementation_->data_set(name);
  const Handle disk(H5Dget_type(set), H5Tclose);
  const Handle space(H5Dget_space(set), H5Sclose);
  const std::size_t size = H5Tget_size(disk);
  if (H5Tget_class(disk) != H5T_STRING || H5Tis_variable_str(disk) != 0 || H5Sget_simple_extent_npoints(space) != 1 ||
      size > implementation_->file_bytes)
    implementation_->missing(name);
  std::string value(size, '\0');
  const Handle type = text_type(size);
  if (H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data()) < 0) implementation_->missing(name);
  return value.substr(0, value.find('\0'));
}

unsigned long long Hdf5Input::length(const char* name) const { return implementation_->length(name); }

std::vector<double> Hdf5Input::numbers(const char* name, const Slab& slab) const {
  return implementation_->values<double>(name, slab);
}

std::vector<long long> Hdf5Input::integers(const char* name, const Slab& slab) const {
  return implementation_->values<long long>(name, slab);
}

}  // namespace ixos
