#include "io/hdf5_image.hpp"

#include <algorithm>
#include <cstring>
#include <exception>
#include <string>

#include "base/error.hpp"

namespace ixos::hdf5 {

struct Image::Contents {
  const DiskFile* base = nullptr;
  Pieces pieces{};
  std::uint64_t allocated = 0;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> raw{};
  std::string problem{};  ///< the first, of reading the base
  bool out_of_memory = false;

  /// The first piece that ends after a position.
  Pieces::iterator first_after(std::uint64_t position) {
    auto piece = pieces.upper_bound(position);
    if (piece != pieces.begin() && std::prev(piece)->first + std::prev(piece)->second.size() > position) --piece;
    return piece;
  }

  void read(std::uint64_t position, char* data, std::size_t size) {
    const std::size_t there = base == nullptr ? 0 : base->read_at(position, data, size);
    std::memset(data + there, 0, size - there);
    for (auto piece = first_after(position); piece != pieces.end() && piece->first < position + size; ++piece) {
      const std::uint64_t begin = std::max(position, piece->first);
      const std::uint64_t end = std::min(position + size, piece->first + piece->second.size());
      std::memcpy(data + (begin - position), piece->second.data() + (begin - piece->first), end - begin);
    }
  }

  void write(std::uint64_t position, const char* data, std::size_t size) {
    if (size == 0) return;
    std::uint64_t begin = position, end = position + size;
    const auto first = first_after(position);
    auto last = first;
    for (; last != pieces.end() && last->first < position + size; ++last) {
      begin = std::min(begin, last->first);
      end = std::max(end, last->first + last->second.size());
    }
    if (first != pieces.end() && first->first == begin && first->second.size() == end - begin) {
      std::memcpy(first->second.data() + (position - begin), data, size);
      return;
    }
    std::vector<char> merged(end - begin);
    for (auto piece = first; piece != last; ++piece)
      std::copy(piece->second.begin(), piece->second.end(),
                merged.begin() + static_cast<std::ptrdiff_t>(piece->first - begin));
    std::memcpy(merged.data() + (position - begin), data, size);
    pieces.erase(first, last);
    pieces.emplace(begin, std::move(merged));
  }
};

namespace {

using Shared = std::shared_ptr<Image::Contents>;

/// An open file, as HDF5 sees it.
struct OpenImage {
  H5FD_t common;  ///< of every driver; comes first
  Shared contents;
  haddr_t end = 0;  ///< of what HDF5 addresses now
};

OpenImage& open_image(H5FD_t* file) { return *reinterpret_cast<OpenImage*>(file); }
const OpenImage& open_image(const H5FD_t* file) { return *reinterpret_cast<const OpenImage*>(file); }

/// HDF5 is C: no exception passes through it.
template <class Call>
herr_t status_of(Image::Contents& contents, const Call& call) noexcept {
  try {
    call();
    return 0;
  } catch (const FileError& error) {
    if (contents.problem.empty()) contents.problem = error.what();
  } catch (const std::bad_alloc&) {
    contents.out_of_memory = true;
  } catch (const std::exception&) {  // nothing else is thrown
  }
  return -1;
}

void* copy_shared(const void* shared) { return new (std::nothrow) Shared(*static_cast<const Shared*>(shared)); }
herr_t free_shared(void* shared) {
  delete static_cast<Shared*>(shared);
  return 0;
}

H5FD_t* open(const char*, unsigned, hid_t access, haddr_t) {
  const auto* shared = static_cast<const Shared*>(H5Pget_driver_info(access));
  auto* file = shared == nullptr ? nullptr : new (std::nothrow) OpenImage{{}, *shared};
  return file == nullptr ? nullptr : &file->common;
}
herr_t close(H5FD_t* file) {
  delete &open_image(file);
  return 0;
}
int compare(const H5FD_t* a, const H5FD_t* b) {
  const auto *left = open_image(a).contents.get(), *right = open_image(b).contents.get();
  return std::less<>()(left, right) ? -1 : left == right ? 0 : 1;
}
herr_t query(const H5FD_t*, unsigned long* flags) {
  *flags = H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;  // an ordinary file in the end
  return 0;
}
haddr_t allocate(H5FD_t* file, H5FD_mem_t type, hid_t, hsize_t size) {
  OpenImage& image = open_image(file);
  const haddr_t position = image.end;
  const auto note = [&] {
    if (type == H5FD_MEM_DRAW) image.contents->raw.emplace_back(position, size);
  };
  if (status_of(*image.contents, note) < 0) return HADDR_UNDEF;
  image.end += size;
  image.contents->allocated = image.end;
  return position;
}
haddr_t end_of_addresses(const H5FD_t* file, H5FD_mem_t) { return open_image(file).end; }
herr_t set_end_of_addresses(H5FD_t* file, H5FD_mem_t, haddr_t end) {
  open_image(file).end = open_image(file).contents->allocated = end;
  return 0;
}
haddr_t end_of_file(const H5FD_t* file, H5FD_mem_t) {
  Image::Contents& contents = *open_image(file).contents;
  haddr_t end = contents.allocated;
  const auto look = [&] {
    if (contents.base != nullptr) end = std::max<haddr_t>(end, contents.base->length());
  };
  return status_of(contents, look) < 0 ? HADDR_UNDEF : end;
}
herr_t read(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t position, std::size_t size, void* data) {
  Image::Contents& contents = *open_image(file).contents;
  return status_of(contents, [&] { contents.read(position, static_cast<char*>(data), size); });
}
herr_t write(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t position, std::size_t size, const void* data) {
  Image::Contents& contents = *open_image(file).contents;
  return status_of(contents, [&] { contents.write(position, static_cast<const char*>(data), size); });
}

hid_t driver() {
  static const hid_t registered = [] {
    H5FD_class_t methods{};
#ifdef H5FD_CLASS_VERSION  // from HDF5 1.14 on
    methods.version = H5FD_CLASS_VERSION;
    methods.value = 511;  // the last value that HDF5 leaves to drivers that no other program uses
#endif
    methods.name = "ixos_image";
    methods.maxaddr = HADDR_MAX;
    methods.fc_degree = H5F_CLOSE_STRONG;
    methods.fapl_size = sizeof(Shared);
    methods.fapl_copy = copy_shared;
    methods.fapl_free = free_shared;
    methods.open = open;
    methods.close = close;
    methods.cmp = compare;
    methods.query = query;
    methods.alloc = allocate;
    methods.get_eoa = end_of_addresses;
    methods.set_eoa = set_end_of_addresses;
    methods.get_eof = end_of_file;
    methods.read = read;
    methods.write = write;
    // Raw data must not be mixed with the structure: every kind of allocation is asked for by its own name.
    const H5FD_mem_t kinds[] = H5FD_FLMAP_DEFAULT;
    std::copy(std::begin(kinds), std::end(kinds), std::begin(methods.fl_map));
    return H5FDregister(&methods);
  }();
  return registered;
}

}  // namespace

Image::Image(const DiskFile* base) : contents_(std::make_shared<Contents>(Contents{base})) {}

Handle Image::access() const {
  Handle list = property_list(H5P_FILE_ACCESS);
  require(H5Pset_driver(list, driver(), &contents_) >= 0, "the driver");
  return list;
}

const Image::Pieces& Image::pieces() const { return contents_->pieces; }

std::uint64_t Image::end() const { return contents_->allocated; }

std::vector<std::pair<std::uint64_t, std::uint64_t>> Image::new_raw_data() { return std::exchange(contents_->raw, {}); }

void Image::check() const {
  if (contents_->out_of_memory) throw std::bad_alloc();
  if (!contents_->problem.empty()) throw FileError(contents_->problem);
}

void Image::commit(DiskFile& file, std::uint64_t old_end) {
  for (const bool beyond : {true, false})
    for (const auto& [position, bytes] : contents_->pieces)
      if ((position >= old_end) == beyond) file.write_at(position, bytes.data(), bytes.size());
  contents_->pieces.clear();
}

}  // namespace ixos::hdf5
