#include "base/error.hpp"
#include "io/hdf5_file.hpp"
#include "io/hdf5_image.hpp"
#include "io/hdf5_types.hpp"

namespace ixos {
namespace {

using hdf5::Handle;
using hdf5::in_memory;
using hdf5::text_type;
using hdf5::whole;

/// The slab as a selection of its data set.
Handle selection(const Slab& slab) {
  const hsize_t offset = slab.offset, count = slab.count;
  Handle space = whole(slab);
  H5Sselect_hyperslab(space, H5S_SELECT_SET, &offset, nullptr, &count, nullptr);
  return space;
}

Handle memory(const Slab& slab) {
  const hsize_t count = slab.count;
  return {H5Screate_simple(1, &count, nullptr), H5Sclose};
}

}  // namespace

void start_hdf5() {
  H5dont_atexit();
  H5open();
}

struct Hdf5Input::Implementation {
  explicit Implementation(const std::string& file_path)
      : path(file_path),
        disk(file_path, DiskFile::Mode::Read),
        file_bytes(disk.length()),
        image(&disk),
        file(H5Fopen(file_path.c_str(), H5F_ACC_RDONLY, image.access()), H5Fclose) {}

  hid_t here() const { return groups.empty() ? hid_t(file) : hid_t(groups.back()); }
  [[noreturn]] void missing(const char* name) const {
    image.check();
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
  DiskFile disk;
  std::uint64_t file_bytes;  ///< more than that no data set of ours holds, whatever it says
  hdf5::Image image;         ///< HDF5 would not survive a file that it cannot close
  Handle file;
  std::vector<Handle> groups;
};

Hdf5Input::Hdf5Input(const std::string& path) {
  hdf5::prepare();
  try {
    implementation_ = std::make_unique<Implementation>(path);
  } catch (const FileError& error) {
    throw InputError(error.what());
  }
  if (implementation_->file < 0) throw InputError(path + ": HDF5 cannot read it");
}

Hdf5Input::~Hdf5Input() { implementation_->groups.clear(); }

bool Hdf5Input::has_group(const std::string& name) const {
  if (H5Lexists(implementation_->here(), name.c_str(), H5P_DEFAULT) <= 0) return false;
  const Handle handle(H5Gopen2(implementation_->here(), name.c_str(), H5P_DEFAULT), H5Gclose);
  return handle >= 0;
}

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
